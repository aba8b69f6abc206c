//! Damage done to a right map, and how it came back.

use rayon::prelude::*;
use skycube::envmap::{Face, Orientation};
use skycube::stress::Random;
use skycube::validate::{Check, FaceFix, Names};

use super::pictures::Map;

/// How a damaged map came back.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Outcome {
    /// Pixel for pixel the original, or turned or mirrored as a whole where images may change places.
    Recovered,
    /// All that differs from the original are faces called undecided and left as they were, and they are undecided in
    /// the original too: by the evidence the result is as good.
    Tied,
    /// All that differs from the original are faces called undecided and left as they were, but in the original the
    /// pixels decide them.
    Undecided,
    Wrong,
}

/// What was done to a map: per face the image and the orientation of that image.
#[derive(Debug, Clone, Copy)]
pub struct Damage {
    pub images: [usize; 6],
    pub orientations: [Orientation; 6],
}

impl Damage {
    pub const NONE: Self = Self { images: [0, 1, 2, 3, 4, 5], orientations: [Orientation::IDENTITY; 6] };

    /// One face in another orientation.
    pub fn orientation(face: usize, orientation: Orientation) -> Self {
        let mut damage = Self::NONE;
        damage.orientations[face] = orientation;
        damage
    }

    /// Two images in each other's place.
    pub fn swap(one: usize, other: usize) -> Self {
        let mut damage = Self::NONE;
        damage.images.swap(one, other);
        damage
    }

    /// Each of the seven wrong orientations on each face.
    pub fn of_one_face() -> Vec<Self> {
        let wrong =
            |face: usize| Orientation::ALL[1..].iter().map(move |&orientation| Self::orientation(face, orientation));
        (0..6).flat_map(wrong).collect()
    }

    pub fn random_orientations(count: usize) -> Vec<Self> {
        let mut random = Random(7);
        (0..count)
            .map(|_| Self { orientations: [(); 6].map(|()| Orientation::ALL[random.below(8)]), ..Self::NONE })
            .collect()
    }

    pub fn swaps(count: usize) -> Vec<Self> {
        let mut random = Random(11);
        let mut swap = || {
            let (one, other) = (random.below(6), random.below(5));
            Self::swap(one, if other >= one { other + 1 } else { other })
        };
        (0..count).map(|_| swap()).collect()
    }
}

/// Counts of one row of the table.
#[derive(Debug, Default)]
pub struct Tally {
    pub recovered: usize,
    pub tied: usize,
    pub undecided: usize,
    pub wrong: Vec<String>,
}

/// A right map, and what the check says of it as it is.
pub struct Recovery<'a> {
    map: &'a Map,
    names: Names,
    /// The images that the pixels of the right map decide.
    decided: [bool; 6],
}

impl<'a> Recovery<'a> {
    pub fn of(map: &'a Map, names: Names) -> Self {
        Self { map, names, decided: map.check(names).fix.faces.map(|fix| fix.decided) }
    }

    pub fn outcomes(&self, damages: &[Damage]) -> Vec<Outcome> {
        damages.par_iter().map(|damage| self.outcome(damage)).collect()
    }

    pub fn tally(&self, damages: &[Damage]) -> Tally {
        let mut tally = Tally::default();
        for (damage, outcome) in damages.iter().zip(self.outcomes(damages)) {
            match outcome {
                Outcome::Recovered => tally.recovered += 1,
                Outcome::Tied => tally.tied += 1,
                Outcome::Undecided => tally.undecided += 1,
                Outcome::Wrong => tally.wrong.push(self.described(damage)),
            }
        }
        tally
    }

    /// Damages the map, checks it and says whether the fix undoes the damage.
    pub fn outcome(&self, damage: &Damage) -> Outcome {
        let damaged = self.map.damaged(&damage.images, &damage.orientations);
        let check = damaged.check(self.names);
        assert_undecided_change_for_the_better(&damaged, &check);
        let mut unlike = Vec::new();
        for fix in check.fix.faces {
            // What the face shows after the fix: which original image, in which orientation.
            let source = damage.images[fix.image.index()];
            let orientation = damage.orientations[fix.image.index()].after(fix.orientation);
            if self.map.looks_alike(source, orientation, fix.face.index()) {
                continue;
            }
            if fix.decided || source != fix.face.index() {
                return self.equivalent_or_wrong(damage, &check);
            }
            unlike.push(source);
        }
        if unlike.is_empty() { Outcome::Recovered } else { self.left_alone(&unlike) }
    }

    /// What was done and what was found, for messages.
    fn described(&self, damage: &Damage) -> String {
        let check = self.map.damaged(&damage.images, &damage.orientations).check(self.names);
        let done = damage.orientations.map(|orientation| orientation.formulas());
        let found = check.fix.faces.map(|fix| (fix.image.name(), fix.orientation.formulas(), fix.decided));
        format!("images {:?} in {done:?}: {:?} {found:?} {:?}", damage.images, check.verdict, check.outliers)
    }

    /// The outcome if these original images are undecided and do not lie as in the original.
    fn left_alone(&self, images: &[usize]) -> Outcome {
        if images.iter().any(|&image| self.decided[image]) { Outcome::Undecided } else { Outcome::Tied }
    }

    /// With images that change places the original may come back turned or mirrored as a whole: then its seams are those
    /// of the original, pair by pair.
    fn equivalent_or_wrong(&self, damage: &Damage, check: &Check) -> Outcome {
        if self.names == Names::Trusted && damage.images == Damage::NONE.images {
            return Outcome::Wrong;
        }
        let images = check.fix.faces.map(|fix| damage.images[fix.image.index()]);
        let orientations = check.fix.faces.map(|fix| damage.orientations[fix.image.index()].after(fix.orientation));
        let fixed = self.map.damaged(&images, &orientations);
        let mut original = steps(self.map, &[]);
        let mut found = steps(&fixed, &[]);
        original.sort_unstable();
        found.sort_unstable();
        if found == original {
            return Outcome::Recovered;
        }
        // Where undecided faces lie otherwise the rest must still be equal: all broken seams are at such faces.
        let undecided: Vec<Face> = check.fix.faces.iter().filter(|fix| !fix.decided).map(|fix| fix.face).collect();
        let rest = steps(&fixed, &undecided);
        if undecided.is_empty() || !rest.iter().all(|step| original.contains(step)) {
            return Outcome::Wrong;
        }
        self.left_alone(&undecided.iter().map(|face| images[face.index()]).collect::<Vec<_>>())
    }
}

/// The steps at the seams of a map that touch none of some faces. Those of an equivalent map are the same in another order.
fn steps(map: &Map, without: &[Face]) -> Vec<i64> {
    let seams = map.check(Names::Trusted).seams;
    let kept = seams.iter().filter(|seam| !without.iter().any(|&face| seam.edge.touches(face)));
    kept.map(|seam| (seam.step * 1e6).round() as i64).collect()
}

/// A guess is no fix: a file whose face is not decided is not edited, unless its seams then step less. Where the files follow
/// an order, that says how an undecided face lies.
fn assert_undecided_change_for_the_better(damaged: &Map, check: &Check) {
    let story = &check.fix.story;
    let is_edited = |fix: &&FaceFix| !fix.decided && story.order.is_none() && story.edited.contains(&fix.face);
    for fix in check.fix.faces.iter().filter(is_edited) {
        let images = check.fix.faces.map(|fix| fix.image.index());
        let found = check.fix.faces.map(|fix| fix.orientation);
        let mut kept = found;
        kept[fix.face.index()] = Orientation::IDENTITY;
        let [found, kept] =
            [found, kept].map(|orientations| steps(&damaged.damaged(&images, &orientations), &[]).iter().sum::<i64>());
        assert!(found < kept, "{} is undecided and changed: {:?}", fix.face.name(), check.fix);
    }
}
