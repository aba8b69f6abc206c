//! Maps in memory: read, scaled, re-compressed, damaged and checked.

use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use skycube::colour::encode_srgb;
use skycube::envmap::source::Skybox;
use skycube::envmap::{CubeFilter, CubeMap, Face, LazyImage, Orientation, Preset, VOrigin};
use skycube::math::Vec3;
use skycube::picture::{self, Format, Header, OutputFormat, Picture, Raster, Texels, WriteOptions};
use skycube::validate::{Check, CheckOptions, ImageFacts, Names, check};

use crate::common::shared_map;

/// How the pictures of a map are kept.
pub struct Storage {
    pub size: usize,
    /// None for PNG.
    quality: Option<u8>,
}

impl Storage {
    pub fn png(size: usize) -> Self {
        Self { size, quality: None }
    }

    pub fn jpeg(size: usize) -> Self {
        Self::jpeg_of_quality(size, 50)
    }

    pub fn jpeg_of_quality(size: usize, quality: u8) -> Self {
        Self { size, quality: Some(quality) }
    }

    pub fn name(&self) -> String {
        self.quality.map_or("PNG".to_owned(), |quality| format!("JPEG {quality}"))
    }
}

/// Six pictures that are right under the `opengl` lookup.
#[derive(Clone)]
pub struct Map {
    pictures: [Picture; 6],
}

/// The right maps at hand, in the opengl convention: those of the project, and real ones where they are. They are decoded once
/// for all tests of a binary.
pub fn right_maps() -> &'static [(&'static str, Map)] {
    static MAPS: LazyLock<Vec<(&'static str, Map)>> = LazyLock::new(read_right_maps);
    &MAPS
}

fn read_right_maps() -> Vec<(&'static str, Map)> {
    use Face::{NegX, NegY, NegZ, PosX, PosY, PosZ};
    let own = Face::ALL;
    let quake = [PosZ, NegZ, PosY, NegY, PosX, NegX];
    let openexr = [PosX, NegX, PosY, NegY, NegZ, PosZ];
    let real: [(&str, [Face; 6], usize); 9] = [
        ("meadow", own, 0),
        ("studio-garden", own, 0),
        ("city-upside-down", own, 2),
        ("clouds-dusk", quake, 0),
        ("miramar-quake", quake, 0),
        ("layouts/storm-cross.jpg", own, 0),
        ("layouts/ryfjallet-strip.png", own, 0),
        ("openexr/KernerEnvCube.exr", openexr, 0),
        ("openexr/OrientationCube.exr", openexr, 0),
    ];
    let project = |name: &str| Path::new(env!("CARGO_MANIFEST_DIR")).join("envmaps").join(name);
    let mut maps: Vec<(&'static str, PathBuf, [Face; 6], usize)> =
        ["compass", "courtyard", "hall", "night", "seaside"].map(|name| (name, project(name), own, 0)).into();
    for (name, order, orientation) in real {
        maps.extend(shared_map(name).map(|path| (name, path, order, orientation)));
    }
    maps.into_iter()
        .map(|(name, path, order, orientation)| (name, Map::read(&path, order, Orientation::ALL[orientation])))
        .collect()
}

/// A map of the project, by the name of its folder.
pub fn project_map(name: &str) -> Map {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("envmaps").join(name);
    Map::read(&folder, Face::ALL, Orientation::IDENTITY)
}

impl Map {
    fn read(path: &Path, order: [Face; 6], orientation: Orientation) -> Self {
        let skybox = Skybox::open(path).unwrap();
        let pictures = order.map(|face| oriented(&skybox.image(face).decode().unwrap(), orientation));
        Self { pictures }
    }

    pub fn new(pictures: [Picture; 6]) -> Self {
        Self { pictures }
    }

    pub fn pictures(&self) -> &[Picture; 6] {
        &self.pictures
    }

    /// The map scaled and written as 8-bit files of a kind, and read again.
    pub fn stored(&self, storage: &Storage) -> Self {
        let format = if storage.quality.is_some() { OutputFormat::Jpeg } else { OutputFormat::Png };
        let options = WriteOptions { jpeg_quality: storage.quality.unwrap_or(92), ..WriteOptions::default() };
        let scale = self.exposure();
        let store = |picture: &Picture| {
            let encoded = picture::encode(&scaled(picture, storage.size, scale), format, &options).unwrap();
            picture::decode(&encoded, Path::new("stored")).unwrap()
        };
        Self { pictures: std::array::from_fn(|face| store(&self.pictures[face])) }
    }

    /// The factor that brings radiance into the range of 8-bit files; 1 for those that are.
    fn exposure(&self) -> f32 {
        let Texels::Linear(_) = self.pictures[0].texels() else { return 1.0 };
        let texels = |picture: &Picture| match picture.texels() {
            Texels::Linear(colours) => {
                colours.iter().map(|colour| colour.element_sum() / 3.0).sum::<f32>() / colours.len() as f32
            }
            Texels::Srgb8(_) => 1.0,
        };
        let mean = self.pictures.iter().map(texels).sum::<f32>() / 6.0;
        0.3 / mean
    }

    /// The map with images in other places and other orientations.
    pub fn damaged(&self, images: &[usize; 6], orientations: &[Orientation; 6]) -> Self {
        Self { pictures: std::array::from_fn(|face| oriented(&self.pictures[images[face]], orientations[face])) }
    }

    /// True if an original image in an orientation has the texels of the original at a face.
    pub fn looks_alike(&self, image: usize, orientation: Orientation, face: usize) -> bool {
        (image == face && orientation == Orientation::IDENTITY)
            || oriented(&self.pictures[image], orientation).texels() == self.pictures[face].texels()
    }

    pub fn check(&self, names: Names) -> Check {
        self.check_named(names, Face::ALL.map(Face::name))
    }

    /// The check of files with these names, which stand for the faces in their order.
    pub fn check_named(&self, names: Names, files: [&str; 6]) -> Check {
        let images = self.pictures.clone().map(LazyImage::ready);
        let map = CubeMap::new(images, Preset::Opengl.lookup(), CubeFilter::Nearest);
        let facts = |face: Face| {
            let Header { width, height, format, alpha, .. } = self.pictures[face.index()].header();
            ImageFacts { face, file: format!("{}.png", files[face.index()]), width, height, format, alpha }
        };
        let options = CheckOptions { names, lookup_name: "opengl".to_owned(), ..CheckOptions::default() };
        check(&map, Face::ALL.map(facts).to_vec(), &options).unwrap()
    }
}

/// A picture after the operation on the file that the orientation amounts to.
pub fn oriented(picture: &Picture, orientation: Orientation) -> Picture {
    if orientation == Orientation::IDENTITY {
        return picture.clone();
    }
    let size = picture.width();
    let operation = orientation.image_operation(VOrigin::Top);
    let places =
        (0..size).flat_map(|y| (0..size).map(move |x| operation.source(x, y, size))).map(|(x, y)| y * size + x);
    let texels = match picture.texels() {
        Texels::Srgb8(bytes) => {
            Texels::Srgb8(places.flat_map(|at| [bytes[3 * at], bytes[3 * at + 1], bytes[3 * at + 2]]).collect())
        }
        Texels::Linear(colours) => Texels::Linear(places.map(|at| colours[at]).collect()),
    };
    Picture::new(picture.header(), texels)
}

/// A picture of another size: the mean of what a texel covers where it shrinks, bilinear where it grows.
fn scaled(picture: &Picture, size: usize, factor: f32) -> Raster {
    let own = picture.width();
    Raster::from_function(size, size, |x, y| {
        let colour = if own > size {
            let cells = |index: usize| index * own / size..((index + 1) * own).div_ceil(size);
            let (columns, rows) = (cells(x), cells(y));
            let count = (columns.len() * rows.len()) as f32;
            rows.flat_map(|row| columns.clone().map(move |column| (column, row)))
                .map(|(column, row)| picture.texel(column, row))
                .sum::<Vec3>()
                / count
        } else {
            let place = |index: usize| (index as f32 + 0.5) * own as f32 / size as f32;
            picture.bilinear(place(x), place(y))
        };
        colour * factor
    })
}

/// An 8-bit picture computed from column, row and size; display colours from 0 to 255.
pub fn computed(size: usize, colour: impl Fn(usize, usize) -> [f32; 3]) -> Picture {
    let bytes =
        (0..size * size).flat_map(|at| colour(at % size, at / size).map(|value| value.round().clamp(0.0, 255.0) as u8));
    let header = Header { width: size, height: size, format: Format::Png, bit_depth: 8, alpha: false };
    Picture::new(header, Texels::Srgb8(bytes.collect()))
}

/// The display colours of a texel.
pub fn display(picture: &Picture, x: usize, y: usize) -> [f32; 3] {
    picture.texel(x, y).to_array().map(|value| 255.0 * encode_srgb(value))
}
