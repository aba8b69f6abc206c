//! TGA pictures.

use super::*;

/// A file from the parts of its header: kind, bits of a pixel, descriptor, and the pixels' rows in the order of the file.
fn file(kind: u8, bits: u8, descriptor: u8, map: &[[u8; 3]], data: Vec<u8>) -> Vec<u8> {
    let size = |side: usize| (side as u16).to_le_bytes();
    let (count, entry) = (map.len() as u16, if map.is_empty() { 0 } else { 24 });
    let mut file = vec![0, u8::from(!map.is_empty()), kind, 0, 0];
    file.extend(count.to_le_bytes());
    file.extend([entry, 0, 0, 0, 0]);
    file.extend([size(WIDTH), size(HEIGHT)].concat());
    file.extend([bits, descriptor]);
    file.extend(map.iter().flat_map(|&[red, green, blue]| [blue, green, red]));
    file.extend(data);
    file
}

/// Rows in the order of an origin: bit 5 top, bit 4 right.
fn rows(descriptor: u8, pixel: impl Fn(usize, usize) -> Vec<u8>) -> Vec<Vec<u8>> {
    let row = |row: usize| if descriptor & 0x20 > 0 { row } else { HEIGHT - 1 - row };
    let column = |column: usize| if descriptor & 0x10 > 0 { WIDTH - 1 - column } else { column };
    (0..HEIGHT).flat_map(|y| (0..WIDTH).map(move |x| (x, y))).map(|(x, y)| pixel(column(x), row(y))).collect()
}

/// Packets of up to 128 pixels, alternately of one pixel repeated once and of three pixels as they are.
fn run_lengths(pixels: &[Vec<u8>]) -> Vec<u8> {
    let mut data = Vec::new();
    for part in pixels.chunks(4) {
        data.push(0x80);
        data.extend(&part[0]);
        if part.len() > 1 {
            data.push(part.len() as u8 - 2);
            data.extend(part[1..].concat());
        }
    }
    data
}

pub fn kinds() -> Vec<Kind> {
    let mut kinds = Vec::new();
    let map = palette(200);
    for descriptor in [0x00, 0x10, 0x20, 0x30] {
        let grey = rows(descriptor, |x, y| vec![sample(x, y, 0, 8) as u8]);
        let index = rows(descriptor, |x, y| vec![index(x, y, 8, 200) as u8]);
        let colour = |channels: usize| {
            rows(descriptor, |x, y| [2, 1, 0, 3].map(|channel| sample(x, y, channel, 8) as u8)[..channels].to_vec())
        };
        let five = rows(descriptor, |x, y| {
            let part = |channel: usize| sample(x, y, channel, 5) as u16;
            (part(0) << 10 | part(1) << 5 | part(2)).to_le_bytes().to_vec()
        });
        for (compressed, name) in [(0, ""), (8, ", run lengths")] {
            let data = |pixels: &[Vec<u8>]| if compressed > 0 { run_lengths(pixels) } else { pixels.concat() };
            let mut add = |what: &str, kind: u8, bits: u8, map: &[[u8; 3]], pixels: &[Vec<u8>], right| {
                let name = format!("{what}{name}, origin {descriptor:x}");
                let alpha = if bits == 32 { 8 } else { 0 };
                kinds.push(Kind::new(
                    name,
                    file(kind + compressed, bits, descriptor | alpha, map, data(pixels)),
                    right,
                ));
            };
            add("grey", 3, 8, &[], &grey, Right::Codes(greys(8), 0.51));
            add("palette", 1, 8, &map, &index, Right::Codes(of_palette(8, &map), 0.51));
            add("16 bits", 2, 16, &[], &five, Right::Codes(codes(5), 1.01));
            add("24 bits", 2, 24, &[], &colour(3), Right::Codes(codes(8), 0.51));
            add("32 bits", 2, 32, &[], &colour(4), Right::Codes(codes(8), 0.51));
        }
    }
    kinds
}
