//! The conventions of engines: how each reads six files, and how its viewers stand in the world.
//!
//! ```text
//!                                             which files      world       up   front
//!   opengl, vulkan                            opengl           right-handed +y   -z
//!   directx, babylon                          opengl           left-handed  +y   +z
//!   unity                                     opengl           left-handed  +y   +z   (left is +X, right is -X)
//!   unreal                                    opengl           left-handed  +z   +x
//!   threejs                                   opengl(-x, y, z) right-handed +y   -z
//!   godot                                     opengl           right-handed +y   -z
//!   blender                                   course           right-handed +z   +y
//! ```
//!
//! Every engine reads by a preset: the graphics cards have one table. What differs is the world whose directions it gets.
//! OpenGL, Vulkan and Direct3D prescribe no world; theirs is the usual one.

use clap::ValueEnum;

use super::axis::SignedAxis;
use super::face::Face;
use super::lookup::Lookup;
use super::preset::Preset;
use super::world::{Handedness, World};
use crate::choice::name_of;

/// An engine or graphics library that shows skyboxes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, ValueEnum, serde::Serialize)]
#[value(rename_all = "kebab-case")]
#[serde(rename_all = "kebab-case")]
pub enum Engine {
    /// The world's directions as they are; right-handed, y up
    Opengl,
    /// The table of OpenGL; right-handed, y up
    Vulkan,
    /// The table of OpenGL in a left-handed world, y up
    Directx,
    /// px nx py ny pz nz; right-handed, y up; the loader reads along (-x, y, z)
    Threejs,
    /// _px _nx _py _ny _pz _nz; left-handed, y up
    Babylon,
    /// Left is +X, right is -X; left-handed, y up
    Unity,
    /// +X -X +Y -Y +Z -Z of one DDS file; left-handed, z up
    Unreal,
    /// X+ X- Y+ Y- Z+ Z- of one picture; right-handed, y up
    Godot,
    /// Blender reads no cube maps: six renders along its axes; right-handed, z up
    Blender,
}

/// What an engine does.
#[derive(Debug, Clone, Copy)]
struct Convention {
    engine: Engine,
    preset: Preset,
    /// The axis that the engine negates before it reads.
    negated: Option<u8>,
    up: SignedAxis,
    handedness: Handedness,
    /// The files +X -X +Y -Y +Z -Z as its documents call them.
    files: [&'static str; 6],
    /// The document.
    document: &'static str,
}

const AXES: [&str; 6] = ["posx", "negx", "posy", "negy", "posz", "negz"];
const LETTERS: [&str; 6] = ["px", "nx", "py", "ny", "pz", "nz"];
const SUFFIXES: [&str; 6] = ["_px", "_nx", "_py", "_ny", "_pz", "_nz"];
const UNITY: [&str; 6] = ["left", "right", "up", "down", "front", "back"];

#[rustfmt::skip]
const TABLE: [Convention; 9] = [
    Convention {
        engine: Engine::Opengl, preset: Preset::Opengl, negated: None, up: SignedAxis::POS_Y, handedness: Handedness::Right,
        files: AXES, document: "OpenGL 4.6 Core Profile, table 8.19",
    },
    Convention {
        engine: Engine::Vulkan, preset: Preset::Opengl, negated: None, up: SignedAxis::POS_Y, handedness: Handedness::Right,
        files: AXES, document: "Vulkan Specification, Image Operations: Cube Map Face Selection",
    },
    // "purposefully designed to be consistent with DirectX 7's cube map arrangement" (NVIDIA on the extension).
    Convention {
        engine: Engine::Directx, preset: Preset::Opengl, negated: None, up: SignedAxis::POS_Y, handedness: Handedness::Left,
        files: AXES, document: "EXT_texture_cube_map; learn.microsoft.com, Cubic Environment Mapping (Direct3D 9)",
    },
    // `vec3(flipEnvMap * vWorldDirection.x, vWorldDirection.yz)` with flipEnvMap = -1, in backgroundCube.glsl.js.
    Convention {
        engine: Engine::Threejs, preset: Preset::Opengl, negated: Some(0), up: SignedAxis::POS_Y, handedness: Handedness::Right,
        files: LETTERS, document: "threejs.org/docs, CubeTextureLoader: \"pos-x and neg-x swapped\"",
    },
    Convention {
        engine: Engine::Babylon, preset: Preset::Opengl, negated: None, up: SignedAxis::POS_Y, handedness: Handedness::Left,
        files: SUFFIXES, document: "doc.babylonjs.com, Skyboxes; Coordinate Systems and Handedness",
    },
    Convention {
        engine: Engine::Unity, preset: Preset::Opengl, negated: None, up: SignedAxis::POS_Y, handedness: Handedness::Left,
        files: UNITY, document: "docs.unity3d.com, 6 Sided skybox: Front [+Z], Left [+X]; CubemapFace",
    },
    // The page's rotations are those of this table seen with z up: a test works them out.
    Convention {
        engine: Engine::Unreal, preset: Preset::Opengl, negated: None, up: SignedAxis::POS_Z, handedness: Handedness::Left,
        files: AXES, document: "docs.unrealengine.com, Creating Cubemaps",
    },
    Convention {
        engine: Engine::Godot, preset: Preset::Opengl, negated: None, up: SignedAxis::POS_Y, handedness: Handedness::Right,
        files: AXES, document: "docs.godotengine.org, Cubemap: \"X+, X-, Y+, Y-, Z+, Z- (in Godot's coordinate system)\"",
    },
    Convention {
        engine: Engine::Blender, preset: Preset::Course, negated: None, up: SignedAxis::POS_Z, handedness: Handedness::Right,
        files: AXES, document: "docs.blender.org, Environment Texture Node: equirectangular or mirror ball alone, z up",
    },
];

impl Engine {
    /// All engines.
    pub const ALL: [Self; 9] = [
        Self::Opengl,
        Self::Vulkan,
        Self::Directx,
        Self::Threejs,
        Self::Babylon,
        Self::Unity,
        Self::Unreal,
        Self::Godot,
        Self::Blender,
    ];

    fn convention(self) -> &'static Convention {
        TABLE.iter().find(|convention| convention.engine == self).expect("every engine has its row")
    }

    /// The name on the command line.
    pub fn name(self) -> String {
        name_of(self)
    }

    /// The axes of its world.
    pub fn world(self) -> World {
        let Convention { up, handedness, .. } = *self.convention();
        World { up, handedness }
    }

    /// The files +X -X +Y -Y +Z -Z as its documents call them.
    pub fn file_names(self) -> [&'static str; 6] {
        self.convention().files
    }

    /// The file that it shows in the direction of a face.
    pub fn file_name(self, face: Face) -> &'static str {
        self.file_names()[self.lookup([""; 6]).row(face).image.index()]
    }

    /// The document that says so.
    pub fn document(self) -> &'static str {
        self.convention().document
    }

    /// The table by which it reads six files, called `files` in the order of [`Face::ALL`].
    pub fn lookup(self, files: [&str; 6]) -> Lookup {
        let Convention { preset, negated, handedness, .. } = *self.convention();
        let lookup = preset.lookup().in_world(handedness);
        let lookup = negated.map_or(lookup, |axis| lookup.reflected(axis));
        // Unity's left is +X, where every other naming has -X.
        let file = |face: Face| files[face.index()].rsplit(['/', '\\']).next().unwrap_or_default().to_lowercase();
        let called = |face: Face, name: &str| file(face).contains(name);
        if self == Self::Unity && called(Face::PosX, "right") && called(Face::NegX, "left") {
            let mut rows = *lookup.rows();
            (rows[0].image, rows[1].image) = (rows[1].image, rows[0].image);
            return lookup.with_rows(rows).expect("the axes are those of a valid table");
        }
        lookup
    }

    /// How it shows a map, in one sentence.
    pub fn description(self) -> String {
        let World { up, handedness } = self.world();
        let front = self.world().front();
        let seen = format!("as {} shows it: a {}-handed world, {up} up, front {front}", self.name(), handedness.name());
        if self.lookup([""; 6]).mirrors(Face::PosX) {
            return format!(
                "{seen}; photographs appear mirrored, unless the program reads along (x, y, -z): --lookup humus-y-up"
            );
        }
        seen
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::envmap::{FaceLookup, ImageOperation, Orientation, VOrigin};
    use crate::math::Vec3;
    use crate::render::AxisShot;

    #[test]
    fn every_engine_has_one_row() {
        assert_eq!(TABLE.map(|convention| convention.engine), Engine::ALL);
        for engine in Engine::ALL {
            let others = Engine::ALL.into_iter().filter(|other| other.name() == engine.name()).count();
            assert!(others == 1 && !engine.document().is_empty());
        }
    }

    /// Left-handed engines, three.js and Blender show photographs unmirrored; the others read the world's directions as
    /// they are and mirror them.
    #[test]
    fn handedness_is_that_of_the_documents() {
        for engine in Engine::ALL {
            let mirrors = matches!(engine, Engine::Opengl | Engine::Vulkan | Engine::Godot);
            let lookup = engine.lookup(engine.file_names());
            assert_eq!(Face::ALL.map(|face| lookup.mirrors(face)), [mirrors; 6], "{}", engine.name());
        }
    }

    #[test]
    fn threejs_is_opengl_with_x_reversed_and_humus_y_up_turned_half_about_the_up_axis() {
        let threejs = Engine::Threejs.lookup(LETTERS);
        let (opengl, humus) = (Preset::Opengl.lookup(), Preset::HumusYUp.lookup());
        for d in [Vec3::new(1.0, 0.2, -0.7), Vec3::new(-0.1, 0.9, 0.3), Vec3::new(0.2, 0.1, -1.0), Vec3::NEG_Y] {
            let place = threejs.image_point(threejs.locate(d));
            assert_eq!(place, opengl.image_point(opengl.locate(Vec3::new(-d.x, d.y, d.z))));
            assert_eq!(place, humus.image_point(humus.locate(Vec3::new(-d.x, d.y, -d.z))));
        }
        assert_eq!(Preset::Opengl.lookup().reflected(2), Preset::HumusYUp.lookup());
    }

    /// What a viewer sees along an axis, as an operation on the image that the face reads.
    fn seen(engine: Engine, direction: Face) -> (Face, ImageOperation) {
        let shot = AxisShot::new(direction, engine.world());
        let lookup = engine.lookup(engine.file_names());
        let upright = FaceLookup { image: direction, u: shot.right(), v: -shot.up };
        let row = lookup.row_counted_from(direction, VOrigin::Top);
        (row.image, Orientation::between(upright, row).image_operation(VOrigin::Top))
    }

    /// In a left-handed world with y up every image is seen as it is. In Unity's files the picture at +X is called left.
    #[test]
    fn left_handed_engines_show_the_files_as_they_are() {
        for engine in [Engine::Directx, Engine::Babylon, Engine::Unity] {
            for face in Face::ALL {
                assert_eq!(seen(engine, face), (face, ImageOperation::None), "{} {}", engine.name(), face.name());
            }
        }
        let named = ["right.png", "left.png", "up.png", "down.png", "front.png", "back.png"];
        let lookup = Engine::Unity.lookup(named);
        assert_eq!(lookup.row(Face::PosX).image, Face::NegX, "the image called left");
        assert_eq!(lookup.row(Face::PosZ).image, Face::PosZ);
        assert_eq!(Engine::Unity.lookup(AXES), Engine::Directx.lookup(AXES));
    }

    /// The table of Unreal's page: how each view is turned in the file. What is seen is turned back.
    #[test]
    fn unreal_turns_the_sides_as_its_page_says() {
        let turned_back = [
            (Face::PosX, ImageOperation::TurnClockwise),
            (Face::NegX, ImageOperation::TurnCounterclockwise),
            (Face::PosY, ImageOperation::Turn180),
            (Face::NegY, ImageOperation::None),
        ];
        for (face, operation) in turned_back {
            assert_eq!(seen(Engine::Unreal, face), (face, operation), "{}", face.name());
        }
        // "The side that must align with positive Y should be at the top."
        for face in [Face::PosZ, Face::NegZ] {
            assert_eq!(Engine::Unreal.lookup(AXES).row(face).v, SignedAxis::NEG_Y);
        }
    }

    #[test]
    fn blenders_six_renders_are_the_axis_shots_of_a_world_with_z_up() {
        for face in Face::ALL {
            assert_eq!(seen(Engine::Blender, face), (face, ImageOperation::None));
        }
    }
}
