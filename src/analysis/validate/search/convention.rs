//! Known conventions: fixes that have one cause and a name.

use std::fmt;

use super::arrangement::Arrangement;
use super::symmetry::orientation_between;
use crate::envmap::{Face, Lookup, Preset};

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
    OpenExr,
    /// Names of Quake and Terragen: front is +X.
    Quake,
}

impl Convention {
    const ALL: [Self; 8] = [
        Self::BottomUp,
        Self::Mirrored,
        Self::Opengl,
        Self::Course,
        Self::HumusZUp,
        Self::HumusYUp,
        Self::OpenExr,
        Self::Quake,
    ];

    /// The name in JSON.
    pub fn name(self) -> &'static str {
        match self {
            Self::BottomUp => "bottom-up",
            Self::Mirrored => "mirrored",
            Self::Opengl => "opengl",
            Self::Course => "course",
            Self::HumusZUp => "humus-z-up",
            Self::HumusYUp => "humus-y-up",
            Self::OpenExr => "openexr",
            Self::Quake => "quake",
        }
    }

    /// What the lookup would have to be for a map of this convention.
    fn arrangement(self, lookup: &Lookup) -> Arrangement {
        use Face::{NegX, NegY, NegZ, PosX, PosY, PosZ};
        let given = Arrangement::given(Face::ALL.map(|face| lookup.row(face).image));
        let read = |faces: [Face; 6]| faces.map(|face| lookup.row(face).image);
        match self {
            Self::BottomUp => Arrangement { orientations: [2; 6], ..given },
            Self::Mirrored => Arrangement { orientations: [1; 6], ..given },
            Self::OpenExr => Arrangement { images: read([PosX, NegX, PosY, NegY, NegZ, PosZ]), ..given },
            Self::Quake => Arrangement { images: read([PosZ, NegZ, PosY, NegY, PosX, NegX]), ..given },
            Self::Opengl => table(lookup, Preset::Opengl),
            Self::Course => table(lookup, Preset::Course),
            Self::HumusZUp => table(lookup, Preset::HumusZUp),
            Self::HumusYUp => table(lookup, Preset::HumusYUp),
        }
    }
}

/// A preset as an arrangement relative to the given lookup.
pub(crate) fn table(lookup: &Lookup, preset: Preset) -> Arrangement {
    let wanted = preset.lookup();
    let turned_over = wanted.v_origin() != lookup.v_origin();
    let mut arrangement = Arrangement::given(Face::ALL.map(|face| wanted.row(face).image));
    for face in Face::ALL {
        let mut row = wanted.row(face);
        // Counted from the other end, v grows the other way.
        row.v = if turned_over { -row.v } else { row.v };
        arrangement.orientations[face.index()] = orientation_between(lookup.row(face), row);
    }
    arrangement
}

/// The conventions that differ from the given lookup, with their arrangements. Quake's is among them only for
/// files that are named in its way (`quake_names`).
pub fn candidates(lookup: &Lookup, quake_names: bool) -> Vec<(Convention, Arrangement)> {
    let given = Arrangement::given(Face::ALL.map(|face| lookup.row(face).image));
    let possible = |convention: &Convention| *convention != Convention::Quake || quake_names;
    Convention::ALL
        .into_iter()
        .filter(possible)
        .map(|convention| (convention, convention.arrangement(lookup)))
        .filter(|(_, arrangement)| *arrangement != given)
        .collect()
}

/// True if files are named by words (`front`, `left`, ...) or as Quake does (`ft`, `lf`, ...).
pub fn has_quake_names<'a>(files: impl Iterator<Item = &'a str>) -> bool {
    const NAMES: [&str; 8] = ["front", "back", "left", "right", "ft", "bk", "lf", "rt"];
    let named = |file: &str| {
        let name = file.rsplit('/').next().unwrap_or(file).to_ascii_lowercase();
        let stem = name.rsplit_once('.').map_or(name.as_str(), |(stem, _)| stem).to_owned();
        NAMES[..4].iter().any(|word| stem.contains(word)) || NAMES[4..].iter().any(|word| stem.ends_with(word))
    };
    files.filter(|file| named(file)).count() >= 4
}

impl fmt::Display for Convention {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Self::BottomUp => "all six flipped top-bottom: these files were made for bottom-up upload",
            Self::Mirrored => "all six flipped left-right: these files were made for the opposite handedness",
            Self::Opengl => "these files follow OpenGL's convention: use --lookup opengl",
            Self::Course => "these files follow the course's convention for a z-up world: use --lookup course",
            Self::HumusZUp => "a y-up download in a z-up world: use --lookup humus-z-up",
            Self::HumusYUp => "a y-up download seen along -z: use --lookup humus-y-up",
            Self::OpenExr => "OpenEXR's convention: +Z and -Z change places",
            Self::Quake => "Quake's convention: front is +X, back -X, right +Z, left -Z",
        })
    }
}

/// The faces that show their pictures mirrored to an observer in a right-handed world.
pub fn mirrored_faces(lookup: &Lookup) -> Vec<Face> {
    Face::ALL.into_iter().filter(|&face| lookup.mirrors(face)).collect()
}
