//! Small picture files of every kind, written here byte by byte or by a codec of another crate, each with what it shows.
#![allow(dead_code)] // Every test uses a part of it.

pub mod bmp;
pub mod exr;
pub mod png;
pub mod tga;
pub mod tiff;
pub mod webp;

/// The size of all pictures: odd, so that rows end within a byte.
pub const WIDTH: usize = 13;
pub const HEIGHT: usize = 9;

/// A file and what is right.
pub struct Kind {
    pub name: String,
    pub file: Vec<u8>,
    pub right: Right,
}

/// What a reader should make of a file.
pub enum Right {
    /// Codes of sRGB from 0 to 255, and by how many a reader may differ.
    Codes(Vec<[f32; 3]>, f32),
    /// Linear light, and the relative difference that is allowed.
    Light(Vec<[f32; 3]>, f32),
    /// An error.
    Refused,
}

impl Kind {
    pub fn new(name: impl Into<String>, file: Vec<u8>, right: Right) -> Self {
        Self { name: name.into(), file, right }
    }
}

/// The numbers of the test picture: no two pixels, rows or channels are alike.
pub fn sample(x: usize, y: usize, channel: usize, bits: u32) -> u64 {
    let mixed = ((x as u64 + 1) * 0x9E37_79B9) ^ ((y as u64 + 1) * 0x85EB_CA6B) ^ ((channel as u64 + 1) * 0xC2B2_AE35);
    let wide = mixed.wrapping_mul(0xD6E8_FEB8_6659_FD93);
    (wide ^ wide >> 32).wrapping_mul(0xD6E8_FEB8_6659_FD93) >> (64 - bits)
}

/// A number of so many bits as a code of 8.
pub fn code(value: u64, bits: u32) -> f32 {
    (value as f64 * 255.0 / ((1u128 << bits) - 1) as f64) as f32
}

/// A value for each pixel, row by row from the top.
pub fn pixels<T>(mut value: impl FnMut(usize, usize) -> T) -> Vec<T> {
    (0..HEIGHT).flat_map(|y| (0..WIDTH).map(move |x| (x, y))).map(|(x, y)| value(x, y)).collect()
}

/// What a file of so many bits a channel shows.
pub fn codes(bits: u32) -> Vec<[f32; 3]> {
    pixels(|x, y| [0, 1, 2].map(|channel| code(sample(x, y, channel, bits), bits)))
}

/// The same for a grey one.
pub fn greys(bits: u32) -> Vec<[f32; 3]> {
    pixels(|x, y| [code(sample(x, y, 0, bits), bits); 3])
}

/// A palette of so many colours.
pub fn palette(count: usize) -> Vec<[u8; 3]> {
    (0..count).map(|index| [0, 1, 2].map(|channel| sample(index, 77, channel, 8) as u8)).collect()
}

/// What a file of indices shows.
pub fn of_palette(bits: u32, palette: &[[u8; 3]]) -> Vec<[f32; 3]> {
    pixels(|x, y| palette[index(x, y, bits, palette.len())].map(f32::from))
}

/// The index of a pixel into a palette.
pub fn index(x: usize, y: usize, bits: u32, count: usize) -> usize {
    sample(x, y, 0, bits) as usize % count.max(1)
}

/// Numbers packed from the highest bit on, filled to a whole count of bytes.
#[derive(Default)]
pub struct BitWriter {
    pub bytes: Vec<u8>,
    count: u32,
}

impl BitWriter {
    pub fn put(&mut self, value: u64, bits: u32) {
        for bit in (0..bits).rev() {
            if self.count.is_multiple_of(8) {
                self.bytes.push(0);
            }
            *self.bytes.last_mut().unwrap() |= ((value >> bit & 1) as u8) << (7 - self.count % 8);
            self.count += 1;
        }
    }

    /// Begins a byte.
    pub fn align(&mut self) {
        self.count = self.count.next_multiple_of(8);
    }

    /// Bits written out: `"0011"`.
    pub fn put_text(&mut self, text: &str) {
        text.bytes().filter(|byte| *byte != b' ').for_each(|byte| self.put(u64::from(byte - b'0'), 1));
    }
}

/// A row of numbers of so many bits, whole bytes.
pub fn packed_row(bits: u32, values: impl Iterator<Item = u64>) -> Vec<u8> {
    let mut writer = BitWriter::default();
    values.for_each(|value| writer.put(value, bits));
    writer.bytes
}

/// A zlib stream of stored blocks (RFC 1950 and 1951).
pub fn zlib(bytes: &[u8]) -> Vec<u8> {
    let mut stream = vec![0x78, 0x01];
    let blocks: Vec<&[u8]> = bytes.chunks(60_000).collect();
    for (number, block) in blocks.iter().enumerate() {
        stream.push(u8::from(number + 1 == blocks.len()));
        stream.extend((block.len() as u16).to_le_bytes());
        stream.extend((!(block.len() as u16)).to_le_bytes());
        stream.extend(*block);
    }
    let (mut a, mut b) = (1u32, 0u32);
    for &byte in bytes {
        a = (a + u32::from(byte)) % 65_521;
        b = (b + a) % 65_521;
    }
    stream.extend((b << 16 | a).to_be_bytes());
    stream
}
