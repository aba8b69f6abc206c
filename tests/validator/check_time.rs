//! `check` on six 2048^2 JPEGs costs at most 1.25 times what decoding them costs.

use std::time::{Duration, Instant};

use crate::common;

use skycube::envmap::Preset;
use skycube::envmap::source::Skybox;
use skycube::validate::{CheckOptions, ImageFacts, check, load};

#[test]
#[ignore = "measures time: run it alone, in release"]
fn checking_costs_little_more_than_decoding() {
    let Some(folder) = common::shared_map("meadow") else { return };
    let skybox = Skybox::open(&folder).unwrap();
    let (mut decoding, mut all) = (Duration::MAX, Duration::MAX);
    for _ in 0..10 {
        let started = Instant::now();
        let map = load(&skybox, Preset::Opengl.lookup()).unwrap();
        let decoded = started.elapsed();
        check(&map, ImageFacts::of_skybox(&skybox), &CheckOptions::default()).unwrap();
        let checked = started.elapsed();
        decoding = decoding.min(decoded);
        all = all.min(checked);
    }
    println!("decoding {decoding:?}, decoding and checking {all:?}: {:.3}", all.as_secs_f64() / decoding.as_secs_f64());
    assert!(all.as_secs_f64() < 1.25 * decoding.as_secs_f64());
}
