//! TIFF pictures: the kinds of libtiff's test pictures.

use super::*;

/// How samples are meant (tag 339).
const UNSIGNED: u16 = 1;
const SIGNED: u16 = 2;
const FLOAT: u16 = 3;

/// A picture before it is written.
#[derive(Clone)]
struct Tiff {
    big_endian: bool,
    /// BigTIFF: places of 64 bits.
    big: bool,
    bits: u32,
    samples: u32,
    /// 0 white is zero, 1 black is zero, 2 RGB, 3 palette, 5 CMYK, 6 YCbCr, 8 Lab.
    photometric: u16,
    format: u16,
    compression: u16,
    predictor: u16,
    planar: bool,
    /// The side of tiles; `None` for strips.
    tile: Option<usize>,
    rows_per_strip: usize,
    palette: Vec<[u8; 3]>,
    /// Further tags of short numbers.
    tags: Vec<(u16, Vec<u64>)>,
    /// A second picture behind the first.
    second: bool,
    /// Replaces the coded pixels.
    data: Option<Vec<u8>>,
}

impl Tiff {
    fn new(photometric: u16, samples: u32, bits: u32) -> Self {
        Self {
            big_endian: false,
            big: false,
            bits,
            samples,
            photometric,
            format: UNSIGNED,
            compression: 1,
            predictor: 1,
            planar: false,
            tile: None,
            rows_per_strip: HEIGHT,
            palette: Vec::new(),
            tags: Vec::new(),
            second: false,
            data: None,
        }
    }

    fn value(&self, x: usize, y: usize, channel: usize) -> u64 {
        let (x, y) = (x.min(WIDTH - 1), y.min(HEIGHT - 1));
        match (self.format, self.bits) {
            (FLOAT, 16) => u64::from(half(light(x, y, channel))),
            (FLOAT, 32) => u64::from(light(x, y, channel).to_bits()),
            (FLOAT, 64) => f64::from(light(x, y, channel)).to_bits(),
            _ if self.photometric == 3 => index(x, y, self.bits, self.palette.len()) as u64,
            _ if self.photometric == 0 => !sample(x, y, channel, self.bits) & (u64::MAX >> (64 - self.bits)),
            _ => sample(x, y, channel, self.bits),
        }
    }

    /// Rows of a rectangle of pixels, of some channels.
    fn block(
        &self,
        columns: std::ops::Range<usize>,
        rows: std::ops::Range<usize>,
        channels: std::ops::Range<usize>,
    ) -> Vec<u8> {
        let row = |y: usize| {
            let places = columns.clone().flat_map(|x| channels.clone().map(move |channel| (x, channel)));
            let mut values: Vec<u64> = places.map(|(x, channel)| self.value(x, y, channel)).collect();
            let distance = channels.len();
            if self.predictor == 2 {
                for place in (distance..values.len()).rev() {
                    values[place] =
                        values[place].wrapping_sub(values[place - distance]) & (u64::MAX >> (64 - self.bits));
                }
            }
            if self.predictor == 3 {
                return float_differences(&values, distance, self.bits as usize / 8);
            }
            match self.bits {
                16 | 32 | 64 => values.iter().flat_map(|&value| self.number(value, self.bits / 8)).collect(),
                bits => packed_row(bits, values.into_iter()),
            }
        };
        self.compressed(&rows.map(row).collect::<Vec<_>>())
    }

    fn compressed(&self, rows: &[Vec<u8>]) -> Vec<u8> {
        match self.compression {
            5 => lzw(&rows.concat()),
            8 | 32946 => zlib(&rows.concat()),
            32773 => rows.iter().flat_map(|row| pack_bits(row)).collect(),
            _ => rows.concat(),
        }
    }

    /// A number of so many bytes in the order of the file.
    fn number(&self, value: u64, bytes: u32) -> Vec<u8> {
        let little = &value.to_le_bytes()[..bytes as usize];
        if self.big_endian { little.iter().rev().copied().collect() } else { little.to_vec() }
    }

    fn blocks(&self) -> Vec<Vec<u8>> {
        if let Some(data) = &self.data {
            return vec![data.clone()];
        }
        let planes: Vec<std::ops::Range<usize>> = match self.planar {
            true => (0..self.samples as usize).map(|channel| channel..channel + 1).collect(),
            false => std::iter::once(0..self.samples as usize).collect(),
        };
        let places: Vec<(std::ops::Range<usize>, std::ops::Range<usize>)> = match self.tile {
            Some(side) => (0..HEIGHT.div_ceil(side))
                .flat_map(|row| (0..WIDTH.div_ceil(side)).map(move |column| (column * side, row * side)))
                .map(|(x, y)| (x..x + side, y..y + side))
                .collect(),
            None => (0..HEIGHT)
                .step_by(self.rows_per_strip)
                .map(|y| (0..WIDTH, y..(y + self.rows_per_strip).min(HEIGHT)))
                .collect(),
        };
        let block = |plane: &std::ops::Range<usize>| {
            places
                .iter()
                .map(|(columns, rows)| self.block(columns.clone(), rows.clone(), plane.clone()))
                .collect::<Vec<_>>()
        };
        planes.iter().flat_map(block).collect()
    }

    fn written(&self) -> Vec<u8> {
        let (place, count) = if self.big { (8, 8) } else { (4, 2) };
        let start = if self.big { 16 } else { 8 };
        let blocks = self.blocks();
        let lengths: Vec<u64> = blocks.iter().map(|block| block.len() as u64).collect();
        let mut offsets = vec![start];
        lengths.iter().for_each(|length| offsets.push(offsets.last().unwrap() + length));
        let end = offsets.pop().unwrap();
        let (first, longs) = if self.tile.is_some() { (324, 4) } else { (273, 4) };
        // Tag, kind (3 short, 4 long), numbers.
        let mut entries: Vec<(u16, u16, Vec<u64>)> = vec![
            (256, 3, vec![WIDTH as u64]),
            (257, 3, vec![HEIGHT as u64]),
            (258, 3, vec![self.bits.into(); self.samples as usize]),
            (259, 3, vec![self.compression.into()]),
            (262, 3, vec![self.photometric.into()]),
            (277, 3, vec![self.samples.into()]),
            (284, 3, vec![1 + u64::from(self.planar)]),
            (317, 3, vec![self.predictor.into()]),
            (339, 3, vec![self.format.into(); self.samples as usize]),
            (first, longs, offsets),
            (if self.tile.is_some() { 325 } else { 279 }, 4, lengths),
        ];
        match self.tile {
            Some(side) => entries.extend([(322, 3, vec![side as u64]), (323, 3, vec![side as u64])]),
            None => entries.push((278, 3, vec![self.rows_per_strip as u64])),
        }
        if !self.palette.is_empty() {
            let wide = |channel: usize| self.palette.iter().map(move |colour| u64::from(colour[channel]) * 257);
            entries.push((320, 3, [0, 1, 2].into_iter().flat_map(wide).collect()));
        }
        if self.samples == 4 && self.photometric == 2 || self.samples == 2 {
            entries.push((338, 3, vec![2]));
        }
        entries.extend(self.tags.iter().map(|(tag, values)| (*tag, 3, values.clone())));
        entries.sort_by_key(|entry| entry.0);

        let mut file = match (self.big_endian, self.big) {
            (false, false) => b"II*\0".to_vec(),
            (true, false) => b"MM\0*".to_vec(),
            (false, true) => b"II+\0\x08\0\0\0".to_vec(),
            (true, true) => b"MM\0+\0\x08\0\0".to_vec(),
        };
        let directory = end.next_multiple_of(2);
        file.extend(self.number(directory, place));
        file.extend(blocks.concat());
        file.resize(directory as usize, 0);
        let size = count + entries.len() as u64 as u32 * if self.big { 20 } else { 12 } + place;
        let mut behind = Vec::new();
        file.extend(self.number(entries.len() as u64, count));
        for (tag, kind, values) in &entries {
            let bytes: Vec<u8> =
                values.iter().flat_map(|&value| self.number(value, if *kind == 3 { 2 } else { 4 })).collect();
            file.extend(self.number((*tag).into(), 2));
            file.extend(self.number((*kind).into(), 2));
            file.extend(self.number(values.len() as u64, place));
            if bytes.len() <= place as usize {
                file.extend(&bytes);
                file.resize(file.len() + place as usize - bytes.len(), 0);
            } else {
                file.extend(self.number(directory + u64::from(size) + behind.len() as u64, place));
                behind.extend(bytes);
            }
        }
        let first = file[directory as usize..].to_vec();
        let next = if self.second { directory + u64::from(size) + behind.len() as u64 } else { 0 };
        file.extend(self.number(next, place));
        file.extend(behind);
        if self.second {
            // The same picture once more.
            file.extend(first);
            file.extend(self.number(0, place));
        }
        file
    }

    fn shown(&self) -> Right {
        let tolerance = if self.bits >= 16 { 0.02 } else { 0.51 };
        match self.photometric {
            _ if self.format == FLOAT && self.samples < 3 => Right::Light(pixels(|x, y| [light(x, y, 0); 3]), 1e-3),
            _ if self.format == FLOAT => {
                Right::Light(pixels(|x, y| [0, 1, 2].map(|channel| light(x, y, channel))), 1e-3)
            }
            3 => Right::Codes(of_palette(self.bits, &self.palette), 0.51),
            0 | 1 => Right::Codes(greys(self.bits), tolerance),
            5 => Right::Codes(
                pixels(|x, y| {
                    let ink = |channel| 1.0 - code(sample(x, y, channel, self.bits), self.bits) / 255.0;
                    [0, 1, 2].map(|channel| 255.0 * ink(channel) * ink(3))
                }),
                1.01,
            ),
            _ => Right::Codes(codes(self.bits), tolerance),
        }
    }
}

/// Floats of a wide range.
fn light(x: usize, y: usize, channel: usize) -> f32 {
    sample(x, y, channel, 10) as f32 / 64.0
}

/// A number as half precision; exact for [`light`].
fn half(value: f32) -> u16 {
    if value == 0.0 {
        return 0;
    }
    let bits = value.to_bits();
    (((bits >> 23) as i32 - 112) as u16) << 10 | (bits >> 13 & 0x3FF) as u16
}

/// Predictor 3: the bytes of a row sorted by their weight, each as a difference from the one before.
fn float_differences(values: &[u64], distance: usize, bytes: usize) -> Vec<u8> {
    let byte = |weight: usize| values.iter().map(move |value| (value >> (8 * (bytes - 1 - weight))) as u8);
    let mut sorted: Vec<u8> = (0..bytes).flat_map(byte).collect();
    for place in (distance..sorted.len()).rev() {
        sorted[place] = sorted[place].wrapping_sub(sorted[place - distance]);
    }
    sorted
}

/// LZW without a code longer than 9 bits: the table begins anew before it needs them.
fn lzw(bytes: &[u8]) -> Vec<u8> {
    let mut writer = BitWriter::default();
    for part in bytes.chunks(200) {
        writer.put(256, 9);
        part.iter().for_each(|&byte| writer.put(byte.into(), 9));
    }
    writer.put(257, 9);
    writer.bytes
}

fn pack_bits(row: &[u8]) -> Vec<u8> {
    row.chunks(100).flat_map(|part| [&[part.len() as u8 - 1], part].concat()).collect()
}

/// Six white pixels and seven black ones in every row, as fax machines send them (ITU-T T.4 and T.6).
fn fax(compression: u16) -> Vec<u8> {
    let mut writer = BitWriter::default();
    for row in 0..HEIGHT {
        match compression {
            4 if row > 0 => writer.put_text("1 1"),
            4 => writer.put_text("001 1110 00011"),
            3 => writer.put_text("000000000001 1110 00011"),
            _ => {
                writer.align();
                writer.put_text("1110 00011");
            }
        }
    }
    if compression == 4 {
        writer.put_text("000000000001 000000000001");
    }
    writer.bytes
}

fn with_palette(bits: u32) -> Tiff {
    Tiff { palette: palette(1 << bits), ..Tiff::new(3, 1, bits) }
}

/// Every kind of picture.
pub fn kinds() -> Vec<Kind> {
    let mut kinds = Vec::new();
    let mut add = |name: &str, tiff: &Tiff| kinds.push(Kind::new(name, tiff.written(), tiff.shown()));
    for big_endian in [false, true] {
        let order = if big_endian { "big endian" } else { "little endian" };
        let all: &[u32] = if big_endian { &[8, 16] } else { &[1, 2, 4, 6, 8, 10, 12, 14, 16, 24, 32, 64] };
        for &bits in all {
            for (photometric, samples, name) in [(0, 1, "white is zero"), (1, 1, "black is zero"), (2, 3, "RGB")] {
                add(
                    &format!("{name}, {bits} bits, {order}"),
                    &Tiff { big_endian, ..Tiff::new(photometric, samples, bits) },
                );
            }
        }
        for bits in [8, 16] {
            for (photometric, samples, name) in [(1, 2, "grey and alpha"), (2, 4, "RGBA"), (5, 4, "CMYK")] {
                let tiff = Tiff { big_endian, ..Tiff::new(photometric, samples, bits) };
                add(&format!("{name}, {bits} bits, {order}"), &tiff);
                add(&format!("{name}, {bits} bits, planes, {order}"), &Tiff { planar: true, ..tiff });
            }
            let planes = Tiff { big_endian, planar: true, ..Tiff::new(2, 3, bits) };
            add(&format!("RGB, {bits} bits, planes, {order}"), &planes);
        }
        for bits in [1, 2, 4, 8] {
            add(&format!("palette of {bits} bits, {order}"), &Tiff { big_endian, ..with_palette(bits) });
        }
        for bits in [16, 32, 64] {
            for (photometric, samples) in [(1, 1), (2, 3)] {
                let tiff = Tiff { big_endian, format: FLOAT, ..Tiff::new(photometric, samples, bits) };
                add(&format!("{samples} floats of {bits} bits, {order}"), &tiff);
            }
        }
        for bits in [8, 16] {
            add(&format!("BigTIFF, {bits} bits, {order}"), &Tiff { big_endian, big: true, ..Tiff::new(2, 3, bits) });
            for compression in [5, 8, 32946, 32773] {
                for predictor in [1, 2] {
                    let tiff = Tiff { big_endian, compression, predictor, ..Tiff::new(2, 3, bits) };
                    add(&format!("compression {compression}, predictor {predictor}, {bits} bits, {order}"), &tiff);
                }
            }
        }
        let floats = Tiff { big_endian, compression: 8, predictor: 3, format: FLOAT, ..Tiff::new(2, 3, 32) };
        add(&format!("floats, predictor 3, {order}"), &floats);
    }
    for (photometric, samples, bits) in [(1, 1, 1), (1, 1, 8), (2, 3, 8), (2, 3, 16), (2, 4, 8)] {
        let tiff = Tiff::new(photometric, samples, bits);
        add(&format!("{samples} of {bits} bits, strips of 2 rows"), &Tiff { rows_per_strip: 2, ..tiff.clone() });
        add(&format!("{samples} of {bits} bits, tiles"), &Tiff { tile: Some(16), ..tiff.clone() });
        add(&format!("{samples} of {bits} bits, tiles, planes"), &Tiff { tile: Some(16), planar: samples > 1, ..tiff });
    }
    add("a second picture", &Tiff { second: true, ..Tiff::new(2, 3, 8) });
    for (compression, name) in [(2, "fax, T.4 without markers"), (3, "fax, T.4"), (4, "fax, T.6")] {
        let tiff = Tiff { compression, data: Some(fax(compression)), ..Tiff::new(0, 1, 1) };
        let shown = pixels(|x, _| [if x < 6 { 255.0 } else { 0.0 }; 3]);
        kinds.push(Kind::new(name, tiff.written(), Right::Codes(shown, 0.51)));
    }
    for (name, tiff) in [
        ("signed numbers", Tiff { format: SIGNED, ..Tiff::new(2, 3, 8) }),
        ("Lab", Tiff::new(8, 3, 8)),
        ("YCbCr", Tiff { tags: vec![(530, vec![1, 1])], ..Tiff::new(6, 3, 8) }),
        ("LogLuv", Tiff { compression: 34676, ..Tiff::new(32845, 3, 16) }),
        ("old JPEG", Tiff { compression: 6, ..Tiff::new(6, 3, 8) }),
        ("JPEG 2000", Tiff { compression: 34712, ..Tiff::new(2, 3, 8) }),
        ("NeXT", Tiff { compression: 32766, ..Tiff::new(1, 1, 2) }),
        ("ThunderScan", Tiff { compression: 32809, ..Tiff::new(1, 1, 4) }),
        ("PixarLog", Tiff { compression: 32909, ..Tiff::new(2, 3, 8) }),
        ("bits from the lowest on", Tiff { tags: vec![(266, vec![2])], ..Tiff::new(2, 3, 8) }),
    ] {
        kinds.push(Kind::new(name, tiff.written(), Right::Refused));
    }
    kinds
}
