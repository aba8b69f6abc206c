//! Small files of every kind, as the project writes them.

use std::io::{Cursor, Write};

use skycube::math::Vec3;
use skycube::picture::{OutputFormat, Raster, WriteOptions, encode};

use super::picture_files::{self, Kind};

fn raster() -> Raster {
    Raster::from_function(24, 18, |x, y| {
        let (x, y) = (x as f32, y as f32);
        Vec3::new(0.5 + 0.4 * (x / 3.0).sin(), 0.5 + 0.4 * (y / 2.0 + x).cos(), (x * y / 432.0).fract())
    })
}

/// By the name that tells the format: what the project writes, and every kind of file that other programs write.
pub fn pictures() -> Vec<(&'static str, Vec<Vec<u8>>)> {
    let ours = |format| encode(&raster(), format, &WriteOptions::default()).unwrap();
    let numbers: Vec<u8> =
        raster().pixels().iter().flat_map(|pixel| pixel.to_array().map(|c| (255.0 * c) as u8)).collect();
    let floats = raster().pixels().iter().flat_map(|pixel| pixel.to_array()).flat_map(f32::to_le_bytes).collect();
    let with = |header: &[u8], pixels: Vec<u8>| [header, &pixels].concat();
    let fixtures = [
        include_bytes!("../../src/tracer/picture/tests/fixtures/progressive.jpg").to_vec(),
        include_bytes!("../../src/tracer/picture/tests/fixtures/restarts.jpg").to_vec(),
    ];
    let of = |kinds: Vec<Kind>| kinds.into_iter().map(|kind| kind.file);
    vec![
        ("jpg", [ours(OutputFormat::Jpeg)].into_iter().chain(fixtures).collect()),
        ("png", [ours(OutputFormat::Png)].into_iter().chain(of(picture_files::png::kinds())).collect()),
        ("hdr", vec![ours(OutputFormat::Hdr)]),
        ("exr", [ours(OutputFormat::Exr)].into_iter().chain(of(picture_files::exr::kinds())).collect()),
        ("ppm", vec![with(b"P6 24 18 255\n", numbers), b"P3 2 1 15\n1 2 3 4 5 6\n".to_vec(), b"P4 9 2\nabcd".to_vec()]),
        ("pfm", vec![with(b"PF 24 18 -1\n", floats)]),
        ("a.tga", of(picture_files::tga::kinds()).collect()),
        ("bmp", of(picture_files::bmp::kinds()).collect()),
        ("tif", of(picture_files::tiff::kinds()).collect()),
        ("webp", picture_files::webp::files()),
    ]
}

/// The files of one of those names.
pub fn of(name: &str) -> Vec<Vec<u8>> {
    pictures().into_iter().find(|(known, _)| *known == name).unwrap().1
}

pub fn meshes() -> Vec<Vec<u8>> {
    let texts = [
        "mtllib a.mtl b.mtl\nv 0 0 0\nv 1 0 0 0.5\nv 1 1 0 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvn 0 0 1\nusemtl a\nf 1/1/1 2/2/1 3/1/1\n",
        "v 0 0 0\nv 3 0 0\nv 3 3 0\nv 2 3 0\nv 2 1 0\nv 1 1 0\nv 1 3 0\nv 0 3 0\nf 1 2 3 4 \\\n5 6 7 8\nf -1 -2 -3\nl 1 2\n",
    ];
    let wide = texts[1].encode_utf16().flat_map(u16::to_le_bytes).collect();
    texts.iter().map(|text| text.as_bytes().to_vec()).chain([wide]).collect()
}

pub fn materials() -> Vec<Vec<u8>> {
    vec![
        b"newmtl a\nKd 1 0 0\nKs 0.5 0.5 0.5\nKe 0 0 0\nNs 20\nNi 1.5\nd 0.25\nTr 0.1\nillum 2\nmap_Kd -s 2 2 1 -o 1 1 t.png\nPr 0.5\nPm 1\n".to_vec(),
        b"newmtl b # c\nKd 1.0. 0 0\nKd spectral x.rfl\nTf 1 1 1\nnorm n.png\n".to_vec(),
    ]
}

/// An archive of six small faces.
pub fn archive() -> Vec<u8> {
    let mut file = zip::ZipWriter::new(Cursor::new(Vec::new()));
    let face = encode(&raster(), OutputFormat::Png, &WriteOptions::default()).unwrap();
    for name in ["posx", "negx", "posy", "negy", "posz", "negz"] {
        file.start_file(format!("{name}.png"), zip::write::SimpleFileOptions::default()).unwrap();
        file.write_all(&face).unwrap();
    }
    file.finish().unwrap().into_inner()
}

/// The examples of `scenes.md`.
pub fn scenes() -> Vec<Vec<u8>> {
    let text = include_str!("../../lessons/scenes.md");
    text.split("```toml\n").skip(1).filter_map(|part| Some(part.split_once("```")?.0.as_bytes().to_vec())).collect()
}

pub fn lookups() -> Vec<Vec<u8>> {
    let rows =
        ["posx = { u = \"-y\", v = \"+z\" }", "negx = { u = \"+y\", v = \"+z\" }", "posy = { u = \"+x\", v = \"+z\" }"];
    let more = [
        "negy = { u = \"-x\", v = \"+z\" }",
        "posz = { u = \"+x\", v = \"-y\" }",
        "negz = { u = \"+x\", v = \"+y\", image = \"negz\" }",
    ];
    vec![format!("v_origin = \"bottom\"\n{}\n{}\n", rows.join("\n"), more.join("\n")).into_bytes()]
}
