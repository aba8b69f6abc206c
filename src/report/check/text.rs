//! The report of `skycube check` as text: what to do first, then the code, the verdict and its reasons. The seams and what
//! changes nothing stand behind `--verbose`.

use std::fmt;

use super::repair::{code, repairs, retold};
use super::{CheckReport, MapCheck, Totals};
use crate::envmap::Face;
use crate::report::page::{Column, Look, Meaning, Page, Span, Table};
use crate::validate::{Check, Note, Seam, Verdict};

/// The rotations and mirrorings of a cube.
const TURNS_OF_A_CUBE: usize = 48;

/// What the columns of the seams are.
const LEGEND: [&str; 2] = [
    "score = step / max(detail, 0.5): mean step across the seam over the mean step between texels beside it, of 255",
    "verdict: not by the score, but by comparing orientations: broken if the best orientation continues the two borders \
     decisively better elsewhere, or a face at the seam does not belong; undecidable if they go as well with most other borders",
];

impl CheckReport<'_> {
    /// The report on one map; `verbose` with every seam and note.
    pub fn page(&self, verbose: bool) -> Page {
        let mut page = Page::default();
        self.write_repairs(&mut page);
        self.write_verdict(&mut page, verbose);
        if verbose {
            page.gap();
            page.table(self.seams());
            LEGEND.iter().for_each(|line| page.say(2, *line));
            page.gap();
            page.say(0, self.margin());
            page.say(0, self.equally_good());
        }
        page
    }

    /// What to do with the files, or in the code instead.
    fn write_repairs(&self, page: &mut Page) {
        let repairs = repairs(self.check);
        for repair in &repairs {
            page.add(0, [(Meaning::Action, repair.what.clone())]);
        }
        for other in &self.check.fix.also {
            page.say(0, format!("or, as likely: {}", retold(other, self.check)));
        }
        let code = code(self.check);
        if !code.is_empty() {
            page.gap();
            page.say(0, "or in the code of the lookup:");
            code.into_iter().for_each(|line| page.add(2, [(Meaning::Code, line)]));
        }
        if !repairs.is_empty() {
            page.gap();
        }
        let reasons = repairs.into_iter().filter_map(|repair| repair.why);
        reasons.for_each(|why| page.say(0, format!("why: {why}")));
    }

    fn write_verdict(&self, page: &mut Page, verbose: bool) {
        let Check { verdict, fix, lookup_name, seams, .. } = self.check;
        page.add(
            0,
            [plain(format!("{}: ", self.map)), judged(*verdict), plain(format!(" under the lookup {lookup_name}"))],
        );
        let after =
            if fix.changes > 0 { format!("; after the repair: {}", counted(&fix.seams_after)) } else { String::new() };
        page.say(0, format!("seams: {}{after}", counted(seams)));
        notes(self.check, verbose).iter().for_each(|note| page.say(0, format!("note: {note}")));
        if fix.changes > 0 {
            let command = |text: &str| (Meaning::Code, text.to_owned());
            page.add(
                0,
                [
                    command("skycube fix MAP -o FOLDER"),
                    plain(" writes the repaired files, "),
                    command("--code cpp"),
                    plain(" instead of -o prints the repaired lookup"),
                ],
            );
        }
    }

    /// The twelve seams, before and after the repair.
    fn seams(&self) -> Table {
        let fix = &self.check.fix;
        let column = |heading, to_the_right, weight| Column { heading, to_the_right, weight };
        let mut columns = vec![
            column("seam", false, 4),
            column("step", true, 3),
            column("detail", true, 1),
            column("score", true, 2),
            column("verdict", false, 4),
        ];
        if fix.changes > 0 {
            columns.extend([column("score after", true, 2), column("after the repair", false, 3)]);
        }
        let row = |(before, after): (&Seam, &Seam)| {
            let Seam { edge, step, detail, score, verdict } = before;
            let mut row = vec![plain(edge.name()), figure(*step), figure(*detail), figure(*score), judged(*verdict)];
            if fix.changes > 0 {
                row.extend([figure(after.score), judged(after.verdict)]);
            }
            row
        };
        Table { indent: 2, columns, rows: self.check.seams.iter().zip(&fix.seams_after).map(row).collect() }
    }

    fn margin(&self) -> String {
        let margin = self.check.fix.margin;
        format!("margin {margin:.1}: the next different orientation is worse by this number of standard errors")
    }

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
}

/// The short report, without colours.
impl fmt::Display for CheckReport<'_> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.page(false).shown(Look::default()))
    }
}

/// One of several maps in one line: verdict, and what to do.
pub fn map_line((name, checked): &MapCheck) -> Page {
    let mut page = Page::default();
    match checked {
        Ok(check) => {
            let what: Vec<String> = repairs(check).into_iter().map(|repair| repair.what).collect();
            let what = if what.is_empty() { String::new() } else { format!(": {}", what.join("; ")) };
            page.add(0, [plain(format!("{name}: ")), judged(check.verdict), plain(what)]);
        }
        Err(error) => {
            let problem = error.problem().lines().next().unwrap_or_default();
            page.say(0, format!("{name}: cannot be checked: {problem}"));
        }
    }
    page
}

/// How many maps of each verdict.
pub fn totals_line(totals: &Totals) -> Page {
    let Totals { fits, broken, undecidable, failed } = totals;
    let coloured = |count: usize, meaning: Meaning| if count > 0 { meaning } else { Meaning::Plain };
    let mut page = Page::default();
    page.add(
        0,
        [
            plain(format!("{}: ", counted_maps(fits + broken + undecidable + failed))),
            (coloured(*fits, Meaning::Fits), format!("{fits} fit")),
            plain(", "),
            (coloured(*broken, Meaning::Broken), format!("{broken} broken")),
            plain(", "),
            (coloured(*undecidable, Meaning::Undecidable), format!("{undecidable} undecidable")),
            plain(format!(", {failed} could not be checked")),
        ],
    );
    page
}

/// `1 map`, `2 maps`.
pub fn counted_maps(maps: usize) -> String {
    format!("{maps} map{}", if maps == 1 { "" } else { "s" })
}

/// The notes beside the repairs, as sentences; unless `verbose`, those of the short report.
pub fn notes(check: &Check, verbose: bool) -> Vec<String> {
    let names = check.file_names();
    let notes = check.notes.iter().filter(|note| !note.is_beyond_repair());
    notes.filter(|note| verbose || is_brief(note, check)).map(|note| note.sentence(&names)).collect()
}

/// Whether a note belongs into the short report: it names an assumption, a doubt or a copy. What changes nothing waits for
/// `--verbose`, and so does what is clear once a picture is replaced.
fn is_brief(note: &Note, check: &Check) -> bool {
    let replaced = |face: &Face| check.outliers.iter().any(|outlier| outlier.face == *face);
    match note {
        Note::Outlier { .. } | Note::Sizes { .. } | Note::NotSquare { .. } => true,
        Note::Undecided { faces } => !faces.iter().all(replaced),
        Note::Identical { .. } => check.outliers.is_empty(),
        Note::Flat { .. } | Note::Doubtful { .. } | Note::Open { .. } | Note::Exposure { .. } => true,
        Note::Unnamed { .. } | Note::AssumedUp { .. } | Note::Sky { .. } => true,
        Note::Framed { .. } | Note::Alpha { .. } | Note::Rough { .. } => false,
        Note::Mirrored { .. } => check.verdict == Verdict::Fits,
    }
}

/// `8 fit, 4 broken`.
fn counted(seams: &[Seam]) -> String {
    let words = [(Verdict::Fits, "fit"), (Verdict::Broken, "broken"), (Verdict::Undecidable, "undecidable")];
    let counts = words.map(|(verdict, word)| (seams.iter().filter(|seam| seam.verdict == verdict).count(), word));
    let counts: Vec<String> =
        counts.iter().filter(|(count, _)| *count > 0).map(|(count, word)| format!("{count} {word}")).collect();
    counts.join(", ")
}

fn meaning(verdict: Verdict) -> Meaning {
    match verdict {
        Verdict::Fits => Meaning::Fits,
        Verdict::Broken => Meaning::Broken,
        Verdict::Undecidable => Meaning::Undecidable,
    }
}

fn plain(text: impl Into<String>) -> Span {
    (Meaning::Plain, text.into())
}

fn figure(number: f64) -> Span {
    plain(format!("{number:.2}"))
}

fn judged(verdict: Verdict) -> Span {
    (meaning(verdict), verdict.name().to_owned())
}
