//! What was done to a picture must be named, and nothing else.

mod common;
#[path = "compare/lesson_pictures.rs"]
mod lesson_pictures;

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use skycube::colour::encode_srgb;
use skycube::compare::{Comparison, Finding, Verdict};
use skycube::envmap::ImageOperation;
use skycube::math::Vec3;
use skycube::picture::{Format, Header, Picture, Raster, Texels, WriteOptions};
use skycube::report::{CompareReport, Metric};

fn project(file: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(file)
}

fn raster(file: &str) -> Raster {
    skycube::picture::read(&project(file)).unwrap().to_raster()
}

/// Pictures of the project, their sides halved or quartered, with an offset in full pixels.
fn subject(name: &str, [x, y]: [usize; 2]) -> Raster {
    let (file, factor) = match name {
        "lesson" => ("lessons/06-environment-map/glass-and-mirror.jpg", 4),
        "compass" => ("envmaps/compass/posy.png", 2),
        "courtyard" => ("envmaps/courtyard/negx.jpg", 4),
        face => (face, 4),
    };
    let full = raster(file);
    let (width, height) = (full.width() / factor - 4, full.height() / factor - 4);
    Raster::from_function(width, height, |column, row| {
        let pixel = |index: usize| full.pixel(column * factor + x + index % factor, row * factor + y + index / factor);
        (0..factor * factor).map(pixel).sum::<Vec3>() / (factor * factor) as f32
    })
}

const SUBJECTS: [&str; 3] = ["lesson", "compass", "courtyard"];

/// The picture as an 8-bit file holds it.
fn file_of(raster: &Raster) -> Picture {
    let byte = |value: f32| (encode_srgb(value) * 255.0).round() as u8;
    let bytes = raster.pixels().iter().flat_map(|colour| colour.to_array().map(byte)).collect();
    let header =
        Header { width: raster.width(), height: raster.height(), format: Format::Png, bit_depth: 8, alpha: false };
    Picture::new(header, Texels::Srgb8(bytes))
}

fn each(raster: &Raster, change: impl Fn(Vec3) -> Vec3) -> Raster {
    let pixels = raster.pixels().iter().map(|&colour| change(colour)).collect();
    Raster::from_pixels(raster.width(), raster.height(), pixels)
}

fn channels(colour: Vec3, change: impl Fn(f32) -> f32) -> Vec3 {
    Vec3::from_array(colour.to_array().map(change))
}

fn decoded(code: f32) -> f32 {
    if code <= 0.04045 { code / 12.92 } else { ((code + 0.055) / 1.055).powf(2.4) }
}

fn flipped(raster: &Raster) -> Raster {
    let last = raster.width() - 1;
    Raster::from_function(raster.width(), raster.height(), |x, y| raster.pixel(last - x, y))
}

/// Noise of the given deviation in display codes, from a small generator of its own.
fn noisy(raster: &Raster, deviation: f32) -> Raster {
    let mut state = 12_345u64;
    let mut uniform = move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 40) as f32 / (1u64 << 24) as f32
    };
    let mut gaussian = move || (0..12).map(|_| uniform()).sum::<f32>() - 6.0;
    let mut noisy = |channel: f32| decoded((encode_srgb(channel) + deviation * gaussian()).clamp(0.0, 1.0));
    let pixels: Vec<Vec3> =
        raster.pixels().iter().map(|colour| Vec3::new(noisy(colour.x), noisy(colour.y), noisy(colour.z))).collect();
    Raster::from_pixels(raster.width(), raster.height(), pixels)
}

fn no_gamma(raster: &Raster) -> Raster {
    each(raster, |colour| channels(colour, decoded))
}

/// What is found, in short; clipped highlights follow from exposure and are left out.
fn found(mine: &Raster, expected: &Raster) -> Vec<String> {
    names(&Comparison::of(&file_of(mine), &file_of(expected)))
}

fn names(comparison: &Comparison) -> Vec<String> {
    let name = |finding: &Finding| {
        let (text, number) = (|name: &str| finding.figures[name].as_str().unwrap(), |name: &str| figure(finding, name));
        Some(match finding.kind {
            "stretched" => {
                let across = finding.figures["horizontally"].as_bool().unwrap();
                format!("stretched {} {:.2}", if across { "across" } else { "down" }, number("factor"))
            }
            "orientation" => text("operation").to_owned(),
            "encoding" if text("curve") == "power" => format!("power {:.1}", number("power")),
            "encoding" => text("curve").to_owned(),
            "exposure" => format!("exposure {:.1}", number("factor")),
            "shifted" => format!("shift {} {}", number("x"), number("y")),
            "clipped_highlights" => return None,
            kind => kind.to_owned(),
        })
    };
    comparison.findings.iter().filter_map(name).collect()
}

fn figure(finding: &Finding, name: &str) -> f64 {
    finding.figures[name].as_f64().unwrap()
}

/// The figures of the only finding, which is of this kind.
fn only<const COUNT: usize>(comparison: &Comparison, kind: &str, figures: [&str; COUNT]) -> [f64; COUNT] {
    let [finding] = &comparison.findings[..] else { panic!("{:?}", comparison.findings) };
    assert_eq!(finding.kind, kind);
    figures.map(|name| figure(finding, name))
}

#[test]
fn the_same_picture_and_a_little_noise_name_nothing() {
    for subject in SUBJECTS.map(|name| self::subject(name, [0, 0])) {
        let file = file_of(&subject);
        let comparison = Comparison::of(&file, &file);
        assert_eq!(comparison.verdict(true), Verdict::Identical);
        assert_eq!(comparison.findings, []);
        assert_eq!(found(&noisy(&subject, 0.006), &subject), [""; 0]);
    }
}

#[test]
fn every_single_mistake_is_named() {
    for name in SUBJECTS {
        let expected = subject(name, [0, 0]);
        let square = Raster::from_function(140, 140, |x, y| expected.pixel(x, y));
        let turned = Raster::from_function(140, 140, |x, y| square.pixel(y, 139 - x));
        let cases: [(Raster, &Raster, &str); 9] = [
            (flipped(&expected), &expected, "flip left-right"),
            (turned, &square, "turn 90° clockwise"),
            (no_gamma(&expected), &expected, "not_encoded"),
            (each(&expected, |colour| channels(colour, encode_srgb)), &expected, "encoded_twice"),
            (each(&expected, |colour| colour * 0.5), &expected, "exposure 0.5"),
            (each(&expected, |colour| colour * 1.9), &expected, "exposure 1.9"),
            (each(&expected, |colour| Vec3::new(colour.z, colour.y, colour.x)), &expected, "red_blue_swapped"),
            (each(&expected, |colour| channels(colour, |value| value.powf(1.4))), &expected, "power 1.4"),
            (noisy(&expected, 0.1), &expected, "noise"),
        ];
        for (mine, expected, finding) in cases {
            assert_eq!(found(&mine, expected), [finding], "{name}");
        }
    }
}

#[test]
fn the_power_that_is_nearly_srgb_is_told_from_it() {
    let expected = subject("lesson", [0, 0]);
    let mine = each(&expected, |colour| channels(colour, |value| decoded(value.powf(1.0 / 2.2))));
    assert_eq!(found(&mine, &expected), ["power_1_2.2"]);
}

#[test]
fn shifts_are_named_to_half_a_pixel() {
    let expected = subject("lesson", [4, 4]);
    // The picture of a camera that looks further to the right lies further to the left.
    for (offset, finding) in
        [([0, 4], "shift 1 0"), ([2, 2], "shift 0.5 0.5"), ([4, 12], "shift 0 -2"), ([6, 4], "shift -0.5 0")]
    {
        assert_eq!(found(&subject("lesson", offset), &expected), [finding]);
    }
}

#[test]
fn mistakes_made_together_are_all_named() {
    for name in SUBJECTS {
        let expected = subject(name, [0, 0]);
        assert_eq!(found(&no_gamma(&flipped(&expected)), &expected), ["flip left-right", "not_encoded"], "{name}");
        let dark = no_gamma(&flipped(&each(&expected, |colour| colour * 0.5)));
        assert_eq!(found(&dark, &expected), ["flip left-right", "not_encoded", "exposure 0.5"], "{name}");
        let swapped = each(&expected, |colour| Vec3::new(colour.z, colour.y, colour.x) * 0.7);
        assert_eq!(found(&swapped, &expected), ["red_blue_swapped", "exposure 0.7"], "{name}");
    }
    let (expected, shifted) = (subject("lesson", [0, 0]), subject("lesson", [4, 0]));
    let dark = each(&shifted, |colour| colour * 0.6);
    assert_eq!(found(&dark, &expected), ["exposure 0.6", "shift -1 0"]);
    assert_eq!(found(&noisy(&dark, 0.05), &expected), ["exposure 0.6", "shift -1 0", "noise"]);
}

#[test]
fn another_size_is_named_and_looked_through() {
    let expected = subject("lesson", [0, 0]);
    let half = Raster::from_function(expected.width() / 2, expected.height() / 2, |x, y| {
        (0..4).map(|index| expected.pixel(2 * x + index % 2, 2 * y + index / 2)).sum::<Vec3>() / 4.0
    });
    assert_eq!(found(&expected, &half), ["size"]);
    assert_eq!(found(&flipped(&expected), &half), ["size", "flip left-right"]);
}

#[test]
fn something_else_is_called_so_and_nothing_wrong_is_named() {
    for (mine, expected) in [("lesson", "courtyard"), ("courtyard", "compass"), ("compass", "lesson")] {
        let (mine, expected) = (subject(mine, [0, 0]), subject(expected, [0, 0]));
        let mine = Raster::from_function(expected.width().min(140), 120, |x, y| mine.pixel(x.min(120), y));
        let expected = Raster::from_function(mine.width(), 120, |x, y| expected.pixel(x.min(120), y));
        assert_eq!(found(&mine, &expected), ["unrelated"]);
    }
    for face in ["posx", "posy", "negy", "negz"] {
        let mine = subject(&format!("envmaps/courtyard/{face}.jpg"), [0, 0]);
        let expected = subject("courtyard", [0, 0]);
        assert_eq!(found(&mine, &expected), ["unrelated"], "{face}");
    }
}

#[test]
fn a_changed_region_is_framed() {
    let expected = subject("lesson", [0, 0]);
    let mut mine = expected.clone();
    for (x, y) in (60..90).flat_map(|x| (40..64).map(move |y| (x, y))) {
        mine.set(x, y, Vec3::new(1.0, 0.0, 1.0));
    }
    let comparison = Comparison::of(&file_of(&mine), &file_of(&expected));
    assert_eq!(names(&comparison), ["region"]);
    assert_eq!(comparison.verdict(true), Verdict::Differs);
    let worst = comparison.worst;
    assert!(worst.x <= 60 && worst.x + worst.width >= 90 && worst.width < 60, "{worst:?}");
    assert!(worst.y <= 40 && worst.y + worst.height >= 64 && worst.height < 54, "{worst:?}");
}

#[test]
fn a_region_that_is_flipped_or_turned_is_called_so() {
    // A poster with a letter.
    let mut expected = subject("lesson", [0, 0]);
    for (u, v) in (0..48).flat_map(|u| (0..48).map(move |v| (u, v))) {
        let letter = (6..14).contains(&u) || (4..12).contains(&v) || ((22..28).contains(&v) && u < 34);
        expected.set(60 + u, 30 + v, if letter { Vec3::new(0.7, 0.1, 0.1) } else { Vec3::splat(0.8) });
    }
    for (name, [mirrors_u, mirrors_v]) in
        [("flip left-right", [true, false]), ("flip top-bottom", [false, true]), ("turn 180°", [true, true])]
    {
        let mut mine = expected.clone();
        for (u, v) in (0..48).flat_map(|u| (0..48).map(move |v| (u, v))) {
            let [x, y] =
                [(u, mirrors_u), (v, mirrors_v)].map(|(place, mirrors)| if mirrors { 47 - place } else { place });
            mine.set(60 + u, 30 + v, expected.pixel(60 + x, 30 + y));
        }
        let comparison = Comparison::of(&file_of(&mine), &file_of(&expected));
        assert_eq!(names(&comparison), ["region_orientation"], "{name}");
        assert_eq!(comparison.findings[0].figures["operation"], name);
        assert_eq!(comparison.verdict(true), Verdict::Differs);
    }
}

#[test]
fn black_and_broken_pictures_are_called_so() {
    let expected = subject("lesson", [0, 0]);
    let black = Raster::filled(expected.width(), expected.height(), Vec3::ZERO);
    assert_eq!(found(&black, &expected), ["flat"]);
    let mut broken = expected.clone();
    broken.set(7, 5, Vec3::splat(f32::NAN));
    let header = Header { format: Format::Exr, bit_depth: 32, ..file_of(&expected).header() };
    let float = |raster: &Raster| Picture::new(header, Texels::Linear(raster.pixels().to_vec()));
    let comparison = Comparison::of(&float(&broken), &float(&expected));
    let first = &comparison.findings[0];
    assert_eq!((first.kind, ["pixels", "x", "y"].map(|name| figure(first, name))), ("not_finite", [1.0, 7.0, 5.0]));
    assert_eq!(comparison.verdict(true), Verdict::Differs);
}

#[test]
fn highlights_that_a_file_cut_off_are_named() {
    let bright = each(&subject("lesson", [0, 0]), |colour| colour * 2.0);
    let header = Header { format: Format::Exr, bit_depth: 32, ..file_of(&bright).header() };
    let expected = Picture::new(header, Texels::Linear(bright.pixels().to_vec()));
    let comparison = Comparison::of(&file_of(&bright), &expected);
    let [share] = only(&comparison, "clipped_highlights", ["share"]);
    assert!(share > 0.01, "{share}");
}

#[test]
fn every_orientation_of_an_oblong_picture_is_named() {
    let expected = subject("lesson", [0, 0]);
    let (width, height) = (expected.width(), expected.height());
    let clockwise = Raster::from_function(height, width, |x, y| expected.pixel(y, height - 1 - x));
    assert_eq!(found(&clockwise, &expected), [ImageOperation::TurnClockwise.name()]);
    let transposed = Raster::from_function(height, width, |x, y| expected.pixel(y, x));
    assert_eq!(found(&transposed, &expected), [ImageOperation::Transpose.name()]);
    let upside_down = Raster::from_function(width, height, |x, y| expected.pixel(x, height - 1 - y));
    assert_eq!(found(&upside_down, &expected), [ImageOperation::FlipTopBottom.name()]);
}

#[test]
fn reports() {
    let expected = subject("lesson", [0, 0]);
    let mine = no_gamma(&flipped(&expected));
    let comparison = Comparison::of(&file_of(&mine), &file_of(&expected));
    let report = CompareReport::new(&comparison, Metric::Flip, 0.05);
    insta::assert_snapshot!("flipped_text", report.to_string());
    common::json_report(&report.to_json());
    insta::assert_snapshot!("flipped_json", report.to_json());
    let comparison = Comparison::of(&file_of(&expected), &file_of(&expected));
    let report = CompareReport::new(&comparison, Metric::Psnr, 28.0);
    insta::assert_snapshot!("identical_text", report.to_string());
}

#[test]
fn nothing_is_left_where_nothing_was_undone() {
    let report = |mine: &Raster, expected: &Raster| {
        let comparison = Comparison::of(&file_of(mine), &file_of(expected));
        CompareReport::new(&comparison, Metric::Flip, 0.05).to_string()
    };
    let expected = subject("lesson", [0, 0]);
    let noise = report(&noisy(&expected, 0.1), &expected);
    assert!(noise.contains("- The difference has no structure") && !noise.contains("hat is left"), "{noise}");
    let undone = report(&noisy(&flipped(&expected), 0.1), &expected);
    assert!(undone.contains("- What is left has no structure"), "{undone}");
    // All of the picture is no place in it.
    let tone = |light: f32| Raster::filled(64, 48, Vec3::splat(light));
    let all = report(&tone(0.0), &tone(1.0));
    assert!(all.contains("the difference covers the whole picture") && !all.contains("elsewhere"), "{all}");
}

#[test]
fn one_broken_pixel_is_counted_as_one() {
    let mut mine = subject("lesson", [0, 0]);
    mine.set(7, 5, Vec3::splat(f32::NAN));
    let header = Header { format: Format::Exr, bit_depth: 32, ..file_of(&mine).header() };
    let mine = Picture::new(header, Texels::Linear(mine.pixels().to_vec()));
    let comparison = Comparison::of(&mine, &file_of(&subject("lesson", [0, 0])));
    let text = CompareReport::new(&comparison, Metric::Flip, 0.05).to_string();
    assert!(text.contains("1 of your pixels is not a finite number (column 7, row 5)"), "{text}");
}

fn skycube(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_skycube")).args(arguments).current_dir(folder).output().unwrap()
}

#[test]
fn the_command_draws_and_ends_by_the_threshold() {
    let folder = tempfile::tempdir().unwrap();
    let expected = subject("lesson", [0, 0]);
    let write = |raster: &Raster, name: &str| {
        skycube::picture::write(raster, &folder.path().join(name), &WriteOptions::default()).unwrap();
    };
    write(&expected, "expected.png");
    write(&noisy(&expected, 0.01), "noisy.jpg");
    write(&flipped(&expected), "flipped.exr");
    let code = |arguments: &[&str]| skycube(folder.path(), arguments).status.code();
    assert_eq!(code(&["compare", "expected.png", "expected.png"]), Some(0));
    assert_eq!(code(&["compare", "noisy.jpg", "expected.png", "-o", "difference.png"]), Some(0));
    assert_eq!(code(&["compare", "noisy.jpg", "expected.png", "--threshold", "0.0001"]), Some(1));
    assert_eq!(code(&["compare", "flipped.exr", "expected.png"]), Some(1));
    assert_eq!(code(&["compare", "flipped.exr", "expected.png", "--threshold", "1"]), Some(1));
    for metric in ["flip", "rmse", "psnr", "ssim"] {
        assert_eq!(code(&["compare", "noisy.jpg", "expected.png", "--metric", metric]), Some(0), "{metric}");
        assert_eq!(code(&["compare", "flipped.exr", "expected.png", "--metric", metric]), Some(1), "{metric}");
    }
    let drawing = skycube::picture::read(&folder.path().join("difference.png")).unwrap();
    assert!(drawing.width() > 3 * expected.width() && drawing.height() > expected.height());
    let before = std::fs::read(folder.path().join("expected.png")).unwrap();
    assert_eq!(code(&["compare", "noisy.jpg", "expected.png", "-o", "expected.png"]), Some(2));
    assert_eq!(std::fs::read(folder.path().join("expected.png")).unwrap(), before);
    assert_eq!(code(&["compare", "nowhere.png", "expected.png"]), Some(2));
    assert_eq!(code(&["compare", "noisy.jpg", "expected.png", "-o", "difference.jpg"]), Some(2));
    let output = skycube(folder.path(), &["compare", "flipped.exr", "expected.png", "--json"]);
    let report = common::json_report(&common::text(&output.stdout));
    assert_eq!(report["findings"][0]["operation"], "flip left-right");
}
