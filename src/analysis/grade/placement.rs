//! What a shot may show: an image in one of eight orientations; and what a camera and a lookup make of it.
//!
//! ```text
//!      t = 1  +-------+       a shot: s grows to the camera's right, t upwards, both from 0 to 1
//!             |       |
//!             | shot  |       the lookup's row for a face seen by a camera gives (u, v) as functions of (s, t):
//!             |       |       the orientation [`on_screen`]
//!      t = 0  +-------+
//!          s = 0    s = 1
//! ```

use serde::{Serialize, Serializer};

use crate::envmap::{Face, FaceLookup, ImageOperation, Lookup, Orientation, SignedAxis, VOrigin};

/// How the camera of a shot should stand.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ShotFrame {
    /// The axis it looks along, by the name of the face.
    pub face: Face,
    /// The world axis to the right on the screen.
    pub right: SignedAxis,
    /// The world axis to the top of the screen.
    pub up: SignedAxis,
}

/// An image and how it is read: the texture coordinates (u', v') that code computes as functions of the (u, v) that the
/// given lookup computes for the same face.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Placement {
    /// The image, by its name.
    pub image: Face,
    /// (u', v') as functions of (u, v).
    #[serde(flatten)]
    pub orientation: Orientation,
}

/// (u, v) of a row as functions of the place in a picture whose camera has `right` and `up`.
pub(super) fn on_screen(row: FaceLookup, right: SignedAxis, up: SignedAxis) -> Orientation {
    let along_right = |axis: SignedAxis| axis.axis == right.axis;
    let inverts = |axis: SignedAxis| axis != if along_right(axis) { right } else { up };
    Orientation { swaps: !along_right(row.u), inverts_u: inverts(row.u), inverts_v: inverts(row.v) }
}

/// For each cell of a shot, row by row from the top left, the cell of the image it shows; both in `side` x `side` cells.
pub(super) fn source_cells(on_screen: Orientation, v_origin: VOrigin, side: usize) -> Vec<u32> {
    let place = |index: usize| (index as f32 + 0.5) / side as f32;
    let cell = |place: f32| ((place * side as f32) as usize).min(side - 1);
    let mut cells = Vec::with_capacity(side * side);
    for (row, column) in (0..side).flat_map(|row| (0..side).map(move |column| (row, column))) {
        let (u, v) = on_screen.apply(place(column), 1.0 - place(row));
        let down = if v_origin == VOrigin::Top { v } else { 1.0 - v };
        cells.push((cell(down) * side + cell(u)) as u32);
    }
    cells
}

/// Where a camera that is not as it should be takes its shots: along other axes, in another orientation on the screen.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CameraFault {
    /// What it takes for +x, +y and +z.
    pub axes: [SignedAxis; 3],
    /// The place in the right picture as a function of the place (s, t) in the shot.
    pub orientation: Orientation,
}

impl CameraFault {
    /// A camera that is right.
    pub const NONE: Self =
        Self { axes: [SignedAxis::POS_X, SignedAxis::POS_Y, SignedAxis::POS_Z], orientation: Orientation::IDENTITY };

    /// Every camera: pictures in another orientation first, then axes exchanged, those that keep the handedness first.
    pub(super) fn all() -> Vec<Self> {
        let mut axes: Vec<[SignedAxis; 3]> = signed_permutations();
        axes.sort_by_key(|axes| (*axes != Self::NONE.axes, !keeps_handedness(axes)));
        let cameras =
            |axes: [SignedAxis; 3]| Orientation::ALL.into_iter().map(move |orientation| Self { axes, orientation });
        axes.into_iter().flat_map(cameras).collect()
    }

    /// The cameras that look along the right axes and give all six pictures one orientation, the right one first.
    pub(super) fn oriented_alike() -> impl Iterator<Item = Self> {
        Orientation::ALL.into_iter().map(|orientation| Self { orientation, ..Self::NONE })
    }

    pub(super) fn axis(&self, axis: SignedAxis) -> SignedAxis {
        let seen = self.axes[usize::from(axis.axis)];
        if axis.negative { -seen } else { seen }
    }

    /// True if it looks along other axes.
    pub fn exchanges_axes(&self) -> bool {
        self.axes != Self::NONE.axes
    }

    /// The fault in one word.
    fn name(self) -> &'static str {
        let Orientation { swaps, inverts_u, inverts_v } = self.orientation;
        match (swaps, inverts_u, inverts_v) {
            _ if self.exchanges_axes() => "axes",
            (false, false, false) => "none",
            (false, false, true) => "upside_down",
            (false, true, false) | (true, false, false) | (true, true, true) => "mirrored",
            _ => "turned",
        }
    }

    /// What it does to all six pictures.
    pub fn image_operation(self) -> ImageOperation {
        // In a shot t grows upwards.
        self.orientation.image_operation(VOrigin::Bottom)
    }

    /// The face that the shot of a frame shows, and that face's (u, v) as functions of the place in the shot.
    pub(super) fn sees(&self, lookup: &Lookup, frame: ShotFrame) -> (Face, Orientation) {
        let face = self.axis(frame.face.signed_axis()).face();
        let seen = on_screen(lookup.row(face), self.axis(frame.right), self.axis(frame.up));
        (face, seen.after(self.orientation))
    }
}

/// By its name.
impl Serialize for CameraFault {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

/// The 48 signed permutations of x, y and z.
fn signed_permutations() -> Vec<[SignedAxis; 3]> {
    const ORDERS: [[u8; 3]; 6] = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]];
    let signed = |order: [u8; 3], signs: usize| {
        std::array::from_fn(|k| SignedAxis { axis: order[k], negative: signs >> k & 1 == 1 })
    };
    (0..8).flat_map(|signs| ORDERS.map(|order| signed(order, signs))).collect()
}

fn keeps_handedness([x, y, z]: &[SignedAxis; 3]) -> bool {
    x.cross(*y) == Some(*z)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::envmap::Preset;

    #[test]
    fn on_screen_is_the_lookup_seen_by_the_camera() {
        for preset in Preset::ALL {
            let lookup = preset.lookup();
            let frame = ShotFrame { face: Face::PosZ, right: SignedAxis::POS_X, up: SignedAxis::NEG_Y };
            let (s, t) = (0.2_f32, 0.7_f32);
            let direction = frame.face.normal()
                + frame.right.direction() * (2.0 * s - 1.0)
                + frame.up.direction() * (2.0 * t - 1.0);
            let point = lookup.locate(direction);
            let (u, v) = on_screen(lookup.row(Face::PosZ), frame.right, frame.up).apply(s, t);
            assert!((point.u - u).abs() < 1e-6 && (point.v - v).abs() < 1e-6, "{}", preset.name());
        }
    }

    #[test]
    fn there_are_48_cubes_of_which_half_are_turned() {
        let all = signed_permutations();
        assert_eq!((all.len(), all.iter().filter(|axes| keeps_handedness(axes)).count()), (48, 24));
        assert_eq!(CameraFault::all()[0], CameraFault::NONE);
        assert_eq!(CameraFault::all().len(), 48 * 8);
    }
}
