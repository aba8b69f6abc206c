//! The margins of the thresholds: shots of all maps at hand, taken by right code and by wrong code.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use super::super::field_of_view::{FINE_STEP, FINE_STEPS, degrees};
use super::super::matching::{best, lead, noise_around, variance};
use super::super::{Codes, Grader, Middle, SIDE, ShotFrame, candidates, mean_square};
use super::{angle, decisive, shown};
use crate::envmap::source::Skybox;
use crate::envmap::{CubeFilter, CubeMap, Face, Lookup, Preset, SignedAxis};
use crate::math::functions::exponential_f64;
use skycube_tracer::render::AxisShot;

/// Pixels of a side of the shots.
const PIXELS: usize = 64;

fn maps() -> Vec<(String, Skybox)> {
    let project = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../envmaps");
    let shared = std::env::var_os("SKYCUBE_SHARED_MAPS")
        .map_or_else(|| Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/envmaps"), PathBuf::from);
    let entries = [project, shared].into_iter().filter_map(|folder| std::fs::read_dir(folder).ok());
    let mut paths: Vec<PathBuf> = entries.flat_map(|entries| entries.flatten().map(|entry| entry.path())).collect();
    paths.sort();
    let skybox = |path: PathBuf| Some((path.file_name()?.to_string_lossy().into_owned(), Skybox::open(&path).ok()?));
    paths.into_iter().filter_map(skybox).collect()
}

fn frames() -> [ShotFrame; 6] {
    let frame = |shot: AxisShot| ShotFrame { face: shot.direction, right: shot.right(), up: shot.up };
    AxisShot::all(SignedAxis::POS_Y).map(frame)
}

/// The six shots as code takes them that reads the map by a lookup, or forgets to divide, with half the extent of a camera of 90
/// degrees or another.
fn shots(map: &CubeMap, lookup: &Lookup, divides: bool, reach: f32) -> [Codes; 6] {
    frames().map(|frame| {
        let at = |index: usize| reach * (2.0 * (index as f32 + 0.5) / PIXELS as f32 - 1.0);
        let pixel = |index: usize| {
            let (x, y) = (at(index % PIXELS), -at(index / PIXELS));
            let direction = frame.face.normal() + frame.right.direction() * x + frame.up.direction() * y;
            let mut point = lookup.locate(direction);
            if !divides {
                let length = direction.length();
                point.u = (2.0 * point.u - 1.0) / length / 2.0 + 0.5;
                point.v = (2.0 * point.v - 1.0) / length / 2.0 + 0.5;
            }
            map.sample(lookup.direction(point)).to_array().map(crate::colour::encode_srgb)
        };
        Codes { width: PIXELS, height: PIXELS, values: (0..PIXELS * PIXELS).flat_map(pixel).collect() }
    })
}

/// Values of right shots and of wrong ones by threshold, with the map that has each.
#[derive(Default)]
struct Table(BTreeMap<&'static str, [Vec<(f64, String)>; 2]>);

impl Table {
    fn add(&mut self, threshold: &'static str, is_right: bool, value: f64, name: &str) {
        self.0.entry(threshold).or_default()[usize::from(!is_right)].push((value, name.to_owned()));
    }

    /// The line of a threshold that a fault exceeds (or, if `below`, falls short of): the nearest values on both sides.
    fn print(&self, name: &'static str, threshold: f64, below: bool) {
        let by_value = |a: &&(f64, String), b: &&(f64, String)| a.0.total_cmp(&b.0);
        let [right, wrong] = [0, 1].map(|side| {
            let values = self.0[name][side].iter();
            let nearest = if (side == 0) != below { values.max_by(by_value) } else { values.min_by(by_value) };
            nearest.map_or_else(|| "-".to_owned(), |(value, map)| format!("{value:.4} ({map})"))
        });
        println!("{name:16} {threshold:8.4}  {right:34}  {wrong}");
    }
}

/// What the shots of a map leave unexplained, and how far the images that they do not show are behind.
fn explained(table: &mut Table, grader: &Grader, shots: &[Codes; 6], is_right: bool, name: &str) {
    let views = grader.views(&grader.images, shots);
    let images = views.levels(1.0, SIDE);
    for face in Face::ALL {
        let shot = views.shot(face.index(), 1.0, SIDE);
        let coarse = |values: &[f32]| {
            let codes = Codes { width: SIDE, height: SIDE, values: values.to_vec() };
            codes.reduced(Middle(1.0), super::super::COARSE).values
        };
        let all = candidates(&images, views.expected[face.index()], &shot, views.screens[face.index()], SIDE);
        let found = best(&all);
        let unexplained = mean_square(&coarse(&found.fitted), &coarse(&shot));
        table.add("NEGLIGIBLE", is_right, unexplained, name);
        if variance(&coarse(&shot)) < shown::NEGLIGIBLE {
            continue;
        }
        if unexplained > shown::NEGLIGIBLE {
            table.add("UNEXPLAINED", is_right, unexplained / variance(&coarse(&shot)), name);
        }
        if is_right {
            table.add("FLAT", true, variance(&shot), name);
            table.add("NEARLY_UNIFORM", true, variance(&shot), name);
            table.add("SURE_NOISE", true, mean_square(&found.fitted, &shot).sqrt(), name);
            let noise = noise_around(&found.fitted, &shot, SIDE);
            for other in all.iter().filter(|other| other.placement.image != found.placement.image) {
                if let Some((near, lead)) = lead(&found.fitted, &other.fitted, &shot, &noise) {
                    table.add("NEARNESS", false, near, name);
                    table.add("DEVIATIONS", false, lead, name);
                }
            }
        }
    }
}

/// The scale that explains shots best, and what it explains more than 1 does.
fn scaled(table: &mut Table, grader: &Grader, shots: &[Codes; 6], is_right: bool, name: &str) {
    let views = grader.views(&grader.images, shots);
    let placements = views.placements(1.0);
    if placements.is_empty() {
        return;
    }
    let scales = (-FINE_STEPS..=FINE_STEPS).map(|step| exponential_f64(FINE_STEP * f64::from(step)));
    let scored = scales.map(|scale| (scale, views.misfit_of(&placements, scale)));
    let (scale, misfit) = scored.min_by(|a, b| a.1.total_cmp(&b.1)).expect("there are scales");
    let misfit_of_one = views.misfit_of(&placements, 1.0);
    table.add("TOLERANCE", is_right, (scale - 1.0).abs(), name);
    table.add("TELLING", is_right, misfit_of_one - misfit, name);
    table.add("HARDLY_BETTER", is_right, misfit / misfit_of_one, name);
}

/// What is left of shots if their code did not divide.
fn undivided(table: &mut Table, grader: &Grader, shots: &[Codes; 6], is_right: bool, name: &str) {
    let misfit = grader.views(&grader.images, shots).misfit(1.0);
    table.add("UNDIVIDED", is_right, misfit, name);
    table.add("WORTH_A_SEARCH", is_right, misfit, name);
    let images = grader.images.each_ref().map(|image| image.undivided(1.0));
    table.add("MUCH_BETTER", is_right, grader.views(&images, shots).misfit(1.0) / misfit, name);
}

#[test]
#[ignore = "prints the margins of all maps at hand"]
fn margins() {
    let maps = maps();
    let lookup = Preset::Opengl.lookup();
    let mut table = Table::default();
    for (index, (name, skybox)) in maps.iter().enumerate() {
        let map = CubeMap::from_skybox(skybox, lookup, CubeFilter::Bilinear);
        let other = CubeMap::from_skybox(&maps[(index + 1) % maps.len()].1, lookup, CubeFilter::Bilinear);
        let grader = Grader::new(&map, frames()).expect("the map can be read");
        let right = shots(&map, &lookup, true, 1.0);
        explained(&mut table, &grader, &right, true, name);
        explained(&mut table, &grader, &shots(&other, &lookup, true, 1.0), false, name);
        undivided(&mut table, &grader, &right, true, name);
        undivided(&mut table, &grader, &shots(&map, &lookup, false, 1.0), false, name);
        // A camera of 86 degrees: tan 43.
        scaled(&mut table, &grader, &right, true, name);
        scaled(&mut table, &grader, &shots(&map, &lookup, true, 0.9325), false, name);
        // The camera that sees as much as code that does not halve.
        let angle = degrees(grader.views(&grader.images, &shots(&map, &lookup, true, 2.0)).scale());
        table.add("DEGREES", true, (angle - degrees(2.0)).abs(), name);
    }
    println!("{} maps", maps.len());
    println!("{:16} {:>8}  {:34}  wrong ones have", "threshold", "value", "right shots reach");
    for (name, value) in [
        ("UNEXPLAINED", shown::UNEXPLAINED),
        ("NEGLIGIBLE", shown::NEGLIGIBLE),
        ("UNDIVIDED", shown::UNDIVIDED),
        ("WORTH_A_SEARCH", angle::WORTH_A_SEARCH),
        ("TOLERANCE", angle::TOLERANCE),
        ("TELLING", angle::TELLING),
        ("DEGREES", angle::DEGREES),
        ("SURE_NOISE", decisive::SURE_NOISE),
        // A shot lies nearer to what it shows; the two of a plain pair are the same.
        ("NEARNESS", decisive::NEARNESS),
        ("DEVIATIONS", decisive::DEVIATIONS),
    ] {
        table.print(name, value, false);
    }
    println!("lower where something is wrong");
    for (name, value) in [
        ("MUCH_BETTER", shown::MUCH_BETTER),
        ("HARDLY_BETTER", angle::HARDLY_BETTER),
        ("FLAT", shown::FLAT),
        ("NEARLY_UNIFORM", angle::NEARLY_UNIFORM),
    ] {
        table.print(name, value, true);
    }
}
