//! The margins of the thresholds: shots of all maps at hand, taken by right code and by wrong code.

use std::path::{Path, PathBuf};

use super::super::matching::{best, lead, noise_around, variance};
use super::super::{Codes, Grader, Middle, SIDE, ShotFrame, candidates, mean_square};
use super::{angle, decisive, shown};
use crate::envmap::source::Skybox;
use crate::envmap::{CubeFilter, CubeMap, Face, Lookup, Preset, SignedAxis};
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

/// The six shots as code takes them that reads the map by a lookup, or forgets to divide.
fn shots(map: &CubeMap, lookup: &Lookup, divides: bool) -> [Codes; 6] {
    frames().map(|frame| {
        let at = |index: usize| 2.0 * (index as f32 + 0.5) / PIXELS as f32 - 1.0;
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

/// The least and the most of what is measured, with the map that has it.
#[derive(Default)]
struct Reach(Vec<(f64, String)>);

impl Reach {
    fn add(&mut self, value: f64, name: &str) {
        self.0.push((value, name.to_owned()));
    }

    fn shown(&self, most: bool) -> String {
        let by_value = |a: &&(f64, String), b: &&(f64, String)| a.0.total_cmp(&b.0);
        let found = if most { self.0.iter().max_by(by_value) } else { self.0.iter().min_by(by_value) };
        found.map_or_else(|| "-".to_owned(), |(value, name)| format!("{value:.4} ({name})"))
    }
}

#[test]
#[ignore = "prints the margins of all maps at hand"]
fn margins() {
    let maps = maps();
    let lookup = Preset::Opengl.lookup();
    let [mut own, mut foreign, mut right, mut undivided, mut nearness, mut deviations, mut textured] =
        std::array::from_fn(|_| Reach::default());
    for (index, (name, skybox)) in maps.iter().enumerate() {
        let map = CubeMap::from_skybox(skybox, lookup, CubeFilter::Bilinear);
        let other = CubeMap::from_skybox(&maps[(index + 1) % maps.len()].1, lookup, CubeFilter::Bilinear);
        let grader = Grader::new(&map, frames()).expect("the map can be read");
        let taken = shots(&map, &lookup, true);
        right.add(grader.views(&grader.images, &taken).misfit(1.0), name);
        undivided.add(grader.views(&grader.images, &shots(&map, &lookup, false)).misfit(1.0), name);
        for (shots, left) in [(&taken, &mut own), (&shots(&other, &lookup, true), &mut foreign)] {
            let views = grader.views(&grader.images, shots);
            let images = views.levels(1.0, SIDE);
            for face in Face::ALL {
                let shot = views.shot(face.index(), 1.0, SIDE);
                let coarse = |values: &[f32]| {
                    let codes = Codes { width: SIDE, height: SIDE, values: values.to_vec() };
                    codes.reduced(Middle(1.0), super::super::COARSE).values
                };
                if variance(&coarse(&shot)) < shown::NEGLIGIBLE {
                    continue;
                }
                let all = candidates(&images, views.expected[face.index()], &shot, views.screens[face.index()], SIDE);
                let found = best(&all);
                let unexplained = mean_square(&coarse(&found.fitted), &coarse(&shot));
                if unexplained > shown::NEGLIGIBLE {
                    left.add(unexplained / variance(&coarse(&shot)), name);
                }
                if std::ptr::eq(shots, &taken) {
                    textured.add(variance(&shot), name);
                    let noise = noise_around(&found.fitted, &shot, SIDE);
                    for other in all.iter().filter(|other| other.placement.image != found.placement.image) {
                        if let Some((near, lead)) = lead(&found.fitted, &other.fitted, &shot, &noise) {
                            nearness.add(near, name);
                            deviations.add(lead, name);
                        }
                    }
                }
            }
        }
    }
    println!("{} maps", maps.len());
    println!("{:16} {:>8}  {:34}  wrong ones have", "threshold", "value", "right shots reach");
    let line =
        |name: &str, value: f64, right: String, wrong: String| println!("{name:16} {value:8.4}  {right:34}  {wrong}");
    line("UNEXPLAINED", shown::UNEXPLAINED, own.shown(true), foreign.shown(false));
    line("UNDIVIDED", shown::UNDIVIDED, right.shown(true), undivided.shown(false));
    line("WORTH_A_SEARCH", angle::WORTH_A_SEARCH, right.shown(true), undivided.shown(false));
    line("NEARNESS", decisive::NEARNESS, "0.5 at most".to_owned(), nearness.shown(false));
    line("DEVIATIONS", decisive::DEVIATIONS, "0 at most".to_owned(), deviations.shown(false));
    println!(
        "NEARLY_UNIFORM   {:8.4}  shots with detail have {} or more",
        angle::NEARLY_UNIFORM,
        textured.shown(false)
    );
}
