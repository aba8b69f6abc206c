//! The report of `skycube check`, as text and as JSON.
//!
//! The JSON has an entry for each map, and `totals`. An entry has these keys, in this order, or `{ map, error }`; numbers are
//! rounded to the digits that are stable:
//!
//! ```text
//! map, lookup
//! images:     [ { face, file, width, height, format } ]                       six, by name
//! verdict:    fits | broken | undecidable
//! seams:      [ { edge, step, detail, score, verdict } ]                      twelve, as they are now
//! fix:        { faces: [ { face, image, u, v, image_operation, decided } ],   six; u, v of those the lookup computes
//!               story, also: [ text ], changes, convention, margin, seams_after, equivalents }
//! handedness: { mirrored: [ face ] }
//! notes:      [ text ]
//! ```

use std::fmt;

use serde::Serialize;

use super::json::to_json;
use crate::envmap::Orientation;
use crate::error::Result;
use crate::validate::{Check, FaceFix, Seam, Verdict};

/// A check of a map, to be printed.
#[derive(Serialize)]
pub struct CheckReport<'a> {
    map: String,
    #[serde(flatten)]
    check: &'a Check,
}

impl<'a> CheckReport<'a> {
    /// The report on the map that the user calls `map`.
    pub fn new(map: String, check: &'a Check) -> Self {
        Self { map, check }
    }

    /// The report in one line: verdict, and what to do.
    pub fn line(&self) -> String {
        let Check { verdict, fix, .. } = self.check;
        let mut what = Vec::new();
        if *verdict == Verdict::Broken {
            what.extend(fix.story.sentences());
            let edited = fix.faces.iter().filter(|face| fix.story.edited.contains(&face.face));
            what.extend(edited.map(|face| self.change(face)));
        }
        what.extend(self.check.unrepaired().iter().map(ToString::to_string));
        let separator = if what.is_empty() { "" } else { ": " };
        format!("{}: {}{separator}{}", self.map, verdict.name(), what.join("; "))
    }

    fn changed(&self) -> impl Iterator<Item = &FaceFix> {
        self.check.fix.faces.iter().filter(|face| !face.is_unchanged(&self.check.lookup))
    }

    /// `posx u = 1-u`, `posz reads negz`.
    fn change(&self, fix: &FaceFix) -> String {
        let mut parts = Vec::new();
        if fix.image != self.check.lookup.row(fix.face).image {
            parts.push(format!("reads {}", fix.image.name()));
        }
        parts.extend(formulas(fix));
        format!("{} {}", fix.face.name(), parts.join(", "))
    }
}

/// A map as the user calls it, and its check.
pub type MapCheck = (String, Result<Check>);

/// The number of maps per verdict.
#[derive(Default, Serialize)]
pub(crate) struct Totals {
    pub fits: usize,
    pub broken: usize,
    pub undecidable: usize,
    pub failed: usize,
}

impl Totals {
    /// Counts the verdicts.
    pub fn of(checks: &[MapCheck]) -> Self {
        let mut totals = Self::default();
        for (_, checked) in checks {
            let count = match checked.as_ref().map(|check| check.verdict) {
                Ok(Verdict::Fits) => &mut totals.fits,
                Ok(Verdict::Broken) => &mut totals.broken,
                Ok(Verdict::Undecidable) => &mut totals.undecidable,
                Err(_) => &mut totals.failed,
            };
            *count += 1;
        }
        totals
    }
}

/// The report for machines, on one map or several.
pub fn check_json(checks: &[MapCheck]) -> String {
    #[derive(Serialize)]
    struct Json<'a> {
        maps: Vec<Entry<'a>>,
        totals: Totals,
    }
    #[derive(Serialize)]
    #[serde(untagged)]
    enum Entry<'a> {
        Checked(CheckReport<'a>),
        Failed { map: &'a str, error: String },
    }
    let maps = checks.iter().map(|(map, checked)| match checked {
        Ok(check) => Entry::Checked(CheckReport::new(map.clone(), check)),
        Err(error) => Entry::Failed { map, error: error.to_string() },
    });
    to_json("check", &Json { maps: maps.collect(), totals: Totals::of(checks) })
}

/// The statements that change u, v to u', v', after those that compute u and v.
fn statements(fix: &FaceFix) -> Vec<&'static str> {
    let Orientation { swaps, inverts_u, inverts_v } = fix.orientation;
    // After the swap u holds the old v, so the inversions read alike with and without it.
    let all = [(swaps, "swap(u, v);"), (inverts_u, "u = 1 - u;"), (inverts_v, "v = 1 - v;")];
    all.into_iter().filter(|(needed, _)| *needed).map(|(_, statement)| statement).collect()
}

/// The coordinates that differ from u and v, as formulas.
fn formulas(fix: &FaceFix) -> Vec<String> {
    let (u, v) = fix.orientation.formulas();
    let changed = [("u", u), ("v", v)].into_iter().filter(|(name, formula)| name != formula);
    changed.map(|(name, formula)| format!("{name}' = {formula}")).collect()
}

/// The rotations and mirrorings of a cube.
const TURNS_OF_A_CUBE: usize = 48;

/// What the columns of the seams are.
const LEGEND: &str = "  score = step / max(detail, 0.5): mean step across the seam over the mean step between texels \
    beside it, of 255
  verdict: not by the score, but by comparing orientations: broken if the best orientation continues the two borders decisively
  better elsewhere, or a face at the seam does not belong; undecidable if they go as well with most other borders";

impl fmt::Display for CheckReport<'_> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Check { verdict, fix, lookup_name, .. } = self.check;
        writeln!(formatter, "{}: {} under the lookup {lookup_name}", self.map, verdict.name())?;
        let sentences = fix.story.sentences();
        for sentence in &sentences {
            writeln!(formatter, "  {sentence}")?;
        }
        for other in &fix.also {
            writeln!(formatter, "  another story of the same length: {other}")?;
        }
        if !sentences.is_empty() {
            writeln!(formatter, "  face by face:")?;
        }
        for face in self.changed() {
            self.write_change(face, formatter)?;
        }
        writeln!(
            formatter,
            "\n  seam    step  detail  score  verdict{}",
            if fix.changes > 0 { "      after the fix" } else { "" }
        )?;
        for (before, after) in self.check.seams.iter().zip(&fix.seams_after) {
            let Seam { edge, step, detail, score, verdict } = before;
            write!(formatter, "  {}  {step:6.2}  {detail:6.2} {score:6.2}  {}", edge.name(), verdict.name())?;
            if fix.changes > 0 {
                let gap = 12 - verdict.name().len();
                write!(formatter, "{:gap$} {:6.2} {}", "", after.score, after.verdict.name())?;
            }
            writeln!(formatter)?;
        }
        writeln!(formatter, "{LEGEND}")?;
        writeln!(
            formatter,
            "\n  margin {:.1}: the next different orientation is worse by this number of standard errors\n  {}",
            fix.margin,
            self.equally_good()
        )?;
        for note in &self.check.notes {
            writeln!(formatter, "  note: {note}")?;
        }
        Ok(())
    }
}

impl CheckReport<'_> {
    /// How many fixes are as good as the one shown, and why.
    fn equally_good(&self) -> String {
        let Check { fix, lookup, outliers, .. } = self.check;
        if !outliers.is_empty() {
            return "equally good orientations: not counted, because a face does not belong here".to_owned();
        }
        if fix.equivalents == 1 {
            return "equally good orientations: 1, the one shown".to_owned();
        }
        let renamed = fix.faces.iter().any(|face| face.image != lookup.row(face.face).image);
        let whole = if renamed && fix.equivalents.is_multiple_of(TURNS_OF_A_CUBE) {
            "; once images change places, the whole cube has 48 rotations and mirrorings"
        } else {
            ""
        };
        format!(
            "equally good orientations: {}; the simplest one is shown, seams cannot tell them apart{whole}",
            fix.equivalents
        )
    }

    fn write_change(&self, fix: &FaceFix, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let check = self.check;
        let file = &check.images[fix.image.index()].file;
        let mut code = Vec::new();
        if fix.image != check.lookup.row(fix.face).image {
            code.push(format!("image = {};", fix.image.constant_name()));
        }
        code.extend(statements(fix).into_iter().map(str::to_owned));
        writeln!(formatter, "  {} ({file})", fix.face.name())?;
        writeln!(formatter, "    in the code: case {}: {}", fix.face.constant_name(), code.join(" "))?;
        let mut file_change = Vec::new();
        if fix.image != check.lookup.row(fix.face).image {
            // The file takes the name that the lookup reads for this face.
            file_change.push(format!("read {file} as {}", check.lookup.row(fix.face).image.name()));
        }
        if fix.orientation != Orientation::IDENTITY {
            file_change.push(fix.image_operation.name());
        }
        let doubt = if fix.decided { "" } else { " (undecided)" };
        writeln!(formatter, "    or the file: {}{doubt}", file_change.join(", "))
    }
}

/// Why the fix of a map changes nothing, as a sentence without its full stop: the map may fit, be undecidable, or have
/// faces that do not belong, which no lookup repairs.
pub fn nothing_to_fix(check: &Check) -> String {
    let outliers: Vec<&str> = check.outliers.iter().map(|outlier| outlier.face.name()).collect();
    match check.verdict {
        Verdict::Fits => "the map fits under this lookup: nothing to fix".to_owned(),
        _ if !check.has_equal_squares() => {
            "broken: the faces are not square or differ in size, which no lookup repairs".to_owned()
        }
        _ if !outliers.is_empty() => {
            format!("broken, and no lookup repairs it: the picture of {} does not belong here", outliers.join(", "))
        }
        Verdict::Undecidable => {
            "undecidable: the pixels cannot decide whether these faces fit; nothing is changed".to_owned()
        }
        Verdict::Broken => "broken, but no change is certain; nothing is changed".to_owned(),
    }
}
