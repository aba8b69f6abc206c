//! WebP pictures: lossless ones, as the `image` crate writes them.

use std::io::Cursor;

use image::{DynamicImage, ImageBuffer, ImageFormat};

use super::{HEIGHT, WIDTH, pixels, sample};

/// Colours with and without alpha, and a plain one.
pub fn files() -> Vec<Vec<u8>> {
    let bytes = |channels: usize| {
        let pixel = |x: usize, y: usize| (0..channels).map(|channel| sample(x, y, channel, 8) as u8).collect();
        pixels(pixel).into_iter().flat_map(|pixel: Vec<u8>| pixel).collect::<Vec<u8>>()
    };
    let (width, height) = (WIDTH as u32, HEIGHT as u32);
    let written = |image: DynamicImage| {
        let mut file = Cursor::new(Vec::new());
        image.write_to(&mut file, ImageFormat::WebP).unwrap();
        file.into_inner()
    };
    vec![
        written(DynamicImage::ImageRgb8(ImageBuffer::from_raw(width, height, bytes(3)).unwrap())),
        written(DynamicImage::ImageRgba8(ImageBuffer::from_raw(width, height, bytes(4)).unwrap())),
        written(DynamicImage::new_rgb8(width, height)),
    ]
}
