//! The grade of six shots as JSON.

use serde::Serialize;

use crate::digits::rounded;
use crate::envmap::{Face, Orientation};
use crate::grade::{CameraFault, FaceGrade, Grade, GradeVerdict, Misfit};

/// The report for machines.
#[derive(Serialize)]
pub(super) struct Json<'a> {
    verdict: GradeVerdict,
    map: &'a str,
    lookup: &'a str,
    world_up: String,
    camera: JsonCamera,
    /// True if the code does not divide by the largest component.
    undivided: bool,
    faces: [JsonFace; 6],
    /// What the code contains, if that is another preset.
    preset: Option<JsonPreset>,
    /// The slips that explain the shots, the likeliest first.
    causes: &'a [String],
    notes: &'a [String],
}

#[derive(Serialize)]
struct JsonPreset {
    /// One, unless the pixels cannot tell several apart.
    names: Vec<String>,
    /// What the camera's fault is then: `none`, `mirrored`, ...
    camera: &'static str,
}

#[derive(Serialize)]
struct JsonCamera {
    right: bool,
    /// `none`, `mirrored`, `upside_down`, `turned` or `axes`.
    fault: &'static str,
    /// What was done to all six pictures: `none`, `flip left-right`, ...
    image_operation: String,
    /// Degrees.
    field_of_view: f64,
    /// What it takes for +x, +y and +z.
    axes: [String; 3],
}

#[derive(Serialize)]
struct JsonFace {
    face: Face,
    /// The shot that shows the face.
    shot: Face,
    /// Null if the shot fits no orientation of any image.
    image: Option<Face>,
    u: Option<&'static str>,
    v: Option<&'static str>,
    decided: bool,
    wrong: bool,
    /// How many placements the pixels leave.
    possible: usize,
    /// What the shot looks like if it fits no orientation.
    misfit: Option<Misfit>,
    /// What to compute from the code's own u and v, null if nothing is to be repaired.
    repair: Option<JsonRepair>,
}

#[derive(Serialize)]
struct JsonRepair {
    image: Face,
    u: &'static str,
    v: &'static str,
}

impl<'a> Json<'a> {
    pub fn new(
        grade: &Grade,
        [map, lookup]: [&'a str; 2],
        world_up: String,
        [causes, notes]: [&'a [String]; 2],
    ) -> Self {
        Self {
            verdict: grade.verdict(),
            map,
            lookup,
            world_up,
            camera: JsonCamera {
                right: grade.camera == CameraFault::NONE && grade.field_of_view.is_none(),
                fault: fault_name(grade.camera),
                image_operation: screen_operation(grade.camera.orientation).name(),
                // A tenth of a degree is more than can be known.
                field_of_view: grade.field_of_view.map_or(90.0, |angle| rounded(angle, 1)),
                axes: grade.camera.axes.map(|axis| axis.to_string()),
            },
            undivided: grade.undivided,
            faces: grade.faces.each_ref().map(face),
            preset: grade.preset.as_ref().map(|reading| JsonPreset {
                names: reading.presets.iter().map(|preset| preset.name()).collect(),
                camera: fault_name(reading.camera),
            }),
            causes,
            notes,
        }
    }
}

fn face(grade: &FaceGrade) -> JsonFace {
    let placement = grade.placement();
    let formulas = placement.map(|placement| placement.orientation.formulas());
    let repair = grade.repair().filter(|_| grade.is_wrong());
    JsonFace {
        face: grade.face,
        shot: grade.shot,
        image: placement.map(|placement| placement.image),
        u: formulas.map(|(u, _)| u),
        v: formulas.map(|(_, v)| v),
        decided: grade.is_decided(),
        wrong: grade.is_wrong(),
        possible: grade.possible.len(),
        misfit: grade.misfit,
        repair: repair.map(|orientation| {
            let (u, v) = orientation.formulas();
            JsonRepair { image: grade.expected, u, v }
        }),
    }
}

fn fault_name(camera: CameraFault) -> &'static str {
    let Orientation { swaps, inverts_u, inverts_v } = camera.orientation;
    match (swaps, inverts_u, inverts_v) {
        _ if camera.exchanges_axes() => "axes",
        (false, false, false) => "none",
        (false, false, true) => "upside_down",
        (false, true, false) | (true, false, false) | (true, true, true) => "mirrored",
        _ => "turned",
    }
}

/// What was done to a picture that shows at (s, t) what the right one has at `orientation(s, t)`, t growing upwards.
pub(super) fn screen_operation(orientation: Orientation) -> crate::envmap::ImageOperation {
    orientation.image_operation(crate::envmap::VOrigin::Bottom)
}
