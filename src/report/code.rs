//! A lookup as source code: the exercise's `get_texel` with one case per face, ready to paste.

use std::fmt::Write;

use crate::choice::name_of;
use crate::envmap::{Face, FaceLookup, Lookup, SignedAxis};

/// A language in which a lookup is printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum CodeLanguage {
    Cpp,
    Glsl,
    Rust,
    Java,
    Python,
    Csharp,
    /// The form that `--lookup FILE.toml` reads.
    Toml,
}

/// The corrected lookup; every line that differs from the given one says so and what it was.
pub fn lookup_code(corrected: &Lookup, given: &Lookup, language: CodeLanguage) -> String {
    let origin = name_of(corrected.v_origin());
    let rows = Face::ALL.map(|face| (face, corrected.row(face), given.row(face)));
    if language == CodeLanguage::Toml {
        return format!("v_origin = \"{origin}\"\n{}", rows.map(toml_row).concat());
    }
    let Form { comment, head, tail, .. } = form(language);
    format!(
        "{comment} v = 0 is the {origin} row of the image.\n{head}{}{tail}",
        rows.map(|row| case(language, row)).concat()
    )
}

fn toml_row((face, now, before): (Face, FaceLookup, FaceLookup)) -> String {
    let table =
        |row: FaceLookup| format!("{{ image = \"{}\", u = \"{}\", v = \"{}\" }}", row.image.name(), row.u, row.v);
    let was = if now == before { String::new() } else { format!("  # was: {}", table(before)) };
    format!("{} = {}{was}\n", face.name(), table(now))
}

/// How a language writes the function.
struct Form {
    comment: &'static str,
    /// Up to the first case.
    head: &'static str,
    /// What begins and ends a case; `#` stands for the face.
    case: [&'static str; 2],
    /// What ends a statement, and a number.
    end: &'static str,
    number: &'static str,
    tail: &'static str,
}

fn form(language: CodeLanguage) -> Form {
    let cpp = Form {
        comment: "//",
        head: CPP,
        case: ["        case #:", "            break;\n"],
        end: ";",
        number: "f",
        tail: "    }\n}\n",
    };
    match language {
        CodeLanguage::Cpp => cpp,
        CodeLanguage::Glsl => Form { head: GLSL, number: "", ..cpp },
        CodeLanguage::Rust => {
            let tail = "    }\n    (image, u, v)\n}\n";
            Form { head: RUST, case: ["        # => {", "        }\n"], number: "", tail, ..cpp }
        }
        CodeLanguage::Java => Form { head: JAVA, tail: "    }\n    return new Texel(image, u, v);\n}\n", ..cpp },
        CodeLanguage::Python => Form {
            comment: "#",
            head: PYTHON,
            case: ["    if face == #:", ""],
            end: "",
            number: "",
            tail: "    return image, u, v\n",
        },
        CodeLanguage::Csharp => {
            let tail = "        default: throw new System.ArgumentException();\n    }\n    return (image, u, v);\n}\n";
            Form { head: CSHARP, tail, ..cpp }
        }
        CodeLanguage::Toml => unreachable!("a table, not a function"),
    }
}

/// One face: three statements, and what they were where they changed.
fn case(language: CodeLanguage, (face, now, before): (Face, FaceLookup, FaceLookup)) -> String {
    let Form { comment, case: [start, tail], end, number, .. } = form(language);
    let name = |face: Face| match language {
        CodeLanguage::Rust => format!("Face::{face:?}"),
        _ => face.constant_name().to_owned(),
    };
    let coordinate = |axis: SignedAxis| {
        let sign = if axis.negative { "-" } else { "" };
        format!("0.5{number} * ({sign}{} / m + 1.0{number})", ["x", "y", "z"][usize::from(axis.axis)])
    };
    let statements = |row: FaceLookup| [("image", name(row.image)), ("u", coordinate(row.u)), ("v", coordinate(row.v))];
    let mut text = format!("{}\n", start.replace('#', &name(face)));
    let indent = if language == CodeLanguage::Python { "        " } else { "            " };
    for ((variable, now), (_, before)) in statements(now).into_iter().zip(statements(before)) {
        let was = if now == before { String::new() } else { format!("  {comment} changed, was: {before}") };
        let _ = writeln!(text, "{indent}{variable} = {now}{end}{was}");
    }
    text + tail
}

const CPP: &str = "\
// In: a direction d. Out: the image to read, and u, v in it from 0 to 1.
void get_texel(const Vec3& d, int& image, float& u, float& v) {
    const float x = d.x, y = d.y, z = d.z;
    const float m = std::max({std::abs(x), std::abs(y), std::abs(z)});
    const int face = m == std::abs(x)   ? (x > 0 ? POS_X : NEG_X)
                     : m == std::abs(y) ? (y > 0 ? POS_Y : NEG_Y)
                                        : (z > 0 ? POS_Z : NEG_Z);
    switch (face) {
";

const GLSL: &str = "\
// In: a direction d. Out: the image to read, and u, v in it from 0 to 1.
void get_texel(in vec3 d, out int image, out float u, out float v) {
    float x = d.x, y = d.y, z = d.z;
    float m = max(max(abs(x), abs(y)), abs(z));
    int face = m == abs(x)   ? (x > 0.0 ? POS_X : NEG_X)
               : m == abs(y) ? (y > 0.0 ? POS_Y : NEG_Y)
                             : (z > 0.0 ? POS_Z : NEG_Z);
    switch (face) {
";

const RUST: &str = "\
// In: a direction d. Out: the image to read, and u, v in it from 0 to 1.
fn get_texel(d: Vec3) -> (Face, f32, f32) {
    let (x, y, z) = (d.x, d.y, d.z);
    let m = x.abs().max(y.abs()).max(z.abs());
    let face = match m {
        _ if m == x.abs() => if x > 0.0 { Face::PosX } else { Face::NegX },
        _ if m == y.abs() => if y > 0.0 { Face::PosY } else { Face::NegY },
        _ => if z > 0.0 { Face::PosZ } else { Face::NegZ },
    };
    let (image, u, v);
    match face {
";

const JAVA: &str = "\
// In: a direction d. Out: the image to read, and u, v in it from 0 to 1.
static Texel getTexel(Vec3 d) {
    final float x = d.x, y = d.y, z = d.z;
    final float m = Math.max(Math.max(Math.abs(x), Math.abs(y)), Math.abs(z));
    final int face = m == Math.abs(x) ? (x > 0 ? POS_X : NEG_X)
            : m == Math.abs(y) ? (y > 0 ? POS_Y : NEG_Y)
            : (z > 0 ? POS_Z : NEG_Z);
    int image = 0;
    float u = 0, v = 0;
    switch (face) {
";

const PYTHON: &str = "\
# In: a direction d of x, y, z. Out: the image to read, and u, v in it from 0 to 1.
def get_texel(d):
    x, y, z = d
    m = max(abs(x), abs(y), abs(z))
    if m == abs(x):
        face = POS_X if x > 0 else NEG_X
    elif m == abs(y):
        face = POS_Y if y > 0 else NEG_Y
    else:
        face = POS_Z if z > 0 else NEG_Z
";

const CSHARP: &str = "\
// In: a direction d. Out: the image to read, and u, v in it from 0 to 1.
static (Face image, float u, float v) GetTexel(Vector3 d) {
    float x = d.x, y = d.y, z = d.z;
    float m = Math.Max(Math.Max(Math.Abs(x), Math.Abs(y)), Math.Abs(z));
    Face face = m == Math.Abs(x) ? (x > 0 ? POS_X : NEG_X)
        : m == Math.Abs(y) ? (y > 0 ? POS_Y : NEG_Y)
        : (z > 0 ? POS_Z : NEG_Z);
    Face image;
    float u, v;
    switch (face) {
";

#[cfg(test)]
mod tests {
    use clap::ValueEnum;

    use super::*;
    use crate::envmap::Preset;

    #[test]
    fn code_marks_what_changed() {
        let (course, exercise) = (Preset::Course.lookup(), Preset::Exercise.lookup());
        for language in CodeLanguage::value_variants() {
            let code = lookup_code(&course, &exercise, *language);
            assert!(code.lines().all(|line| line.chars().count() < 100), "{code}");
            insta::assert_snapshot!(format!("code_{language:?}"), code);
        }
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
