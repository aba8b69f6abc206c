//! Known conventions: orders of six files that have one cause and a name.

use std::fmt;

use super::super::thresholds::story::{
    ANNOUNCED, ANNOUNCING_NAMES, LIKE_AN_EXCHANGE, MIRRORED, NUMBERED, OTHER_TABLE, SIDEWAYS,
};
use super::arrangement::Arrangement;
use super::symmetry::orientation_between;
use crate::envmap::{Face, Lookup, Preset, SignedAxis};

/// A convention that a map was made for, where the given lookup reads it otherwise.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Convention {
    /// Rows stored from the bottom to the top.
    BottomUp,
    /// Every picture mirrored left-right.
    Mirrored,
    /// OpenGL's table where another lookup was given.
    Opengl,
    /// The course's table for a z-up world.
    Course,
    /// A y-up download in the course's z-up world.
    HumusZUp,
    /// A y-up download seen along -z, unmirrored.
    HumusYUp,
    /// `+Z` and `-Z` change places.
    #[serde(rename = "openexr")]
    OpenExr,
    /// Names of Quake and Terragen: front is +X.
    Quake,
    /// Unity's names: left is +X, right is -X.
    Unity,
    /// Files named for a world with z up where the lookup has y up.
    ZUp,
    /// The same, right-handed.
    ZUpRightHanded,
    /// Front, right, back, left, up, down: cells and numbers of Pannellum and Minecraft.
    FrontFirst,
    /// Sheets of Minecraft's OptiFine: bottom, top, south, west, north, east.
    Optifine,
}

/// An order that files may follow, and what it costs to assume it.
#[derive(Debug, Clone, Copy)]
pub struct Order {
    /// `None` for the order of the lookup itself.
    pub convention: Option<Convention>,
    pub arrangement: Arrangement,
    pub cost: u32,
}

/// What the names and formats of the files say about their order.
#[derive(Debug, Clone, Copy, Default)]
pub struct Hints {
    /// `front`, `left`, ... or `ft`, `lf`, ...
    pub quake_names: bool,
    /// `_FrontTex`, `_LeftTex`, ...
    pub unity_names: bool,
    /// A cube in one OpenEXR file.
    pub openexr_cube: bool,
    /// Names mean nothing: numbers, cells of a strip.
    pub free_names: bool,
}

impl Convention {
    const ALL: [Self; 13] = [
        Self::BottomUp,
        Self::Mirrored,
        Self::Opengl,
        Self::Course,
        Self::HumusZUp,
        Self::HumusYUp,
        Self::OpenExr,
        Self::Quake,
        Self::Unity,
        Self::ZUp,
        Self::ZUpRightHanded,
        Self::FrontFirst,
        Self::Optifine,
    ];

    /// What the lookup would have to be for a map of this convention.
    fn arrangement(self, lookup: &Lookup) -> Arrangement {
        use Face::{NegX, NegY, NegZ, PosX, PosY, PosZ};
        let given = Arrangement::given(Face::ALL.map(|face| lookup.row(face).image));
        let read = |faces: [Face; 6]| Arrangement { images: faces.map(|face| lookup.row(face).image), ..given };
        match self {
            Self::BottomUp => Arrangement { orientations: [2; 6], ..given },
            Self::Mirrored => Arrangement { orientations: [1; 6], ..given },
            Self::OpenExr => read([PosX, NegX, PosY, NegY, NegZ, PosZ]),
            Self::Quake => read([PosZ, NegZ, PosY, NegY, PosX, NegX]),
            Self::Unity => read([NegX, PosX, PosY, NegY, PosZ, NegZ]),
            Self::ZUp => read([PosX, NegX, PosZ, NegZ, PosY, NegY]),
            Self::ZUpRightHanded => read([PosX, NegX, PosZ, NegZ, NegY, PosY]),
            Self::FrontFirst => read([NegX, NegY, PosZ, NegZ, PosX, PosY]),
            Self::Optifine => read([NegZ, NegY, NegX, PosX, PosZ, PosY]),
            Self::Opengl => table(lookup, Preset::Opengl),
            Self::Course => table(lookup, Preset::Course),
            Self::HumusZUp => table(lookup, Preset::HumusZUp),
            Self::HumusYUp => table(lookup, Preset::HumusYUp),
        }
    }

    /// The lookup to use instead, if the convention has one.
    pub fn preset(self) -> Option<Preset> {
        match self {
            Self::Opengl => Some(Preset::Opengl),
            Self::Course => Some(Preset::Course),
            Self::HumusZUp => Some(Preset::HumusZUp),
            Self::HumusYUp => Some(Preset::HumusYUp),
            Self::BottomUp | Self::Mirrored | Self::OpenExr | Self::Quake | Self::Unity => None,
            Self::ZUp | Self::ZUpRightHanded | Self::FrontFirst | Self::Optifine => None,
        }
    }

    /// What these files are, as a sentence without its full stop.
    pub fn reason(self) -> &'static str {
        match self {
            Self::BottomUp => "all six flipped top-bottom: these files were made for bottom-up upload",
            Self::Mirrored => "all six flipped left-right: these files were made for the opposite handedness",
            Self::Opengl => "these files follow OpenGL's convention",
            Self::Course => "these files follow the course's convention for a z-up world",
            Self::HumusZUp => "a y-up download in a z-up world",
            Self::HumusYUp => "a y-up download seen along -z",
            Self::OpenExr => "OpenEXR's convention: +Z and -Z change places",
            Self::Quake => "Quake's convention: front is +X, back -X, right +Z, left -Z",
            Self::Unity => "Unity's convention: left is +X, right -X",
            Self::ZUp => "these files are named for a world with z up: posz is the top",
            Self::ZUpRightHanded => "these files are named for a right-handed world with z up: posz is the top",
            Self::Optifine => "OptiFine's order: bottom, top, south, west, north, east",
            Self::FrontFirst => "the order of Pannellum and Minecraft: front, right, back, left, up, down",
        }
    }

    /// What it costs to assume this order; `None` where nothing speaks for it that an exchange would not explain.
    fn cost(self, world_up: SignedAxis, hints: Hints) -> Option<u32> {
        let announced = |by_names: bool| by_names.then_some(ANNOUNCED);
        let y_up = world_up.axis == 1;
        let upright = |preset: Preset| Some(if preset.usual_up() == world_up { OTHER_TABLE } else { SIDEWAYS });
        match self {
            Self::BottomUp => Some(LIKE_AN_EXCHANGE),
            Self::Mirrored => Some(MIRRORED),
            Self::Opengl => upright(Preset::Opengl),
            Self::Course => upright(Preset::Course),
            Self::HumusZUp => upright(Preset::HumusZUp),
            Self::HumusYUp => upright(Preset::HumusYUp),
            Self::OpenExr => announced(hints.openexr_cube),
            Self::Quake => announced(hints.quake_names),
            Self::Unity => announced(hints.unity_names),
            Self::ZUp | Self::ZUpRightHanded => y_up.then_some(LIKE_AN_EXCHANGE),
            Self::FrontFirst | Self::Optifine => hints.free_names.then_some(NUMBERED),
        }
    }
}

/// A preset as an arrangement relative to the given lookup.
pub(crate) fn table(lookup: &Lookup, preset: Preset) -> Arrangement {
    let wanted = preset.lookup();
    let mut arrangement = Arrangement::given(Face::ALL.map(|face| wanted.row(face).image));
    for face in Face::ALL {
        let row = wanted.row_counted_from(face, lookup.v_origin());
        arrangement.orientations[face.index()] = orientation_between(lookup.row(face), row);
    }
    arrangement
}

/// The orders that files may follow: that of the lookup first, then every convention that differs from it.
pub fn orders(lookup: &Lookup, world_up: SignedAxis, hints: Hints) -> Vec<Order> {
    let given = Arrangement::given(Face::ALL.map(|face| lookup.row(face).image));
    let own = Order { convention: None, arrangement: given, cost: 0 };
    let known = Convention::ALL.into_iter().filter_map(|convention| {
        let cost = convention.cost(world_up, hints)?;
        Some(Order { convention: Some(convention), arrangement: convention.arrangement(lookup), cost })
    });
    std::iter::once(own).chain(known.filter(|order| order.arrangement != given)).collect()
}

impl Hints {
    /// What the names of six files say. Cells of a strip or sheet are called `strip.png [+x cell]`.
    pub fn of_files<'a>(files: impl Iterator<Item = &'a str>, free_names: bool) -> Self {
        const WORDS: [&str; 4] = ["front", "back", "left", "right"];
        const SHORT: [&str; 4] = ["ft", "bk", "lf", "rt"];
        let names: Vec<String> =
            files.map(|file| file.rsplit('/').next().unwrap_or(file).to_ascii_lowercase()).collect();
        let stem = |name: &str| name.rsplit_once('.').map_or(name, |(stem, _)| stem).to_owned();
        let count = |named: &dyn Fn(&str) -> bool| names.iter().filter(|name| named(&stem(name))).count();
        let quake =
            |stem: &str| WORDS.iter().any(|word| stem.contains(word)) || SHORT.iter().any(|word| stem.ends_with(word));
        let unity = |stem: &str| WORDS.iter().any(|word| stem.contains(word));
        Self {
            quake_names: count(&quake) >= ANNOUNCING_NAMES,
            unity_names: count(&unity) >= ANNOUNCING_NAMES,
            openexr_cube: names.iter().all(|name| name.contains(".exr [")),
            free_names,
        }
    }
}

impl fmt::Display for Convention {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(self.reason())?;
        self.preset().map_or(Ok(()), |preset| write!(formatter, ": use --lookup {}", preset.name()))
    }
}

/// The faces that show their pictures mirrored to an observer in a right-handed world.
pub fn mirrored_faces(lookup: &Lookup) -> Vec<Face> {
    Face::ALL.into_iter().filter(|&face| lookup.mirrors(face)).collect()
}
