//! The formats that students write by hand: PBM, PGM, PPM (Netpbm, P1 to P6) and PFM (floats).

use super::header::{check_size, damaged};
use super::{Decoded, Format, Header, Samples};
use crate::error::{Error, Result};

/// What stands before the pixels.
struct Start<'a> {
    header: Header,
    /// The digit behind `P`, or `F` and `f` of PFM.
    kind: u8,
    channels: usize,
    /// The number that stands for white; for PFM the scale, below 0 for the order of small processors.
    most: f64,
    rest: &'a [u8],
}

pub fn read_header(encoded: &[u8]) -> Result<Header> {
    start(encoded).map(|start| start.header)
}

pub fn decode(encoded: &[u8]) -> Result<Decoded> {
    let start = start(encoded)?;
    let Header { width, height, .. } = start.header;
    let count = width * height * start.channels;
    let samples = match start.kind {
        b'F' | b'f' => Samples::Floats(start.channels, floats(&start, count)?),
        _ => {
            let numbers = match start.kind {
                b'1' => digits(start.rest, count),
                b'2' | b'3' => plain(start.rest, count, start.header.format)?,
                b'4' => bits(start.rest, width, height),
                _ if start.most > 255.0 => {
                    start.rest.as_chunks().0.iter().map(|&pair| u16::from_be_bytes(pair)).collect()
                }
                _ => start.rest.iter().map(|&byte| u16::from(byte)).collect(),
            };
            let numbers = enough(numbers, count, start.header.format)?;
            if let Some(beyond) = numbers.iter().find(|&&number| f64::from(number) > start.most) {
                let problem = format!("it has the number {beyond}, but says that {} is white", start.most);
                return Err(damaged(start.header.format, problem));
            }
            let part = |number: u16| f64::from(number) / start.most;
            // In bitmaps 1 is black.
            let part = |number: u16| if matches!(start.kind, b'1' | b'4') { 1.0 - part(number) } else { part(number) };
            if start.most > 255.0 {
                Samples::Words(
                    start.channels,
                    numbers.into_iter().map(|n| (part(n) * 65535.0).round() as u16).collect(),
                )
            } else {
                Samples::Bytes(start.channels, numbers.into_iter().map(|n| (part(n) * 255.0).round() as u8).collect())
            }
        }
    };
    Ok(Decoded::plain(start.header, samples))
}

fn start(encoded: &[u8]) -> Result<Start<'_>> {
    let kind = encoded[1];
    let floats = matches!(kind, b'F' | b'f');
    let format = if floats { Format::Pfm } else { Format::Ppm };
    let mut rest = &encoded[2..];
    let mut number = |what: &str| {
        let word = word(&mut rest);
        let number = word.parse::<f64>().ok().filter(|number| number.is_finite());
        let short: String = word.chars().take(40).collect();
        number.ok_or_else(|| Error::new(format!("found \"{short}\" as its {what}")).expected("a number"))
    };
    let [width, height] = [number("width")?, number("height")?];
    let most =
        if matches!(kind, b'1' | b'4') { 1.0 } else { number(if floats { "scale" } else { "number for white" })? };
    let whole = |number: f64| number.fract() == 0.0 && (1.0..=65_535.0).contains(&number);
    if !whole(width) || !whole(height) || (floats && most == 0.0) || (!floats && !whole(most)) {
        return Err(damaged(format, format!("its header says {width} x {height}, white {most}")));
    }
    let (width, height) = (width as usize, height as usize);
    check_size(width, height, 3 * size_of::<f32>())?;
    // One blank, and the pixels.
    rest = rest.get(1..).unwrap_or_default();
    let channels = if matches!(kind, b'3' | b'6' | b'F') { 3 } else { 1 };
    let bit_depth = if floats { 32 } else { 16 - (most as u16).leading_zeros() as u8 };
    Ok(Start { header: Header { width, height, format, bit_depth, alpha: false }, kind, channels, most, rest })
}

/// The next word; comments run from `#` to the end of their line.
fn word<'a>(rest: &mut &'a [u8]) -> &'a str {
    loop {
        *rest = rest.trim_ascii_start();
        if !rest.starts_with(b"#") {
            break;
        }
        let end = rest.iter().position(|&byte| byte == b'\n').unwrap_or(rest.len());
        *rest = &rest[end..];
    }
    let end = rest.iter().position(|byte| byte.is_ascii_whitespace() || *byte == b'#').unwrap_or(rest.len());
    let (word, behind) = rest.split_at(end);
    *rest = behind;
    std::str::from_utf8(word).unwrap_or_default()
}

/// Numbers written out.
fn plain(mut rest: &[u8], count: usize, format: Format) -> Result<Vec<u16>> {
    let mut numbers = Vec::with_capacity(count.min(rest.len()));
    while numbers.len() < count {
        match word(&mut rest) {
            "" => break,
            word => numbers.push(word.parse().map_err(|_| {
                let short: String = word.chars().take(40).collect();
                damaged(format, format!("its number {} is \"{short}\"", numbers.len() + 1))
            })?),
        }
    }
    Ok(numbers)
}

/// The digits of a bitmap written out; blanks between them may be missing.
fn digits(rest: &[u8], count: usize) -> Vec<u16> {
    rest.iter().filter(|byte| matches!(byte, b'0' | b'1')).take(count).map(|byte| u16::from(byte - b'0')).collect()
}

/// The bits of a bitmap; every row begins with a byte.
fn bits(rest: &[u8], width: usize, height: usize) -> Vec<u16> {
    let row = |row: &[u8]| (0..width).map(|x| u16::from(row[x / 8] >> (7 - x % 8) & 1)).collect::<Vec<_>>();
    rest.chunks_exact(width.div_ceil(8)).take(height).flat_map(row).collect()
}

fn enough<T>(mut numbers: Vec<T>, count: usize, format: Format) -> Result<Vec<T>> {
    if numbers.len() < count {
        return Err(damaged(format, format!("it is truncated, it has {} numbers of {count}", numbers.len())));
    }
    numbers.truncate(count);
    Ok(numbers)
}

/// The rows from the bottom up; the scale says nothing of the light, only of the order of bytes.
fn floats(start: &Start, count: usize) -> Result<Vec<f32>> {
    let value = if start.most < 0.0 { f32::from_le_bytes } else { f32::from_be_bytes };
    let numbers = start.rest.as_chunks().0.iter().map(|&bytes| value(bytes)).collect();
    let numbers = enough(numbers, count, Format::Pfm)?;
    Ok(numbers.chunks_exact(start.header.width * start.channels).rev().flatten().copied().collect())
}
