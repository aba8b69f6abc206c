//! What was found on a map as a list: each finding has a kind that never changes its name, a level, and the images it is about.
//! JSON, SARIF, JUnit and annotations show this list; `skycube.toml` allows findings by their kinds.

use serde::Serialize;
use serde_json::{Value, json};

use super::findings::{Check, FaceFix};
use super::note::Note;
use super::outlier::Reason;
use super::verdict::Verdict;
use crate::envmap::Face;

/// Something that was found on a map.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Finding {
    /// One of [`KINDS`].
    pub kind: &'static str,
    /// How it counts.
    pub level: Level,
    /// What a person reads.
    pub sentence: String,
    /// The images it is about, in the order of [`Face::ALL`].
    pub images: Vec<Face>,
    /// Their files, in the same order.
    pub files: Vec<String>,
    /// The figures of this kind by their names.
    #[serde(flatten)]
    pub figures: Value,
}

/// How a finding counts for the exit code.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Level {
    /// A fault.
    Error,
    /// A fault if the user is strict.
    Warning,
    /// A remark.
    Note,
}

/// All kinds, and what each says of a map.
pub const KINDS: [(&str, &str); 20] = [
    ("order", "all six files follow another order or convention than the lookup"),
    ("exchanged", "files are in each other's place"),
    ("edited", "a file is turned or flipped"),
    ("outlier", "a picture does not belong to the map: a flat colour, a copy of another, another scene"),
    ("not_square", "pictures are not square"),
    ("sizes", "the pictures differ in size"),
    ("open", "seams stay open, and the pixels do not show how to close them"),
    ("torn", "the faces do not fit, and no change is certain"),
    ("undecidable", "the pixels cannot decide whether the faces fit"),
    ("doubtful", "faces would fit better otherwise, but not decisively"),
    ("undecided", "the pixels do not determine the orientation of faces"),
    ("rough", "seams are rough although the geometry fits"),
    ("exposure", "a picture is brighter or darker than all its neighbours"),
    ("identical", "pictures are the same along all their borders"),
    ("flat", "a picture is one flat colour along its borders"),
    ("framed", "a picture has a frame one texel wide"),
    ("alpha", "a picture has an alpha channel, which is ignored"),
    ("unnamed", "the names of the files do not identify the faces"),
    ("mirrored", "a right-handed world sees faces mirrored"),
    ("up", "what is said of the axis that points up"),
];

impl Check {
    /// Everything that was found, faults first. A broken map has at least one error.
    pub fn findings(&self) -> Vec<Finding> {
        let mut findings = self.repairs();
        findings.extend(self.notes.iter().map(|note| self.of_note(note)));
        let has_error = findings.iter().any(|finding| finding.level == Level::Error);
        match self.verdict {
            Verdict::Broken if !has_error => {
                let sentence = "the faces do not fit, but no change is certain".to_owned();
                findings.push(self.finding("torn", Level::Error, sentence, &Face::ALL, json!({})));
            }
            Verdict::Undecidable => {
                let sentence = "the pixels cannot decide whether these faces fit".to_owned();
                findings.push(self.finding("undecidable", Level::Warning, sentence, &Face::ALL, json!({})));
            }
            _ => {}
        }
        findings.sort_by_key(|finding| finding.level);
        findings
    }

    /// What happened to the files, and what to do about it.
    fn repairs(&self) -> Vec<Finding> {
        let story = &self.fix.story;
        let mut findings = Vec::new();
        if let Some(order) = story.order {
            let figures = json!({ "convention": order });
            findings.push(self.finding("order", Level::Error, order.to_string(), &Face::ALL, figures));
        }
        for ring in &story.exchanged {
            let files: Vec<&str> = ring.iter().map(|&image| self.file(image)).collect();
            let sentence = match files[..] {
                [one, other] => format!("exchange {one} and {other}"),
                _ => format!("exchange {} in a cycle: each takes the picture of the next", files.join(", ")),
            };
            findings.push(self.finding("exchanged", Level::Error, sentence, ring, json!({})));
        }
        let edited = self.fix.faces.iter().filter(|fix| story.edited.contains(&fix.face));
        findings.extend(edited.map(|fix| self.edited(fix)));
        findings
    }

    fn edited(&self, fix: &FaceFix) -> Finding {
        let (u, v) = fix.orientation.formulas();
        let sentence = format!("{}: {}", self.file(fix.image), fix.image_operation.name());
        let figures = json!({ "face": fix.face, "u": u, "v": v, "image_operation": fix.image_operation });
        self.finding("edited", Level::Error, sentence, &[fix.image], figures)
    }

    fn of_note(&self, note: &Note) -> Finding {
        let level = match note {
            note if note.is_beyond_repair() => Level::Error,
            Note::Open { .. } if self.verdict == Verdict::Broken => Level::Error,
            _ => Level::Note,
        };
        let shown = |faces: &[Face]| faces.iter().map(|face| self.fix.faces[face.index()].image).collect();
        let all = || Face::ALL.to_vec();
        let (kind, images, figures): (_, Vec<Face>, _) = match note {
            Note::Outlier { face, reason, .. } => ("outlier", shown(&[*face]), outlier(*face, *reason)),
            Note::Framed { images } => ("framed", images.clone(), json!({})),
            Note::Sizes { smallest, largest } => ("sizes", all(), json!({ "smallest": smallest, "largest": largest })),
            Note::NotSquare { images } => ("not_square", images.clone(), json!({})),
            Note::Alpha { images } => ("alpha", images.clone(), json!({})),
            Note::Exposure { image, codes } => ("exposure", vec![*image], json!({ "codes": rounded(*codes) })),
            Note::Identical { images } => ("identical", images.clone(), json!({})),
            Note::Flat { images } => ("flat", images.clone(), json!({})),
            Note::Undecided { faces } => ("undecided", shown(faces), json!({ "faces": faces })),
            Note::Doubtful { faces } => ("doubtful", shown(faces), json!({ "faces": faces })),
            Note::Rough { seams, step, .. } => ("rough", all(), json!({ "seams": seams, "step": rounded(*step) })),
            Note::Open { seams, step, .. } => ("open", all(), json!({ "seams": seams, "step": rounded(*step) })),
            Note::Unnamed { numbered } => ("unnamed", all(), json!({ "numbered": numbered })),
            Note::Mirrored { faces, after, .. } => {
                ("mirrored", shown(faces), json!({ "faces": faces, "after": after }))
            }
            Note::AssumedUp { up, .. } => ("up", all(), json!({ "up": up, "assumed": true })),
            Note::Sky { sky, up, there, .. } => {
                ("up", vec![*sky], json!({ "up": up, "assumed": false, "sky": sky, "there": there }))
            }
        };
        self.finding(kind, level, note.sentence(&self.file_names()), &images, figures)
    }

    fn finding(&self, kind: &'static str, level: Level, sentence: String, images: &[Face], figures: Value) -> Finding {
        let files = images.iter().map(|&image| self.file(image).to_owned()).collect();
        Finding { kind, level, sentence, images: images.to_vec(), files, figures }
    }

    fn file(&self, image: Face) -> &str {
        &self.images[image.index()].file
    }
}

fn outlier(face: Face, reason: Reason) -> Value {
    let (reason, copy_of) = match reason {
        Reason::Flat => ("flat", None),
        Reason::CopyOf(other) => ("copy", Some(other)),
        Reason::AnotherScene => ("another_scene", None),
    };
    json!({ "face": face, "reason": reason, "copy_of": copy_of })
}

/// To a tenth of a code: more digits may differ between machines.
fn rounded(codes: f64) -> f64 {
    crate::digits::rounded(codes, 1)
}
