//! Files as other programs write them, and files made to break the tool: read right, or refused with a reason.
//!
//! Each kind has a fixture made here; the folders of real files beside the repository are tried where they are there.

mod common;

use std::path::{Path, PathBuf};

use common::{outcome, project};
use skycube::math::Vec3;

/// A folder beside the repository; where it is missing, says that the test is skipped.
fn shared(name: &str) -> Option<PathBuf> {
    common::present(&project("../shared"), name)
}

/// Four units by four, seen from above, one pixel a tenth; what is drawn is black before white.
const ABOVE: &str = "camera = { position = [1.5, 1.5, 10], target = [1.5, 1.5, 0], up = [0, 1, 0], field_of_view = 22.62, size = [40, 40] }\n\
    environment = { kind = \"constant\", radiance = 1 }\nmaterials = { black = { kind = \"lambert\", colour = 0 } }\n\
    lights = [ { kind = \"ambient\", radiance = 1 } ]\n";

/// Renders a scene in a folder: the picture's pixels and standard error.
fn rendered(folder: &Path, scene: &str) -> (Vec<Vec3>, String) {
    let picture = tempfile::tempdir().unwrap();
    let file = picture.path().join("picture.exr");
    let (code, _, error) = outcome(folder, &["render", scene, "-o", file.to_str().unwrap()]);
    assert_eq!(code, Some(0), "{scene}: {error}");
    (skycube::picture::read(&file).unwrap().to_raster().pixels().to_vec(), error)
}

/// The area that is black, in square units of a picture four units wide.
fn black_area(pixels: &[Vec3]) -> f64 {
    let black = pixels.iter().filter(|pixel| pixel.max_element() < 0.5).count();
    16.0 * black as f64 / pixels.len() as f64
}

/// The colour in the middle.
fn middle(pixels: &[Vec3]) -> Vec3 {
    let side = pixels.len().isqrt();
    pixels[side * (side / 2) + side / 2]
}

/// A scene that shows the mesh `a.obj` with a shape table's further lines.
fn write_scene(folder: &Path, object: &str, materials: &str, further: &str) {
    std::fs::write(folder.join("a.obj"), object).unwrap();
    std::fs::write(folder.join("a.mtl"), materials).unwrap();
    std::fs::write(folder.join("a.toml"), format!("{ABOVE}[[shapes]]\nkind = \"mesh\"\nfile = \"a.obj\"\n{further}"))
        .unwrap();
}

const SQUARE: &str = "mtllib a.mtl\nv 0 0 0\nv 3 0 0\nv 3 3 0\nv 0 3 0\nusemtl a\nf 1 2 3 4\n";

#[test]
fn materials_of_other_programs() {
    let folder = tempfile::tempdir().unwrap();
    let shown = |materials: &str, further: &str| {
        write_scene(folder.path(), SQUARE, &format!("newmtl a\n{materials}"), further);
        let (pixels, error) = rendered(folder.path(), "a.toml");
        (middle(&pixels), error)
    };
    let orange = Vec3::new(0.8, 0.4, 0.0);
    for plain in [
        "Kd 0.8 0.4 0",
        "Kd 0.8 0.4 0\nKs 0 0 0\nillum 3",
        "Kd 0.8 0.4 0\nillum 4\nd 1\nTf 1 1 1",
        "Kd .8 .4. 0\nillum 8\nKs 0 0 0",
    ] {
        let (found, _) = shown(plain, "");
        assert!((found - orange).abs().max_element() < 1e-6, "{plain}: {found}");
    }
    let (found, error) = shown("Kd 0.8 0.4 0\nd 0.3\nKa 1 1 1\nillum 2", "");
    assert!((found - orange).abs().max_element() < 1e-6, "{found}");
    assert!(error.contains("a.obj: not used: Ka (a), d (a)"), "{error}");
    // Light, glass, a mirror, codes instead of light.
    let (found, error) = shown("Kd 0 0 0\nKe 3 2 1", "");
    assert!(found == Vec3::new(3.0, 2.0, 1.0) && error.contains("light sources: a"), "{found} {error}");
    let (_, error) = shown("Kd 0 0 0\nillum 7\nNi 1.4", "");
    assert!(error.contains("clear glass: a") && error.contains("4 open edges"), "{error}");
    assert_eq!(shown("Kd 0 0 0\nKs 0.5 0.5 0.5\nillum 3", "").0, Vec3::splat(0.5));
    let code = shown("Kd 0.5 1 0", "mtl_colours = \"srgb\"\n").0;
    assert!((code - Vec3::new(0.214, 1.0, 0.0)).abs().max_element() < 1e-3, "{code}");
}

#[test]
fn a_mesh_needs_no_materials_that_the_scene_names() {
    let folder = tempfile::tempdir().unwrap();
    let broken = SQUARE.replace("a.mtl", "gone.mtl");
    for (object, materials) in
        [(broken.as_str(), ""), (SQUARE, "newmtl a\nKd none\n"), (SQUARE, "newmtl a\nmap_Kd gone.png\n")]
    {
        write_scene(folder.path(), object, materials, "material = \"black\"\n");
        assert!((black_area(&rendered(folder.path(), "a.toml").0) - 9.0).abs() < 0.2);
        write_scene(folder.path(), object, materials, "");
        assert_eq!(outcome(folder.path(), &["render", "a.toml"]).0, Some(2));
    }
}

#[test]
fn the_material_file_is_not_overwritten() {
    let folder = tempfile::tempdir().unwrap();
    write_scene(folder.path(), &SQUARE.replace("a.mtl", "a.png"), "", "");
    std::fs::write(folder.path().join("a.png"), "newmtl a\nKd 1 0 0\n").unwrap();
    let (code, _, error) = outcome(folder.path(), &["render", "a.toml"]);
    assert!(code == Some(2) && error.contains("not overwritten"), "{error}");
}

#[test]
fn a_damaged_face_is_a_fault_of_the_map() {
    let folder = tempfile::tempdir().unwrap();
    let map = folder.path().join("map");
    std::fs::create_dir(&map).unwrap();
    for face in ["posx", "negx", "posy", "negy", "posz", "negz"] {
        let picture = skycube::picture::read(&project("envmaps/compass").join(format!("{face}.png"))).unwrap();
        skycube::picture::write(&picture.to_raster(), &map.join(format!("{face}.jpg")), &Default::default()).unwrap();
    }
    assert_eq!(outcome(folder.path(), &["check", "map"]).0, Some(0));
    let file = std::fs::read(map.join("negz.jpg")).unwrap();
    std::fs::write(map.join("negz.jpg"), [&file[..file.len() / 2], &[0xFF, 0xD9]].concat()).unwrap();
    let (code, _, error) = outcome(folder.path(), &["check", "map"]);
    assert!(code == Some(1) && error.contains("negz.jpg") && error.contains("truncated"), "{error}");
}

#[cfg(target_os = "linux")]
#[test]
fn a_report_that_is_lost_is_an_error() {
    let full = || std::fs::File::options().write(true).open("/dev/full").unwrap();
    for arguments in [&["check", "envmaps/compass"][..], &["check", "envmaps/compass", "--json"], &["lessons"]] {
        let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_skycube"));
        let output = command.args(arguments).current_dir(project("")).stdout(full()).output().unwrap();
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert!(String::from_utf8_lossy(&output.stderr).contains("the report is lost"), "{arguments:?}");
    }
}

#[test]
fn more_memory_than_allowed_is_refused_before_it_is_taken() {
    let folder = tempfile::tempdir().unwrap();
    write_scene(folder.path(), SQUARE, "newmtl a\n", "");
    let (code, _, error) = outcome(folder.path(), &["render", "a.toml", "--size", "4000x4000", "--memory", "200M"]);
    assert!(code == Some(2) && error.contains("--memory"), "{error}");
    assert_eq!(outcome(folder.path(), &["render", "a.toml", "--memory", "much"]).0, Some(2));
    // A picture of some bytes that claims a gigabyte.
    std::fs::write(folder.path().join("big.ppm"), "P6 10000 10000 255\n").unwrap();
    std::fs::write(folder.path().join("small.ppm"), "P6 1 1 255\n\0\0\0").unwrap();
    let (code, _, error) = outcome(folder.path(), &["compare", "big.ppm", "small.ppm", "--memory", "200M"]);
    assert!(code == Some(2) && error.contains("big.ppm") && error.contains("of memory"), "{error}");
}

#[test]
fn strips_are_compared() {
    let folder = tempfile::tempdir().unwrap();
    let strip = |offset: usize| {
        let pixels = (0..3 * 200).flat_map(|index| [(index % 200 + offset) as u8 ^ ((index / 200) as u8 * 37); 3]);
        [b"P6 200 3 255\n".to_vec(), pixels.collect()].concat()
    };
    std::fs::write(folder.path().join("mine.ppm"), strip(9)).unwrap();
    std::fs::write(folder.path().join("expected.ppm"), strip(0)).unwrap();
    let (code, _, error) = outcome(folder.path(), &["compare", "mine.ppm", "expected.ppm"]);
    assert!(matches!(code, Some(0 | 1)), "{code:?} {error}");
}

#[test]
fn real_meshes() {
    let Some(files) = shared("files") else { return };
    for (scene, area) in [
        ("concave-polygon/scene.toml", 7.0),
        ("line-elements/scene.toml", 0.5),
        ("mtl-missing-overridden/scene.toml", 9.0),
        ("usemtl-no-mtllib-overridden/scene.toml", 9.0),
        ("usemtl-none/scene.toml", 9.0),
        ("vertex-colours-partial/scene.toml", 9.0),
        ("vertex-colours-partial2/scene.toml", 9.0),
        ("normals-mixed/scene.toml", 9.0),
        ("texcoord-mixed/scene.toml", 9.0),
    ] {
        let found = black_area(&rendered(&files, scene).0);
        assert!((found - area).abs() < 0.06, "{scene}: {found}");
    }
    for scene in ["mtllib-several", "mtllib-backslash", "mtllib-dot-backslash", "illum3-diffuse", "illum3-course"] {
        let found = middle(&rendered(&files, &format!("{scene}/scene.toml")).0);
        assert!(found.x > 0.7 && found.z < 0.2, "{scene}: {found}");
    }
    let (code, _, error) = outcome(&files, &["render", "map-kd-options/scene.toml"]);
    assert!(code == Some(2) && error.contains("tex.png"), "{error}");
    let base = std::fs::read_to_string(files.join("models/base.toml")).unwrap();
    let copy = tempfile::tempdir().unwrap();
    for entry in std::fs::read_dir(files.join("models")).unwrap().flatten() {
        std::fs::copy(entry.path(), copy.path().join(entry.file_name())).unwrap();
    }
    let objects =
        std::fs::read_dir(copy.path()).unwrap().flatten().map(|entry| entry.file_name().into_string().unwrap());
    for object in objects.filter(|name| name.ends_with(".obj")).collect::<Vec<_>>() {
        let scene = base.replace("FILE", &object).replace("MATERIAL", "material = \"m\"");
        std::fs::write(copy.path().join("scene.toml"), scene).unwrap();
        rendered(copy.path(), "scene.toml");
    }
}

#[test]
fn real_pictures() {
    let Some(files) = shared("files") else { return };
    let read = |file: &str| skycube::picture::read(&files.join(file));
    let damaged = std::fs::read_dir(files.join("jpeg-damaged")).unwrap().flatten().map(|entry| entry.path());
    for file in damaged.filter(|path| path.is_file()) {
        let error = skycube::picture::read(&file).unwrap_err();
        assert!(error.is_damage(), "{error}");
    }
    assert!(read("models/jpeg-4096-bytes-missing.jpg").unwrap_err().is_damage());
    let (code, _, error) = outcome(&files, &["check", "jpeg-damaged/fuji"]);
    assert!(code == Some(1) && error.contains("posx.jpg"), "{error}");
    let (turned, seen) = (read("exif-orientation/hopper_orientation_6.jpg"), read("exif-orientation/as-viewed.png"));
    let (turned, seen) = (turned.unwrap().to_raster(), seen.unwrap().to_raster());
    assert_eq!((turned.width(), turned.height()), (seen.width(), seen.height()));
    let differences = turned.pixels().iter().zip(seen.pixels()).map(|(a, b)| (*a - *b).abs().max_element());
    let mean = differences.sum::<f32>() / seen.pixels().len() as f32;
    assert!(mean < 0.01, "{mean}");
    let planar = read("tiff-planar-tiled/tiff_tiled_planar_raw.tif");
    assert!(
        planar.is_ok_and(|picture| picture.width() > 0) || read("tiff-planar-tiled/tiff_tiled_planar_raw.tif").is_err()
    );
    assert!(read("models/rtow.ppm").is_ok() && read("models/g4_orientation_3.tif").is_ok());
}

#[test]
fn hostile_input() {
    let Some(files) = shared("hostile") else { return };
    let limit = std::time::Duration::from_secs(20);
    let within = |arguments: &[&str], expected: &[i32]| {
        let started = std::time::Instant::now();
        let (code, printed, error) = outcome(&files, arguments);
        assert!(code.is_some_and(|code| expected.contains(&code)), "{arguments:?}: {code:?} {error}");
        assert!(started.elapsed() < limit, "{arguments:?} took {:?}", started.elapsed());
        assert!(error.len() < 20_000, "{arguments:?}: an error of {} bytes", error.len());
        let control = |text: &str| text.contains(|letter: char| letter.is_control() && letter != '\n');
        assert!(!control(&printed) && !control(&error), "{arguments:?}");
    };
    let picture = tempfile::tempdir().unwrap();
    let picture = picture.path().join("a.png");
    let picture = picture.to_str().unwrap();
    within(&["compare", "compare-panic-8bit-mine.png", "compare-panic-8bit-expected.png"], &[0, 1]);
    within(&["check", "zip-six-1GiB-of-zeros.zip"], &[2]);
    within(&["check", "zip-one-long-name.zip"], &[2]);
    within(&["check", "zip-escape-sequences.zip"], &[0, 1, 2]);
    within(&["check", "zip-six-23000x23000-grey.zip", "--memory", "1G"], &[1, 2]);
    for scene in ["scene-10-unused-rough-glasses", "scene-mesh-100k-equal", "scene-mesh-18k", "scene-mesh-mtllib"] {
        within(&["render", &format!("{scene}.toml"), "-o", picture], &[0]);
    }
    within(&["render", "scene-mesh-negate.toml", "-o", picture], &[2]);
    within(&["render", "scene-2-28-pixels.toml", "-o", picture, "--memory", "1G"], &[2]);
}

/// A triangle whose corners have colours, seen from above under even light.
fn write_coloured(folder: &Path, vertices: [&str; 3], material: &str) {
    let [a, b, c] = vertices;
    std::fs::write(folder.join("a.obj"), format!("v 0 0 0 {a}\nv 3 0 0 {b}\nv 0 3 0 {c}\nf 1 2 3\n")).unwrap();
    let scene = ABOVE.replace("black = {", &format!("paint = {{ {material} }}, black = {{"));
    let shape = "[[shapes]]\nkind = \"mesh\"\nfile = \"a.obj\"\nmaterial = \"paint\"\n";
    std::fs::write(folder.join("a.toml"), format!("{scene}{shape}")).unwrap();
}

const PAINT: &str = "kind = \"lambert\", colour = \"vertex\"";

#[test]
fn colours_of_vertices_are_shown() {
    let folder = tempfile::tempdir().unwrap();
    let shown = |vertices: [&str; 3], material: &str| {
        write_coloured(folder.path(), vertices, material);
        rendered(folder.path(), "a.toml")
    };
    let (found, error) = shown(["1 0 0", "0 0.5 0", "0.25 0.25 1"], PAINT);
    assert!(!error.contains("a.obj"), "{error}");
    // The light of each code, and between the corners the mean by their weights.
    let linear = |code: f32| if code <= 0.04045 { code / 12.92 } else { ((code + 0.055) / 1.055).powf(2.4) };
    let corners = [[1.0, 0.0, 0.0], [0.0, 0.5, 0.0], [0.25, 0.25, 1.0]].map(|codes| Vec3::from(codes.map(linear)));
    let mut inside = 0;
    for (index, colour) in found.iter().enumerate() {
        let (x, y) = ((index % 40) as f32 / 10.0 - 0.45, 3.45 - (index / 40) as f32 / 10.0);
        // Away from the border; a pixel is a tenth wide.
        if x < 0.2 || y < 0.2 || x + y > 2.7 {
            continue;
        }
        let expected = corners[0] * (1.0 - (x + y) / 3.0) + corners[1] * (x / 3.0) + corners[2] * (y / 3.0);
        assert!((*colour - expected).abs().max_element() < 0.04, "at {x} {y}: {colour} instead of {expected}");
        inside += 1;
    }
    assert!(inside > 250, "{inside} pixels");
    // Codes over 255; the other materials.
    assert_eq!(shown(["255 0 0", "0 127.5 0", "63.75 63.75 255"], PAINT).0, found);
    let phong = "kind = \"phong\", diffuse = \"vertex\"";
    assert_eq!(shown(["1 0 0", "0 0.5 0", "0.25 0.25 1"], phong).0, found);
    // A vertex without a colour is white.
    let (found, error) = shown(["", "1 1 1", "1 1 1"], PAINT);
    assert!(error.contains("a.obj: 1 of its vertices have no colour: white"), "{error}");
    assert!((found[40 * 30 + 10] - Vec3::ONE).abs().max_element() < 1e-6);
}

#[test]
fn colours_of_vertices_are_asked_for_where_there_are_some() {
    let folder = tempfile::tempdir().unwrap();
    write_coloured(folder.path(), ["1 0 0", "1 0 0", "1 0 0"], "kind = \"lambert\", colour = 0");
    let (_, error) = rendered(folder.path(), "a.toml");
    assert!(error.contains("a.obj: the colours of its vertices are not used"), "{error}");
    write_coloured(folder.path(), ["", "", ""], PAINT);
    let (code, _, error) = outcome(folder.path(), &["render", "a.toml"]);
    assert!(code == Some(2) && error.contains("materials.paint: it takes the colours of vertices"), "{error}");
    write_coloured(folder.path(), ["1 0 0", "1 0 0", "1 0 0"], "kind = \"lambert\", colour = \"vertices\"");
    let (code, _, error) = outcome(folder.path(), &["render", "a.toml"]);
    assert!(code == Some(2) && error.contains("one of vertex"), "{error}");
}
