//! Windows and OS/2 bitmaps: the kinds of the BMP suite.

use super::*;

/// A bitmap before it is written.
struct Bitmap {
    /// 12 and 64 for OS/2, 40 and more for Windows.
    header: u32,
    bits: u32,
    compression: u32,
    /// Of red, green, blue and alpha.
    masks: Option<[u32; 4]>,
    palette: Vec<[u8; 3]>,
    /// What the header says of the palette's length.
    colours: u32,
    top_down: bool,
    /// Bytes between the palette and the pixels.
    gap: usize,
    data: Vec<u8>,
}

impl Bitmap {
    fn new(bits: u32, data: Vec<u8>) -> Self {
        let palette = Vec::new();
        Self { header: 40, bits, compression: 0, masks: None, palette, colours: 0, top_down: false, gap: 0, data }
    }

    fn of_palette(bits: u32, palette: &[[u8; 3]], data: Vec<u8>) -> Self {
        Self { palette: palette.to_vec(), colours: palette.len() as u32, ..Self::new(bits, data) }
    }

    fn written(&self) -> Vec<u8> {
        let mut header = Vec::new();
        let numbers = |header: &mut Vec<u8>, numbers: &[u32]| {
            numbers.iter().for_each(|number| header.extend(number.to_le_bytes()));
        };
        numbers(&mut header, &[self.header]);
        if self.header == 12 {
            numbers(&mut header, &[WIDTH as u32 | (HEIGHT as u32) << 16, 1 | self.bits << 16]);
        } else {
            let height = if self.top_down { (HEIGHT as u32).wrapping_neg() } else { HEIGHT as u32 };
            numbers(&mut header, &[WIDTH as u32, height, 1 | self.bits << 16, self.compression]);
            numbers(&mut header, &[self.data.len() as u32, 2835, 2835, self.colours, 0]);
            if self.header >= 52 && self.header != 64 {
                numbers(&mut header, &self.masks.unwrap_or_default());
            }
            let end = self.header as usize;
            match self.masks {
                Some(masks) if self.header == 40 => {
                    numbers(&mut header, &masks[..if self.compression == 6 { 4 } else { 3 }]);
                }
                _ => header.resize(end, 0),
            }
            if self.header >= 108 {
                header[56..60].copy_from_slice(b"BGRs");
            }
        }
        let entry = |&[red, green, blue]: &[u8; 3]| match self.header {
            12 => vec![blue, green, red],
            _ => vec![blue, green, red, 0],
        };
        header.extend(self.palette.iter().flat_map(entry));
        header.resize(header.len() + self.gap, 0);
        let start = 14 + header.len() as u32;
        let mut file = b"BM".to_vec();
        numbers(&mut file, &[start + self.data.len() as u32, 0, start]);
        [file, header, self.data.clone()].concat()
    }
}

/// Rows from the bottom up, each filled to four bytes.
fn rows(row: impl Fn(usize) -> Vec<u8>) -> Vec<u8> {
    let filled = |y: usize| {
        let mut row = row(y);
        row.resize(row.len().next_multiple_of(4), 0);
        row
    };
    (0..HEIGHT).rev().flat_map(filled).collect()
}

fn indices(bits: u32, count: usize) -> Vec<u8> {
    rows(|y| packed_row(bits, (0..WIDTH).map(|x| index(x, y, bits, count) as u64)))
}

/// Pixels of 16 or 32 bits with the channels at masks.
fn masked(bytes: usize, masks: [u32; 4]) -> Vec<u8> {
    let pixel = |x: usize, y: usize| {
        let part = |(channel, mask): (usize, &u32)| match mask {
            0 => 0,
            mask => (sample(x, y, channel, mask.count_ones()) as u32) << mask.trailing_zeros(),
        };
        masks.iter().enumerate().map(part).fold(0, |a, b| a | b)
    };
    rows(|y| (0..WIDTH).flat_map(|x| pixel(x, y).to_le_bytes()[..bytes].to_vec()).collect())
}

fn codes_of_masks(masks: [u32; 4]) -> Vec<[f32; 3]> {
    pixels(|x, y| {
        [0, 1, 2].map(|channel| match masks[channel].count_ones() {
            0 => 0.0,
            bits => code(sample(x, y, channel, bits), bits),
        })
    })
}

/// Run lengths of 8 bits: a run, a literal, and the end of each row.
fn runs8(indices: impl Fn(usize, usize) -> usize) -> Vec<u8> {
    let mut data = Vec::new();
    for y in (0..HEIGHT).rev() {
        data.extend([1, indices(0, y) as u8, 0, (WIDTH - 1) as u8]);
        data.extend((1..WIDTH).map(|x| indices(x, y) as u8));
        data.extend([0, 0]);
    }
    data.extend([0, 1]);
    data
}

fn runs4(indices: impl Fn(usize, usize) -> usize) -> Vec<u8> {
    let mut data = Vec::new();
    for y in (0..HEIGHT).rev() {
        data.extend([1, (indices(0, y) << 4) as u8, 0, (WIDTH - 1) as u8]);
        let literal = packed_row(4, (1..WIDTH).map(|x| indices(x, y) as u64));
        data.extend(&literal);
        data.resize(data.len() + literal.len() % 2, 0);
        data.extend([0, 0]);
    }
    data.extend([0, 1]);
    data
}

/// Every kind of bitmap.
pub fn kinds() -> Vec<Kind> {
    let mut kinds = Vec::new();
    let mut add = |name: &str, bitmap: Bitmap, right: Right| kinds.push(Kind::new(name, bitmap.written(), right));
    let exact = |codes| Right::Codes(codes, 0.51);
    let near = |codes| Right::Codes(codes, 1.01);
    for bits in [1, 2, 4, 8] {
        let full = palette(1 << bits);
        let data = indices(bits, full.len());
        add(
            &format!("palette of {bits} bits"),
            Bitmap::of_palette(bits, &full, data.clone()),
            exact(of_palette(bits, &full)),
        );
        let unsaid = Bitmap { colours: 0, ..Bitmap::of_palette(bits, &full, data.clone()) };
        add(&format!("palette of {bits} bits, length not said"), unsaid, exact(of_palette(bits, &full)));
        if bits != 2 {
            let old = Bitmap { header: 12, ..Bitmap::of_palette(bits, &full, data) };
            add(&format!("palette of {bits} bits, OS/2"), old, exact(of_palette(bits, &full)));
        }
    }
    let some = palette(11);
    let eight = || Bitmap::of_palette(8, &some, indices(8, 11));
    let shown = || exact(of_palette(8, &some));
    add("palette of 11 colours", eight(), shown());
    add("one colour", Bitmap::of_palette(1, &some[..1], indices(1, 1)), exact(of_palette(1, &some[..1])));
    add("from the top down", top_down(Bitmap { top_down: true, ..eight() }), shown());
    for header in [52, 56, 64, 108, 124] {
        add(&format!("header of {header} bytes"), Bitmap { header, ..eight() }, shown());
    }
    add("a gap before the pixels", Bitmap { gap: 100, ..eight() }, shown());
    let long = palette(300);
    let oversized = Bitmap { palette: long.clone(), colours: 300, ..Bitmap::new(8, indices(8, 256)) };
    add("palette of 300 colours", oversized, exact(of_palette(8, &long[..256])));
    let missing = Bitmap { compression: 0, ..Bitmap::of_palette(8, &some[..4], indices(8, 11)) };
    let short = |index: usize| if index < 4 { some[index].map(f32::from) } else { [0.0; 3] };
    add("indices beyond the palette", missing, exact(pixels(|x, y| short(index(x, y, 8, 11)))));

    let at = |bits| move |x: usize, y: usize| index(x, y, bits, 11);
    let compressed = |bits, compression, data| Bitmap { compression, ..Bitmap::of_palette(bits, &some, data) };
    add("run lengths of 8 bits", compressed(8, 1, runs8(at(8))), shown());
    add("run lengths of 4 bits", compressed(4, 2, runs4(at(4))), exact(of_palette(4, &some)));
    let skipping = [2, 3, 0, 2, 3, 1, 5, 4, 0, 1];
    // Two pixels of colour 3, then 3 to the right and 1 up, five of colour 4; what is skipped is black.
    let skipped = pixels(|x, y| match (HEIGHT - 1 - y, x) {
        (0, 0..2) => some[3].map(f32::from),
        (1, 5..10) => some[4].map(f32::from),
        _ => [0.0; 3],
    });
    add("run lengths that skip pixels", compressed(8, 1, skipping.to_vec()), exact(skipped));
    let cut = runs8(at(8))[..40].to_vec();
    add("run lengths cut off", compressed(8, 1, cut), Right::Refused);
    let runs24 = Bitmap { header: 64, compression: 4, ..Bitmap::new(24, vec![1, 2, 3, 4, 0, 0, 0, 1]) };
    add("run lengths of 24 bits", runs24, Right::Refused);
    add("JPEG inside", Bitmap { compression: 4, ..Bitmap::new(0, vec![0; 64]) }, Right::Refused);
    add("PNG inside", Bitmap { compression: 5, ..Bitmap::new(0, vec![0; 64]) }, Right::Refused);
    let huffman = Bitmap { header: 64, compression: 3, ..Bitmap::of_palette(1, &some[..2], vec![0; 64]) };
    add("fax codes, OS/2", huffman, Right::Refused);

    let colours = |bytes: usize| {
        rows(|y| (0..WIDTH).flat_map(|x| [2, 1, 0, 3].map(|c| sample(x, y, c, 8) as u8)[..bytes].to_vec()).collect())
    };
    add("24 bits", Bitmap::new(24, colours(3)), exact(codes(8)));
    add("24 bits, OS/2", Bitmap { header: 12, ..Bitmap::new(24, colours(3)) }, exact(codes(8)));
    let with_palette = Bitmap { palette: some.clone(), colours: 11, ..Bitmap::new(24, colours(3)) };
    add("24 bits and a palette", with_palette, exact(codes(8)));
    add("32 bits", Bitmap::new(32, colours(4)), exact(codes(8)));
    add("64 bits", Bitmap::new(64, vec![0; 8 * WIDTH * HEIGHT]), Right::Refused);
    let x555 = [0x7C00, 0x3E0, 0x1F, 0];
    add("16 bits", Bitmap::new(16, masked(2, x555)), near(codes_of_masks(x555)));
    for (bytes, masks) in [
        (2, x555),
        (2, [0xF800, 0x7E0, 0x1F, 0]),
        (2, [0xC0, 0x38, 0x07, 0]),
        (2, [0xF00, 0xF0, 0x0F, 0xF000]),
        (4, [0xFF_0000, 0xFF00, 0xFF, 0]),
        (4, [0xFF00_0000, 0xFF_0000, 0xFF00, 0]),
        (4, [0xFF_0000, 0xFF00, 0xFF, 0xFF00_0000]),
        (4, [0x7F00_0000, 0x1, 0x1FE0_0000 >> 8, 0]),
        (4, [0x3FF0_0000, 0xF_FC00, 0x3FF, 0xC000_0000]),
    ] {
        let bits = 8 * bytes as u32;
        let fields = Bitmap { compression: 3, masks: Some(masks), ..Bitmap::new(bits, masked(bytes, masks)) };
        let name = format!("masks {masks:x?}");
        if masks[3] == 0 {
            add(&name, fields, near(codes_of_masks(masks)));
        } else {
            add(&name, Bitmap { header: 124, ..fields }, near(codes_of_masks(masks)));
            let short = Bitmap { compression: 6, masks: Some(masks), ..Bitmap::new(bits, masked(bytes, masks)) };
            add(&format!("{name}, alpha in a short header"), short, near(codes_of_masks(masks)));
        }
    }
    let gaps = [0xF0F0, 0xF00, 0x0F, 0];
    let fields = Bitmap { compression: 3, masks: Some(gaps), ..Bitmap::new(16, vec![0; 28 * HEIGHT]) };
    add(&format!("masks {gaps:x?}"), fields, Right::Refused);
    kinds
}

/// The same bitmap with its rows in the other order.
fn top_down(bitmap: Bitmap) -> Bitmap {
    let length = bitmap.data.len() / HEIGHT;
    let data = bitmap.data.chunks(length).rev().flatten().copied().collect();
    Bitmap { data, ..bitmap }
}
