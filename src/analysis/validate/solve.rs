//! From the cheapest arrangement to the fix: of all that are equally good the one with the fewest and simplest changes.

use super::borders::border::Borders;
use super::borders::edge::EdgeBorders;
use super::borders::pair_cost::PairCosts;
use super::outlier::{self, Outlier, Reason};
use super::search::arrangement::{Arrangement, Problem};
use super::search::branch_and_bound::{Freedom, cheapest};
use super::search::convention::mirrored_faces;
use super::search::convention::{self, Convention};
use super::search::symmetry::Symmetry;
use super::{CheckOptions, Names};
use crate::envmap::{CubeMap, Face, FaceLookup, Lookup, Orientation, SignedAxis};
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
    pub outlier: Option<Outlier>,
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
pub struct Search<'a> {
    pub map: &'a CubeMap,
    pub images: &'a Borders,
    pub problem: &'a Problem,
    pub lookup: &'a Lookup,
    pub options: &'a CheckOptions,
    pub quake_names: bool,
    /// The image that shows the sky and the one that shows the ground, if the pictures tell.
    pub sky: Option<[Face; 2]>,
}

impl Search<'_> {
    pub fn given(&self) -> Arrangement {
        Arrangement::given(Face::ALL.map(|face| self.lookup.row(face).image))
    }

    /// Finds the fix. What the pixels do not tell for at least half of the faces is no ground to change anything.
    pub fn solve(&self) -> Result<Solution> {
        let (best, any_order) = self.best();
        for arrangement in [self.given(), best] {
            if let Some((outlier, arrangement)) = self.outlier(&arrangement)? {
                let image = arrangement.images[outlier.face.index()];
                // Were the others wrong too, the face would be one of several that changed places.
                if self.problem.compare_without(&best, &arrangement, &[image]).is_decisive() {
                    continue;
                }
                let solution = self.around(outlier, &arrangement)?;
                // Equal texels are no matter of chance, whatever the other faces tell.
                if matches!(outlier.reason, Reason::CopyOf(_)) || solution.tells(&self.given()) {
                    return Ok(solution);
                }
            }
        }
        let ties = self.ties(&best);
        let (arrangement, convention) = self.simplest(&best, &ties, any_order);
        let alike: usize = ties.iter().map(Vec::len).product();
        let solution = self.solution(arrangement, convention, &[], if any_order { 48 * alike } else { alike })?;
        let related = self.problem.mean_fit(&arrangement) < UNRELATED;
        if arrangement == self.given() || (related && solution.tells(&self.given())) {
            return Ok(self.keeping_undecided(solution));
        }
        let solution = self.solution(self.given(), None, &[], solution.equivalents)?;
        Ok(Solution { unsettled: !self.problem.ties(&best, &self.given()), ..solution })
    }

    /// The solution around a face that does not belong. What only the seams of outliers would gain is no ground to change
    /// anything: the given orientation stands where the others do not decide.
    fn around(&self, outlier: Outlier, arrangement: &Arrangement) -> Result<Solution> {
        let (map, problem) = (self.map, self.problem);
        let outliers = outlier::outliers(map, problem, self.images, arrangement, outlier.face)?;
        let given = self.given();
        let needed = problem.compare_without(arrangement, &given, &outliers).is_decisive();
        let found = if needed { *arrangement } else { given };
        let image = arrangement.images[outlier.face.index()];
        let face = found.face_of(image).unwrap_or(outlier.face);
        let solution = self.solution(found, None, &outliers, 1)?;
        Ok(self.keeping_undecided(Solution { outlier: Some(Outlier { face, ..outlier }), ..solution }))
    }

    fn outlier(&self, arrangement: &Arrangement) -> Result<Option<(Outlier, Arrangement)>> {
        let found = outlier::find(self.map, self.problem, self.images, arrangement)?;
        let Some((outlier, _)) = &found else { return Ok(None) };
        if outlier.reason != Reason::AnotherScene {
            return Ok(found);
        }
        // A frame that was seen around some of the images only would make them outliers to the others: the finding
        // must hold one row further inside all six, and inside the outlier alone.
        let image = arrangement.images[outlier.face.index()];
        for only in [None, Some(image)] {
            let mut within = self.images.clone();
            for inner in Face::ALL.into_iter().filter(|&face| only.is_none_or(|only| only == face)) {
                within[inner.index()].framed = true;
            }
            let problem = Problem { borders: EdgeBorders::new(self.lookup), costs: PairCosts::new(&within) };
            let again = outlier::find(self.map, &problem, &within, arrangement)?;
            if again.is_none_or(|(other, _)| other.face != outlier.face) {
                return Ok(None);
            }
        }
        Ok(found)
    }

    /// The cheapest arrangement, and whether images changed places for it.
    fn best(&self) -> (Arrangement, bool) {
        let trusted = cheapest(self.problem, &self.given(), Freedom::TRUSTED);
        let free = || cheapest(self.problem, &Arrangement::given(Face::ALL), Freedom::ANY_ORDER);
        match self.options.names {
            Names::Trusted => (trusted, false),
            Names::AnyOrder => (free(), true),
            Names::Auto => {
                let free = free();
                let renames = !self.problem.ties(&free, &trusted) || self.sky_is_elsewhere(&trusted);
                if renames { (free, true) } else { (trusted, false) }
            }
        }
    }

    fn solution(
        &self,
        arrangement: Arrangement,
        convention: Option<Convention>,
        outliers: &[Face],
        equivalents: usize,
    ) -> Result<Solution> {
        let (excluded, margin) = self.alternatives(&arrangement, outliers)?;
        Ok(Solution { arrangement, convention, excluded, margin, equivalents, outlier: None, unsettled: false })
    }

    /// By face the orientations that are as good as the best one's, itself first.
    fn ties(&self, best: &Arrangement) -> [Vec<usize>; 6] {
        Face::ALL.map(|face| {
            let own = best.orientations[face.index()];
            let others = (0..8).filter(|&orientation| orientation != own);
            let tied = others.filter(|&orientation| self.problem.ties(best, &best.with_orientation(face, orientation)));
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
        candidates.into_iter().find(|candidate| self.problem.ties(best, candidate))
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

impl Search<'_> {
    /// The solution, and the convention that would turn the sky to where the user says it is. Where the sky lies is a
    /// hint: if the pixels alone ask for no change, it asks for none either.
    pub fn solve_and_turn(&self) -> Result<(Solution, Option<Convention>)> {
        let solution = self.solve()?;
        if self.sky.is_none() || solution.arrangement == self.given() || solution.outlier.is_some() {
            return Ok((solution, None));
        }
        let plain = Search { sky: None, ..*self }.solve()?;
        let stays = plain.arrangement == self.given() && plain.outlier.is_none();
        Ok(if stays { (plain, solution.convention) } else { (solution, None) })
    }

    /// The solution with every face laid as it was that is not decided: a guess is no fix. What the pixels decide of the
    /// other faces stands, since it holds whatever this one does. Where a convention explains all six,
    /// a face follows the other five. If nothing remains to be changed although something better was found, the
    /// question is unsettled.
    pub fn keeping_undecided(&self, mut solution: Solution) -> Solution {
        if solution.convention.is_some() {
            return solution;
        }
        let (found, given) = (solution.arrangement, self.given());
        for face in 0..6 {
            let relaid =
                found.images[face] == given.images[face] && found.orientations[face] != given.orientations[face];
            if relaid && !solution.is_decided(Face::ALL[face]) {
                solution.arrangement.orientations[face] = given.orientations[face];
            }
        }
        solution.unsettled = solution.arrangement == given && found != given;
        solution
    }

    /// By face the number of other orientations that are decisively worse or show the same picture, and the standard errors by which the best of
    /// all those is worse. The seams of images that do not belong tell nothing, in whatever orientation.
    pub fn alternatives(&self, found: &Arrangement, outliers: &[Face]) -> Result<([usize; 6], f64)> {
        let mut excluded = [0; 6];
        let mut margin = f64::INFINITY;
        for face in Face::ALL.into_iter().filter(|face| !outliers.contains(&found.images[face.index()])) {
            let others = if outliers.is_empty() { self.others(found, face) } else { relaid(found, face) };
            for other in others {
                let comparison = self.problem.compare_without(found, &other, outliers);
                if comparison.is_decisive() {
                    excluded[face.index()] += 1;
                    margin = margin.min(comparison.standard_errors());
                } else if outliers.is_empty() && self.shows_the_same(found, &other, face)? {
                    excluded[face.index()] += 1;
                }
            }
        }
        Ok((excluded, if margin.is_finite() { margin } else { 0.0 }))
    }

    /// The cheapest arrangements of the same images with another orientation of the face.
    fn others(&self, found: &Arrangement, face: Face) -> Vec<Arrangement> {
        let own = found.orientations[face.index()];
        let base = Arrangement::given(found.images);
        let fixed = |orientation| Freedom { fixed: Some((face, orientation)), ..Freedom::TRUSTED };
        (0..8)
            .filter(|&orientation| orientation != own)
            .map(|orientation| cheapest(self.problem, &base, fixed(orientation)))
            .collect()
    }

    /// True if the picture of a face looks the same in both, because it is symmetric. One flat colour does
    /// not count: nobody can say how it lies.
    fn shows_the_same(&self, one: &Arrangement, other: &Arrangement, face: Face) -> Result<bool> {
        let image = one.images[face.index()];
        if image != other.images[face.index()] || self.images[image.index()].is_flat() {
            return Ok(false);
        }
        let picture = self.map.picture(image)?;
        if picture.width() != picture.height() {
            return Ok(false);
        }
        let size = picture.width();
        let place = |orientation: Orientation, x: usize, y: usize| {
            orientation.image_operation(self.lookup.v_origin()).source(x, y, size)
        };
        let same = |(x, y): (usize, usize)| {
            let [one, other] = [one, other].map(|arrangement| place(arrangement.orientation(face), x, y));
            picture.texel(one.0, one.1) == picture.texel(other.0, other.1)
        };
        Ok((0..size).flat_map(|y| (0..size).map(move |x| (x, y))).all(same))
    }
}

impl Solution {
    /// True if the pixels tell this orientation of a face from all others that look different.
    pub fn is_decided(&self, face: Face) -> bool {
        self.excluded[face.index()] == 7
    }
}

/// The seven arrangements that lay one face otherwise and leave the others as they are.
fn relaid(found: &Arrangement, face: Face) -> Vec<Arrangement> {
    let others = (0..8).filter(|&orientation| orientation != found.orientations[face.index()]);
    others.map(|orientation| found.with_orientation(face, orientation)).collect()
}
