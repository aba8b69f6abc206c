//! The exact search for the cheapest arrangement: branch and bound over the faces in order.
//!
//! The cost of an edge is added when the second of its faces is placed. The lower bound adds, for every remaining edge,
//! the cheapest pair of borders that could meet there. With that bound most of the 8^6 orientations are never visited,
//! and only a few thousand of the 6! 8^6 arrangements.

use super::super::borders::edge::Edge;
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
        bounds: bounds(problem, given, freedom),
        edges: edges_by_face(),
        current: *given,
        used: [false; 6],
        best: *given,
        best_cost: f64::INFINITY,
        sources: given.images,
    };
    search.lay(0, 0.0);
    search.best
}

struct BranchAndBound<'a> {
    problem: &'a Problem,
    freedom: Freedom,
    /// The least that the edges paid for from a face on can cost.
    bounds: [f64; 7],
    /// The edges whose cost is added when a face is placed.
    edges: [Vec<usize>; 6],
    current: Arrangement,
    used: [bool; 6],
    best: Arrangement,
    best_cost: f64,
    sources: [Face; 6],
}

impl BranchAndBound<'_> {
    fn lay(&mut self, face: usize, cost: f64) {
        if face == 6 {
            if cost < self.best_cost {
                (self.best, self.best_cost) = (self.current, cost);
            }
            return;
        }
        let pinned = self.freedom.any_order && face == 0;
        let sources = if self.freedom.any_order && !pinned { 0..6 } else { face..face + 1 };
        for source in sources.filter(|&source| !self.used[source]).collect::<Vec<_>>() {
            self.used[source] = true;
            self.current.images[face] = self.sources[source];
            for orientation in (0..8).filter(|&orientation| !(pinned && orientation > 0)) {
                if self.allows(face, orientation) {
                    self.current.orientations[face] = orientation;
                    let paid: f64 =
                        self.edges[face].iter().map(|&edge| self.problem.edge_cost(&self.current, edge)).sum();
                    // Costs that differ by rounding alone count as equal.
                    if cost + paid + self.bounds[face + 1] < self.best_cost * (1.0 - 1e-9) {
                        self.lay(face + 1, cost + paid);
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

/// For every face the edges to faces before it.
fn edges_by_face() -> [Vec<usize>; 6] {
    let mut edges: [Vec<usize>; 6] = Default::default();
    for (index, edge) in Edge::ALL.iter().enumerate() {
        edges[edge.second.index()].push(index);
    }
    edges
}

/// For every face the least that it and those after it can cost.
fn bounds(problem: &Problem, given: &Arrangement, freedom: Freedom) -> [f64; 7] {
    let mut bounds = [0.0; 7];
    for face in (0..6).rev() {
        let least = |edge: usize| {
            let Edge { first, second } = Edge::ALL[edge];
            if freedom.any_order {
                return least_between_any(problem);
            }
            let mut least = f64::INFINITY;
            for orientations in (0..64).map(|index| [index / 8, index % 8]) {
                let images = [given.images[first.index()], given.images[second.index()]];
                least = least.min(problem.costs.total(images, problem.borders.at(edge, orientations)));
            }
            least
        };
        bounds[face] = bounds[face + 1] + edges_by_face()[face].iter().map(|&edge| least(edge)).sum::<f64>();
    }
    bounds
}

/// The cheapest pair of borders of two different images.
fn least_between_any(problem: &Problem) -> f64 {
    let mut least = f64::INFINITY;
    for one in 0..24 {
        for other in (one / 4 + 1) * 4..24 {
            for reversed in [false, true] {
                least = least.min(problem.costs.total_of(one, other, reversed));
            }
        }
    }
    least
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
