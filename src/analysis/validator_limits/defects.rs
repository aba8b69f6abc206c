//! What happens to the pixels of pictures: compression, noise, exposure, blur.

use std::path::Path;

use super::picture_of;
use crate::envmap::Face;
use crate::math::functions::power;
use crate::picture::{self, OutputFormat, Picture, Texels, WriteOptions};
use crate::random::Random;

/// Stored as a JPEG file of this quality, and read again.
pub fn jpeg(picture: &Picture, quality: u8) -> Picture {
    let options = WriteOptions { jpeg_quality: quality, ..WriteOptions::default() };
    let encoded = picture::encode(&picture.to_raster(), OutputFormat::Jpeg, &options).expect("a quality from 1 to 100");
    picture::decode(&encoded, Path::new("stored.jpg")).expect("what was just written")
}

/// Noise of this standard deviation, in codes: the sum of three even distributions.
pub fn noisy(picture: &Picture, face: Face, deviation: f64) -> Picture {
    let mut random = Random(face.index() as u64 + 1);
    changed(picture, |code, _, _| {
        let sum = random.unit() + random.unit() + random.unit() - 1.5;
        code + (2.0 * deviation * sum) as f32
    })
}

/// Exposures that differ from face to face, up to this factor between two of them. Nothing becomes brighter.
pub fn exposed(picture: &Picture, face: Face, factor: f64) -> Picture {
    const STEPS: [f64; 6] = [0.6, 0.0, 0.8, 0.2, 1.0, 0.4];
    let scale = (1.0 + (factor - 1.0) * STEPS[face.index()]) / factor;
    changed(picture, |code, _, _| code * scale as f32)
}

/// Codes from 0 to 1 raised to this power.
pub fn with_gamma(picture: &Picture, gamma: f64) -> Picture {
    changed(picture, |code, _, _| 255.0 * power(code / 255.0, gamma as f32))
}

/// A black frame, so many texels wide.
pub fn framed(picture: &Picture, width: usize) -> Picture {
    let size = picture.width();
    let inside = width..size.saturating_sub(width);
    changed(picture, |code, x, y| if inside.contains(&x) && inside.contains(&y) { code } else { 0.0 })
}

/// The mean of so many texels to either side, within the picture alone: as a paint program blurs six files.
pub fn blurred(picture: &Picture, radius: usize) -> Picture {
    let size = picture.width();
    let bytes = bytes(picture);
    let along = |bytes: &[f32], stride: usize, other: usize| -> Vec<f32> {
        let mut means = vec![0.0; bytes.len()];
        for line in 0..size {
            for at in 0..size {
                let near = at.saturating_sub(radius)..(at + radius + 1).min(size);
                for channel in 0..3 {
                    let place = |at: usize| 3 * (at * stride + line * other) + channel;
                    let sum: f32 = near.clone().map(|near| bytes[place(near)]).sum();
                    means[place(at)] = sum / near.len() as f32;
                }
            }
        }
        means
    };
    let floats: Vec<f32> = bytes.iter().map(|&byte| f32::from(byte)).collect();
    let means = along(&along(&floats, 1, size), size, 1);
    picture_of(size, means.iter().map(|mean| mean.round() as u8).collect())
}

/// A picture of which every code becomes another one, by code, column and row.
fn changed(picture: &Picture, mut code: impl FnMut(f32, usize, usize) -> f32) -> Picture {
    let size = picture.width();
    let codes = bytes(picture).iter().enumerate();
    let codes = codes.map(|(at, &byte)| code(f32::from(byte), at / 3 % size, at / 3 / size));
    picture_of(size, codes.map(|code| code.round().clamp(0.0, 255.0) as u8).collect())
}

fn bytes(picture: &Picture) -> &[u8] {
    match picture.texels() {
        Texels::Srgb8(bytes) => bytes,
        Texels::Linear(_) => unreachable!("the worlds are drawn in eight bits"),
    }
}
