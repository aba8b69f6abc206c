//! The report of `skycube grade`: the image in each shot, the fault of lookup or camera, and the repair in terms of the
//! student's code.

use std::fmt;
use std::path::Path;

use serde::ser::{Serialize, SerializeStruct, Serializer};

use super::super::formats::{Examined, ReportedFinding};
use super::super::json::to_json;
use super::sentences::{
    DIVISION, cause, describe, faces, other_explanation, other_up, out_of_range, preset, repair, undecided,
};
use crate::digits::rounded;
use crate::envmap::{ImageOperation, Lookup, SignedAxis, World};
use crate::grade::{CameraFault, FaceGrade, Grade, GradeVerdict, Misfit, ShotFrame, other_ups};
use crate::render::AxisShot;

/// A grade and the names of what was graded.
#[derive(Debug, Clone)]
pub struct GradeReport<'a> {
    /// What was found.
    pub grade: &'a Grade,
    /// The map, as the user calls it.
    pub map: &'a str,
    /// The lookup that the code should have: a preset or a file.
    pub lookup: &'a str,
    /// False if the lookup was not named by the user.
    pub lookup_given: bool,
    /// The table of that lookup.
    pub table: Lookup,
    /// The axis that points up in the student's world.
    pub world_up: SignedAxis,
}

/// The report for machines.
impl Serialize for GradeReport<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Grade { camera, field_of_view, undivided, faces, preset, .. } = self.grade;
        let camera = JsonCamera {
            right: *camera == CameraFault::NONE && field_of_view.is_none(),
            fault: *camera,
            image_operation: camera.image_operation(),
            // A tenth of a degree is more than can be known.
            field_of_view: field_of_view.map_or(90.0, |angle| rounded(angle, 1)),
            axes: camera.axes,
        };
        let mut keys = serializer.serialize_struct("GradeReport", 10)?;
        keys.serialize_field("verdict", &self.grade.verdict())?;
        keys.serialize_field("map", self.map)?;
        keys.serialize_field("lookup", self.lookup)?;
        keys.serialize_field("world_up", &self.world_up)?;
        keys.serialize_field("camera", &camera)?;
        // True if the code does not divide by the largest component.
        keys.serialize_field("undivided", undivided)?;
        keys.serialize_field("faces", faces)?;
        // What the code contains, if that is another preset.
        keys.serialize_field("preset", preset)?;
        // The slips that explain the shots, the likeliest first.
        keys.serialize_field("causes", &self.causes())?;
        keys.serialize_field("notes", &self.notes())?;
        keys.end()
    }
}

#[derive(serde::Serialize)]
struct JsonCamera {
    right: bool,
    /// `none`, `mirrored`, `upside_down`, `turned` or `axes`.
    fault: CameraFault,
    /// What was done to all six pictures: `none`, `flip left-right`, ...
    image_operation: ImageOperation,
    /// Degrees.
    field_of_view: f64,
    /// What it takes for +x, +y and +z.
    axes: [SignedAxis; 3],
}

impl GradeReport<'_> {
    fn causes(&self) -> Vec<String> {
        let causes = self.grade.causes(&self.table, self.world_up);
        causes.into_iter().map(|one| cause(one, self.table.v_origin())).collect()
    }

    /// The report for machines.
    pub fn to_json(&self) -> String {
        to_json("grade", self)
    }

    /// What was found, for formats that list findings: the verdict, the camera, and each case that needs repair. `shots` is the
    /// folder of the shots.
    pub(crate) fn examined(&self, shots: &Path) -> Examined {
        let verdict = self.grade.verdict();
        let reported = |kind, sentence| ReportedFinding::error(kind, sentence, shots);
        let name_of_verdict = match verdict {
            GradeVerdict::Right => "right",
            GradeVerdict::Lookup => "lookup",
            GradeVerdict::Camera => "camera",
            GradeVerdict::CameraAndLookup => "camera_and_lookup",
            GradeVerdict::OutOfRange => "out_of_range",
            GradeVerdict::Undecided => "undecided",
        };
        let mut findings = Vec::new();
        if !matches!(verdict, GradeVerdict::Right | GradeVerdict::Undecided) {
            findings.push(reported(name_of_verdict, self.verdict()));
            findings.extend(self.camera().into_iter().map(|sentence| reported("camera", sentence)));
            if self.grade.undivided {
                findings.push(reported("division", DIVISION.to_owned()));
            }
            findings.extend(
                self.grade.faces.iter().filter(|face| face.is_wrong()).map(|face| reported("case", repair(face))),
            );
        }
        Examined { name: shots.display().to_string(), verdict: name_of_verdict, findings }
    }

    /// The verdict as a sentence.
    pub fn verdict(&self) -> String {
        let wrong = self.grade.faces.iter().filter(|face| face.is_wrong()).count();
        let cases = format!("{} {}", faces(wrong), if wrong == 1 { "needs" } else { "need" });
        let others = if wrong == 0 { String::new() } else { format!(", and {cases} repair") };
        match self.grade.verdict() {
            GradeVerdict::Right => "right: every shot that the pixels decide shows the right image".to_owned(),
            GradeVerdict::Lookup if self.grade.undivided => {
                format!("the lookup is wrong: it does not divide by the largest component{others}")
            }
            GradeVerdict::CameraAndLookup if self.grade.undivided => {
                format!("the camera is wrong, and the lookup does not divide by the largest component{others}")
            }
            GradeVerdict::Lookup => format!("the lookup is wrong: {cases} repair"),
            GradeVerdict::Camera if self.grade.faces.iter().any(|face| face.misfit.is_some()) => {
                "the camera is wrong, and not every shot shows an image of the map".to_owned()
            }
            GradeVerdict::Camera if self.contains_preset() => {
                "the camera is wrong and the lookup right, or the camera right and the lookup another preset".to_owned()
            }
            GradeVerdict::Camera if !self.causes().is_empty() => {
                "the lookup is wrong, or the camera is: both explain these shots".to_owned()
            }
            GradeVerdict::Camera => "the camera is wrong, the lookup is right".to_owned(),
            GradeVerdict::CameraAndLookup => format!("the camera is wrong, and {cases} repair in the lookup"),
            GradeVerdict::OutOfRange => self.out_of_range().to_owned(),
            GradeVerdict::Undecided => "undecided: the pixels show too little; use a map with more detail".to_owned(),
        }
    }

    /// True if the code contains another preset, if the camera is right.
    fn contains_preset(&self) -> bool {
        self.grade.preset.as_ref().is_some_and(|reading| reading.camera == CameraFault::NONE)
    }

    /// What shots come from that show no image of the map.
    fn out_of_range(&self) -> &'static str {
        if self.grade.faces.iter().filter_map(|face| face.misfit).all(|misfit| misfit == Misfit::Unlike) {
            "a shot fits no orientation of any image: the texture is read out of range, or the map is another one, or \
             the camera is rolled, elsewhere, or not 90° wide in this shot alone"
        } else {
            "a shot shows no image of the map: the texture is read out of range"
        }
    }

    /// What is wrong with the camera.
    fn camera(&self) -> Vec<String> {
        let Grade { camera, field_of_view, .. } = self.grade;
        let mut sentences = Vec::new();
        if let Some(angle) = field_of_view {
            sentences.push(format!("the camera sees {angle:.0}° where it should see 90°"));
        }
        if *camera != CameraFault::NONE {
            sentences.push(describe(*camera));
        }
        sentences
    }

    /// The world that the lookup is for.
    fn world(&self) -> World {
        World { up: self.world_up, handedness: self.table.handedness() }
    }

    /// The up vectors that were assumed where none is plain, and what would be wrong with others.
    fn ups(&self) -> Vec<String> {
        let shots = AxisShot::all(self.world()).into_iter().filter(|shot| shot.up.axis != self.world_up.axis);
        let sentence = |shot: AxisShot| {
            let AxisShot { direction, up, .. } = shot;
            let frame = ShotFrame { face: direction, right: shot.right(), up };
            other_up(direction, up, &other_ups(&self.table, frame))
        };
        shots.map(sentence).collect()
    }

    /// What else the same pictures may come from, and what is left open.
    fn notes(&self) -> Vec<String> {
        let mut notes = Vec::new();
        let vertical = |face: &FaceGrade| face.shot.axis() == usize::from(self.world_up.axis);
        if self.grade.faces.iter().all(|face| vertical(face) || !face.is_wrong()) {
            notes.extend(self.ups());
        }
        if self.grade.undivided {
            notes.push(
                "each picture shows only the middle of its image, enlarged: the sign of code that uses the components \
                 of a unit direction without dividing them; images and orientations are told as if it had divided"
                    .to_owned(),
            );
        }
        notes.extend(
            self.grade.alternatives.iter().map(|alternative| other_explanation(alternative, &self.grade.faces)),
        );
        for face in &self.grade.faces {
            if face.possible.len() > 1 {
                notes.push(undecided(face));
            }
            if let Some(misfit) = face.misfit {
                notes.push(format!("shot {}: {}", face.shot.name(), out_of_range(misfit)));
            }
        }
        notes
    }

    /// `posx   image negx, flipped left-right`.
    fn shot_line(&self, face: &FaceGrade) -> String {
        let mark = match face {
            _ if face.misfit.is_some() => "fits no orientation of any image".to_owned(),
            _ if face.is_wrong() => format!("should read {}", face.right().image.name()),
            _ if face.is_decided() => "right".to_owned(),
            _ => "undecided".to_owned(),
        };
        let Some(placement) = face.placement() else {
            return format!("{}   {:<7}  ?        ?            {mark}", face.shot.name(), face.face.signed_name());
        };
        let (u, v) = placement.orientation.formulas();
        let reads = format!("({u}, {v})");
        let wrong = match (face.is_wrong(), placement.image == face.expected) {
            (true, true) => {
                // What their orientation did to the image as it should be seen.
                let operation = placement.orientation.image_operation(self.table.v_origin()).name();
                format!("wrong: {operation}{}", if face.is_decided() { "" } else { " (or another of its ties)" })
            }
            _ => mark,
        };
        let (shot, name) = (face.shot.name(), face.face.signed_name());
        format!("{shot}   {name:<7}  {:<7}  {reads:<11}  {wrong}", placement.image.name())
    }
}

impl fmt::Display for GradeReport<'_> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let because = if self.lookup_given { "" } else { ", the default because --lookup was not given" };
        writeln!(
            formatter,
            "shots of {} by your code, which should have the lookup {} (world up {}){because}",
            self.map, self.lookup, self.world_up
        )?;
        let camera = |shot: AxisShot| format!("{} up {}", shot.direction.name(), shot.up);
        let cameras = AxisShot::all(self.world()).map(camera).join(", ");
        let right = self.world().handedness.right();
        writeln!(formatter, "cameras: at the origin, 90° wide and high: {cameras}; right = {right}")?;
        writeln!(formatter, "\nshot   sees     image    reads")?;
        let mut faces: Vec<&FaceGrade> = self.grade.faces.iter().collect();
        faces.sort_by_key(|face| face.shot);
        for face in faces {
            writeln!(formatter, "{}", self.shot_line(face))?;
        }
        writeln!(formatter, "\n{}", self.verdict())?;
        let causes = self.causes();
        for cause in &causes {
            writeln!(formatter, "  likely cause: {cause}")?;
        }
        let or = if causes.is_empty() { "" } else { "or else: " };
        for sentence in self.camera() {
            writeln!(formatter, "  {or}{sentence}")?;
        }
        if let Some(reading) = &self.grade.preset {
            writeln!(formatter, "  {}", preset(reading, self.grade.camera, self.world_up))?;
        }
        if self.grade.undivided {
            writeln!(formatter, "    all cases: {DIVISION}")?;
        }
        for face in self.grade.faces.iter().filter(|face| face.is_wrong()) {
            writeln!(formatter, "    {}", repair(face))?;
        }
        for note in self.notes() {
            writeln!(formatter, "note: {note}")?;
        }
        Ok(())
    }
}
