//! What the shots say about camera and lookup. The same pictures may come from either: a camera is blamed if it leaves at
//! most one face wrong, and at least three fewer than a right camera. [`super::alternative`] names the others.

use serde::ser::{Serialize, SerializeStruct, Serializer};

use super::misfit::Misfit;
use super::placement::{CameraFault, Placement, ShotFrame, on_screen};
use super::thresholds::decisive::{LEFT_WRONG, SET_RIGHT};
use crate::envmap::{Face, Lookup, Orientation};

/// What one shot may show: placements that the pixels cannot tell apart, relative to the lookup's row of its own face.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Reading {
    pub possible: Vec<Placement>,
    /// What it looks like if it shows no image.
    pub misfit: Option<Misfit>,
}

/// What the code does for one face.
#[derive(Debug, Clone, PartialEq)]
pub struct FaceGrade {
    /// The face that the shot should show.
    pub face: Face,
    /// The shot that shows it, by the name of its file.
    pub shot: Face,
    /// What the code may read, the most plausible first; one if decided, none if the shot fits no orientation.
    pub possible: Vec<Placement>,
    /// What the shot looks like if it shows no image; `None` if it shows one.
    pub misfit: Option<Misfit>,
    /// The image it should read.
    pub expected: Face,
}

impl FaceGrade {
    /// What the code reads, or the most plausible of several.
    pub fn placement(&self) -> Option<Placement> {
        self.possible.first().copied()
    }

    /// True if the pixels leave one placement.
    pub fn is_decided(&self) -> bool {
        self.possible.len() == 1
    }

    /// What the code should read.
    pub fn right(&self) -> Placement {
        Placement { image: self.expected, orientation: Orientation::IDENTITY }
    }

    /// True if the pixels exclude that the code is right.
    pub fn is_wrong(&self) -> bool {
        !self.possible.is_empty() && !self.possible.contains(&self.right())
    }

    /// How many things are to be changed for it: its image, its orientation.
    pub fn changes(&self) -> usize {
        let placement = self.placement().filter(|_| self.is_wrong());
        placement.map_or(0, |Placement { image, orientation }| {
            usize::from(image != self.expected) + usize::from(orientation != Orientation::IDENTITY)
        })
    }

    /// What to compute from the code's own (u, v).
    pub fn repair(&self) -> Option<Orientation> {
        self.placement().map(|placement| placement.orientation.inverse())
    }
}

/// What was found, and the repair; keys are null where there is nothing to say.
impl Serialize for FaceGrade {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let placement = self.placement();
        let formulas = placement.map(|placement| placement.orientation.formulas());
        let repair = self.repair().filter(|_| self.is_wrong());
        let mut keys = serializer.serialize_struct("FaceGrade", 10)?;
        keys.serialize_field("face", &self.face)?;
        keys.serialize_field("shot", &self.shot)?;
        keys.serialize_field("image", &placement.map(|placement| placement.image))?;
        keys.serialize_field("u", &formulas.map(|(u, _)| u))?;
        keys.serialize_field("v", &formulas.map(|(_, v)| v))?;
        keys.serialize_field("decided", &self.is_decided())?;
        keys.serialize_field("wrong", &self.is_wrong())?;
        keys.serialize_field("possible", &self.possible.len())?;
        keys.serialize_field("misfit", &self.misfit)?;
        keys.serialize_field("repair", &repair.map(|orientation| Placement { image: self.expected, orientation }))?;
        keys.end()
    }
}

/// The shots of a map, their frames and what they may show.
pub(super) struct Evidence<'a> {
    pub lookup: &'a Lookup,
    pub frames: &'a [ShotFrame; 6],
    pub readings: &'a [Reading; 6],
}

impl Evidence<'_> {
    /// What the code does for each face, in the order of [`Face::ALL`], if the camera stood so.
    pub fn under(&self, camera: CameraFault) -> [FaceGrade; 6] {
        let mut grades: Vec<FaceGrade> =
            (0..6).map(|index| self.face_under(camera, self.frames[index], &self.readings[index])).collect();
        grades.sort_by_key(|grade| grade.face);
        grades.try_into().expect("a camera sees each face once")
    }

    fn face_under(&self, camera: CameraFault, frame: ShotFrame, reading: &Reading) -> FaceGrade {
        let (face, seen) = camera.sees(self.lookup, frame);
        let screen = on_screen(self.lookup.row(frame.face), frame.right, frame.up);
        let moved = |placement: &Placement| Placement {
            orientation: placement.orientation.after(screen).after(seen.inverse()),
            ..*placement
        };
        let expected = self.lookup.row(face).image;
        let mut possible: Vec<Placement> = reading.possible.iter().map(moved).collect();
        let simplicity = |placement: &Placement| {
            let orientation = Orientation::ALL.iter().position(|orientation| *orientation == placement.orientation);
            (placement.image != expected, orientation, placement.image)
        };
        possible.sort_by_key(simplicity);
        FaceGrade { face, shot: frame.face, possible, misfit: reading.misfit, expected }
    }

    /// The camera that is blamed: one that leaves at most one face wrong, and at least three fewer than a right camera
    /// ([`LEFT_WRONG`], [`SET_RIGHT`]).
    pub fn camera(&self) -> CameraFault {
        let wrong_faces = wrong(&self.under(CameraFault::NONE));
        match self.best_camera() {
            Some((camera, left)) if left <= LEFT_WRONG && wrong_faces >= left + SET_RIGHT => camera,
            _ => CameraFault::NONE,
        }
    }

    /// The simplest camera with a fault under which the fewest faces are wrong, and how many.
    pub fn best_camera(&self) -> Option<(CameraFault, usize)> {
        let simplicity = |camera: &CameraFault| {
            usize::from(camera.exchanges_axes()) + usize::from(camera.orientation != Orientation::IDENTITY)
        };
        let cameras = CameraFault::all().into_iter().filter(|camera| *camera != CameraFault::NONE);
        let scored = cameras.map(|camera| (camera, wrong(&self.under(camera))));
        scored.min_by_key(|(camera, wrong)| (*wrong, simplicity(camera)))
    }
}

/// How many faces are wrong.
pub(super) fn wrong(grades: &[FaceGrade; 6]) -> usize {
    grades.iter().filter(|grade| grade.is_wrong()).count()
}
