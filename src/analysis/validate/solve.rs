//! From the cheapest arrangement to the fix: of all that are equally good the one with the fewest and simplest changes.

use super::arrangement::{Arrangement, Puzzle};
use super::border::Borders;
use super::convention::{self, Convention};
use super::edge::EdgeBorders;
use super::foreign::{self, Foreign, Reason};
use super::handedness::mirrored_faces;
use super::pair_cost::PairCosts;
use super::search::{Freedom, cheapest};
use super::symmetry::Symmetry;
use super::{CheckOptions, Names};
use crate::envmap::{CubeMap, Face, FaceLookup, Lookup, SignedAxis};
use crate::error::Result;

/// The answer of the search.
#[derive(Debug, Clone)]
pub struct Solution {
    pub arrangement: Arrangement,
    pub convention: Option<Convention>,
    /// By face how many of the seven other orientations are decisively worse, whatever the other faces then do, or show the
    /// same picture.
    pub excluded: [usize; 6],
    /// The standard errors by which the best essentially different arrangement is worse.
    pub margin: f64,
    /// Arrangements that are equally good, this one among them.
    pub equivalents: usize,
    /// The face whose image does not belong.
    pub foreign: Option<Foreign>,
    /// True if something is wrong that the pixels show but cannot mend: nothing that would change is decided.
    pub unsettled: bool,
}

/// The mean fit of seams from which on the six pictures have nothing to do with each other.
pub const UNRELATED: f64 = 0.85;

impl Solution {
    /// Faces of which at least four other orientations are decisively worse.
    pub fn telling_faces(&self) -> usize {
        self.excluded.iter().filter(|&&excluded| excluded >= 4).count()
    }

    /// True if at least half of the faces tell how they lie, and so do those that change.
    fn tells(&self, given: &Arrangement) -> bool {
        let relaid = |&face: &usize| {
            self.arrangement.images[face] == given.images[face] && self.arrangement.orientations[face] != 0
        };
        self.telling_faces() >= 3 && (0..6).filter(relaid).all(|face| self.excluded[face] >= 3)
    }
}

/// What the search is about.
pub struct Question<'a> {
    pub map: &'a CubeMap,
    pub images: &'a Borders,
    pub puzzle: &'a Puzzle,
    pub lookup: &'a Lookup,
    pub options: &'a CheckOptions,
    pub quake_names: bool,
    /// The image that shows the sky and the one that shows the ground, if the pictures tell.
    pub sky: Option<[Face; 2]>,
}

impl Question<'_> {
    pub fn given(&self) -> Arrangement {
        Arrangement::given(Face::ALL.map(|face| self.lookup.row(face).image))
    }

    /// Finds the fix. What the pixels do not tell for at least half of the faces is no ground to change anything.
    pub fn solve(&self) -> Result<Solution> {
        let (best, any_order) = self.best();
        for arrangement in [self.given(), best] {
            if let Some((foreign, arrangement)) = self.foreign(&arrangement)? {
                let image = arrangement.images[foreign.face.index()];
                // Were the others wrong too, the face would be one of several that changed places.
                if self.puzzle.compare_without(&best, &arrangement, &[image]).is_decisive() {
                    continue;
                }
                let solution = self.around(foreign, &arrangement)?;
                // Equal texels are no matter of chance, whatever the other faces tell.
                if matches!(foreign.reason, Reason::CopyOf(_)) || solution.tells(&self.given()) {
                    return Ok(solution);
                }
            }
        }
        let ties = self.ties(&best);
        let (arrangement, convention) = self.simplest(&best, &ties, any_order);
        let alike: usize = ties.iter().map(Vec::len).product();
        let solution = self.solution(arrangement, convention, &[], if any_order { 48 * alike } else { alike })?;
        let related = self.puzzle.mean_fit(&arrangement) < UNRELATED;
        if arrangement == self.given() || (related && solution.tells(&self.given())) {
            return Ok(self.keeping_undecided(solution));
        }
        let solution = self.solution(self.given(), None, &[], solution.equivalents)?;
        Ok(Solution { unsettled: !self.puzzle.ties(&best, &self.given()), ..solution })
    }

    /// The solution around a face that does not belong. What only the seams of strangers would gain is no ground to change
    /// anything: the given orientation stands where the others do not decide.
    fn around(&self, foreign: Foreign, arrangement: &Arrangement) -> Result<Solution> {
        let (map, puzzle) = (self.map, self.puzzle);
        let strangers = foreign::strangers(map, puzzle, self.images, arrangement, foreign.face)?;
        let given = self.given();
        let needed = puzzle.compare_without(arrangement, &given, &strangers).is_decisive();
        let found = if needed { *arrangement } else { given };
        let image = arrangement.images[foreign.face.index()];
        let face = found.face_of(image).unwrap_or(foreign.face);
        let solution = self.solution(found, None, &strangers, 1)?;
        Ok(self.keeping_undecided(Solution { foreign: Some(Foreign { face, ..foreign }), ..solution }))
    }

    fn foreign(&self, arrangement: &Arrangement) -> Result<Option<(Foreign, Arrangement)>> {
        let found = foreign::find(self.map, self.puzzle, self.images, arrangement)?;
        let Some((stranger, _)) = &found else { return Ok(None) };
        if stranger.reason != Reason::AnotherScene {
            return Ok(found);
        }
        // A frame that was seen around some of the images only would make them strangers to the others: the finding
        // must hold one row further inside all six, and inside the stranger alone.
        let image = arrangement.images[stranger.face.index()];
        for only in [None, Some(image)] {
            let mut within = self.images.clone();
            for inner in Face::ALL.into_iter().filter(|&face| only.is_none_or(|only| only == face)) {
                within[inner.index()].framed = true;
            }
            let puzzle = Puzzle { borders: EdgeBorders::new(self.lookup), costs: PairCosts::new(&within) };
            let again = foreign::find(self.map, &puzzle, &within, arrangement)?;
            if again.is_none_or(|(other, _)| other.face != stranger.face) {
                return Ok(None);
            }
        }
        Ok(found)
    }

    /// The cheapest arrangement, and whether images changed places for it.
    fn best(&self) -> (Arrangement, bool) {
        let trusted = cheapest(self.puzzle, &self.given(), Freedom::TRUSTED);
        let free = || cheapest(self.puzzle, &Arrangement::given(Face::ALL), Freedom::ANY_ORDER);
        match self.options.names {
            Names::Trusted => (trusted, false),
            Names::AnyOrder => (free(), true),
            Names::Auto => {
                let free = free();
                let renames = !self.puzzle.ties(&free, &trusted) || self.sky_is_elsewhere(&trusted);
                if renames { (free, true) } else { (trusted, false) }
            }
        }
    }

    fn solution(
        &self,
        arrangement: Arrangement,
        convention: Option<Convention>,
        strangers: &[Face],
        equivalents: usize,
    ) -> Result<Solution> {
        let (excluded, margin) = self.alternatives(&arrangement, strangers)?;
        Ok(Solution { arrangement, convention, excluded, margin, equivalents, foreign: None, unsettled: false })
    }

    /// By face the orientations that are as good as the best one's, itself first.
    fn ties(&self, best: &Arrangement) -> [Vec<usize>; 6] {
        Face::ALL.map(|face| {
            let own = best.orientations[face.index()];
            let others = (0..8).filter(|&orientation| orientation != own);
            let tied = others.filter(|&orientation| self.puzzle.ties(best, &best.with_orientation(face, orientation)));
            std::iter::once(own).chain(tied).collect()
        })
    }

    /// The simplest arrangement among those as good as the best, and the convention that it is.
    fn simplest(
        &self,
        best: &Arrangement,
        ties: &[Vec<usize>; 6],
        any_order: bool,
    ) -> (Arrangement, Option<Convention>) {
        let given = self.given();
        let named = convention::candidates(self.lookup, self.quake_names);
        let variants = variants(best, ties);
        let turned = || {
            variants.iter().flat_map(|variant| Symmetry::all().into_iter().map(|turn| turn.of(variant, self.lookup)))
        };
        let mut candidates = vec![given];
        candidates
            .extend(named.iter().map(|(_, known)| *known).filter(|known| any_order || known.images == given.images));
        if any_order {
            candidates.extend(turned());
        } else {
            candidates.extend(&variants);
        }
        let simplest = self.first_that_ties(best, candidates, &named).unwrap_or(*best);
        let name = |arrangement: &Arrangement| name(&named, arrangement);
        if self.options.names != Names::Auto || any_order || name(&simplest).is_some() || self.changes(&simplest) < 4 {
            return (simplest, name(&simplest));
        }
        // Names are trusted, but turning most faces is a poor explanation where a convention, or files that changed
        // places and are otherwise as they were, explain the same cube.
        let laid = self.changes(&simplest);
        let simpler = |arrangement: &Arrangement| match name(arrangement) {
            Some(_) => self.changes(arrangement) < laid,
            None => self.changes(arrangement) <= laid / 2 && self.mostly_renames(arrangement),
        };
        let renamed = named.iter().map(|(_, known)| *known).chain(turned()).filter(simpler).collect();
        let simplest = self.first_that_ties(best, renamed, &named).unwrap_or(simplest);
        (simplest, name(&simplest))
    }

    /// The simplest of the candidates that is as good as the best.
    fn first_that_ties(
        &self,
        best: &Arrangement,
        mut candidates: Vec<Arrangement>,
        named: &[(Convention, Arrangement)],
    ) -> Option<Arrangement> {
        candidates.sort_by_cached_key(|arrangement| self.complexity(arrangement, name(named, arrangement)));
        candidates.dedup();
        candidates.into_iter().find(|candidate| self.puzzle.ties(best, candidate))
    }

    /// Faces that an arrangement changes.
    fn changes(&self, arrangement: &Arrangement) -> usize {
        let given = self.given();
        let changed = |&face: &usize| {
            arrangement.images[face] != given.images[face] || arrangement.orientations[face] != given.orientations[face]
        };
        (0..6).filter(changed).count()
    }

    /// True if no image is renamed and laid anew, and at most one is laid anew at all.
    fn mostly_renames(&self, arrangement: &Arrangement) -> bool {
        let given = self.given();
        let laid = |&face: &usize| arrangement.orientations[face] != given.orientations[face];
        let renamed = |face: usize| arrangement.images[face] != given.images[face];
        (0..6).filter(laid).count() <= 1 && !(0..6).filter(laid).any(renamed)
    }

    /// The order of preference: the up axis that the user named; nothing changed; a convention as a whole; the
    /// fewest faces; the simplest changes; unmirrored before mirrored.
    fn complexity(&self, arrangement: &Arrangement, convention: Option<Convention>) -> impl Ord + use<> {
        let given = self.given();
        let changes = self.changes(arrangement);
        let mut weight = 0;
        for face in Face::ALL {
            let renamed = arrangement.images[face.index()] != given.images[face.index()];
            let laid = match arrangement.orientations[face.index()] {
                0 => 0,
                1 | 2 => 1,
                3 => 2,
                _ => 3,
            };
            weight += laid + 10 * usize::from(renamed);
        }
        let unnamed = changes > 0 && convention.is_none();
        let mirrored = mirrored_faces(&corrected(self.lookup, arrangement)).len();
        (self.sky_is_elsewhere(arrangement), unnamed, changes, weight, mirrored, *arrangement)
    }

    /// True if the user named an up axis, the pictures show sky and ground, and the sky lies elsewhere.
    fn sky_is_elsewhere(&self, arrangement: &Arrangement) -> bool {
        let (Some(up), Some([sky, ground])) = (self.options.world_up, self.sky) else { return false };
        let image =
            |axis: SignedAxis| arrangement.images[Face::on_axis(usize::from(axis.axis), !axis.negative).index()];
        (image(up), image(-up)) != (sky, ground)
    }
}

/// The convention that an arrangement is.
fn name(named: &[(Convention, Arrangement)], arrangement: &Arrangement) -> Option<Convention> {
    named.iter().find(|(_, known)| known == arrangement).map(|&(convention, _)| convention)
}

/// The combinations of equally good orientations, at most a few thousand of them.
fn variants(best: &Arrangement, ties: &[Vec<usize>; 6]) -> Vec<Arrangement> {
    const MOST: usize = 4096;
    let mut variants = vec![*best];
    for face in Face::ALL {
        if variants.len() * ties[face.index()].len() > MOST {
            continue;
        }
        let orientations = &ties[face.index()];
        variants = variants
            .iter()
            .flat_map(|variant| {
                orientations.iter().map(move |&orientation| variant.with_orientation(face, orientation))
            })
            .collect();
    }
    variants
}

/// The lookup that an arrangement amounts to.
pub fn corrected(lookup: &Lookup, arrangement: &Arrangement) -> Lookup {
    let rows = Face::ALL.map(|face| FaceLookup {
        image: arrangement.images[face.index()],
        ..arrangement.orientation(face).of_row(lookup.row(face))
    });
    Lookup::new(rows, lookup.v_origin()).expect("a laid row spans its face")
}
