//! The exact search for the cheapest arrangement: branch and bound over the faces in order.
//!
//! An edge is paid for when the second of its faces is laid. What is still to pay is at least, for every edge not paid
//! for, the cheapest pair of borders that could meet there; with that bound most of the 8^6 layings are never
//! visited, and of the 6! 8^6 arrangements a few thousand.

use super::arrangement::{Arrangement, Puzzle};
use super::edge::Edge;
use crate::envmap::Face;

/// What the search may change.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Freedom {
    /// Images may change places; the cheapest is then one of 48 that cost the same, and the one found leaves the image
    /// of +X as it is.
    pub any_order: bool,
    /// A face whose laying is prescribed.
    pub fixed: Option<(Face, usize)>,
}

impl Freedom {
    pub const TRUSTED: Self = Self { any_order: false, fixed: None };
    pub const ANY_ORDER: Self = Self { any_order: true, fixed: None };
}

/// The cheapest arrangement; of several the first in the order of faces and layings, so the given one if it is among them.
pub fn cheapest(puzzle: &Puzzle, given: &Arrangement, freedom: Freedom) -> Arrangement {
    let mut search = Search {
        puzzle,
        freedom,
        bounds: bounds(puzzle, given, freedom),
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

struct Search<'a> {
    puzzle: &'a Puzzle,
    freedom: Freedom,
    /// The least that the edges paid for from a face on can cost.
    bounds: [f64; 7],
    /// The edges paid for when a face is laid.
    edges: [Vec<usize>; 6],
    current: Arrangement,
    used: [bool; 6],
    best: Arrangement,
    best_cost: f64,
    sources: [Face; 6],
}

impl Search<'_> {
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
            for laying in (0..8).filter(|&laying| !(pinned && laying > 0)) {
                if self.allows(face, laying) {
                    self.current.layings[face] = laying;
                    let paid: f64 =
                        self.edges[face].iter().map(|&edge| self.puzzle.edge_cost(&self.current, edge)).sum();
                    // Costs that differ by rounding alone count as equal.
                    if cost + paid + self.bounds[face + 1] < self.best_cost * (1.0 - 1e-9) {
                        self.lay(face + 1, cost + paid);
                    }
                }
            }
            self.used[source] = false;
        }
    }

    fn allows(&self, face: usize, laying: usize) -> bool {
        self.freedom.fixed.is_none_or(|(fixed, prescribed)| fixed.index() != face || prescribed == laying)
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
fn bounds(puzzle: &Puzzle, given: &Arrangement, freedom: Freedom) -> [f64; 7] {
    let mut bounds = [0.0; 7];
    for face in (0..6).rev() {
        let least = |edge: usize| {
            let Edge { first, second } = Edge::ALL[edge];
            if freedom.any_order {
                return least_between_any(puzzle);
            }
            let mut least = f64::INFINITY;
            for layings in (0..64).map(|index| [index / 8, index % 8]) {
                let images = [given.images[first.index()], given.images[second.index()]];
                least = least.min(puzzle.costs.total(images, puzzle.borders.at(edge, layings)));
            }
            least
        };
        bounds[face] = bounds[face + 1] + edges_by_face()[face].iter().map(|&edge| least(edge)).sum::<f64>();
    }
    bounds
}

/// The cheapest pair of borders of two different images.
fn least_between_any(puzzle: &Puzzle) -> f64 {
    let mut least = f64::INFINITY;
    for one in 0..24 {
        for other in (one / 4 + 1) * 4..24 {
            for reversed in [false, true] {
                least = least.min(puzzle.costs.total_of(one, other, reversed));
            }
        }
    }
    least
}
