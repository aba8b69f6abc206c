//! Pictures as others publish them: the project's own always, real downloads where they are at hand.

mod common;

use std::path::Path;

use skycube::picture::{
    self, EnvironmentLayout, Format, Header, Texels, WriteOptions, exr_environment, read, read_header,
};

/// Reads a picture and checks that its header alone says the same.
fn check(path: &Path, expected: Header) {
    let picture = read(path).unwrap();
    assert_eq!(picture.header(), expected, "{}", path.display());
    let encoded = std::fs::read(path).unwrap();
    assert_eq!(read_header(&encoded, path).unwrap(), expected);
    if let Texels::Linear(colours) = picture.texels() {
        assert!(colours.iter().all(|colour| colour.is_finite() && colour.min_element() >= 0.0));
        assert!(colours.iter().any(|colour| colour.max_element() > 0.0));
    }
}

fn header(width: usize, height: usize, format: Format, bit_depth: u8) -> Header {
    Header { width, height, format, bit_depth, alpha: false }
}

#[test]
fn the_projects_own_pictures_are_read() {
    check(&common::project("envmaps/courtyard/posx.jpg"), header(1024, 1024, Format::Jpeg, 8));
    let hall = common::project("envmaps/hall/posx.png");
    check(&hall, header(128, 128, Format::Png, 8));
    let folder = tempfile::tempdir().unwrap();
    for (name, format, bit_depth) in [("hall.hdr", Format::Hdr, 8), ("hall.exr", Format::Exr, 32)] {
        let path = folder.path().join(name);
        picture::write(&read(&hall).unwrap().to_raster(), &path, &WriteOptions::default()).unwrap();
        check(&path, header(128, 128, format, bit_depth));
    }
}

#[test]
fn skybox_faces_are_read() {
    let Some(folder) = common::shared_map("meadow") else { return };
    for name in ["posx", "negx", "posy", "negy", "posz", "negz"] {
        check(&folder.join(name).with_extension("jpg"), header(2048, 2048, Format::Jpeg, 8));
    }
}

#[test]
fn layouts_are_read() {
    let Some(folder) = common::shared_map("layouts") else { return };
    check(&folder.join("dresden_square_1k.hdr"), header(1024, 512, Format::Hdr, 8));
    check(&folder.join("ryfjallet-strip.png"), header(256, 1536, Format::Png, 8));
}

/// Files with and without the attribute are made in the tests of the package `skycube-tracer`.
#[test]
fn openexr_maps_say_how_they_wrap() {
    let Some(folder) = common::shared_map("openexr") else { return };
    let maps = [
        ("KernerEnvCube.exr", Some(EnvironmentLayout::Cube)),
        ("OrientationCube.exr", Some(EnvironmentLayout::Cube)),
        ("OrientationLatLong.exr", Some(EnvironmentLayout::LatitudeLongitude)),
    ];
    for (name, layout) in maps {
        let path = folder.join(name);
        let found = read(&path).unwrap();
        if layout == Some(EnvironmentLayout::Cube) {
            assert_eq!(found.height(), 6 * found.width(), "{name} holds six squares");
        }
        check(&path, Header { format: Format::Exr, bit_depth: 16, ..found.header() });
        assert_eq!(exr_environment(&std::fs::read(&path).unwrap()), layout, "{name}");
    }
}
