//! One map that is damaged, stored and checked, and whether the answer is the truth.

use super::damage::Damage;
use super::world::World;
use crate::envmap::{CubeFilter, CubeMap, Face, FacePoint, LazyImage, Lookup, Preset};
use crate::math::Vec3;
use crate::picture::Picture;
use crate::validate::{Check, CheckOptions, ImageFacts, Verdict, check};

/// Places along a face at which two maps are compared.
const PLACES: usize = 16;

/// What an answer is worth.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Answer {
    /// The verdict and the repair are what was done.
    Right,
    /// The validator says less than what was done, and nothing untrue.
    Undecided,
    /// A verdict, a repair or a named face that is not what was done.
    Wrong,
}

/// Damages the pictures of a world, stores them and checks them.
pub fn answer(
    world: World,
    faces: &[Picture; 6],
    damage: Damage,
    stored: &(dyn Fn(Face, Picture) -> Picture + Sync),
) -> (Answer, String) {
    let damaged = damage.done_to(faces, world);
    let kept: Vec<Picture> = Face::ALL.iter().map(|&face| stored(face, damaged[face.index()].clone())).collect();
    let facts = Face::ALL.map(|face| facts(face, &kept[face.index()]));
    let kept: [Picture; 6] = kept.try_into().expect("there are six pictures");
    let options = CheckOptions { lookup_name: "opengl".to_owned(), ..CheckOptions::default() };
    let map = map_of(kept, Preset::Opengl.lookup());
    let check = check(&map, facts.to_vec(), &options).expect("pictures in memory can be read");
    (judged(&check, faces, damaged, damage), said(&check))
}

/// The answer in words.
fn said(check: &Check) -> String {
    let outliers = check.outliers.iter().map(|outlier| format!(", {} does not belong", outlier.face.name()));
    let given = Preset::Opengl.lookup();
    let changed = check.fix.faces.iter().filter(|fix| !fix.is_unchanged(&given)).map(|fix| {
        let (u, v) = fix.orientation.formulas();
        format!(", {} = {}({u}, {v})", fix.face.name(), fix.image.name())
    });
    format!("{}{}", check.verdict.name(), outliers.chain(changed).collect::<String>())
}

fn facts(face: Face, picture: &Picture) -> ImageFacts {
    let header = picture.header();
    let file = format!("{}.{}", face.name(), header.format.extension());
    ImageFacts { face, file, width: header.width, height: header.height, format: header.format, alpha: false }
}

fn map_of(pictures: [Picture; 6], lookup: Lookup) -> CubeMap {
    CubeMap::new(pictures.map(LazyImage::ready), lookup, CubeFilter::Nearest)
}

/// Compares the repaired map with the right one, texel by texel: it does not matter in which words the repair is told.
fn judged(check: &Check, faces: &[Picture; 6], damaged: [Picture; 6], damage: Damage) -> Answer {
    let named: Vec<Face> = check.outliers.iter().map(|outlier| outlier.face).collect();
    let truth = damage.outlier();
    let given = Preset::Opengl.lookup();
    let repaired = map_of(damaged, check.fix.lookup(&given));
    let others = || Face::ALL.into_iter().filter(|&face| Some(face) != truth);
    let is_restored = others().all(|face| shows(&repaired, face, &faces[face.index()]));
    let untrue = named.iter().any(|&face| Some(face) != truth)
        || (check.fix.changes > 0 && !is_restored)
        || (check.verdict == Verdict::Fits && (truth.is_some() || !is_restored));
    let expected = if damage == Damage::None { Verdict::Fits } else { Verdict::Broken };
    match (untrue, is_restored && named.first().copied() == truth && check.verdict == expected) {
        (true, _) => Answer::Wrong,
        (false, true) => Answer::Right,
        (false, false) => Answer::Undecided,
    }
}

/// True if a map shows the picture on a face.
fn shows(map: &CubeMap, face: Face, picture: &Picture) -> bool {
    let lookup = Preset::Opengl.lookup();
    let size = picture.width();
    let place = |index: usize| index * (size - 1) / (PLACES - 1);
    let centre = |index: usize| (index as f32 + 0.5) / size as f32;
    let same = |(x, y): (usize, usize)| -> bool {
        let direction: Vec3 = lookup.direction(FacePoint { face, u: centre(x), v: centre(y) });
        map.sample(direction) == picture.texel(x, y)
    };
    (0..PLACES * PLACES).map(|at| (place(at % PLACES), place(at / PLACES))).all(same)
}
