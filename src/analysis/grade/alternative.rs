//! Alternative explanations of the same shots: another camera, other names of the files, a preset.

use super::explanation::{Evidence, FaceGrade, wrong};
use super::placement::{CameraFault, Placement, ShotFrame, on_screen};
use super::thresholds::decisive::TELLING_FACES;
use crate::envmap::{Face, Orientation, Preset};

/// Another explanation of the same pictures.
#[derive(Debug, Clone, PartialEq)]
pub enum Alternative {
    /// The camera is right, and the lookup does this.
    Lookup(Box<[FaceGrade; 6]>),
    /// The lookup is right, and the camera stands so.
    Camera(CameraFault),
    /// The camera stands so, and the lookup does this.
    Both(CameraFault, Box<[FaceGrade; 6]>),
    /// The lookup is right, and the cameras of these shots were rolled.
    Rolled(Vec<Face>),
    /// The lookup is right, and the first of each is the shot of the second.
    Exchanged(Vec<(Face, Face)>),
}

/// Presets that the code may contain.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct PresetReading {
    /// One, unless the pixels cannot tell several apart.
    #[serde(rename = "names")]
    pub presets: Vec<Preset>,
    /// How the camera stands then: right, or all six shots mirrored or turned alike.
    pub camera: CameraFault,
}

impl Evidence<'_> {
    /// The other explanations of a fault that are simple.
    pub fn alternatives(&self, camera: CameraFault) -> Vec<Alternative> {
        let grades = self.under(CameraFault::NONE);
        if camera != CameraFault::NONE {
            return vec![Alternative::Lookup(Box::new(grades))];
        }
        if wrong(&grades) == 0 {
            return Vec::new();
        }
        let mistaken = self.mistaken_shots(&grades);
        let camera = self.other_camera(wrong(&grades), mistaken.is_none());
        mistaken.into_iter().chain(camera).collect()
    }

    /// The lookup is right, and shots were rolled or files named wrongly.
    fn mistaken_shots(&self, grades: &[FaceGrade; 6]) -> Option<Alternative> {
        let wrong_grades = || grades.iter().filter(|grade| grade.is_wrong());
        if wrong_grades().all(|grade| self.is_rolled(grade)) {
            return Some(Alternative::Rolled(wrong_grades().map(|grade| grade.shot).collect()));
        }
        let exchanged: Option<Vec<_>> =
            wrong_grades().map(|grade| self.shot_of(grade).map(|other| (grade.shot, other))).collect();
        exchanged.map(Alternative::Exchanged)
    }

    /// A camera that leaves no face wrong; else one that gives all six shots one orientation, is right about a face, and leaves no
    /// more faces wrong than a right camera does. `axes` are exchanged only if nothing simpler is known.
    fn other_camera(&self, wrong_faces: usize, axes: bool) -> Option<Alternative> {
        let perfect = self.best_camera().filter(|(camera, left)| *left == 0 && (axes || !camera.exchanges_axes()));
        if let Some((camera, _)) = perfect {
            return Some(Alternative::Camera(camera));
        }
        let preset_camera = self.preset().map(|reading| reading.camera);
        let readings = CameraFault::oriented_alike().skip(1).map(|camera| (camera, self.under(camera)));
        let plausible = readings.filter(|(_, grades)| {
            wrong(grades) <= wrong_faces && grades.iter().any(|grade| grade.is_decided() && !grade.is_wrong())
        });
        let simplest = plausible
            .min_by_key(|(camera, grades)| (Some(*camera) != preset_camera, wrong(grades), changes(grades)))?;
        Some(Alternative::Both(simplest.0, Box::new(simplest.1)))
    }

    /// The presets that all faces may be, if the lookup the code should have is not among what they may be.
    pub fn preset(&self) -> Option<PresetReading> {
        if wrong(&self.under(CameraFault::NONE)) == 0 {
            return None;
        }
        let reading = |camera: CameraFault| PresetReading { camera, presets: self.presets_shown(&self.under(camera)) };
        CameraFault::oriented_alike().map(reading).find(|reading| !reading.presets.is_empty())
    }

    fn presets_shown(&self, grades: &[FaceGrade; 6]) -> Vec<Preset> {
        let decided = grades.iter().filter(|grade| grade.is_decided()).count();
        if decided < TELLING_FACES || wrong(grades) == 0 {
            return Vec::new();
        }
        let shown = |preset: &Preset| {
            let wanted = preset.lookup();
            grades.iter().all(|grade| {
                let row = wanted.row_counted_from(grade.face, self.lookup.v_origin());
                let orientation = Orientation::between(self.lookup.row(grade.face), row);
                grade.possible.contains(&Placement { image: row.image, orientation })
            })
        };
        Preset::ALL.into_iter().filter(shown).collect()
    }

    /// True if the shot shows the right picture turned, not mirrored.
    fn is_rolled(&self, grade: &FaceGrade) -> bool {
        let Some(placement) = grade.placement() else { return false };
        let Orientation { swaps, inverts_u, inverts_v } = placement.orientation;
        placement.image == grade.expected && swaps == (inverts_u != inverts_v)
    }

    /// The other axis whose right picture this shot is.
    fn shot_of(&self, grade: &FaceGrade) -> Option<Face> {
        let placement = grade.placement()?;
        let screen = |frame: &ShotFrame| on_screen(self.lookup.row(frame.face), frame.right, frame.up);
        let shown = placement.orientation.after(screen(&self.frames[grade.shot.index()]));
        let other = self.frames.iter().find(|frame| {
            self.lookup.row(frame.face).image == placement.image && screen(frame) == shown && frame.face != grade.shot
        });
        other.map(|frame| frame.face)
    }
}

/// How many things are to be changed in the lookup.
fn changes(grades: &[FaceGrade; 6]) -> usize {
    grades.iter().map(FaceGrade::changes).sum()
}
