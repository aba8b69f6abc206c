//! The eight orientations of a square picture.
//!
//! An orientation is named by the texture coordinates it reads, (u', v') as functions of those the lookup computes: one
//! of `u`, `1-u` and one of `v`, `1-v`, in either order. A repair of the code computes (u', v') instead of (u, v); a
//! repair of the file applies the equivalent picture operation once.

use serde::{Serialize, Serializer};

use super::axis::SignedAxis;
use super::lookup::FaceLookup;
use super::v_origin::VOrigin;
use crate::choice::name_of;
use crate::picture::Picture;

/// One of the eight orientations: a symmetry of the square.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Orientation {
    /// u' is made of v, and v' of u.
    pub swaps: bool,
    /// u' counts from the other end: `1 - u` or `1 - v`.
    pub inverts_u: bool,
    /// v' counts from the other end.
    pub inverts_v: bool,
}

/// What a picture operation does to a file, as image programs call it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, clap::ValueEnum)]
pub enum ImageOperation {
    /// The file stays as it is.
    #[value(name = "none")]
    None,
    /// Exchanges left and right.
    #[value(name = "flip left-right")]
    FlipLeftRight,
    /// Exchanges top and bottom.
    #[value(name = "flip top-bottom")]
    FlipTopBottom,
    /// Half a turn.
    #[value(name = "turn 180°")]
    Turn180,
    /// A quarter turn clockwise.
    #[value(name = "turn 90° clockwise")]
    TurnClockwise,
    /// A quarter turn counterclockwise.
    #[value(name = "turn 90° counterclockwise")]
    TurnCounterclockwise,
    /// Mirror about the diagonal from the top left to the bottom right.
    #[value(name = "mirror about the diagonal from top left to bottom right")]
    Transpose,
    /// Mirror about the diagonal from the top right to the bottom left.
    #[value(name = "mirror about the diagonal from top right to bottom left")]
    Transverse,
}

impl Orientation {
    /// The picture as the lookup reads it.
    pub const IDENTITY: Self = Self { swaps: false, inverts_u: false, inverts_v: false };

    /// All eight, the simplest first: unchanged, flips, half turn, quarter turns, diagonal mirrors.
    pub const ALL: [Self; 8] = [
        Self::IDENTITY,
        Self { swaps: false, inverts_u: true, inverts_v: false },
        Self { swaps: false, inverts_u: false, inverts_v: true },
        Self { swaps: false, inverts_u: true, inverts_v: true },
        Self { swaps: true, inverts_u: true, inverts_v: false },
        Self { swaps: true, inverts_u: false, inverts_v: true },
        Self { swaps: true, inverts_u: false, inverts_v: false },
        Self { swaps: true, inverts_u: true, inverts_v: true },
    ];

    /// (u', v') for (u, v).
    pub fn apply(self, u: f32, v: f32) -> (f32, f32) {
        let (first, second) = if self.swaps { (v, u) } else { (u, v) };
        let turned = |coordinate: f32, inverts: bool| if inverts { 1.0 - coordinate } else { coordinate };
        (turned(first, self.inverts_u), turned(second, self.inverts_v))
    }

    /// u' and v' as formulas of u and v: `("1-u", "v")`.
    pub fn formulas(self) -> (&'static str, &'static str) {
        let (first, second) = if self.swaps { (["v", "1-v"], ["u", "1-u"]) } else { (["u", "1-u"], ["v", "1-v"]) };
        (first[usize::from(self.inverts_u)], second[usize::from(self.inverts_v)])
    }

    /// The orientation that does `self` to what `first` yields: `then.after(first).apply(p) = then.apply(first.apply(p))`.
    pub fn after(self, first: Self) -> Self {
        let (first_u, first_v) =
            if self.swaps { (first.inverts_v, first.inverts_u) } else { (first.inverts_u, first.inverts_v) };
        Self {
            swaps: self.swaps != first.swaps,
            inverts_u: first_u != self.inverts_u,
            inverts_v: first_v != self.inverts_v,
        }
    }

    /// The orientation that undoes this one.
    pub fn inverse(self) -> Self {
        Self::ALL.into_iter().find(|other| other.after(self) == Self::IDENTITY).expect("the orientations form a group")
    }

    /// The row of a lookup that computes (u', v') where `row` computes (u, v).
    pub fn of_row(self, row: FaceLookup) -> FaceLookup {
        let (first, second) = if self.swaps { (row.v, row.u) } else { (row.u, row.v) };
        let turned = |axis: SignedAxis, inverts: bool| if inverts { -axis } else { axis };
        FaceLookup { image: row.image, u: turned(first, self.inverts_u), v: turned(second, self.inverts_v) }
    }

    /// The orientation that makes the axes of one row into those of another of the same face.
    pub fn between(from: FaceLookup, to: FaceLookup) -> Self {
        let leads = |orientation: &Self| {
            let row = orientation.of_row(from);
            (row.u, row.v) == (to.u, to.v)
        };
        Self::ALL.into_iter().find(leads).expect("the rows span the same face")
    }

    /// The operation on the file with the same effect: the new picture holds at (u, v) what the old one held at
    /// (u', v').
    pub fn image_operation(self, v_origin: VOrigin) -> ImageOperation {
        // Seen on the screen, with rows counted from the top: for v = 0 at the bottom both v and v' are turned over.
        let inverts_v = self.inverts_v ^ (self.swaps && v_origin == VOrigin::Bottom);
        let inverts_u = self.inverts_u ^ (self.swaps && v_origin == VOrigin::Bottom);
        match (self.swaps, inverts_u, inverts_v) {
            (false, false, false) => ImageOperation::None,
            (false, true, false) => ImageOperation::FlipLeftRight,
            (false, false, true) => ImageOperation::FlipTopBottom,
            (false, true, true) => ImageOperation::Turn180,
            (true, false, false) => ImageOperation::Transpose,
            (true, true, true) => ImageOperation::Transverse,
            // new(x, y) = old(y, 1 - x): the left column becomes the top row, read upwards.
            (true, false, true) => ImageOperation::TurnClockwise,
            (true, true, false) => ImageOperation::TurnCounterclockwise,
        }
    }
}

/// By its formulas: `u` and `v`.
impl Serialize for Orientation {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let (u, v) = self.formulas();
        serializer.collect_map([("u", u), ("v", v)])
    }
}

/// In words.
impl Serialize for ImageOperation {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&self.name())
    }
}

impl ImageOperation {
    /// The operation in words: `turn 90° clockwise`.
    pub fn name(self) -> String {
        name_of(self)
    }

    /// The picture after the operation; a picture that is not square must be left as it is.
    pub fn applied(self, picture: &Picture) -> Picture {
        match self {
            ImageOperation::None => picture.clone(),
            _ => picture.rearranged(|x, y| self.source(x, y, picture.width())),
        }
    }

    /// Where the new picture of side `size` takes the pixel in column `x` and row `y` (from the top) from.
    pub fn source(self, x: usize, y: usize, size: usize) -> (usize, usize) {
        let last = size - 1;
        match self {
            ImageOperation::None => (x, y),
            ImageOperation::FlipLeftRight => (last - x, y),
            ImageOperation::FlipTopBottom => (x, last - y),
            ImageOperation::Turn180 => (last - x, last - y),
            ImageOperation::TurnClockwise => (y, last - x),
            ImageOperation::TurnCounterclockwise => (last - y, x),
            ImageOperation::Transpose => (y, x),
            ImageOperation::Transverse => (last - y, last - x),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn composition_is_application_one_after_the_other() {
        for first in Orientation::ALL {
            for then in Orientation::ALL {
                let (u, v) = first.apply(0.25, 0.625);
                assert_eq!(then.after(first).apply(0.25, 0.625), then.apply(u, v), "{first:?} {then:?}");
            }
            assert_eq!(first.inverse().after(first), Orientation::IDENTITY);
        }
    }

    #[test]
    fn a_clockwise_turn_brings_the_left_column_to_the_top() {
        // Size 2, old picture "ab / cd": turned clockwise it is "ca / db".
        let old = [["a", "b"], ["c", "d"]];
        let at = |x: usize, y: usize| {
            let (x, y) = ImageOperation::TurnClockwise.source(x, y, 2);
            old[y][x]
        };
        assert_eq!([[at(0, 0), at(1, 0)], [at(0, 1), at(1, 1)]], [["c", "a"], ["d", "b"]]);
    }

    #[test]
    fn the_operation_on_the_file_does_what_the_code_would() {
        let size = 5;
        for orientation in Orientation::ALL {
            for v_origin in [VOrigin::Top, VOrigin::Bottom] {
                let operation = orientation.image_operation(v_origin);
                for (x, y) in (0..size).flat_map(|x| (0..size).map(move |y| (x, y))) {
                    let centre = |index: usize| (index as f32 + 0.5) / size as f32;
                    let row = |v: f32| if v_origin == VOrigin::Top { v } else { 1.0 - v };
                    let (u, v) = orientation.apply(centre(x), row(centre(y)));
                    let expected = ((u * size as f32) as usize, (row(v) * size as f32) as usize);
                    assert_eq!(operation.source(x, y, size), expected, "{orientation:?} {v_origin:?}");
                }
            }
        }
    }

    #[test]
    fn rows_of_a_lookup_compute_the_new_coordinates() {
        let row = FaceLookup { image: super::super::Face::PosX, u: SignedAxis::NEG_Z, v: SignedAxis::NEG_Y };
        let placed = Orientation { swaps: true, inverts_u: true, inverts_v: false }.of_row(row);
        assert_eq!((placed.u, placed.v), (SignedAxis::POS_Y, SignedAxis::NEG_Z));
        for orientation in Orientation::ALL {
            assert_eq!(Orientation::between(row, orientation.of_row(row)), orientation);
        }
    }
}
