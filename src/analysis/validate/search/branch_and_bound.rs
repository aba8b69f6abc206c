//! The exact search for the cheapest arrangement: branch and bound over the faces in order.
//!
//! The cost of an edge is added when the second of its faces is placed. The lower bound adds, for every remaining edge,
//! the cheapest border that could continue the one placed there, or the cheapest pair where neither face is placed. With
//! that bound most of the 8^6 orientations are never visited, and only a few thousand of the 6! 8^6 arrangements.

use super::super::borders::edge::Edge;
use super::super::borders::pair_cost::border_index;
use super::arrangement::{Arrangement, Problem};
use crate::envmap::Face;

/// What the search may change.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Freedom {
    /// Images may change places; the cheapest is then one of 48 that cost the same, and the one found leaves the image
    /// of +X as it is.
    pub any_order: bool,
    /// A face whose orientation is prescribed.
    pub fixed: Option<(Face, usize)>,
}

impl Freedom {
    pub const TRUSTED: Self = Self { any_order: false, fixed: None };
    pub const ANY_ORDER: Self = Self { any_order: true, fixed: None };
}

/// The cheapest arrangement; of several the first in the order of faces and orientations, so the given one if it is among them.
pub fn cheapest(problem: &Problem, given: &Arrangement, freedom: Freedom) -> Arrangement {
    let mut search = BranchAndBound {
        problem,
        freedom,
        bounds: Bounds::new(problem, given, freedom),
        current: *given,
        used: [false; 6],
        best: *given,
        best_cost: f64::INFINITY,
        sources: given.images,
    };
    search.place(0, 0.0);
    search.best
}

struct BranchAndBound<'a> {
    problem: &'a Problem,
    freedom: Freedom,
    bounds: Bounds,
    current: Arrangement,
    used: [bool; 6],
    best: Arrangement,
    best_cost: f64,
    sources: [Face; 6],
}

impl BranchAndBound<'_> {
    fn place(&mut self, face: usize, cost: f64) {
        if face == 6 {
            (self.best, self.best_cost) = (self.current, cost);
            return;
        }
        let pinned = self.freedom.any_order && face == 0;
        let sources = if self.freedom.any_order && !pinned { 0..6 } else { face..face + 1 };
        for source in sources {
            if self.used[source] {
                continue;
            }
            self.used[source] = true;
            self.current.images[face] = self.sources[source];
            for orientation in (0..8).filter(|&orientation| !(pinned && orientation > 0)) {
                if self.allows(face, orientation) {
                    self.current.orientations[face] = orientation;
                    let paid = edges_to(face).map(|edge| self.problem.edge_cost(&self.current, edge)).sum::<f64>();
                    // Costs that differ by rounding alone count as equal.
                    if cost + paid + self.bounds.rest(&self.current, face) < self.best_cost * (1.0 - 1e-9) {
                        self.place(face + 1, cost + paid);
                    }
                }
            }
            self.used[source] = false;
        }
    }

    fn allows(&self, face: usize, orientation: usize) -> bool {
        self.freedom.fixed.is_none_or(|(fixed, prescribed)| fixed.index() != face || prescribed == orientation)
    }
}

/// The edges from a face to those before it, whose cost is added when it is placed.
fn edges_to(face: usize) -> impl Iterator<Item = usize> {
    (0..Edge::ALL.len()).filter(move |&edge| Edge::ALL[edge].second.index() == face)
}

/// The least that edges can cost.
struct Bounds {
    /// By edge, image and orientation of its first face.
    placed: [[[f64; 8]; 6]; 12],
    /// By edge, whatever its faces show.
    unplaced: [f64; 12],
}

impl Bounds {
    fn new(problem: &Problem, given: &Arrangement, freedom: Freedom) -> Self {
        let mut bounds = Self { placed: [[[f64::INFINITY; 8]; 6]; 12], unplaced: [f64::INFINITY; 12] };
        let cheapest_to: Vec<f64> = (0..24).map(|border| cheapest_continuation(problem, border)).collect();
        for (index, &Edge { first, second }) in Edge::ALL.iter().enumerate() {
            let images = if freedom.any_order { Face::ALL.to_vec() } else { vec![given.images[first.index()]] };
            for (image, orientation) in images.into_iter().flat_map(|image| (0..8).map(move |turn| (image, turn))) {
                let least = if freedom.any_order {
                    let [border, _] = problem.borders.at(index, [orientation, 0]);
                    cheapest_to[border_index(image, border.side)]
                } else {
                    let borders = (0..8).map(|other| problem.borders.at(index, [orientation, other]));
                    let costs =
                        borders.map(|borders| problem.costs.total([image, given.images[second.index()]], borders));
                    costs.fold(f64::INFINITY, f64::min)
                };
                bounds.placed[index][image.index()][orientation] = least;
                bounds.unplaced[index] = bounds.unplaced[index].min(least);
            }
        }
        bounds
    }

    /// The least that the edges to faces after this one can cost.
    fn rest(&self, current: &Arrangement, face: usize) -> f64 {
        let least = |(index, edge): (usize, &Edge)| {
            let first = edge.first.index();
            if first > face {
                return self.unplaced[index];
            }
            self.placed[index][current.images[first].index()][current.orientations[first]]
        };
        Edge::ALL.iter().enumerate().filter(|(_, edge)| edge.second.index() > face).map(least).sum()
    }
}

/// The least that any border of another image costs as the continuation of this one.
fn cheapest_continuation(problem: &Problem, border: usize) -> f64 {
    let others = (0..24).filter(|other| other / 4 != border / 4);
    let costs = others.flat_map(|other| [false, true].map(|reversed| problem.costs.total_of(border, other, reversed)));
    costs.fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests {
    use super::super::super::borders::edge::EdgeBorders;
    use super::super::super::borders::pair_cost::PairCosts;
    use super::*;
    use crate::envmap::Preset;

    /// Costs that look random: no structure that a bound could profit from.
    fn problem(seed: u64) -> Problem {
        let cost = |one: usize, other: usize, reversed: bool| {
            let mut state =
                seed ^ ((one * 48 + other * 2 + usize::from(reversed)) as u64).wrapping_mul(0x9E37_79B9_7F4A_7C15);
            state = (state ^ (state >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
            ((state ^ (state >> 27)) % 1000) as f64
        };
        Problem { borders: EdgeBorders::new(&Preset::Course.lookup()), costs: PairCosts::made_up(cost) }
    }

    fn cost(problem: &Problem, arrangement: &Arrangement) -> f64 {
        (0..12).map(|edge| problem.edge_cost(arrangement, edge)).sum()
    }

    fn least_over_orientations(problem: &Problem, images: [Face; 6], faces: std::ops::Range<usize>) -> f64 {
        let count = 8_usize.pow(faces.len() as u32);
        let mut least = f64::INFINITY;
        for number in 0..count {
            let mut orientations = [0; 6];
            let mut rest = number;
            for face in faces.clone() {
                orientations[face] = rest % 8;
                rest /= 8;
            }
            least = least.min(cost(problem, &Arrangement { images, orientations }));
        }
        least
    }

    #[test]
    fn finds_the_cheapest_of_all_orientations() {
        for seed in [1, 2, 3] {
            let problem = problem(seed);
            let found = cheapest(&problem, &Arrangement::given(Face::ALL), Freedom::TRUSTED);
            assert_eq!(cost(&problem, &found), least_over_orientations(&problem, Face::ALL, 0..6));
        }
    }

    #[test]
    fn finds_the_cheapest_of_all_orders() {
        // All 5! orders of five images behind the first, which stays: 3.9 million arrangements.
        let problem = problem(4);
        let mut least = f64::INFINITY;
        let mut images = Face::ALL;
        let mut orders = vec![];
        permutations(&mut images, 1, &mut orders);
        assert_eq!(orders.len(), 120);
        for order in orders {
            least = least.min(least_over_orientations(&problem, order, 1..6));
        }
        let found = cheapest(&problem, &Arrangement::given(Face::ALL), Freedom::ANY_ORDER);
        assert_eq!(cost(&problem, &found), least);
    }

    fn permutations(images: &mut [Face; 6], from: usize, orders: &mut Vec<[Face; 6]>) {
        if from == 6 {
            orders.push(*images);
            return;
        }
        for other in from..6 {
            images.swap(from, other);
            permutations(images, from + 1, orders);
            images.swap(from, other);
        }
    }

    #[test]
    fn a_turn_of_the_whole_cube_costs_the_same() {
        let problem = problem(5);
        let lookup = Preset::Course.lookup();
        let placed = Arrangement { images: Face::ALL, orientations: [0, 3, 5, 7, 1, 2] };
        for symmetry in super::super::symmetry::Symmetry::all() {
            assert_eq!(cost(&problem, &symmetry.of(&placed, &lookup)), cost(&problem, &placed), "{symmetry:?}");
        }
    }
}
