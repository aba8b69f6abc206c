//! The project's own maps, and the real maps beside the repository, which are skipped where they are missing: all open, and
//! the seams of those that are right close.

use std::io::Write;
use std::path::PathBuf;

use super::*;
use crate::picture::Picture;

/// Signed axes of u and v of the `opengl` lookup: axis number and sign, v from the top row down.
const OPENGL: [[(usize, f32); 2]; 6] = [
    [(2, -1.0), (1, -1.0)],
    [(2, 1.0), (1, -1.0)],
    [(0, 1.0), (2, 1.0)],
    [(0, 1.0), (2, -1.0)],
    [(0, 1.0), (1, -1.0)],
    [(0, -1.0), (1, -1.0)],
];

/// A real map by its path in the folder of maps. Where it is missing, says so on the terminal itself, since `cargo test` shows
/// nothing that a passing test prints, and gives `None`.
fn real_map(name: &str) -> Option<PathBuf> {
    let beside = || PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../../shared/envmaps");
    let path = std::env::var_os("SKYCUBE_SHARED_MAPS").map_or_else(beside, PathBuf::from).join(name);
    if !path.exists() {
        let test = std::thread::current().name().unwrap_or("a test").to_owned();
        let line = format!("skipped in {test}: {} is missing\n", path.display());
        std::io::stderr().write_all(line.as_bytes()).unwrap();
        return None;
    }
    Some(path)
}

/// The encoded colour of the texel of a face nearest to a point on the cube [-1, 1]^3.
fn colour_at(picture: &Picture, face: Face, point: [f32; 3]) -> [f32; 3] {
    let place = |(axis, sign): (usize, f32), count: usize| {
        let coordinate = (sign * point[axis] + 1.0) / 2.0 * count as f32;
        (coordinate as usize).min(count - 1)
    };
    let [u, v] = OPENGL[face.index()];
    let at = place(v, picture.height()) * picture.width() + place(u, picture.width());
    match picture.texels() {
        Texels::Srgb8(bytes) => [0, 1, 2].map(|channel| f32::from(bytes[3 * at + channel])),
        Texels::Linear(_) => panic!("an 8-bit map is wanted"),
    }
}

/// The mean difference, of 255, between the outermost texels of two faces along their common edge.
fn seam_step(pictures: &[Picture], one: Face, other: Face) -> f32 {
    let along = 3 - one.axis() - other.axis();
    let count = pictures[one.index()].width();
    let mut sum = 0.0;
    for texel in 0..count {
        let mut point = (one.normal() + other.normal()).to_array();
        point[along] = (texel as f32 + 0.5) / count as f32 * 2.0 - 1.0;
        let (a, b) = (colour_at(&pictures[one.index()], one, point), colour_at(&pictures[other.index()], other, point));
        sum += (0..3).map(|channel| (a[channel] - b[channel]).abs()).sum::<f32>() / 3.0;
    }
    sum / count as f32
}

/// The steps across all twelve edges.
fn seam_steps(pictures: &[Picture]) -> Vec<f32> {
    let faces = Face::ALL.into_iter();
    let pairs = faces.flat_map(|one| Face::ALL.into_iter().map(move |other| (one, other)));
    pairs
        .filter(|(one, other)| one < other && one.axis() != other.axis())
        .map(|(one, other)| seam_step(pictures, one, other))
        .collect()
}

fn mean(steps: &[f32]) -> f32 {
    assert_eq!(steps.len(), 12);
    steps.iter().sum::<f32>() / 12.0
}

fn pictures(name: &str) -> Option<Vec<Picture>> {
    let skybox = Skybox::open(&real_map(name)?).unwrap();
    Some(skybox.images.iter().map(|image| image.decode().unwrap()).collect())
}

/// Any two faces exchanged must make the seams clearly worse: then the cells were cut by the right names.
fn assert_names_are_the_best(mut pictures: Vec<Picture>, step: f32) {
    for one in 0..6 {
        for other in one + 1..6 {
            pictures.swap(one, other);
            let worse = mean(&seam_steps(&pictures));
            pictures.swap(one, other);
            assert!(worse > 1.5 * step, "exchanging faces {one} and {other} gives {worse} instead of {step}");
        }
    }
}

#[test]
fn all_real_maps_open() {
    let maps = [
        ("meadow", 2048, 1),
        ("Meadow.zip", 2048, 1),
        ("city-upside-down", 512, 0),
        ("clouds-dusk", 1024, 1),
        ("miramar-quake", 1024, 0),
        ("studio-garden", 1024, 0),
        ("layouts/ryfjallet-strip.png", 256, 0),
        ("layouts/storm-cross.jpg", 1024, 0),
        ("openexr/KernerEnvCube.exr", 256, 0),
        ("openexr/OrientationCube.exr", 512, 0),
    ];
    for (name, size, passed_over) in maps {
        let Some(path) = real_map(name) else { continue };
        let skybox = Skybox::open(&path).unwrap();
        assert!(
            skybox.images.iter().all(|image| (image.header().width, image.header().height) == (size, size)),
            "{name}"
        );
        assert_eq!(skybox.passed_over.len(), passed_over, "{name}");
    }
}

#[test]
fn panoramas_are_told_from_cubes() {
    for name in ["openexr/OrientationLatLong.exr", "layouts/dresden_square_1k.hdr"] {
        let Some(path) = real_map(name) else { continue };
        let error = Skybox::open(&path).unwrap_err();
        assert!(error.problem().ends_with("an equirectangular picture, not six faces"), "{error}");
    }
}

#[test]
fn the_archive_holds_the_same_bytes_as_the_folder() {
    let (Some(folder), Some(archive)) = (real_map("meadow"), real_map("Meadow.zip")) else { return };
    let (folder, archive) = (Skybox::open(&folder).unwrap(), Skybox::open(&archive).unwrap());
    for (file, entry) in folder.images.iter().zip(&archive.images) {
        assert_eq!(file.encoded_bytes().unwrap(), entry.encoded_bytes().unwrap());
        assert_eq!(entry.name(), format!("Meadow.zip/{}", file.name()));
    }
}

#[test]
fn the_seams_of_the_projects_own_maps_close() {
    for name in ["hall", "night", "seaside"] {
        let skybox = Skybox::open(&PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../envmaps").join(name)).unwrap();
        let pictures: Vec<Picture> = skybox.images.iter().map(|image| image.decode().unwrap()).collect();
        assert!(pictures.iter().all(|picture| (picture.width(), picture.height()) == (128, 128)), "{name}");
        let steps = seam_steps(&pictures);
        println!("{name}: seam steps {steps:?}, mean {}", mean(&steps));
        assert_names_are_the_best(pictures, mean(&steps));
    }
}

#[test]
fn the_seams_of_a_folder_close() {
    let Some(pictures) = pictures("meadow") else { return };
    let step = mean(&seam_steps(&pictures));
    println!("meadow: mean seam step {step}");
    assert!((1.6..1.8).contains(&step), "{step}");
}

#[test]
fn the_seams_of_a_horizontal_cross_close() {
    let Some(pictures) = pictures("layouts/storm-cross.jpg") else { return };
    let steps = seam_steps(&pictures);
    println!("storm-cross: seam steps {steps:?}, mean {}", mean(&steps));
    assert_names_are_the_best(pictures, mean(&steps));
}

#[test]
fn the_seams_of_a_vertical_strip_close() {
    let Some(pictures) = pictures("layouts/ryfjallet-strip.png") else { return };
    let steps = seam_steps(&pictures);
    println!("ryfjallet-strip: seam steps {steps:?}, mean {}", mean(&steps));
    assert_names_are_the_best(pictures, mean(&steps));
}
