//! FLIP against the implementation of its authors, and against closed forms.

use std::path::Path;

use super::*;

fn compass(face: &str) -> Raster {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../../envmaps/compass/{face}.png"));
    crate::picture::read(&path).unwrap().to_raster()
}

/// Values of NVIDIA's flip-evaluator 1.7 (from PyPI; LDR, 67.02 pixels a degree) on the same files: the mean of its map in
/// double precision (it adds up in single, and is 5e-4 off), and the pixels (10, 10), (50, 100) and (220, 200), as column
/// and row.
#[test]
fn agrees_with_the_implementation_of_its_authors() {
    for (picture, reference, mean, pixels) in [
        ("posx", "negy", 0.730_019_03, [0.959_703_2, 0.646_494_57, 0.984_235_47]),
        ("posx", "posy", 0.875_772_95, [0.957_564_1, 0.958_675, 0.137_887_51]),
        ("posz", "negz", 0.908_013_22, [0.953_596_7, 0.968_257_07, 0.984_324_3]),
    ] {
        let map = flip_map(&compass(picture), &compass(reference));
        assert!((map.mean() - mean).abs() < 2e-5, "{picture} {reference}: {} against {mean}", map.mean());
        for ((x, y), expected) in [(10, 10), (50, 100), (220, 200)].into_iter().zip(pixels) {
            let value = map.at(x, y);
            assert!((value - expected).abs() < 2e-5, "{picture} {reference} ({x}, {y}): {value} against {expected}");
        }
    }
}

#[test]
fn equal_pictures_differ_nowhere() {
    let picture = compass("posx");
    assert!(flip_map(&picture, &picture).values().iter().all(|&value| value == 0.0));
}

#[test]
fn flat_pictures_differ_by_the_distance_of_their_colours() {
    let flat = |colour: Vec3| Raster::filled(24, 16, colour);
    // Green and blue are the farthest colours of a display.
    let map = flip_map(&flat(Vec3::Y), &flat(Vec3::Z));
    assert!(map.values().iter().all(|value| (value - 1.0).abs() < 1e-4), "{:?}", map.at(3, 3));
    // Black and white: |L| = 100, so 100^0.7 brought into range; no features. Largest distance: green against blue, Lab
    // (87.73, -86.18, 83.18) and (32.30, 79.19, -107.86), adjusted by L / 100.
    let green: [f64; 3] = [87.734, -0.87734 * 86.183, 0.87734 * 83.179];
    let blue: [f64; 3] = [32.297, 0.32297 * 79.188, -0.32297 * 107.86];
    let chroma = ((green[1] - blue[1]).powi(2) + (green[2] - blue[2]).powi(2)).sqrt();
    let largest = (green[0] - blue[0] + chroma).powf(0.7);
    let expected = 0.95 + (100f64.powf(0.7) - 0.4 * largest) / (0.6 * largest) * 0.05;
    let map = flip_map(&flat(Vec3::ZERO), &flat(Vec3::ONE));
    assert!((map.mean() - expected).abs() < 1e-3, "{} {expected}", map.mean());
}

#[test]
fn is_symmetric() {
    let (a, b) = (compass("posx"), compass("posy"));
    assert_eq!(flip_map(&a, &b), flip_map(&b, &a));
}
