//! What `skycube grade` says: what each shot shows, whether lookup or camera is wrong, and the repair in the words of the
//! student's code.

use std::fmt;

use super::grade_json::{Json, screen_operation};
use crate::envmap::{Face, ImageOperation, Laying, SignedAxis, VOrigin};
use crate::validate::grade::{Alternative, CameraFault, FaceGrade, Grade, GradeVerdict, Misfit};

/// A grade and the names of what was graded.
#[derive(Debug, Clone)]
pub struct GradeReport<'a> {
    pub grade: &'a Grade,
    pub map: &'a str,
    pub lookup: &'a str,
    pub v_origin: VOrigin,
    pub world_up: SignedAxis,
}

impl GradeReport<'_> {
    /// The report for machines.
    pub fn to_json(&self) -> String {
        let notes = self.notes();
        let json = Json::new(self.grade, [self.map, self.lookup], self.world_up.to_string(), &notes);
        serde_json::to_string_pretty(&json).expect("a report is plain data")
    }

    /// The verdict as a sentence.
    fn verdict(&self) -> String {
        let wrong = self.grade.faces.iter().filter(|face| face.is_wrong()).count();
        let cases = if wrong == 1 { "1 face is".to_owned() } else { format!("{wrong} faces are") };
        let others = if wrong == 0 { String::new() } else { format!(", and {cases} to be repaired") };
        match self.grade.verdict() {
            GradeVerdict::Right => "right: every shot that the pixels decide shows what it should".to_owned(),
            GradeVerdict::Lookup if self.grade.undivided => {
                format!("the lookup is wrong: it does not divide by the largest component{others}")
            }
            GradeVerdict::CameraAndLookup if self.grade.undivided => {
                format!("the camera is wrong, and the lookup does not divide by the largest component{others}")
            }
            GradeVerdict::Lookup => format!("the lookup is wrong: {cases} to be repaired"),
            GradeVerdict::Camera if self.grade.faces.iter().any(|face| face.misfit.is_some()) => {
                "the camera is wrong, and not every shot shows an image of the map".to_owned()
            }
            GradeVerdict::Camera => "the camera is wrong, the lookup is right".to_owned(),
            GradeVerdict::CameraAndLookup => format!("the camera is wrong, and {cases} to be repaired in the lookup"),
            GradeVerdict::OutOfRange => self.out_of_range().to_owned(),
            GradeVerdict::Undecided => "undecided: the pixels tell nothing, choose a map with more detail".to_owned(),
        }
    }

    /// What shots come from that show no image of the map.
    fn out_of_range(&self) -> &'static str {
        let shown = |misfit: &Misfit| *misfit == Misfit::Unlike;
        if self.grade.faces.iter().filter_map(|face| face.misfit).all(|misfit| shown(&misfit)) {
            "a shot fits no laying of any image: the texture is read out of range, or the map is another one, or the camera \
             is rolled, elsewhere, or not 90° wide in this shot alone"
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

    /// What else the same pictures may come from, and what is left open.
    fn notes(&self) -> Vec<String> {
        let mut notes = Vec::new();
        if self.grade.undivided {
            notes.push(
                "each picture shows only the middle of its image, enlarged, as code does that takes the components of a unit \
                 direction without dividing them; images and layings are told as if it had divided"
                    .to_owned(),
            );
        }
        if let Some(alternative) = &self.grade.alternative {
            notes.push(other_explanation(alternative));
        }
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
            _ if face.misfit.is_some() => "fits no laying of any image".to_owned(),
            _ if face.is_wrong() => format!("should read {}", face.right().image.name()),
            _ if face.is_decided() => "right".to_owned(),
            _ => "undecided".to_owned(),
        };
        let Some(placement) = face.placement() else {
            return format!("{}   {:<7}  ?        ?            {mark}", face.shot.name(), face.face.signed_name());
        };
        let (u, v) = placement.laying.formulas();
        let reads = format!("({u}, {v})");
        let wrong = match (face.is_wrong(), placement.image == face.expected) {
            (true, true) => {
                // What their laying did to the image as it should be seen.
                let operation = placement.laying.image_operation(self.v_origin).name();
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
        writeln!(
            formatter,
            "shots of {} by your code, which should have the lookup {} (world up {})",
            self.map, self.lookup, self.world_up
        )?;
        writeln!(formatter, "\nshot   sees     image    reads")?;
        let mut faces: Vec<&FaceGrade> = self.grade.faces.iter().collect();
        faces.sort_by_key(|face| face.shot);
        for face in faces {
            writeln!(formatter, "{}", self.shot_line(face))?;
        }
        writeln!(formatter, "\n{}", self.verdict())?;
        for sentence in self.camera() {
            writeln!(formatter, "  {sentence}")?;
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

/// The repair of code that does not divide.
const DIVISION: &str = "tmp = 1 / |largest component|; u = (first * tmp + 1) / 2; v = (second * tmp + 1) / 2";

/// `case NEG_Y: u = 1 - u`, to stand after the code's own computation.
fn repair(face: &FaceGrade) -> String {
    let mut parts = Vec::new();
    if let Some(placement) = face.placement().filter(|placement| placement.image != face.expected) {
        parts.push(format!("image = {} instead of {}", face.expected.constant_name(), placement.image.constant_name()));
    }
    let laying = face.repair().unwrap_or(Laying::IDENTITY);
    if laying != Laying::IDENTITY {
        parts.push(coordinates(laying));
    }
    let open = if face.is_decided() { "" } else { "   (one of several that the pixels cannot tell apart)" };
    format!("case {}: {}{open}", face.face.constant_name(), parts.join("; "))
}

/// The new u and v as assignments.
fn coordinates(laying: Laying) -> String {
    let spaced = |formula: &str| formula.replace('-', " - ");
    let (u, v) = laying.formulas();
    match (laying.swaps, laying.inverts_u, laying.inverts_v) {
        (true, ..) => format!("(u, v) = ({}, {})", spaced(u), spaced(v)),
        (false, true, false) => "u = 1 - u".to_owned(),
        (false, false, true) => "v = 1 - v".to_owned(),
        _ => "u = 1 - u; v = 1 - v".to_owned(),
    }
}

/// What a wrong camera does.
fn describe(camera: CameraFault) -> String {
    if camera.exchanges_axes() {
        let [x, y, z] = camera.axes;
        let laid = match camera.laying {
            Laying::IDENTITY => String::new(),
            laying => format!(", and every picture is laid otherwise ({})", screen_operation(laying).name()),
        };
        return format!(
            "the axes are mixed up: your camera looks along {x} for +x, {y} for +y, {z} for +z{laid}; or the shots are \
             named after other axes"
        );
    }
    match screen_operation(camera.laying) {
        ImageOperation::FlipLeftRight => {
            "all six are mirrored left-right: right = forward x up, not up x forward, or columns are counted from the \
             right"
                .to_owned()
        }
        ImageOperation::FlipTopBottom => {
            "all six are upside down, mirrored top-bottom: rows are counted from the bottom, or up points down".to_owned()
        }
        ImageOperation::Turn180 => {
            "all six are turned by 180°: both right and up point the wrong way, or the picture plane lies behind the eye"
                .to_owned()
        }
        operation => format!(
            "all six are laid otherwise ({}): rows and columns, or right and up, are exchanged",
            operation.name()
        ),
    }
}

fn names(faces: &[Face]) -> String {
    faces.iter().map(|face| face.name()).collect::<Vec<_>>().join(", ")
}

fn other_explanation(alternative: &Alternative) -> String {
    match alternative {
        Alternative::Lookup(faces) => {
            let repairs: Vec<String> = faces.iter().filter(|face| face.is_wrong()).map(repair).collect();
            format!("a right camera and a wrong lookup would make the same pictures: {}", repairs.join(", "))
        }
        Alternative::Camera(camera) => {
            format!("a right lookup and a wrong camera would make the same pictures: {}", describe(*camera))
        }
        Alternative::Rolled(shots) => format!(
            "a right lookup would make the same pictures if the up vector of the camera were another one in {}: compare \
             it with what `skycube shots` prints",
            names(shots)
        ),
        Alternative::Exchanged(pairs) => {
            let pairs: Vec<String> = pairs
                .iter()
                .map(|(shot, other)| format!("{} is the shot along {}", shot.name(), other.signed_name()))
                .collect();
            format!("a right lookup would make the same pictures if the files were named wrongly: {}", pairs.join(", "))
        }
    }
}

/// What the pixels leave open.
fn undecided(face: &FaceGrade) -> String {
    let mut images: Vec<Face> = face.possible.iter().map(|placement| placement.image).collect();
    images.sort();
    images.dedup();
    let layings = face.possible.len();
    let what = match images[..] {
        [image] => format!("image {} in {layings} ways", image.name()),
        _ => format!("images {} in {layings} ways", names(&images)),
    };
    let right = if face.is_wrong() { "" } else { ", the right one among them" };
    format!("face {} is undecided: the pixels fit {what}{right}", face.face.signed_name())
}

fn out_of_range(misfit: Misfit) -> &'static str {
    match misfit {
        Misfit::Black => "it is black: the face is not read at all, or outside its texture",
        Misfit::PartlyBlack => "a part of it is black: u or v leave the range from 0 to 1 there",
        Misfit::OneColour => "it is of one colour: u and v do not change, or are clamped everywhere",
        Misfit::Smeared => {
            "it is smeared into streaks: u or v leave the range from 0 to 1 and are clamped (is the division by the \
             largest component, or the step from -1..1 to 0..1, missing?)"
        }
        Misfit::Repeated => {
            "it repeats itself: u or v run from -1 to 1 and are wrapped (is the step from -1..1 to 0..1 missing?)"
        }
        Misfit::Unlike => "it is like no image of this map: is it another map, another place, or is the camera rolled?",
    }
}
