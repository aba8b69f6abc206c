//! The header of an HDR (RGBE) file: exposure and primaries, which the decoder ignores.

use super::Format;
use super::colour_space::{ColourSpace, REC_709};
use super::header::damaged;
use crate::error::Result;

/// The lines of the header: `KEY=value`.
fn lines(encoded: &[u8]) -> impl Iterator<Item = (String, String)> {
    let end = encoded.windows(2).position(|pair| pair == b"\n\n").unwrap_or(0);
    let text = String::from_utf8_lossy(&encoded[..end]).into_owned();
    let line = |line: &str| line.split_once('=').map(|(key, value)| (key.trim().to_owned(), value.trim().to_owned()));
    text.lines().filter_map(line).collect::<Vec<_>>().into_iter()
}

/// An error if the pixels are not RGB.
pub fn check(encoded: &[u8]) -> Result<()> {
    match lines(encoded).find(|(key, value)| key == "FORMAT" && value.contains("xyze")) {
        Some(_) => Err(damaged(Format::Hdr, "its pixels are XYZ, not RGB")),
        None => Ok(()),
    }
}

/// `EXPOSURE`: what the pixels were multiplied by, all together. `PRIMARIES`: x and y of red, green, blue and white.
pub fn colours(encoded: &[u8]) -> (Option<ColourSpace>, Vec<String>) {
    let (mut exposure, mut primaries, mut notes) = (1.0, REC_709, Vec::new());
    for (key, value) in lines(encoded) {
        let numbers: Vec<f64> = value.split_ascii_whitespace().filter_map(|word| word.parse().ok()).collect();
        match (key.as_str(), numbers.as_slice()) {
            ("EXPOSURE", &[factor]) if factor > 0.0 && factor.is_finite() => exposure *= factor,
            ("PRIMARIES", &[rx, ry, gx, gy, bx, by, wx, wy]) => primaries = [[rx, ry], [gx, gy], [bx, by], [wx, wy]],
            ("EXPOSURE" | "PRIMARIES" | "COLORCORR", _) => notes.push(format!("its {key} is ignored")),
            _ => (),
        }
    }
    // What Radiance writes by default has white at (1/3, 1/3); its programs take that for the white of any screen.
    let usual = [[0.64, 0.33], [0.29, 0.6], [0.15, 0.06], [0.333, 0.333]];
    let near = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).abs() < 0.002 && (a[1] - b[1]).abs() < 0.002;
    if primaries.iter().zip(usual).all(|(&a, b)| near(a, b)) {
        primaries = REC_709;
    }
    match ColourSpace::linear(primaries, 1.0 / exposure) {
        Ok(space) => (space, notes),
        Err(note) => (None, [notes, vec![note]].concat()),
    }
}
