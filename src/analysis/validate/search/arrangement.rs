//! An arrangement of six images on the faces of the cube.

use super::super::borders::edge::{Edge, EdgeBorders};
use super::super::borders::pair_cost::{PairCosts, UNITS, Units, border_index};
use super::super::thresholds::evidence::STRONG;
use crate::envmap::{Face, FaceLookup, Lookup, Orientation};

/// Per face the image it reads and its orientation, relative to the given lookup.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Arrangement {
    pub images: [Face; 6],
    /// Indices into [`Orientation::ALL`].
    pub orientations: [usize; 6],
}

impl Arrangement {
    /// What the lookup does now.
    pub fn given(images: [Face; 6]) -> Self {
        Self { images, orientations: [0; 6] }
    }

    /// The face that an image lies on; `None` if it lies on none.
    pub fn face_of(&self, image: Face) -> Option<Face> {
        Face::ALL.into_iter().find(|face| self.images[face.index()] == image)
    }

    pub fn orientation(&self, face: Face) -> Orientation {
        Orientation::ALL[self.orientations[face.index()]]
    }

    pub fn with_orientation(mut self, face: Face, orientation: usize) -> Self {
        self.orientations[face.index()] = orientation;
        self
    }

    /// The lookup that this amounts to, where `lookup` is the given one.
    pub fn corrected(&self, lookup: &Lookup) -> Lookup {
        let rows = Face::ALL.map(|face| FaceLookup {
            image: self.images[face.index()],
            ..self.orientation(face).of_row(lookup.row(face))
        });
        lookup.with_rows(rows).expect("a row in another orientation spans its face")
    }
}

/// The map's borders under the given lookup: what all arrangements are judged by.
#[derive(Debug, Clone)]
pub struct Problem {
    pub borders: EdgeBorders,
    pub costs: PairCosts,
}

impl Problem {
    /// The same for a search that the seams of an image do not lead: wherever that lies, it costs the same.
    pub fn without(&self, image: Face) -> Self {
        Self { borders: self.borders.clone(), costs: self.costs.without(image) }
    }

    /// The cost of one edge.
    pub fn edge_cost(&self, arrangement: &Arrangement, edge: usize) -> f64 {
        let (images, borders) = self.ends(arrangement, edge);
        self.costs.total(images, borders)
    }

    pub fn edge_units(&self, arrangement: &Arrangement, edge: usize) -> &Units {
        let (images, borders) = self.ends(arrangement, edge);
        self.costs.units(images, borders)
    }

    /// The images and borders that meet at an edge.
    pub fn ends(
        &self,
        arrangement: &Arrangement,
        edge: usize,
    ) -> ([Face; 2], [super::super::borders::edge::Border; 2]) {
        let Edge { first, second } = Edge::ALL[edge];
        let faces = [first.index(), second.index()];
        let borders = self.borders.at(edge, faces.map(|face| arrangement.orientations[face]));
        (faces.map(|face| arrangement.images[face]), borders)
    }

    /// How much worse the second arrangement is than the first, and how sure that is.
    ///
    /// Every side of every image is used once in either. So the two are compared side by side and unit by unit, and
    /// the sum of the differences is put in relation to the root of the sum of their squares: a number
    /// of standard errors that no single outlier can make large (de la Pena, Lai, Shao: "Self-Normalized Processes", 2009).
    pub fn compare(&self, better: &Arrangement, worse: &Arrangement) -> Comparison {
        self.compare_without(better, worse, &[])
    }

    /// The comparison without the seams of some images.
    pub fn compare_without(&self, better: &Arrangement, worse: &Arrangement, without: &[Face]) -> Comparison {
        let mut first = [None; 24];
        let mut second = [None; 24];
        for edge in 0..12 {
            for (arrangement, partners) in [(better, &mut first), (worse, &mut second)] {
                let (images, borders) = self.ends(arrangement, edge);
                let [one, other] = [0, 1].map(|end| border_index(images[end], borders[end].side));
                let units = self.edge_units(arrangement, edge);
                let alike = borders[0].reversed == borders[1].reversed;
                let correlation = self.costs.correlation(images, borders);
                partners[one] = Some((other, alike, units, correlation));
                partners[other] = Some((one, alike, units, correlation));
            }
        }
        let mut comparison = Comparison::default();
        let skipped = |side: usize| without.iter().any(|image| side / 4 == image.index());
        for (side, (first, second)) in first.iter().zip(&second).enumerate() {
            let (Some(first), Some(second)) = (first, second) else { continue };
            let ((one, alike, units, correlation), (other, other_alike, others, other_correlation)) = (first, second);
            if (one, alike) == (other, other_alike) || skipped(side) || skipped(*one) || skipped(*other) {
                continue;
            }
            comparison.add(units, others);
            // Both sides of a seam tell the same.
            comparison.agreement += f64::from(correlation.evidence_against(*other_correlation)) / 2.0;
        }
        comparison
    }
}

/// The paired comparison of two arrangements.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Comparison {
    /// Sums over the sides whose partner differs.
    pub better: f64,
    pub worse: f64,
    squares: f64,
    /// What the patterns along the borders tell for the better one: a logarithm of likelihood.
    pub agreement: f64,
    /// Sums over the units that differ strongly, for and against the better one; and how many there are.
    strong_gains: f64,
    strong_losses: f64,
    strong: usize,
}

impl Comparison {
    fn add(&mut self, better: &Units, worse: &Units) {
        for unit in 0..UNITS {
            let (better, worse) = (f64::from(better[unit]), f64::from(worse[unit]));
            self.better += better;
            self.worse += worse;
            self.squares += (worse - better) * (worse - better);
            if (worse - better).abs() > STRONG {
                self.strong += 1;
                self.strong_gains += (worse - better).max(0.0);
                self.strong_losses += (better - worse).max(0.0);
            }
        }
    }

    /// The difference in standard errors; 0 if nothing differs. The two sides of a seam tell the same, so what looks like
    /// n independent units is n / 2.
    pub fn standard_errors(&self) -> f64 {
        if self.squares > 0.0 { (self.worse - self.better) / (2.0 * self.squares).sqrt() } else { 0.0 }
    }

    /// The logarithm of the likelihood that the strong differences gain, each seam counted once; how many there are; and
    /// the losses among them as a part of the gains.
    pub fn strong(&self) -> (f64, usize, f64) {
        let share = if self.strong_gains > 0.0 { self.strong_losses / self.strong_gains } else { 1.0 };
        (self.strong_gains / 2.0, self.strong / 2, share)
    }

    /// By how much the better one lowers the cost, as a part of the worse one's.
    pub fn improvement(&self) -> f64 {
        if self.worse > 0.0 { (self.worse - self.better) / self.worse } else { 0.0 }
    }
}
