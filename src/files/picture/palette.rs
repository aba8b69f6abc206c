//! Pixels of PNG and BMP pictures that have no colour in the palette: indices beyond it, or rows that run lengths leave open.
//! Decoders show them black.

use super::colour_space::png_chunk;
use super::{Format, Samples};

/// What a user should know of such pixels, seen by a black that the palette does not hold.
pub fn note(encoded: &[u8], format: Format, samples: &Samples) -> Option<String> {
    let has_black = match format {
        Format::Png if encoded.get(25) == Some(&3) => has_black(png_chunk(encoded, b"PLTE")?, 3),
        Format::Bmp => bitmap_has_black(encoded)?,
        _ => return None,
    };
    let Samples::Bytes(channels @ 3.., bytes) = samples else { return None };
    let shows_black = || self::has_black(bytes, *channels);
    (!has_black && shows_black())
        .then(|| "some of its pixels have none of the colours of its palette: they are black".to_owned())
}

/// True if a list of colours holds black; each is three bytes and others behind them.
fn has_black(colours: &[u8], size: usize) -> bool {
    colours.chunks_exact(size).any(|colour| colour[..3] == [0; 3])
}

/// `None` for bitmaps without a palette.
fn bitmap_has_black(encoded: &[u8]) -> Option<bool> {
    let two = |at: usize| Some(u16::from_le_bytes(*encoded.get(at..)?.first_chunk()?));
    let four = |at: usize| Some(u32::from_le_bytes(*encoded.get(at..)?.first_chunk()?) as usize);
    let header = four(14)?;
    let old = header == 12;
    let bits = two(if old { 24 } else { 28 })?;
    if !(1..=8).contains(&bits) {
        return None;
    }
    let stated = if old { 0 } else { four(46)? };
    let count = if stated == 0 { 1 << bits } else { stated.min(1 << bits) };
    let entry = if old { 3 } else { 4 };
    let start = 14 + header;
    Some(has_black(encoded.get(start..(start + entry * count).min(encoded.len()))?, entry))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_that_the_palette_does_not_hold_are_noted() {
        let samples = |last: u8| Samples::Bytes(3, vec![9, 8, 7, last, 0, 0]);
        let mut png = b"\x89PNG\r\n\x1A\n\0\0\0\x0DIHDR\0\0\0\x02\0\0\0\x01\x08\x03\0\0\0CRC.\0\0\0\x03PLTE".to_vec();
        png.extend([9, 8, 7]);
        let mut bitmap = vec![0; 54];
        (bitmap[14], bitmap[28], bitmap[46]) = (40, 8, 1);
        bitmap.extend([7, 8, 9, 0]);
        for (file, format) in [(png, Format::Png), (bitmap, Format::Bmp)] {
            assert!(note(&file, format, &samples(0)).is_some(), "{format:?}");
            assert_eq!(note(&file, format, &samples(1)), None);
            let black = [&file[..file.len() - 4], &[0; 4]].concat();
            assert_eq!(note(&black, format, &samples(0)), None);
        }
    }
}
