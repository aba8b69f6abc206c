//! The named lookup tables.

use clap::ValueEnum;

use super::axis::SignedAxis;
use super::face::Face;
use super::lookup::{FaceLookup, Lookup};
use super::v_origin::VOrigin;
use crate::choice::name_of;

/// A named lookup table, see `conventions.md`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize, ValueEnum)]
#[serde(rename_all = "kebab-case")]
#[value(rename_all = "kebab-case")]
pub enum Preset {
    /// y up: files for OpenGL, Vulkan and Direct3D. Mirrored when used on right-handed world directions.
    Opengl,
    /// The formula of the exercise sheet for +X, repeated by analogy: wrong on purpose.
    Exercise,
    /// z up, right-handed, not mirrored: the exercise solved.
    Course,
    /// `course` reading a y-up download: +Y posz, -Y negz, +Z posy, -Z negy.
    HumusZUp,
    /// `opengl` for the direction (x, y, -z): the camera's forward -Z reads posz; not mirrored.
    HumusYUp,
}

impl Preset {
    /// All presets.
    pub const ALL: [Preset; 5] = [Preset::Opengl, Preset::Exercise, Preset::Course, Preset::HumusZUp, Preset::HumusYUp];

    /// The name in scenes and on the command line.
    pub fn name(self) -> String {
        name_of(self)
    }

    /// The preset of a name.
    pub fn named(name: &str) -> Option<Self> {
        <Self as ValueEnum>::from_str(name, false).ok()
    }

    /// The axis that points upwards in the worlds it is meant for.
    pub fn usual_up(self) -> SignedAxis {
        match self {
            Preset::Opengl | Preset::HumusYUp => SignedAxis::POS_Y,
            Preset::Exercise | Preset::Course | Preset::HumusZUp => SignedAxis::POS_Z,
        }
    }

    /// The same for the name of a lookup; +z, as in the course, for a table of the user's.
    pub fn usual_up_of(lookup: &str) -> SignedAxis {
        Self::named(lookup).map_or(SignedAxis::POS_Z, Self::usual_up)
    }

    /// The table.
    pub fn lookup(self) -> Lookup {
        use Face::{NegX, NegY, NegZ, PosX, PosY, PosZ};
        let own = Face::ALL;
        let (v_origin, images, axes) = match self {
            Preset::Opengl => (VOrigin::Top, own, OPENGL),
            Preset::Exercise => (VOrigin::Bottom, own, EXERCISE),
            Preset::Course => (VOrigin::Bottom, own, COURSE),
            Preset::HumusZUp => (VOrigin::Bottom, [PosX, NegX, PosZ, NegZ, PosY, NegY], COURSE),
            Preset::HumusYUp => (VOrigin::Top, [PosX, NegX, PosY, NegY, NegZ, PosZ], OPENGL_MIRRORED_IN_Z),
        };
        let rows = std::array::from_fn(|face| {
            let (u, v) = axes[face];
            FaceLookup { image: images[face], u, v }
        });
        Lookup::new(rows, v_origin).expect("the presets are valid tables")
    }
}

/// Axis of u and axis of v for +X -X +Y -Y +Z -Z.
type Axes = [(SignedAxis, SignedAxis); 6];

const PX: SignedAxis = SignedAxis::POS_X;
const NX: SignedAxis = SignedAxis::NEG_X;
const PY: SignedAxis = SignedAxis::POS_Y;
const NY: SignedAxis = SignedAxis::NEG_Y;
const PZ: SignedAxis = SignedAxis::POS_Z;
const NZ: SignedAxis = SignedAxis::NEG_Z;

const OPENGL: Axes = [(NZ, NY), (PZ, NY), (PX, PZ), (PX, NZ), (PX, NY), (NX, NY)];
const EXERCISE: Axes = [(PY, PZ), (PY, PZ), (PX, PZ), (PX, PZ), (PX, PY), (PX, PY)];
const COURSE: Axes = [(NY, PZ), (PY, PZ), (PX, PZ), (NX, PZ), (PX, NY), (PX, PY)];
/// `OPENGL` for the direction (x, y, -z): z changes sign in every entry, and the rows of +Z and -Z change places.
const OPENGL_MIRRORED_IN_Z: Axes = [(PZ, NY), (NZ, NY), (PX, NZ), (PX, PZ), (NX, NY), (PX, NY)];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Vec3;

    /// The OpenGL table as the specification writes it (OpenGL 4.6, table 8.19): major axis, sc, tc, ma.
    #[test]
    fn opengl_agrees_with_the_specification() {
        let lookup = Preset::Opengl.lookup();
        let direction = Vec3::new(0.3, -0.2, 0.1);
        let expected = |face: Face, d: Vec3| match face {
            Face::PosX => (-d.z, -d.y),
            Face::NegX => (d.z, -d.y),
            Face::PosY => (d.x, d.z),
            Face::NegY => (d.x, -d.z),
            Face::PosZ => (d.x, -d.y),
            Face::NegZ => (-d.x, -d.y),
        };
        for face in Face::ALL {
            let mut d = direction;
            d[face.axis()] = face.normal()[face.axis()];
            let point = lookup.locate(d);
            let (sc, tc) = expected(face, d);
            assert_eq!(point, super::super::lookup::FacePoint { face, u: (sc + 1.0) * 0.5, v: (tc + 1.0) * 0.5 });
        }
    }

    #[test]
    fn humus_y_up_is_opengl_with_z_reversed() {
        let (humus, opengl) = (Preset::HumusYUp.lookup(), Preset::Opengl.lookup());
        for d in [Vec3::new(1.0, 0.2, -0.7), Vec3::new(-0.1, 0.9, 0.3), Vec3::new(0.2, 0.1, -1.0), Vec3::NEG_Y] {
            let through_humus = humus.image_point(humus.locate(d));
            let reversed = Vec3::new(d.x, d.y, -d.z);
            assert_eq!(through_humus, opengl.image_point(opengl.locate(reversed)));
        }
    }

    #[test]
    fn handedness_follows_from_the_tables() {
        let mirrored = |preset: Preset| Face::ALL.map(|face| preset.lookup().mirrors(face));
        assert_eq!(mirrored(Preset::Opengl), [true; 6]);
        for preset in [Preset::Course, Preset::HumusZUp, Preset::HumusYUp] {
            assert_eq!(mirrored(preset), [false; 6], "{}", preset.name());
        }
        assert_eq!(mirrored(Preset::Exercise), [true, false, false, true, true, false]);
    }
}
