//! What the pixels decide, face by face, and the rule that follows: a face that is not decided is not changed.

use super::arrangement::Arrangement;
use super::convention::Convention;
use super::search::{Freedom, cheapest};
use super::solve::{Question, Solution};
use crate::envmap::{Face, Orientation};
use crate::error::Result;

impl Question<'_> {
    /// The solution, and the convention that would turn the sky to where the user says it is. Where the sky lies is a
    /// hint: if the pixels alone ask for no change, it asks for none either.
    pub fn solve_and_turn(&self) -> Result<(Solution, Option<Convention>)> {
        let solution = self.solve()?;
        if self.sky.is_none() || solution.arrangement == self.given() || solution.foreign.is_some() {
            return Ok((solution, None));
        }
        let plain = Question { sky: None, ..*self }.solve()?;
        let stays = plain.arrangement == self.given() && plain.foreign.is_none();
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
    pub fn alternatives(&self, found: &Arrangement, strangers: &[Face]) -> Result<([usize; 6], f64)> {
        let mut excluded = [0; 6];
        let mut margin = f64::INFINITY;
        for face in Face::ALL.into_iter().filter(|face| !strangers.contains(&found.images[face.index()])) {
            let others = if strangers.is_empty() { self.others(found, face) } else { relaid(found, face) };
            for other in others {
                let comparison = self.puzzle.compare_without(found, &other, strangers);
                if comparison.is_decisive() {
                    excluded[face.index()] += 1;
                    margin = margin.min(comparison.standard_errors());
                } else if strangers.is_empty() && self.shows_the_same(found, &other, face)? {
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
            .map(|orientation| cheapest(self.puzzle, &base, fixed(orientation)))
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
