//! PNG pictures: the kinds of PngSuite.

use super::*;

/// Red, green and blue of each kind of samples: how many a pixel, and the number of the kind in the header.
const GREY: u8 = 0;
const RGB: u8 = 2;
const PALETTE: u8 = 3;
const GREY_ALPHA: u8 = 4;
const RGB_ALPHA: u8 = 6;

fn channels(colour: u8) -> usize {
    match colour {
        RGB => 3,
        GREY_ALPHA => 2,
        RGB_ALPHA => 4,
        _ => 1,
    }
}

/// A picture before it is written.
struct Png {
    colour: u8,
    bits: u32,
    interlaced: bool,
    /// The filter of a row, from 0 to 4.
    filter: fn(usize) -> u8,
    palette: Vec<[u8; 3]>,
    /// Chunks before the pixels.
    chunks: Vec<(&'static [u8; 4], Vec<u8>)>,
    /// Parts of the data, each in a chunk.
    parts: usize,
}

impl Png {
    fn new(colour: u8, bits: u32) -> Self {
        let palette = if colour == PALETTE { palette(1 << bits) } else { Vec::new() };
        Self { colour, bits, interlaced: false, filter: |_| 0, palette, chunks: Vec::new(), parts: 1 }
    }

    fn with(self, kind: &'static [u8; 4], data: Vec<u8>) -> Self {
        Self { chunks: [self.chunks, vec![(kind, data)]].concat(), ..self }
    }

    /// The pixels of every `step` columns and rows, filtered.
    fn pass(&self, [x0, y0, dx, dy]: [usize; 4]) -> Vec<u8> {
        let samples = channels(self.colour);
        let columns: Vec<usize> = (x0..WIDTH).step_by(dx).collect();
        let distance = (samples * self.bits as usize / 8).max(1);
        let (mut data, mut above) = (Vec::new(), Vec::new());
        if columns.is_empty() {
            return data;
        }
        for (number, y) in (y0..HEIGHT).step_by(dy).enumerate() {
            // The second sample of a grey pixel is its alpha.
            let values = columns.iter().flat_map(|&x| (0..samples).map(move |channel| (x, channel)));
            let row = packed_row(
                self.bits,
                values.map(|(x, channel)| match self.colour {
                    PALETTE => index(x, y, self.bits, self.palette.len()) as u64,
                    _ => sample(x, y, channel, self.bits),
                }),
            );
            let filter = (self.filter)(number);
            data.push(filter);
            above.resize(row.len(), 0);
            for place in 0..row.len() {
                let left = if place >= distance { row[place - distance] } else { 0 };
                let corner = if place >= distance { above[place - distance] } else { 0 };
                let guess = match filter {
                    0 => 0,
                    1 => left,
                    2 => above[place],
                    3 => ((u16::from(left) + u16::from(above[place])) / 2) as u8,
                    _ => paeth(left, above[place], corner),
                };
                data.push(row[place].wrapping_sub(guess));
            }
            above = row;
        }
        data
    }

    fn written(&self) -> Vec<u8> {
        let passes: &[[usize; 4]] = match self.interlaced {
            false => &[[0, 0, 1, 1]],
            true => &[[0, 0, 8, 8], [4, 0, 8, 8], [0, 4, 4, 8], [2, 0, 4, 4], [0, 2, 2, 4], [1, 0, 2, 2], [0, 1, 1, 2]],
        };
        let data = zlib(&passes.iter().flat_map(|&pass| self.pass(pass)).collect::<Vec<_>>());
        let size = [(WIDTH as u32).to_be_bytes(), (HEIGHT as u32).to_be_bytes()].concat();
        let mut file = b"\x89PNG\r\n\x1A\n".to_vec();
        file.extend(chunk(
            b"IHDR",
            &[&size[..], &[self.bits as u8, self.colour, 0, 0, self.interlaced.into()]].concat(),
        ));
        let (early, late): (Vec<_>, Vec<_>) =
            self.chunks.iter().partition(|(kind, _)| *kind != b"tRNS" && *kind != b"bKGD");
        early.iter().for_each(|(kind, data)| file.extend(chunk(kind, data)));
        if !self.palette.is_empty() {
            file.extend(chunk(b"PLTE", self.palette.as_flattened()));
        }
        late.iter().for_each(|(kind, data)| file.extend(chunk(kind, data)));
        data.chunks(data.len().div_ceil(self.parts)).for_each(|part| file.extend(chunk(b"IDAT", part)));
        file.extend(chunk(b"IEND", &[]));
        file
    }

    fn shown(&self) -> Right {
        Right::Codes(
            match self.colour {
                GREY | GREY_ALPHA => greys(self.bits),
                PALETTE => of_palette(self.bits, &self.palette),
                _ => codes(self.bits),
            },
            if self.bits == 16 { 0.02 } else { 0.51 },
        )
    }
}

fn paeth(left: u8, above: u8, corner: u8) -> u8 {
    let guess = i32::from(left) + i32::from(above) - i32::from(corner);
    [left, above, corner].into_iter().min_by_key(|&value| (guess - i32::from(value)).abs()).unwrap()
}

fn chunk(kind: &[u8; 4], data: &[u8]) -> Vec<u8> {
    let body = [kind.as_slice(), data].concat();
    [&(data.len() as u32).to_be_bytes()[..], &body, &crc32(&body).to_be_bytes()].concat()
}

fn crc32(bytes: &[u8]) -> u32 {
    let step = |crc: u32, _| if crc & 1 == 1 { 0xEDB8_8320 ^ (crc >> 1) } else { crc >> 1 };
    !bytes.iter().fold(!0, |crc, &byte| (0..8).fold(crc ^ u32::from(byte), step))
}

/// Every kind of picture.
pub fn kinds() -> Vec<Kind> {
    let mut kinds = Vec::new();
    let mut add = |name: String, png: Png| {
        let shown = png.shown();
        kinds.push(Kind::new(name, png.written(), shown));
    };
    let all = [(GREY, 1), (GREY, 2), (GREY, 4), (GREY, 8), (GREY, 16), (RGB, 8), (RGB, 16), (PALETTE, 1), (PALETTE, 2)];
    let more = [(PALETTE, 4), (PALETTE, 8), (GREY_ALPHA, 8), (GREY_ALPHA, 16), (RGB_ALPHA, 8), (RGB_ALPHA, 16)];
    for (colour, bits) in all.into_iter().chain(more) {
        for interlaced in [false, true] {
            add(
                format!("colour {colour}, {bits} bits, interlaced {interlaced}"),
                Png { interlaced, ..Png::new(colour, bits) },
            );
        }
    }
    let filters: [fn(usize) -> u8; 6] = [|_| 1, |_| 2, |_| 3, |_| 4, |row| row as u8 % 5, |row| 4 - row as u8 % 5];
    for (number, filter) in filters.into_iter().enumerate() {
        for (colour, bits) in [(GREY, 8), (RGB, 8), (PALETTE, 4), (RGB_ALPHA, 16)] {
            add(format!("filter {number}, colour {colour}"), Png { filter, ..Png::new(colour, bits) });
        }
    }
    add("data in many chunks".to_owned(), Png { parts: 40, ..Png::new(RGB, 8) });
    let short = Png { palette: palette(11), ..Png::new(PALETTE, 8) };
    add("palette of 11 colours".to_owned(), short);
    // Transparency and background change no colour.
    add("transparent grey".to_owned(), Png::new(GREY, 8).with(b"tRNS", vec![0, 7]));
    add("transparent colour".to_owned(), Png::new(RGB, 8).with(b"tRNS", vec![0, 1, 0, 2, 0, 3]));
    add("transparent colour of 16 bits".to_owned(), Png::new(RGB, 16).with(b"tRNS", vec![0, 1, 0, 2, 0, 3]));
    add("transparent palette".to_owned(), Png::new(PALETTE, 4).with(b"tRNS", vec![0, 128, 255]));
    add("background".to_owned(), Png::new(RGB_ALPHA, 8).with(b"bKGD", vec![0, 200, 0, 100, 0, 50]));
    for (kind, data) in [
        (b"pHYs", vec![0, 0, 0, 4, 0, 0, 0, 1, 0]),
        (b"tIME", vec![7, 208, 1, 1, 12, 34, 56]),
        (b"tEXt", b"Title\0odd".to_vec()),
        (b"sBIT", vec![5, 5, 5]),
        (b"sPLT", [b"name\0\x08".as_slice(), &[1, 2, 3, 4, 0, 5]].concat()),
        (b"prVt", vec![1, 2, 3]),
        (b"gAMA", 45_455u32.to_be_bytes().to_vec()),
        (b"sRGB", vec![0]),
    ] {
        add(format!("chunk {}", String::from_utf8_lossy(kind)), Png::new(RGB, 8).with(kind, data));
    }
    for gamma in [35_000u32, 55_556, 100_000] {
        let png = Png::new(RGB, 8).with(b"gAMA", gamma.to_be_bytes().to_vec());
        let light = |code: f32| (code / 255.0).powf(100_000.0 / gamma as f32);
        let right = Right::Light(codes(8).iter().map(|pixel| pixel.map(light)).collect(), 1e-3);
        kinds.push(Kind::new(format!("gamma {gamma}"), png.written(), right));
    }
    let short = |index: usize| if index < 3 { palette(16)[index].map(f32::from) } else { [0.0; 3] };
    let right = Right::Codes(pixels(|x, y| short(index(x, y, 4, 16))), 0.51);
    kinds.push(Kind::new("indices beyond the palette", beyond(), right));
    kinds.extend(damaged());
    kinds
}

/// Files that are wrong in one place each.
fn damaged() -> Vec<Kind> {
    let good = Png::new(RGB, 8).written();
    let changed = |place: usize, byte: u8| {
        let mut file = good.clone();
        file[place] = byte;
        file
    };
    // A new header with its checksum.
    let header = |place: usize, value: u8| {
        let mut data = good[16..29].to_vec();
        data[place] = value;
        [&good[..8], &chunk(b"IHDR", &data), &good[33..]].concat()
    };
    let data = good.windows(4).position(|bytes| bytes == b"IDAT").unwrap();
    let end = good.len() - 12;
    let no_palette = Png { palette: Vec::new(), ..Png::new(PALETTE, 4) };
    let files = [
        ("without its first byte", good[1..].to_vec()),
        ("line ends changed", changed(4, b'\n')),
        ("checksum of the header", changed(30, good[30] ^ 1)),
        ("checksum of the data", changed(end - 1, good[end - 1] ^ 1)),
        ("a byte of the data", changed(data + 40, good[data + 40] ^ 1)),
        ("colour type 1", header(9, 1)),
        ("colour type 9", header(9, 9)),
        ("0 bits", header(8, 0)),
        ("99 bits", header(8, 99)),
        ("interlace method 2", header(12, 2)),
        ("no data", [&good[..data - 4], &good[end..]].concat()),
        ("half of the data", [&good[..data - 4], &chunk(b"IDAT", &good[data + 4..data + 100]), &good[end..]].concat()),
        ("no palette", no_palette.written()),
    ];
    files.into_iter().map(|(name, file)| Kind::new(name, file, Right::Refused)).collect()
}

/// Indices of four bits and a palette of three colours.
fn beyond() -> Vec<u8> {
    let whole = Png::new(PALETTE, 4);
    let (file, long, short) =
        (whole.written(), chunk(b"PLTE", palette(16).as_flattened()), chunk(b"PLTE", palette(3).as_flattened()));
    let place = file.windows(long.len()).position(|bytes| bytes == long).unwrap();
    [&file[..place], &short, &file[place + long.len()..]].concat()
}
