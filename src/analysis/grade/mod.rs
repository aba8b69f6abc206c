//! Grading: finds the lookup in a student's code from the pixels of six pictures along the axes.
//!
//! 1. [`thumbnail`] brings shots and images to one small size, [`tone`] takes out gamma and exposure.
//! 2. [`field_of_view`] finds the field of view of the camera, or a missing division.
//! 3. [`matching`] tries six images in eight orientations for each shot, and lists those that the pixels exclude.
//! 4. [`explanation`] tells a wrong camera from a wrong lookup, [`alternative`] finds other explanations of the same
//!    shots, [`misfit`] describes a shot without an image. [`thresholds`] has every threshold.

mod alternative;
mod cause;
mod explanation;
mod field_of_view;
mod matching;
mod misfit;
mod placement;
mod thresholds;
mod thumbnail;
mod tone;

pub use alternative::{Alternative, PresetReading};
pub use cause::{Cause, other_ups};
pub use explanation::FaceGrade;
pub use misfit::Misfit;
pub use placement::{CameraFault, Placement, ShotFrame};

use crate::envmap::{CubeMap, Face, Lookup};
use crate::error::Result;
use crate::picture::Picture;
use explanation::{Evidence, Reading};
use field_of_view::Views;
use matching::{Candidate, ImageLevels, Screen, best, candidates, mean_square, possible, variance};
use placement::on_screen;
use thresholds::shown::{FLAT, MUCH_BETTER, NEGLIGIBLE, UNDIVIDED, UNEXPLAINED, WHITE};
use thumbnail::{Codes, Middle};

/// Cells of a side in which shots and images are compared.
const SIDE: usize = 64;
/// Cells in which it is judged whether a shot shows an image at all: aliasing averages out.
const COARSE: usize = 16;
/// Side of the largest picture that is worked on.
const LARGEST: usize = 512;

/// The middle of a shot, as a share of its side, in which code that neither divides nor halves shows the image alone: where
/// `2 a / sqrt(1 + a^2)` is 1.
const WHOLE_IMAGE: f64 = 0.577;

/// What code shows that does not divide by the largest component.
struct Undivided {
    images: [Codes; 6],
    shots: [Codes; 6],
    /// False if it does not halve the coordinates either.
    halved: bool,
}

/// What is wrong, in one word.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub enum GradeVerdict {
    /// Camera and lookup are as they should be.
    Right,
    /// The lookup is wrong, the camera right.
    Lookup,
    /// The camera is wrong, the lookup right.
    Camera,
    /// Both are wrong.
    CameraAndLookup,
    /// A shot fits no orientation of any image.
    OutOfRange,
    /// The pixels decide nothing.
    Undecided,
}

/// What the student's code does.
#[derive(Debug, Clone, PartialEq)]
pub struct Grade {
    /// Where the camera looks, against where it should.
    pub camera: CameraFault,
    /// The angle it saw, in degrees; `None` for 90.
    pub field_of_view: Option<f64>,
    /// True if the code does not divide the two coordinates by the largest component.
    pub undivided: bool,
    /// True if that code does not halve them either.
    pub unhalved: bool,
    /// In the order of [`Face::ALL`].
    pub faces: [FaceGrade; 6],
    /// Other explanations of the same pictures.
    pub alternatives: Vec<Alternative>,
    /// What the code contains if it is another preset than the lookup it should have.
    pub preset: Option<PresetReading>,
}

/// A map, and how the shots of it should be taken: ready to grade any number of them.
pub struct Grader {
    lookup: Lookup,
    frames: [ShotFrame; 6],
    images: [Codes; 6],
}

impl Grader {
    /// `map` is under the lookup that the code should have, `frames` are in the order of [`Face::ALL`]. An error tells that
    /// an image of the map cannot be decoded.
    pub fn new(map: &CubeMap, frames: [ShotFrame; 6]) -> Result<Self> {
        let mut images = Vec::new();
        for face in Face::ALL {
            images.push(limited(Codes::of_picture(map.picture(face)?)));
        }
        let images = images.try_into().expect("there are six faces");
        Ok(Self { lookup: *map.lookup(), frames, images })
    }

    /// Grades shots in the order of [`Face::ALL`].
    pub fn grade(&self, shots: &[Picture; 6]) -> Grade {
        let shots = shots.each_ref().map(|shot| limited(Codes::of_picture(shot)));
        let mut views = self.views(&self.images, &shots);
        let mut scale = views.scale();
        let undivided = self.undivided(&views, scale, &shots);
        if let Some(found) = &undivided {
            views = self.views(&found.images, &found.shots);
            scale = 1.0;
        }
        let images = views.levels(scale, SIDE);
        let readings = std::array::from_fn(|index| read_shot(&views, &images, index, scale));
        let evidence = Evidence { lookup: &self.lookup, frames: &self.frames, readings: &readings };
        let camera = evidence.camera();
        Grade {
            camera,
            undivided: undivided.is_some(),
            unhalved: undivided.as_ref().is_some_and(|found| !found.halved),
            field_of_view: (scale != 1.0).then(|| field_of_view::degrees(scale)),
            faces: evidence.under(camera),
            alternatives: evidence.alternatives(camera),
            preset: evidence.preset(),
        }
    }

    /// Images and shots as they compare for code that does not divide, if that explains decisively more than the best scale
    /// does. Where the coordinates are not halved either, an image fills the middle of a shot.
    fn undivided(&self, views: &Views, scale: f64, shots: &[Codes; 6]) -> Option<Undivided> {
        let misfit = views.misfit(scale);
        if misfit <= UNDIVIDED {
            return None;
        }
        let middle = |codes: &Codes| codes.reduced(Middle(WHOLE_IMAGE), codes.width.min(codes.height));
        let found = [true, false].map(|halved| match halved {
            true => Undivided {
                images: self.images.each_ref().map(|image| image.undivided(1.0)),
                shots: shots.clone(),
                halved,
            },
            false => Undivided {
                images: self.images.each_ref().map(|image| middle(&image.undivided(2.0))),
                shots: shots.each_ref().map(middle),
                halved,
            },
        });
        let judged = found.map(|found| (self.views(&found.images, &found.shots).misfit(1.0), found));
        let best = judged.into_iter().min_by(|one, other| one.0.total_cmp(&other.0));
        best.filter(|(left, _)| *left < MUCH_BETTER * misfit).map(|(_, found)| found)
    }

    fn views<'a>(&self, images: &'a [Codes; 6], shots: &'a [Codes; 6]) -> Views<'a> {
        let row = |frame: ShotFrame| self.lookup.row(frame.face);
        let v_origin = self.lookup.v_origin();
        Views {
            images,
            shots,
            screens: self
                .frames
                .map(|frame| Screen { orientation: on_screen(row(frame), frame.right, frame.up), v_origin }),
            expected: self.frames.map(|frame| row(frame).image),
        }
    }
}

/// What a shot may show.
fn read_shot(views: &Views, images: &ImageLevels, index: usize, scale: f64) -> Reading {
    let shot = views.shot(index, scale, SIDE);
    let candidates = candidates(images, views.expected[index], &shot, views.screens[index], SIDE);
    let possible = if variance(&shot) < FLAT {
        flat_placements(&candidates, images, &shot)
    } else if shows_nothing(&best(&candidates).fitted, &shot) {
        Vec::new()
    } else {
        possible(&candidates, &shot, SIDE)
    };
    let misfit = possible.is_empty().then(|| Misfit::of(&views.shots[index]));
    Reading { possible, misfit }
}

impl Grade {
    /// The camera's faults and the lookup's, summed up.
    pub fn verdict(&self) -> GradeVerdict {
        let camera = self.camera != CameraFault::NONE || self.field_of_view.is_some();
        let lookup = self.undivided || self.faces.iter().any(FaceGrade::is_wrong);
        let nothing = self.faces.iter().any(|face| face.misfit.is_some());
        match (camera, lookup, nothing) {
            (true, false, _) => GradeVerdict::Camera,
            (true, true, _) => GradeVerdict::CameraAndLookup,
            (false, true, _) => GradeVerdict::Lookup,
            (false, false, true) => GradeVerdict::OutOfRange,
            _ if self.faces.iter().any(FaceGrade::is_decided) => GradeVerdict::Right,
            _ => GradeVerdict::Undecided,
        }
    }
}

/// A large picture reduced, a small one as it is.
fn limited(codes: Codes) -> Codes {
    if codes.width.max(codes.height) <= LARGEST { codes } else { codes.reduced(Middle(1.0), LARGEST) }
}

/// True if the best explanation leaves most of a shot unexplained.
fn shows_nothing(fitted: &[f32], shot: &[f32]) -> bool {
    let coarse = |values: &[f32]| {
        let codes = Codes { width: SIDE, height: SIDE, values: values.to_vec() };
        codes.reduced(Middle(1.0), COARSE).values
    };
    let (fitted, shot) = (coarse(fitted), coarse(shot));
    let left = mean_square(&fitted, &shot);
    left > NEGLIGIBLE && left > UNEXPLAINED * variance(&shot)
}

/// What a shot of one colour may show: images of one colour, and anything where it is as bright as can be and may be cut
/// off.
fn flat_placements(candidates: &[Candidate], images: &ImageLevels, shot: &[f32]) -> Vec<Placement> {
    let white = shot.iter().all(|&value| value > WHITE);
    let flat = images.0.each_ref().map(|image| variance(image.values()) < FLAT);
    let shown = candidates.iter().map(|candidate| candidate.placement);
    shown.filter(|placement| white || flat[placement.image.index()]).collect()
}
