//! From the cheapest arrangement to the fix: the shortest story that the pixels do not contradict.

use super::borders::border::Borders;
use super::borders::edge::{Edge, EdgeBorders};
use super::borders::pair_cost::PairCosts;
use super::copies::Copies;
use super::options::Names;
use super::outlier::{self, Outlier, Reason};
use super::seam::measure;
use super::search::arrangement::{Arrangement, Problem};
use super::search::branch_and_bound::{Freedom, cheapest};
use super::search::convention::{Order, mirrored_faces};
use super::search::symmetry::Symmetry;
use super::sky::Sky;
use super::story::{Story, with_faults};
use super::thresholds::story::DIAGONAL;
use super::thresholds::verdict::{
    EDITED_ORIENTATIONS, REPAIRED, TELLING_FACES, TELLING_ORIENTATIONS, TORN_STEP, UNRELATED,
};
use crate::envmap::{CubeMap, Face, Lookup, Orientation, SignedAxis};
use crate::error::Result;

/// The answer of the search.
#[derive(Debug, Clone)]
pub struct Solution {
    pub arrangement: Arrangement,
    pub story: Story,
    /// Other stories that are as short and close the seams as well.
    pub also: Vec<Story>,
    /// By face how many of the seven other orientations are decisively worse, whatever the other faces then do, or show the
    /// same picture.
    pub excluded: [usize; 6],
    /// The standard errors by which the best essentially different arrangement is worse.
    pub margin: f64,
    /// Arrangements that are equally good, this one among them.
    pub equivalents: usize,
    /// The face whose image does not belong.
    pub outlier: Option<Outlier>,
    /// What is wrong if the pixels show that something is but not how to repair it.
    pub unsettled: Option<Unsettled>,
    /// Faces that nothing changes though they would fit noticeably better otherwise.
    pub doubtful: Vec<Face>,
}

/// Something is wrong, and no change is certain.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unsettled {
    /// The seams gape as nobody would overlook.
    Torn,
    /// A viewer may see nothing.
    Faint,
}

/// Stories told beside the one that is taken.
const MOST_TOLD: usize = 3;

/// What the search is about.
pub struct Search<'a> {
    pub map: &'a CubeMap,
    pub copies: &'a Copies,
    pub images: &'a Borders,
    pub problem: &'a Problem,
    pub lookup: &'a Lookup,
    pub names: Names,
    /// The axis that points up in the world.
    pub world_up: SignedAxis,
    /// The orders that the files may follow.
    pub orders: &'a [Order],
    pub sky: &'a Sky,
}

impl Search<'_> {
    pub fn given(&self) -> Arrangement {
        Arrangement::given(Face::ALL.map(|face| self.lookup.row(face).image))
    }

    /// Finds the fix. What the pixels do not tell for at least half of the faces is no ground to change anything, unless
    /// the seams gape.
    pub fn solve(&self) -> Result<Solution> {
        let (best, any_order) = self.best(None);
        for reference in self.references(&best) {
            if let Some(solution) = self.around_outlier(&reference, &best)? {
                return Ok(solution);
            }
        }
        let ties = self.ties(&best, &[]);
        let alike: usize = ties.iter().map(Vec::len).product();
        let equivalents = if any_order { 48 * alike } else { alike };
        let told = self.shortest(&best, &ties, &[]);
        let solution = self.solution(told, &[], equivalents)?;
        let (given, found) = (self.given(), solution.arrangement);
        let related = self.problem.mean_fit(&found) < UNRELATED;
        if found == given {
            let doubtful = self.doubtful(&best, &given);
            let unsettled = (!doubtful.is_empty()).then_some(Unsettled::Faint);
            // A face that may only be turned is not blamed.
            let sole = || outlier::sole(self.copies, self.problem, self.images, &given);
            let outlier = doubtful.is_empty().then(sole).flatten();
            return Ok(Solution { outlier, unsettled, doubtful, ..solution });
        }
        if related && (self.tells(&solution) || self.is_torn(&given, &found)) {
            return Ok(solution);
        }
        let solution = self.solution((given, self.story(&given), Vec::new()), &[], equivalents)?;
        let worse = !self.problem.ties(&best, &given);
        let unsettled = if self.is_torn(&given, &best) { Unsettled::Torn } else { Unsettled::Faint };
        Ok(Solution { unsettled: worse.then_some(unsettled), ..solution })
    }

    /// The faces that the best arrangement changes if it is noticeably better than the given one.
    fn doubtful(&self, best: &Arrangement, given: &Arrangement) -> Vec<Face> {
        if !self.problem.compare(best, given).is_noticeable() {
            return Vec::new();
        }
        let place = |arrangement: &Arrangement, face: Face| {
            (arrangement.images[face.index()], arrangement.orientations[face.index()])
        };
        Face::ALL.into_iter().filter(|&face| place(best, face) != place(given, face)).collect()
    }

    /// The arrangements among which five faces may fit and one not: as given, the best one, and, where one face of the
    /// best gapes, the best of the five others.
    fn references(&self, best: &Arrangement) -> Vec<Arrangement> {
        let mut references = vec![self.given(), *best];
        if Face::ALL.iter().any(|&face| outlier::gapes(self.problem, self.images, best, face)) {
            references.extend(Face::ALL.map(|image| self.best(Some(image)).0));
        }
        references
    }

    /// The solution if five faces fit as the reference has them, and one fits nowhere.
    fn around_outlier(&self, reference: &Arrangement, best: &Arrangement) -> Result<Option<Solution>> {
        let Some((outlier, reference)) = self.outlier(reference) else { return Ok(None) };
        let image = reference.images[outlier.face.index()];
        // Were the others wrong too, the face would be one of several that changed places; so it is if it fits elsewhere,
        // as a copy does wherever its original fits.
        let is_copy = matches!(outlier.reason, Reason::CopyOf(_));
        if self.problem.compare_without(best, &reference, &[image]).is_decisive()
            || (!is_copy && outlier::fits_elsewhere(self.problem, self.images, &reference, best, outlier.face))
        {
            return Ok(None);
        }
        let outliers = outlier::outliers(self.copies, self.problem, &reference, outlier.face);
        let ties = self.ties(&reference, &outliers);
        let told = self.shortest(&reference, &ties, &outliers);
        let face = told.0.face_of(image).unwrap_or(outlier.face);
        let outlier = Outlier { face, ..outlier };
        let solution = Solution { outlier: Some(outlier), ..self.solution(told, &outliers, 1)? };
        // Equal texels are not chance, and nobody overlooks a face that stands out, whatever the other faces tell.
        let found = solution.arrangement;
        let stands_out = outlier::stands_out(self.problem, self.images, &found, face);
        // What does not fit elsewhere may fit where it is.
        if !stands_out && !outlier::steps_away(self.problem, self.images, &found, face, outlier.reason) {
            return Ok(None);
        }
        let certain = is_copy
            || self.tells(&solution)
            || (stands_out && (found == self.given() || self.is_torn(&self.given(), &found)));
        Ok(certain.then_some(solution))
    }

    /// True if at least half of the faces tell how they lie, and so do those whose files were edited.
    fn tells(&self, solution: &Solution) -> bool {
        let given = self.given();
        let edited = solution.story.edited.iter().map(|face| face.index());
        let turned = edited.filter(|&face| solution.arrangement.images[face] == given.images[face]);
        solution.telling_faces() >= TELLING_FACES
            && turned.into_iter().all(|face| solution.excluded[face] >= EDITED_ORIENTATIONS)
    }

    /// True if the seams that differ gape in one arrangement and hardly in the other.
    fn is_torn(&self, given: &Arrangement, found: &Arrangement) -> bool {
        let differs = |&edge: &usize| self.problem.ends(given, edge) != self.problem.ends(found, edge);
        let edges: Vec<usize> = (0..Edge::ALL.len()).filter(differs).collect();
        let step = |arrangement: &Arrangement| {
            let steps = edges.iter().map(|&edge| measure(self.problem, self.images, arrangement, edge).step);
            steps.sum::<f64>() / edges.len().max(1) as f64
        };
        let (now, then) = (step(given), step(found));
        now >= TORN_STEP && then <= REPAIRED * now
    }

    fn outlier(&self, arrangement: &Arrangement) -> Option<(Outlier, Arrangement)> {
        let found = outlier::find(self.copies, self.problem, self.images, arrangement);
        let (outlier, _) = found.as_ref()?;
        if outlier.reason == Reason::Flat {
            return found;
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
            let again = outlier::find(self.copies, &problem, &within, arrangement);
            if again.is_none_or(|(other, _)| other.face != outlier.face) {
                return None;
            }
        }
        found
    }

    /// The cheapest arrangement, without the seams of an image if one is given, and whether images changed places for it.
    fn best(&self, without: Option<Face>) -> (Arrangement, bool) {
        let silenced = without.map(|image| self.problem.without(image));
        let problem = silenced.as_ref().unwrap_or(self.problem);
        let trusted = cheapest(problem, &self.given(), Freedom::TRUSTED);
        let free = || cheapest(problem, &Arrangement::given(Face::ALL), Freedom::ANY_ORDER);
        match self.names {
            Names::Trusted => (trusted, false),
            Names::AnyOrder => (free(), true),
            Names::Auto => {
                let free = free();
                if self.is_as_good(&free, &trusted, without.as_slice()) { (trusted, false) } else { (free, true) }
            }
        }
    }

    fn solution(
        &self,
        (arrangement, story, also): (Arrangement, Story, Vec<Story>),
        outliers: &[Face],
        equivalents: usize,
    ) -> Result<Solution> {
        let (excluded, margin) = self.alternatives(&arrangement, outliers)?;
        Ok(Solution {
            arrangement,
            story,
            also,
            excluded,
            margin,
            equivalents,
            outlier: None,
            unsettled: None,
            doubtful: Vec::new(),
        })
    }

    /// By face the orientations that are as good as the best one's, itself first.
    fn ties(&self, best: &Arrangement, outliers: &[Face]) -> [Vec<usize>; 6] {
        Face::ALL.map(|face| {
            let own = best.orientations[face.index()];
            let others = (0..8).filter(|&orientation| orientation != own);
            let tied = others
                .filter(|&orientation| self.is_as_good(best, &best.with_orientation(face, orientation), outliers));
            std::iter::once(own).chain(tied).collect()
        })
    }

    fn is_as_good(&self, best: &Arrangement, other: &Arrangement, outliers: &[Face]) -> bool {
        !self.problem.compare_without(best, other, outliers).is_decisive()
    }

    fn story(&self, arrangement: &Arrangement) -> Story {
        Story::of(arrangement, self.orders, self.has_free_names())
    }

    /// The arrangement with the shortest story among those as good as the best, and other stories that are as short.
    fn shortest(
        &self,
        best: &Arrangement,
        ties: &[Vec<usize>; 6],
        outliers: &[Face],
    ) -> (Arrangement, Story, Vec<Story>) {
        let given = self.given();
        if self.is_as_good(best, &given, outliers) {
            return (given, self.story(&given), Vec::new());
        }
        let told = self.told(best, ties);
        let is_good = |(_, candidate): &&(u32, Arrangement)| self.is_as_good(best, candidate, outliers);
        let Some(shortest) = told.iter().find(is_good) else { return (*best, self.story(best), Vec::new()) };
        // Which of as few faults happened is for the pixels to tell.
        let faults = self.story(&shortest.1).faults();
        let is_clear = |(_, candidate): &&(u32, Arrangement)| {
            !self.problem.compare_without(best, candidate, outliers).is_noticeable()
                && self.story(candidate).faults() <= faults
        };
        let affordable = |(cost, _): &&(u32, Arrangement)| *cost <= faults as u32 * DIAGONAL;
        let clear = told.iter().take_while(affordable).filter(is_good).find(is_clear);
        let (least, _) = clear.unwrap_or(shortest);
        let is_equal =
            |told: &&(u32, Arrangement)| told.0 == *least && is_good(told) && (clear.is_none() || is_clear(told));
        let mut equal: Vec<&Arrangement> = told.iter().filter(is_equal).map(|(_, candidate)| candidate).collect();
        equal.sort_by_cached_key(|candidate| self.preference(candidate));
        let taken = equal[0];
        let story = self.story(taken);
        let mut others: Vec<Story> = equal.iter().map(|other| self.story(other)).collect();
        others.retain(|other| *other != story);
        others.dedup();
        others.truncate(MOST_TOLD);
        (*taken, story, others)
    }

    /// What may have happened, the shortest story first: the best arrangement, turned as a whole where names may be wrong, and
    /// a few faults on top of every order.
    fn told(&self, best: &Arrangement, ties: &[Vec<usize>; 6]) -> Vec<(u32, Arrangement)> {
        let may_rename = self.names != Names::Trusted;
        let given = self.given();
        let mut candidates: Vec<Arrangement> = variants(best, ties);
        if may_rename {
            let turns = Symmetry::all();
            let turned = |variant: Arrangement| turns.iter().map(move |turn| turn.of(&variant, self.lookup));
            candidates = candidates.into_iter().flat_map(turned).collect();
        }
        candidates.extend(self.orders.iter().flat_map(|order| with_faults(&order.arrangement, may_rename)));
        candidates.retain(|candidate| may_rename || candidate.images == given.images);
        let cost = |candidate| (Story::cost_of(&candidate, self.orders, self.has_free_names()), candidate);
        let mut told: Vec<(u32, Arrangement)> = candidates.into_iter().map(cost).collect();
        told.sort_unstable();
        told.dedup();
        told
    }

    fn has_free_names(&self) -> bool {
        self.names == Names::AnyOrder
    }

    /// What comes first among equally short stories: sky above; the fewest faces changed; unmirrored before mirrored.
    fn preference(&self, arrangement: &Arrangement) -> impl Ord + use<> {
        let given = self.given();
        let changed = |&face: &usize| {
            arrangement.images[face] != given.images[face] || arrangement.orientations[face] != given.orientations[face]
        };
        let lookup = arrangement.corrected(self.lookup);
        let sky_below = -self.sky.above(&lookup, self.world_up);
        let changes = (0..6).filter(changed).count();
        (sky_below, changes, mirrored_faces(&lookup).len(), *arrangement)
    }
}

/// The combinations of equally good orientations, at most a few hundred of them.
fn variants(best: &Arrangement, ties: &[Vec<usize>; 6]) -> Vec<Arrangement> {
    const MOST: usize = 512;
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

impl Search<'_> {
    /// By face the number of other orientations that are decisively worse or show the same picture, and the standard errors by which the best of
    /// all those is worse. The seams of images that do not belong tell nothing, in whatever orientation.
    pub fn alternatives(&self, found: &Arrangement, outliers: &[Face]) -> Result<([usize; 6], f64)> {
        let mut excluded = [0; 6];
        let mut margin = f64::INFINITY;
        for face in Face::ALL.into_iter().filter(|face| !outliers.contains(&found.images[face.index()])) {
            let others = if outliers.is_empty() { self.others(found, face) } else { other_orientations(found, face) };
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
    /// Faces of which at least four other orientations are decisively worse.
    pub fn telling_faces(&self) -> usize {
        self.excluded.iter().filter(|&&excluded| excluded >= TELLING_ORIENTATIONS).count()
    }

    /// True if the pixels tell this orientation of a face from all others that look different.
    pub fn is_decided(&self, face: Face) -> bool {
        self.excluded[face.index()] == 7
    }
}

/// The seven arrangements that differ in the orientation of one face.
fn other_orientations(found: &Arrangement, face: Face) -> Vec<Arrangement> {
    let others = (0..8).filter(|&orientation| orientation != found.orientations[face.index()]);
    others.map(|orientation| found.with_orientation(face, orientation)).collect()
}
