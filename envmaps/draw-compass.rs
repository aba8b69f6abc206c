//! Draws the six faces of `envmaps/compass`: `cargo run --release --example draw-compass [FOLDER]`.

use std::path::PathBuf;

use skycube::envmap::Face;
use skycube::picture::{Samples, Texels, write_png};
use skycube::report::draw_compass_face;

const SIZE: usize = 512;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = std::env::args_os().nth(1).map_or_else(|| PathBuf::from("envmaps/compass"), PathBuf::from);
    std::fs::create_dir_all(&folder)?;
    for face in Face::ALL {
        let picture = draw_compass_face(face, SIZE);
        let Texels::Srgb8(bytes) = picture.texels() else { unreachable!("the compass has 8 bits a channel") };
        let path = folder.join(face.name()).with_extension("png");
        write_png(&path, SIZE, SIZE, Samples::Rgb8(bytes))?;
    }
    println!("wrote six faces to {}", folder.display());
    Ok(())
}
