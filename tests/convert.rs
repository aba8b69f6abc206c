//! `skycube convert`: other layouts, lookups and formats of a map.

mod common;
#[path = "convert/resampling.rs"]
mod resampling;

use std::fs;
use std::path::Path;

use common::{outcome, project};
use skycube::envmap::source::Skybox;
use skycube::envmap::{CubeFilter, CubeMap, Face, Preset};
use skycube::math::Vec3;
use skycube::picture::{self, Header, Picture, PngDepth, Raster, Texels, WriteOptions};

/// Runs `convert` with these words in a folder; it must succeed.
fn convert(folder: &Path, words: &str) -> String {
    let arguments: Vec<&str> = ["convert"].into_iter().chain(words.split(' ')).collect();
    let (code, said, errors) = outcome(folder, &arguments);
    assert_eq!(code, Some(0), "{words}: {errors}");
    said
}

/// The error of `convert` with these words.
fn refused(folder: &Path, words: &str) -> String {
    let arguments: Vec<&str> = ["convert"].into_iter().chain(words.split(' ')).collect();
    let (code, said, errors) = outcome(folder, &arguments);
    assert_eq!((code, said.as_str()), (Some(2), ""), "{words}");
    errors
}

fn pictures(map: &Path) -> [Picture; 6] {
    Skybox::open(map).unwrap().images.each_ref().map(|image| image.decode().unwrap())
}

fn texels(map: &Path) -> [Texels; 6] {
    pictures(map).each_ref().map(|picture| picture.texels().clone())
}

/// Six pictures of 16 bits or floats, each texel another.
fn deep_map(folder: &Path, extension: &str) {
    fs::create_dir(folder).unwrap();
    for face in Face::ALL {
        let colour = |x: usize, y: usize| Vec3::new(x as f32, y as f32, (3 * face.index()) as f32) / 10.0;
        let raster = Raster::from_function(16, 16, colour);
        let options = WriteOptions { png_depth: PngDepth::Sixteen, ..WriteOptions::default() };
        picture::write(&raster, &folder.join(face.name()).with_extension(extension), &options).unwrap();
    }
}

#[test]
fn every_layout_keeps_every_texel() {
    let folder = tempfile::tempdir().unwrap();
    let place = |name: &str| folder.path().join(name);
    for extension in ["png", "exr", "hdr"] {
        deep_map(&place(extension), extension);
    }
    for map in ["hall", "compass"]
        .map(|name| project("envmaps").join(name))
        .into_iter()
        .chain(["png", "exr", "hdr"].map(place))
    {
        let format = if map.ends_with("exr") || map.ends_with("hdr") {
            map.file_name().unwrap().to_str().unwrap()
        } else {
            "png"
        };
        for layout in ["cross", "cross-vertical", "strip", "strip-vertical", "sheet-3x2", "sheet-2x3"] {
            let sheet = format!("sheet.{format}");
            convert(folder.path(), &format!("{} -o {sheet} --to {layout}", map.display()));
            let back = place(&format!("{}-{layout}", map.file_name().unwrap().display()));
            convert(folder.path(), &format!("{sheet} -o {} --to faces", back.display()));
            let read = pictures(&back);
            assert_eq!(
                read.each_ref().map(|picture| picture.texels().clone()),
                texels(&map),
                "{} {layout}",
                map.display()
            );
            let format = |header: Header| (header.format, header.bit_depth);
            let before = format(pictures(&map)[0].header());
            assert!(read.iter().all(|picture| format(picture.header()) == before), "{} {layout}", map.display());
        }
    }
}

#[test]
fn through_the_new_lookup_every_direction_keeps_its_colour() {
    let folder = tempfile::tempdir().unwrap();
    let hall = project("envmaps/compass");
    let map = |path: &Path, preset: Preset| {
        CubeMap::from_skybox(&Skybox::open(path).unwrap(), preset.lookup(), CubeFilter::Nearest)
    };
    let places = (0..40).flat_map(|a| (0..40).map(move |b| ((a as f32 - 19.3) / 20.0, (b as f32 - 19.7) / 20.0)));
    let directions: Vec<Vec3> = places
        .flat_map(|(a, b)| {
            Face::ALL.map(|face| {
                let mut direction = face.normal();
                (direction[(face.axis() + 1) % 3], direction[(face.axis() + 2) % 3]) = (a, b);
                direction
            })
        })
        .collect();
    for from in Preset::ALL {
        for to in Preset::ALL {
            let (from_name, to_name) = (from.name(), to.name());
            let moved = folder.path().join(format!("{from_name}-{to_name}"));
            let words = format!("--lookup {from_name} --to-lookup {to_name}");
            convert(folder.path(), &format!("{} -o {} --to faces {words}", hall.display(), moved.display()));
            let (old, new) = (map(&hall, from), map(&moved, to));
            for &direction in &directions {
                assert_eq!(old.sample(direction), new.sample(direction), "{from_name} {to_name} {direction}");
            }
        }
    }
}

#[test]
fn files_that_need_no_change_are_copied_and_all_six_have_one_format() {
    let folder = tempfile::tempdir().unwrap();
    let courtyard = project("envmaps/courtyard");
    let names = |folder: &str| {
        let mut names: Vec<String> = fs::read_dir(project("").join(folder))
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        names.sort();
        names.join(" ")
    };
    let convert = |words: &str| convert(folder.path(), &format!("{} --to faces {words}", courtyard.display()));
    let place = |name: &str| folder.path().join(name);
    insta::assert_snapshot!(convert("-o copied --lookup humus-z-up --to-lookup humus-y-up --format jpeg --quality 80"));
    assert_eq!(names(place("copied").to_str().unwrap()), "negx.jpg negy.jpg negz.jpg posx.jpg posy.jpg posz.jpg");
    convert("-o same");
    for face in Face::ALL {
        let name = format!("{}.jpg", face.name());
        assert_eq!(fs::read(place("same").join(&name)).unwrap(), fs::read(courtyard.join(&name)).unwrap());
    }
    // One face turned would be enough: the others follow, and no code changes.
    convert("-o turned --lookup opengl --to-lookup humus-y-up");
    assert_eq!(names(place("turned").to_str().unwrap()), "negx.png negy.png negz.png posx.png posy.png posz.png");
}

#[test]
fn contradictions_are_refused_and_nothing_is_written() {
    let folder = tempfile::tempdir().unwrap();
    let hall = project("envmaps/hall");
    fs::create_dir(folder.path().join("map")).unwrap();
    for face in Face::ALL {
        let name = format!("{}.png", face.name());
        fs::copy(hall.join(&name), folder.path().join("map").join(&name)).unwrap();
    }
    fs::write(folder.path().join("shared.toml"), common::SHARED_IMAGE_LOOKUP).unwrap();
    let panorama = Raster::filled(32, 16, Vec3::ONE);
    picture::write(&panorama, &folder.path().join("panorama.png"), &WriteOptions::default()).unwrap();
    let errors = [
        "map -o cross.png --to cross --format exr",
        "map -o cross.png --to cross --quality 50",
        "map -o cross.jpg --to cross --bits 16",
        "map -o cross.exr --to cross --tone-map reinhard",
        "map -o cross --to cross",
        "map -o faces.png --to faces",
        "map -o map --to faces",
        "map -o map/cross.png --to cross",
        "map -o faces --to faces --to-lookup shared.toml",
        "map -o faces --to faces --lookup missing",
        "map -o faces --to faces --rotate 90",
        "map -o panorama.png --to equirectangular --to-lookup course",
        "panorama.png -o faces --to faces --lookup course",
        "panorama.png -o again.exr --to equirectangular --world-up +z",
        "panorama.png -o panorama.png --to equirectangular --size 8",
    ]
    .map(|words| format!("convert {words}\n{}", refused(folder.path(), words)));
    insta::assert_snapshot!(errors.concat());
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 3);
}

#[test]
fn light_above_one_is_not_lost_in_silence() {
    let folder = tempfile::tempdir().unwrap();
    deep_map(&folder.path().join("map"), "exr");
    for (words, noted) in [("-o strip.png", true), ("-o strip.jpg --tone-map reinhard", false), ("-o strip.hdr", false)]
    {
        let (code, _, errors) = outcome(
            folder.path(),
            &[&["convert", "map", "--to", "strip"], &words.split(' ').collect::<Vec<_>>()[..]].concat(),
        );
        assert_eq!((code, errors.contains("radiance above 1")), (Some(0), noted), "{words}: {errors}");
    }
}

#[test]
fn panoramas_go_out_and_come_back() {
    let folder = tempfile::tempdir().unwrap();
    let hall = project("envmaps/hall");
    for (name, words) in [("plain", ""), ("turned", " --world-up +z --rotate 30")] {
        let panorama = format!("{name}.png");
        let said =
            convert(folder.path(), &format!("{} -o {panorama} --to equirectangular --size 512{words}", hall.display()));
        assert!(said.contains("resampled"), "{said}");
        let header = picture::read_file_header(&folder.path().join(&panorama)).unwrap();
        assert_eq!((header.width, header.height, header.bit_depth), (1024, 512, 8));
        convert(folder.path(), &format!("{panorama} -o {name} --to faces{words} --size 128"));
        for (old, new) in pictures(&hall).iter().zip(&pictures(&folder.path().join(name))) {
            let (old, new) = (old.to_raster().reduced(old.width() / 128), new.to_raster());
            let squares = old.pixels().iter().zip(new.pixels()).map(|(a, b)| (*a - *b).length_squared());
            let error = (squares.sum::<f32>() / new.pixels().len() as f32).sqrt();
            // Hard edges of a small picture lose a little on the way; a face mirrored or turned would be 0.1 off and more.
            assert!(error < 0.03, "{name}: {error}");
        }
    }
    // Another size alone, and the same picture in another format.
    convert(folder.path(), &format!("{} -o small --to faces --size 64", hall.display()));
    assert_eq!(pictures(&folder.path().join("small"))[5].header().width, 64);
    convert(folder.path(), "plain.png -o plain.exr --to equirectangular");
    let [png, exr] =
        ["plain.png", "plain.exr"].map(|name| picture::read(&folder.path().join(name)).unwrap().to_raster());
    assert_eq!(png, exr);
}
