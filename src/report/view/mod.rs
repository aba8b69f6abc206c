//! The page of `skycube view`: one HTML file to look around in, which loads nothing from elsewhere.
//!
//! The words are in the page itself and can be read without scripts. The scripts get the **table** that was checked and the
//! repaired one: they do the lookup with it, and hold none of their own.

mod pictures;

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use serde::Serialize;

use super::check::{Repair, code, notes, nothing_to_fix, repairs, statements};
use super::code::{CodeLanguage, lookup_code};
use super::html::{filled, text};
use crate::envmap::{CubeMap, Face, Handedness, Lookup, Orientation, SignedAxis, VOrigin};
use crate::error::Result;
use crate::validate::{Check, Seam};

/// What the page shows.
#[derive(Debug)]
pub struct ViewInput<'a> {
    /// As the user calls the map.
    pub name: &'a str,
    /// The map under the lookup that was checked.
    pub map: &'a CubeMap,
    /// What the validator says.
    pub check: &'a Check,
    /// The axis that points up.
    pub world_up: SignedAxis,
    /// The most bytes that the pictures may take in the page; they are reduced until they fit.
    pub limit: usize,
}

/// A table for the scripts: images as numbers in the order of [`Face::ALL`].
#[derive(Serialize)]
struct Table {
    v_origin: VOrigin,
    rows: Vec<Row>,
}

#[derive(Serialize)]
struct Row {
    image: usize,
    u: SignedAxis,
    v: SignedAxis,
}

impl From<&Lookup> for Table {
    fn from(lookup: &Lookup) -> Self {
        let rows = lookup.rows().iter().map(|row| Row { image: row.image.index(), u: row.u, v: row.v });
        Self { v_origin: lookup.v_origin(), rows: rows.collect() }
    }
}

#[derive(Serialize)]
struct Tables {
    before: Table,
    after: Table,
}

#[derive(Serialize)]
struct Data<'a> {
    world_up: SignedAxis,
    /// True if the lookup is for a left-handed world, or a right-handed one would see all six pictures mirrored.
    mirrored: bool,
    tables: Tables,
    files: [&'a str; 6],
    images: Vec<String>,
    seams: &'a [Seam],
    seams_after: &'a [Seam],
    changes: usize,
    /// What is to be said of each face.
    faces: [String; 6],
}

/// The whole page. An error says which picture cannot be read.
pub fn view_page(input: &ViewInput) -> Result<String> {
    let ViewInput { name, map, check, world_up, limit } = *input;
    let repaired = check.fix.lookup(map.lookup());
    let sources = pictures::embedded(map, limit)?;
    let data = Data {
        world_up,
        mirrored: map.lookup().handedness() == Handedness::Left || check.mirrored.len() == 6,
        tables: Tables { before: map.lookup().into(), after: (&repaired).into() },
        files: Face::ALL.map(|face| check.images[face.index()].file.as_str()),
        images: sources
            .iter()
            .map(|(kind, bytes)| format!("data:{kind};base64,{}", BASE64_STANDARD.encode(bytes)))
            .collect(),
        seams: &check.seams,
        seams_after: &check.fix.seams_after,
        changes: check.fix.changes,
        faces: face_repairs(check),
    };
    // Tags in the name of a file would end the element.
    let data = serde_json::to_string(&data).expect("a page is plain data").replace('<', "\\u003c");
    let verdict = check.verdict.name();
    let headline = format!("<strong>{verdict}</strong> under the lookup {}", text(&check.lookup_name));
    let code = if check.fix.changes > 0 { functions(&repaired, map.lookup()) } else { String::new() };
    let parts = [
        ("title", format!("{}: {verdict}", text(name))),
        ("name", text(name)),
        ("verdict", verdict.to_owned()),
        ("headline", headline),
        ("do_heading", if check.fix.changes > 0 { "What to do" } else { "What was found" }.to_owned()),
        ("repair", [list(&to_do(check)), code_lines(check), list(&notes(check, false))].concat()),
        ("seams", seams(check)),
        ("code", code),
        ("version", env!("CARGO_PKG_VERSION").to_owned()),
        ("style", include_str!("style.css").to_owned()),
        ("script", [include_str!("lookup.js"), include_str!("page.js")].concat()),
        ("data", data),
    ];
    Ok(filled(include_str!("page.html"), &parts))
}

/// What to do and why; or that nothing is to be done.
fn to_do(check: &Check) -> Vec<String> {
    let repairs = repairs(check);
    if repairs.is_empty() {
        return vec![nothing_to_fix(check)];
    }
    let told = repairs.into_iter().map(|Repair { what, why }| match why {
        Some(why) => format!("{what} ({why})"),
        None => what,
    });
    told.collect()
}

/// The sentence on each face, in the order of [`Face::ALL`].
fn face_repairs(check: &Check) -> [String; 6] {
    check.fix.faces.map(|fix| {
        let file = &check.images[fix.image.index()].file;
        if fix.is_unchanged(&check.lookup) {
            return format!("{} ({file}): nothing to change", fix.face.name());
        }
        let read = (fix.image != check.lookup.row(fix.face).image).then(|| format!("read as {}", fix.face.name()));
        let turned = (fix.orientation != Orientation::IDENTITY).then(|| fix.image_operation.name());
        let what: Vec<String> = read.into_iter().chain(turned).collect();
        let doubt = if fix.decided { "" } else { " (the pixels do not decide it)" };
        let code = statements(&fix, check);
        format!("{} ({file}): {}{doubt}; or in the code: {code}", fix.face.name(), what.join(", "))
    })
}

/// The same in the code of the lookup.
fn code_lines(check: &Check) -> String {
    let lines = code(check);
    if lines.is_empty() {
        return String::new();
    }
    format!("<p>Or in the code of the lookup:</p>\n<pre>{}</pre>\n", text(&lines.join("\n")))
}

fn list(lines: &[String]) -> String {
    if lines.is_empty() {
        return String::new();
    }
    let items: String = lines.iter().map(|line| format!("<li>{}</li>\n", text(line))).collect();
    format!("<ul>\n{items}</ul>")
}

fn seams(check: &Check) -> String {
    let repaired = check.fix.changes > 0;
    let cell = |seam: &Seam| {
        let verdict = seam.verdict.name();
        format!("<td>{:.2}</td><td class=\"word {verdict}\">{verdict}</td>", seam.score)
    };
    let row = |(before, after): (&Seam, &Seam)| {
        let after = if repaired { cell(after) } else { String::new() };
        format!("<tr><td>{}</td><td>{:.1}</td>{}{after}</tr>\n", before.edge.name(), before.step, cell(before))
    };
    let rows: String = check.seams.iter().zip(&check.fix.seams_after).map(row).collect();
    let after = if repaired { "<th>repaired</th><th class=\"word\">verdict</th>" } else { "" };
    format!(
        "<table>\n<tr><th>seam</th><th>step of 255</th><th>score</th><th class=\"word\">verdict</th>{after}</tr>\n{rows}</table>"
    )
}

/// The repaired lookup in every language, each to be copied.
fn functions(repaired: &Lookup, given: &Lookup) -> String {
    use CodeLanguage::{Cpp, Csharp, Glsl, Java, Python, Rust};
    let block = |language: CodeLanguage| {
        let code = lookup_code(repaired, given, language);
        let name = match language {
            Cpp => "C++",
            Glsl => "GLSL",
            Rust => "Rust",
            Java => "Java",
            Python => "Python",
            Csharp => "C#",
            CodeLanguage::Toml => "TOML",
        };
        format!(
            "<details><summary>{name}</summary><div><button class=\"copy\" hidden>copy</button><pre>{}</pre></div></details>\n",
            text(&code)
        )
    };
    let blocks: String = [Cpp, Glsl, Rust, Java, Python, Csharp].map(block).concat();
    format!("<section class=\"card\"><h2>The repaired lookup as code</h2>\n{blocks}</section>")
}
