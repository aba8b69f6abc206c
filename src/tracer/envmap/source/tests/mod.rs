//! Opening skyboxes from files made here, with one fault each, and the real maps.

mod archives;
mod folders;
mod naming_schemes;
mod real_maps;
mod sheets;

use std::fs;
use std::io::Cursor;

use image::{ImageFormat, Rgb, RgbImage};
use tempfile::TempDir;

use super::*;
use crate::picture::Texels;

/// The colour that face number `index` is painted in.
pub(super) fn paint(index: usize) -> [u8; 3] {
    [40 * index as u8, 255 - 40 * index as u8, 7]
}

pub(super) fn png(picture: &RgbImage) -> Vec<u8> {
    let mut bytes = Cursor::new(Vec::new());
    picture.write_to(&mut bytes, ImageFormat::Png).unwrap();
    bytes.into_inner()
}

/// A PNG file of one colour.
pub(super) fn plain(width: u32, height: u32, index: usize) -> Vec<u8> {
    png(&RgbImage::from_pixel(width, height, Rgb(paint(index))))
}

pub(super) const NAMES: [&str; 6] = ["posx.png", "negx.png", "posy.png", "negy.png", "posz.png", "negz.png"];

/// A folder with six faces of 4 x 4 pixels, each of its own colour.
pub(super) fn six_files() -> TempDir {
    let folder = TempDir::new().unwrap();
    for (index, name) in NAMES.into_iter().enumerate() {
        fs::write(folder.path().join(name), plain(4, 4, index)).unwrap();
    }
    folder
}

/// The first texel of each image, to see which picture became which face.
pub(super) fn first_texels(skybox: &Skybox) -> [[u8; 3]; 6] {
    [0, 1, 2, 3, 4, 5].map(|index| match skybox.images[index].decode().unwrap().texels() {
        Texels::Srgb8(bytes) => [bytes[0], bytes[1], bytes[2]],
        Texels::Linear(colours) => panic!("a PNG became {:?}", colours[0]),
    })
}

pub(super) fn names(skybox: &Skybox) -> String {
    skybox.images.iter().map(FaceImage::name).collect::<Vec<_>>().join(" ")
}

/// The error of opening `path` in a temporary folder, which it calls `[folder]`.
pub(super) fn error_at(folder: &TempDir, path: &str) -> String {
    let path = if path.is_empty() { folder.path().to_path_buf() } else { folder.path().join(path) };
    let error = Skybox::open(&path).unwrap_err().to_string();
    error.replace(&folder.path().display().to_string(), "[folder]")
}
