//! What the shots say about camera and lookup. The same pictures may come from either: the simplest explanation is the
//! one with the fewest things wrong, and the other one is named.

use super::misfit::Misfit;
use super::placement::{CameraFault, Placement, ShotFrame, on_screen};
use crate::envmap::{Face, Laying, Lookup};

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
    pub face: Face,
    /// The shot that shows it, by the name of its file.
    pub shot: Face,
    /// What the code may read, the most plausible first; one if decided, none if the shot fits no laying.
    pub possible: Vec<Placement>,
    pub misfit: Option<Misfit>,
    /// The image it should read.
    pub expected: Face,
}

impl FaceGrade {
    /// What the code reads, or the most plausible of several.
    pub fn placement(&self) -> Option<Placement> {
        self.possible.first().copied()
    }

    pub fn is_decided(&self) -> bool {
        self.possible.len() == 1
    }

    /// What the code should read.
    pub fn right(&self) -> Placement {
        Placement { image: self.expected, laying: Laying::IDENTITY }
    }

    /// True if the pixels exclude that the code is right.
    pub fn is_wrong(&self) -> bool {
        !self.possible.is_empty() && !self.possible.contains(&self.right())
    }

    /// What to compute from the code's own (u, v).
    pub fn repair(&self) -> Option<Laying> {
        self.placement().map(|placement| placement.laying.inverse())
    }
}

/// Another way to explain the same pictures.
#[derive(Debug, Clone, PartialEq)]
pub enum Alternative {
    /// The camera is right, and the lookup does this.
    Lookup(Box<[FaceGrade; 6]>),
    /// The lookup is right, and the camera stands so.
    Camera(CameraFault),
    /// The lookup is right, and the cameras of these shots were rolled.
    Rolled(Vec<Face>),
    /// The lookup is right, and the first of each is the shot of the second.
    Exchanged(Vec<(Face, Face)>),
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
            laying: placement.laying.after(screen).after(seen.inverse()),
            ..*placement
        };
        let expected = self.lookup.row(face).image;
        let mut possible: Vec<Placement> = reading.possible.iter().map(moved).collect();
        let simplicity = |placement: &Placement| {
            let laying = Laying::ALL.iter().position(|laying| *laying == placement.laying);
            (placement.image != expected, laying, placement.image)
        };
        possible.sort_by_key(simplicity);
        FaceGrade { face, shot: frame.face, possible, misfit: reading.misfit, expected }
    }

    /// The camera that leaves the fewest things wrong. A camera is blamed only if it explains at least three wrong
    /// faces and leaves none wrong, or one of six.
    pub fn camera(&self) -> CameraFault {
        let wrong_faces = wrong(&self.under(CameraFault::NONE));
        let allowed = usize::from(wrong_faces == 6);
        match self.best_camera() {
            Some((camera, left)) if wrong_faces >= 3 && left <= allowed => camera,
            _ => CameraFault::NONE,
        }
    }

    /// The simplest camera with a fault under which the fewest faces are wrong, and how many.
    fn best_camera(&self) -> Option<(CameraFault, usize)> {
        let simplicity = |camera: &CameraFault| {
            usize::from(camera.exchanges_axes()) + usize::from(camera.laying != Laying::IDENTITY)
        };
        let cameras = CameraFault::all().into_iter().filter(|camera| *camera != CameraFault::NONE);
        let scored = cameras.map(|camera| (camera, wrong(&self.under(camera))));
        scored.min_by_key(|(camera, wrong)| (*wrong, simplicity(camera)))
    }

    /// The other explanation of a fault, if there is a simple one.
    pub fn alternative(&self, camera: CameraFault) -> Option<Alternative> {
        let grades = self.under(CameraFault::NONE);
        if camera != CameraFault::NONE {
            return Some(Alternative::Lookup(Box::new(grades)));
        }
        if wrong(&grades) == 0 {
            return None;
        }
        let wrong_grades = || grades.iter().filter(|grade| grade.is_wrong());
        if wrong_grades().all(|grade| self.is_rolled(grade)) {
            return Some(Alternative::Rolled(wrong_grades().map(|grade| grade.shot).collect()));
        }
        let exchanged: Option<Vec<_>> =
            wrong_grades().map(|grade| self.shot_of(grade).map(|other| (grade.shot, other))).collect();
        exchanged.map(Alternative::Exchanged).or_else(|| {
            let (camera, left) = self.best_camera()?;
            (left == 0).then_some(Alternative::Camera(camera))
        })
    }

    /// True if the shot shows the right picture turned, not mirrored.
    fn is_rolled(&self, grade: &FaceGrade) -> bool {
        let Some(placement) = grade.placement() else { return false };
        let Laying { swaps, inverts_u, inverts_v } = placement.laying;
        placement.image == grade.expected && swaps == (inverts_u != inverts_v)
    }

    /// The other axis whose right picture this shot is.
    fn shot_of(&self, grade: &FaceGrade) -> Option<Face> {
        let placement = grade.placement()?;
        let screen = |frame: &ShotFrame| on_screen(self.lookup.row(frame.face), frame.right, frame.up);
        let shown = placement.laying.after(screen(&self.frames[grade.shot.index()]));
        let other = self.frames.iter().find(|frame| {
            self.lookup.row(frame.face).image == placement.image && screen(frame) == shown && frame.face != grade.shot
        });
        other.map(|frame| frame.face)
    }
}

/// How many faces are wrong.
pub(super) fn wrong(grades: &[FaceGrade; 6]) -> usize {
    grades.iter().filter(|grade| grade.is_wrong()).count()
}
