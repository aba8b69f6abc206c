//! Whether a JPEG file reaches its end marker.
//!
//! The decoder silently fills the missing part of a truncated file with grey, which would look like a wrong picture
//! instead of a broken file.

/// True if the markers of the file lead from its start to an end-of-image marker (ITU-T T.81, annex B).
pub fn is_complete(encoded: &[u8]) -> bool {
    const END_OF_IMAGE: u8 = 0xD9;
    let mut position = 2;
    while let Some((marker, after)) = next_marker(encoded, position) {
        position = match marker {
            END_OF_IMAGE => return true,
            // The entropy-coded data after the scan header are passed over by the search for the next marker.
            _ if has_segment(marker) => match segment_length(encoded, after) {
                Some(length) => after + length,
                None => return false,
            },
            _ => after,
        };
    }
    false
}

/// True if the picture comes in several passes, each of which needs the coefficients of all blocks (frame header SOF2).
pub fn is_progressive(encoded: &[u8]) -> bool {
    let mut position = 2;
    while let Some((marker, after)) = next_marker(encoded, position) {
        match marker {
            0xC2 => return true,
            0xC0 | 0xC1 | 0xDA => return false,
            _ => position = after + if has_segment(marker) { segment_length(encoded, after).unwrap_or(0) } else { 0 },
        }
    }
    false
}

/// The next marker at or after `position` and the position behind it. Inside entropy-coded data `FF 00` is a data byte
/// and `FF D0` to `FF D7` are restarts, neither of them a marker; fill bytes `FF` may come before any marker.
fn next_marker(encoded: &[u8], mut position: usize) -> Option<(u8, usize)> {
    loop {
        position += encoded.get(position..)?.iter().position(|&byte| byte == 0xFF)? + 1;
        match *encoded.get(position)? {
            0x00 | 0xD0..=0xD7 => position += 1,
            0xFF => {}
            marker => return Some((marker, position + 1)),
        }
    }
}

/// False for the markers that stand alone: start and end of image, restarts, TEM.
fn has_segment(marker: u8) -> bool {
    !matches!(marker, 0x01 | 0xD0..=0xD9)
}

fn segment_length(encoded: &[u8], position: usize) -> Option<usize> {
    let bytes = encoded.get(position..position + 2)?;
    Some(usize::from(u16::from_be_bytes([bytes[0], bytes[1]])))
}
