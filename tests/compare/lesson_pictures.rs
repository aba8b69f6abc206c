//! Pictures of the lessons, rendered small, with the mistakes that students make, against JPEG files of the right ones.

use std::path::Path;

use skycube::compare::{Comparison, Verdict};
use skycube::math::Vec3;
use skycube::picture::{OutputFormat, Picture, Raster, WriteOptions, decode, encode};
use skycube::render::{Silent, render};
use skycube::report::{CompareReport, Metric};
use skycube::scene::{Plan, Scene};

use super::{file_of, flipped, names, no_gamma, noisy, only, project};

/// The scene of a lesson, with parts of its text exchanged; a part that is not there is an error.
fn rendered(scene: &str, exchanged: &[(&str, &str)]) -> Raster {
    let file = project("lessons").join(scene);
    let mut text = std::fs::read_to_string(&file).unwrap();
    for (from, to) in exchanged {
        assert!(text.contains(from), "{scene} has no {from}");
        text = text.replace(from, to);
    }
    let scene = Scene::from_text(&text, &file).unwrap_or_else(|error| panic!("{error}"));
    render(&scene, &Plan::new(&scene), &Silent).unwrap().raster
}

/// The picture as a JPEG file holds it.
fn jpeg(raster: &Raster, quality: u8) -> Picture {
    let options = WriteOptions { jpeg_quality: quality, ..WriteOptions::default() };
    decode(&encode(raster, OutputFormat::Jpeg, &options).unwrap(), Path::new("expected.jpg")).unwrap()
}

fn compared(mine: &Raster, expected: &Picture) -> Comparison {
    Comparison::of(&file_of(mine), expected)
}

fn text(comparison: &Comparison) -> String {
    CompareReport::new(comparison, Metric::Flip, 0.05).to_string()
}

const DIRECTIONS: &str = "01-camera-rays/directions.toml";
const SPHERES: &str = "01-camera-rays/spheres-field-of-view-45.toml";
const BALLS: &str = "03-phong-shadows/balls-with-shadows.toml";
const WIDE: &str = "03-phong-shadows/balls-wide-highlights.toml";
const ENVIRONMENT: &str = "06-environment-map/environment-with.toml";
const FURNACE: &str = "09-microfacets/furnace-metal.toml";

fn upside_down(raster: &Raster) -> Raster {
    let last = raster.height() - 1;
    Raster::from_function(raster.width(), raster.height(), |x, y| raster.pixel(x, last - y))
}

#[test]
fn smooth_pictures_are_compared_through_jpeg() {
    let right = rendered(DIRECTIONS, &[]);
    let furnace = rendered(FURNACE, &[("samples = 128", "samples = 16"), ("depth = 1000", "depth = 50")]);
    for quality in [80, 88, 95] {
        for picture in [&right, &furnace] {
            let comparison = compared(picture, &jpeg(picture, quality));
            assert_eq!(names(&comparison), [""; 0], "{quality}");
            assert_eq!(comparison.verdict(true), Verdict::Matches);
        }
        let expected = jpeg(&right, quality);
        let bgr = |colour: &Vec3| Vec3::new(colour.z, colour.y, colour.x);
        let swapped = Raster::from_pixels(right.width(), right.height(), right.pixels().iter().map(bgr).collect());
        let dark =
            Raster::from_pixels(right.width(), right.height(), right.pixels().iter().map(|&c| c * 0.5).collect());
        for (mine, finding) in [
            (flipped(&right), "flip left-right"),
            (upside_down(&right), "flip top-bottom"),
            (no_gamma(&right), "not_encoded"),
            (swapped, "red_blue_swapped"),
            (dark, "exposure 0.5"),
        ] {
            assert_eq!(names(&compared(&mine, &expected)), [finding], "{quality}");
        }
        // Without edges, JPEG leaves a shift open by a tenth of a pixel.
        let moved = Raster::from_function(right.width(), right.height(), |x, y| right.pixel(x.saturating_sub(6), y));
        let comparison = compared(&moved, &expected);
        let [x, y] = only(&comparison, "shifted", ["x", "y"]);
        assert!((x - 6.0).abs() < 0.2 && y.abs() < 0.2, "{x} {y}");
        let both = flipped(&no_gamma(&right));
        assert_eq!(names(&compared(&both, &expected)), ["flip left-right", "not_encoded"], "{quality}");
    }
}

#[test]
fn an_even_expected_picture_blames_no_camera() {
    let few = [("samples = 128", "samples = 16"), ("depth = 1000", "depth = 50")];
    let even = rendered(FURNACE, &few);
    let shaped = rendered("09-microfacets/furnace-phong.toml", &few);
    let comparison = compared(&shaped, &jpeg(&even, 88));
    assert_eq!(names(&comparison), ["expected_even"]);
    assert_eq!(comparison.verdict(true), Verdict::Differs);
    assert!(!text(&comparison).contains("camera"), "{}", text(&comparison));
    assert_eq!(names(&compared(&even, &jpeg(&shaped, 88))), ["flat"]);
}

#[test]
fn another_background_behind_the_right_shapes_is_called_so() {
    let small = ("size = [480, 300]", "size = [240, 150]");
    let expected = jpeg(&rendered(ENVIRONMENT, &[small]), 88);
    for scene in ["one-face-flipped", "exercise-lookup", "without"] {
        let mine = rendered(&format!("06-environment-map/environment-{scene}.toml"), &[small]);
        let comparison = compared(&mine, &expected);
        let [fits, by_chance] = only(&comparison, "partial", ["fits", "by_chance"]);
        assert!(fits > 0.2 && fits > 4.0 * by_chance, "{scene}: {fits} {by_chance}");
        assert!(text(&comparison).contains("`skycube grade` finds out"), "{scene}");
        assert_eq!(comparison.verdict(true), Verdict::Differs);
    }
    // From elsewhere nothing stands where it should.
    let elsewhere = rendered(ENVIRONMENT, &[small, ("position = [0.0, -6.2, 1.9]", "position = [5.0, -4.0, 1.9]")]);
    assert_eq!(names(&compared(&elsewhere, &expected)), ["unrelated"]);
}

#[test]
fn another_field_of_view_is_measured() {
    let tangent = |degrees: f64| (degrees.to_radians() / 2.0).tan();
    for (scene, right, wrong) in [(SPHERES, 45, 50), (SPHERES, 45, 90), (BALLS, 27, 34), (BALLS, 27, 22)] {
        let view = |angle: i32| format!("field_of_view = {angle}");
        let (expected, mine) = (rendered(scene, &[]), rendered(scene, &[(&view(right), &view(wrong))]));
        let comparison = compared(&mine, &jpeg(&expected, 88));
        let [factor] = only(&comparison, "scaled", ["factor"]);
        let exact = tangent(f64::from(right)) / tangent(f64::from(wrong));
        assert!((factor / exact - 1.0).abs() < 0.01, "{factor} for {exact}");
    }
}

/// What a camera shows whose half width is `factor` times the right one.
fn widened(scene: &str, [width, height]: [usize; 2], factor: f64) -> Raster {
    let wide = (4.0 * width as f64 * factor).round() as usize;
    let (from, to) = (format!("size = [{width}, {height}]"), format!("size = [{wide}, {}]", 4 * height));
    let large = rendered(scene, &[(&from, &to)]);
    Raster::from_function(width, height, |x, y| large.pixel((2 * x + 1) * wide / (2 * width), 4 * y + 2))
}

#[test]
fn a_wrong_factor_of_width_to_height_is_named() {
    let aspect = 320.0 / 240.0;
    let expected = jpeg(&rendered(SPHERES, &[]), 88);
    for (factor, words) in [
        (
            1.0 / aspect,
            "stretched horizontally by 1.33 = width/height: the factor width/height of the half width is forgotten",
        ),
        (
            aspect,
            "squeezed horizontally, by 0.75 = height/width: the factor width/height of the half width is applied twice",
        ),
        (1.0 / aspect / aspect, "the half width has the factor height/width in place of width/height"),
    ] {
        let comparison = compared(&widened(SPHERES, [320, 240], factor), &expected);
        let [seen] = only(&comparison, "stretched", ["factor"]);
        assert!((seen * factor - 1.0).abs() < 0.015, "{factor}: {seen}");
        assert_eq!(comparison.verdict(true), Verdict::Differs);
        assert!(text(&comparison).contains(words), "{}", text(&comparison));
    }
}

#[test]
fn other_tones_in_the_right_places_are_no_other_scene() {
    let expected = rendered("02-normals/ball-smooth.toml", &[]);
    let ground = expected.pixel(0, 0);
    // Normals that point inwards, not turned: complementary colours on the left, no light on the right.
    let inside_out = Raster::from_function(expected.width(), expected.height(), |x, y| match expected.pixel(x, y) {
        pixel if (pixel - ground).abs().max_element() < 0.01 => pixel,
        pixel if 2 * x < expected.width() => Vec3::ONE - pixel,
        _ => Vec3::ZERO,
    });
    let pixels = rendered(BALLS, &[]);
    let negative = Raster::from_function(pixels.width(), pixels.height(), |x, y| Vec3::ONE - pixels.pixel(x, y));
    for (mine, expected, least) in [(&inside_out, &expected, 0.2), (&negative, &pixels, 0.9)] {
        let comparison = compared(mine, &jpeg(expected, 88));
        let [outlines, inverted] = only(&comparison, "recoloured", ["outlines", "inverted"]);
        println!("outlines {outlines:.3}, inverted {inverted:.3}");
        assert!(outlines > 0.75 && inverted > least, "{outlines} {inverted}");
        assert_eq!(comparison.verdict(true), Verdict::Differs);
        let text = text(&comparison);
        assert!(text.contains("All outlines are in place") && !text.contains("field of view"), "{text}");
    }
}

#[test]
fn the_sentences_blame_the_formula_that_is_wrong() {
    let expected = rendered(SPHERES, &[]);
    let turned = Raster::from_function(320, 240, |x, y| expected.pixel(319 - x, 239 - y));
    let turned = text(&compared(&turned, &file_of(&expected)));
    assert!(turned.contains("turned by 180°: right = up x forward in place of forward x up"), "{turned}");
    let mirrored = text(&compared(&flipped(&expected), &file_of(&expected)));
    assert!(
        mirrored.contains("flipped left-right: x of the pixel has the wrong sign, or right was negated"),
        "{mirrored}"
    );
}

#[test]
fn what_is_clearly_different_in_one_place_never_matches() {
    let narrow = rendered(WIDE, &[("exponent = 6 ", "exponent = 60 ")]);
    let wide = rendered(WIDE, &[]);
    let weak = rendered(WIDE, &[("specular = 0.2", "specular = 0.02")]);
    for (mine, expected) in [(&narrow, &wide), (&wide, &narrow), (&weak, &wide), (&wide, &weak)] {
        for expected in [file_of(expected), jpeg(expected, 85)] {
            let comparison = compared(mine, &expected);
            assert!(
                comparison.views.before.metrics.flip < 0.05 && comparison.worst.flip >= 0.3,
                "{:?}",
                comparison.worst
            );
            assert_eq!(names(&comparison), ["region"]);
            assert_eq!(comparison.verdict(true), Verdict::Differs);
        }
    }
    // Fireflies and noise are not another thing.
    let mut fireflies = wide.clone();
    for index in 0..12 {
        fireflies.set(23 + 29 * index, 17 + 19 * index, Vec3::ONE);
    }
    for mine in [&fireflies, &noisy(&wide, 0.04)] {
        let comparison = compared(mine, &jpeg(&wide, 85));
        assert!(!names(&comparison).contains(&"region".to_owned()), "{:?}", names(&comparison));
        assert_eq!(comparison.verdict(true), Verdict::Matches);
    }
    let loud = compared(&noisy(&wide, 0.25), &jpeg(&wide, 85));
    assert!(loud.worst.flip >= 0.3 && !loud.clearly_different, "{:?}", loud.worst);
    assert_eq!(names(&loud), ["noise"]);
}

#[test]
fn rays_through_the_corners_of_pixels_are_named_and_rough_edges_are_no_noise() {
    let [fine, right] = [("size = [2560, 1920]", 8), ("size = [320, 240]", 1)].map(|(size, factor)| {
        let picture = rendered(SPHERES, &[("size = [320, 240]", size)]);
        Raster::from_function(320, 240, |x, y| picture.pixel(factor * x, factor * y))
    });
    // The finest pixel at the corner of a pixel: 1/16 of a pixel away from it.
    assert_eq!(names(&compared(&fine, &jpeg(&right, 88))), ["shift 0.5 0.5"]);
    let smooth = rendered(SPHERES, &[("size = [320, 240]", "size = [320, 240]\nsamples = 16")]);
    let [one, sixteen] = ["one-sample", "sixteen-samples"]
        .map(|samples| rendered(&format!("07-antialiasing-depth-of-field/row-{samples}.toml"), &[]));
    for (mine, expected) in [(&right, &smooth), (&smooth, &right), (&one, &sixteen), (&sixteen, &one)] {
        for expected in [file_of(expected), jpeg(expected, 88)] {
            assert_eq!(names(&compared(mine, &expected))[0], "edges");
        }
    }
}
