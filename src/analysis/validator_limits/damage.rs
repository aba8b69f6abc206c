//! What was done to the files of a right map.

use super::world::World;
use crate::envmap::{Face, Orientation, VOrigin};
use crate::picture::Picture;

/// One thing that goes wrong with files. The face is one of the four at the sides.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Damage {
    None,
    /// Turned by a quarter.
    Turned(Face),
    /// Flipped left-right.
    Flipped(Face),
    /// In the place of the opposite one.
    Exchanged(Face),
    /// The picture of another world.
    Foreign(Face),
    /// The picture of the opposite face, so that there are two of it.
    Copied(Face),
}

impl Damage {
    /// What is tried in every sweep but that of copies.
    pub const USUAL: [Self; 5] = [
        Self::None,
        Self::Turned(Face::PosX),
        Self::Flipped(Face::NegZ),
        Self::Exchanged(Face::PosZ),
        Self::Foreign(Face::NegX),
    ];

    /// A copy of each of the four sides.
    pub const COPIES: [Self; 4] =
        [Self::Copied(Face::PosX), Self::Copied(Face::NegX), Self::Copied(Face::PosZ), Self::Copied(Face::NegZ)];

    /// The face whose picture belongs nowhere in this map.
    pub fn outlier(self) -> Option<Face> {
        match self {
            Self::Foreign(face) | Self::Copied(face) => Some(face),
            _ => None,
        }
    }

    /// Does it.
    pub fn done_to(self, faces: &[Picture; 6], world: World) -> [Picture; 6] {
        let mut damaged = faces.clone();
        match self {
            Self::None => {}
            Self::Turned(face) => damaged[face.index()] = oriented(&faces[face.index()], Orientation::ALL[4]),
            Self::Flipped(face) => damaged[face.index()] = oriented(&faces[face.index()], Orientation::ALL[1]),
            Self::Exchanged(face) => damaged.swap(face.index(), face.index() ^ 1),
            Self::Foreign(face) => damaged[face.index()] = world.next().face(face, faces[0].width()),
            Self::Copied(face) => damaged[face.index()] = faces[face.index() ^ 1].clone(),
        }
        damaged
    }

    /// In words.
    pub fn told(self) -> String {
        match self {
            Self::None => "as it was".to_owned(),
            Self::Turned(face) => format!("{} turned", face.name()),
            Self::Flipped(face) => format!("{} flipped", face.name()),
            Self::Exchanged(face) => format!("{} exchanged", face.name()),
            Self::Foreign(face) => format!("{} foreign", face.name()),
            Self::Copied(face) => format!("{} a copy", face.name()),
        }
    }
}

fn oriented(picture: &Picture, orientation: Orientation) -> Picture {
    let operation = orientation.image_operation(VOrigin::Top);
    let size = picture.width();
    picture.rearranged(|x, y| operation.source(x, y, size))
}
