//! A lookup as source code: one case per face in the form of the exercise's `get_texel`, ready to paste.

use std::fmt::Write;

use crate::choice::name_of;
use crate::envmap::{Face, FaceLookup, Lookup, SignedAxis};

/// A language in which a lookup is printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum CodeLanguage {
    Cpp,
    Glsl,
    Rust,
    /// The form that `--lookup FILE.toml` reads.
    Toml,
}

/// The corrected lookup; every line that differs from the given one says so and what it was.
pub fn lookup_code(corrected: &Lookup, given: &Lookup, language: CodeLanguage) -> String {
    let (head, tail, comment) = frame(language);
    let mut text = String::new();
    let origin = name_of(corrected.v_origin());
    if language == CodeLanguage::Toml {
        let _ = writeln!(text, "v_origin = \"{origin}\"");
    } else {
        let _ = writeln!(text, "{comment} v = 0 is the {origin} row of the image.");
    }
    text.push_str(head);
    for face in Face::ALL {
        let (now, before) = (corrected.row(face), given.row(face));
        text.push_str(&case(face, now, language));
        if now != before {
            let _ = write!(text, "  {comment} changed, was: {}", assignments(face, before, language));
        }
        text.push('\n');
    }
    text.push_str(tail);
    text
}

/// What stands before and after the cases, and how a comment begins.
fn frame(language: CodeLanguage) -> (&'static str, &'static str, &'static str) {
    match language {
        CodeLanguage::Cpp => (
            "// In: direction d. Out: image, u, v.\nswitch (face) {  // the face of the largest component of d\n",
            "}\n",
            "//",
        ),
        CodeLanguage::Glsl => {
            ("// In: vec3 d. Out: int image, float u, v.\nswitch (face) {  // of the largest component\n", "}\n", "//")
        }
        CodeLanguage::Rust => (
            "// In: direction d and its face, that of the largest component.\nlet (image, u, v) = match face {\n",
            "};\n",
            "//",
        ),
        CodeLanguage::Toml => ("", "", "#"),
    }
}

fn case(face: Face, row: FaceLookup, language: CodeLanguage) -> String {
    let assignments = assignments(face, row, language);
    match language {
        CodeLanguage::Cpp | CodeLanguage::Glsl => format!("    case {}: {assignments} break;", face.constant_name()),
        CodeLanguage::Rust => format!("    Face::{face:?} => {assignments},"),
        CodeLanguage::Toml => format!("{} = {assignments}", face.name()),
    }
}

/// What a face computes, in the words of the language.
fn assignments(face: Face, row: FaceLookup, language: CodeLanguage) -> String {
    let coordinate = |axis: SignedAxis| {
        let sign = if axis.negative { "-" } else { " " };
        let component = |axis: usize| ["d.x", "d.y", "d.z"][axis];
        let largest = match language {
            CodeLanguage::Rust => format!("{}.abs()", component(face.axis())),
            CodeLanguage::Cpp => format!("std::abs({})", component(face.axis())),
            _ => format!("abs({})", component(face.axis())),
        };
        format!(
            "0.5{} * ({sign}{} / {largest} + 1.0{})",
            suffix(language),
            component(usize::from(axis.axis)),
            suffix(language)
        )
    };
    match language {
        CodeLanguage::Toml => format!("{{ image = \"{}\", u = \"{}\", v = \"{}\" }}", row.image.name(), row.u, row.v),
        CodeLanguage::Rust => format!("(Face::{:?}, {}, {})", row.image, coordinate(row.u), coordinate(row.v)),
        _ => format!("image = {}; u = {}; v = {};", row.image.constant_name(), coordinate(row.u), coordinate(row.v)),
    }
}

fn suffix(language: CodeLanguage) -> &'static str {
    if language == CodeLanguage::Cpp { "f" } else { "" }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::envmap::Preset;

    #[test]
    fn code_marks_what_changed() {
        let (course, exercise) = (Preset::Course.lookup(), Preset::Exercise.lookup());
        insta::assert_snapshot!(lookup_code(&course, &exercise, CodeLanguage::Cpp));
        insta::assert_snapshot!(lookup_code(&course, &exercise, CodeLanguage::Glsl));
        insta::assert_snapshot!(lookup_code(&course, &exercise, CodeLanguage::Rust));
        insta::assert_snapshot!(lookup_code(&course, &exercise, CodeLanguage::Toml));
    }

    #[test]
    fn the_toml_form_is_read_back() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("lookup.toml");
        for preset in Preset::ALL {
            let lookup = preset.lookup();
            std::fs::write(&file, lookup_code(&lookup, &Preset::Opengl.lookup(), CodeLanguage::Toml)).unwrap();
            assert_eq!(crate::scene::read_lookup_file(&file).unwrap(), lookup);
        }
    }
}
