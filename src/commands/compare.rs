//! `skycube compare`: pictures against the expected ones, and what they do differently.

use std::path::{Path, PathBuf};

use clap::Args;

use super::compare_folders::{Pair, pairs};
use super::options::{check_drawing_name, refuse_to_overwrite_sources};
use super::report_options::ReportOptions;
use super::terminal::{Outcome, leave_stdout_to, tell};
use crate::compare::Comparison;
use crate::error::{Error, Result};
use crate::picture::{
    check_target, folder_of, is_standard_stream, make_folder, read, write_atomically, write_together,
};
use crate::report::{CompareReport, FolderReport, Metric, PairReport, PairVerdict, draw_comparison};

#[derive(Debug, Args)]
#[command(after_help = "Exit codes: 0 within the threshold, 1 outside it, or with a fault that no threshold allows \
                        (flipped, turned, red and blue exchanged, not finite, clearly different in one place or \
                        altogether; missing or new in a folder), 2 could not run.")]
pub struct CompareArguments {
    /// Your picture, or a folder of yours; - for a picture on standard input
    #[arg(value_name = "MINE")]
    mine: PathBuf,
    /// The expected picture, or a folder of them: pictures are paired by name
    #[arg(value_name = "EXPECTED")]
    expected: PathBuf,
    /// Draw yours, the expected one and a heat map of the difference as .png, - for standard output; or show all pairs on a page as .html
    #[arg(short, long, value_name = "PICTURE|PAGE")]
    output: Option<PathBuf>,
    /// The measure that decides
    #[arg(long, value_enum, default_value = "flip")]
    metric: Metric,
    /// The limit for the measure [default: flip 0.05, rmse 0.05, psnr 28, ssim 0.85]
    #[arg(long, value_name = "X", allow_negative_numbers = true)]
    threshold: Option<f64>,
    /// Accept yours: copy each picture that differs or is new over the expected one
    #[arg(long)]
    update: bool,
    #[command(flatten)]
    pub(super) report: ReportOptions,
}

/// Compares, draws if asked to, accepts if asked to, and prints.
pub fn run(arguments: &CompareArguments) -> Result<Outcome> {
    let threshold = arguments.threshold.unwrap_or_else(|| arguments.metric.default_threshold());
    if !threshold.is_finite() {
        return Err(Error::new(format!("the threshold is {threshold}")).expected("a number"));
    }
    check_output(arguments)?;
    arguments.output.iter().for_each(|output| leave_stdout_to(output));
    let reports = match [&arguments.mine, &arguments.expected].map(|path| path.is_dir()) {
        [false, false] => vec![compare_one(arguments, threshold)?],
        [true, true] => compare_all(arguments, threshold)?,
        [true, false] => return Err(Error::new("this is not a folder, but yours is one").in_file(&arguments.expected)),
        [false, true] => {
            return Err(Error::new("this is not a folder, but the expected one is").in_file(&arguments.mine));
        }
    };
    if let Some(page) = arguments.output.as_ref().filter(|output| is_page(output)) {
        let [mine, expected] = [&arguments.mine, &arguments.expected].map(|path| path.display().to_string());
        write_atomically(page, FolderReport(&reports).page(&mine, &expected).as_bytes())?;
    }
    print_all(arguments, &reports);
    finish(arguments, &reports)
}

/// Compares two pictures, and prints the report in full.
fn compare_one(arguments: &CompareArguments, threshold: f64) -> Result<PairReport> {
    let name = arguments.mine.display().to_string();
    if arguments.update && !arguments.expected.exists() {
        read(&arguments.mine)?;
        return Ok(PairReport::alone(name, &arguments.mine, PairVerdict::New));
    }
    if [&arguments.mine, &arguments.expected].iter().all(|path| is_standard_stream(path)) {
        return Err(Error::new("both pictures are standard input").expected("a file beside -"));
    }
    let (mine, expected) = (read(&arguments.mine)?, read(&arguments.expected)?);
    let comparison = Comparison::of(&mine, &expected);
    let report = CompareReport::new(&comparison, arguments.metric, threshold);
    let drawing = arguments.output.as_ref().filter(|output| !is_page(output));
    if let Some(output) = drawing {
        draw_comparison(&comparison).write(output)?;
    }
    if arguments.report.is_text() {
        tell(&report);
    }
    PairReport::compared(name, &arguments.mine, &report, arguments.output.is_some() && drawing.is_none())
}

/// Compares pictures of the same name. One that cannot be read is reported like any other.
fn compare_all(arguments: &CompareArguments, threshold: f64) -> Result<Vec<PairReport>> {
    let compare = |name: String, mine: &Path, expected: &Path| -> Result<PairReport> {
        let comparison = Comparison::of(&read(mine)?, &read(expected)?);
        let report = CompareReport::new(&comparison, arguments.metric, threshold);
        PairReport::compared(name, mine, &report, arguments.output.is_some())
    };
    let report = |Pair { name, mine, expected }: Pair| match (mine, expected) {
        (Some(mine), Some(expected)) => {
            compare(name.clone(), &mine, &expected).unwrap_or_else(|error| PairReport::failed(name, &error))
        }
        (Some(mine), None) => PairReport::alone(name, &mine, PairVerdict::New),
        (None, file) => PairReport::alone(name, &file.unwrap_or_default(), PairVerdict::Missing),
    };
    Ok(pairs(&arguments.mine, &arguments.expected)?.into_iter().map(report).collect())
}

fn print_all(arguments: &CompareArguments, reports: &[PairReport]) {
    let in_folders = arguments.mine.is_dir();
    if arguments.report.is_text() && in_folders {
        tell(FolderReport(reports));
    } else if arguments.report.is_quiet_text() {
        let wrong = reports.iter().filter(|report| !report.verdict.is_right());
        wrong.for_each(|report| tell(format_args!("{}\n", report.line(0))));
    }
    let examined: Vec<_> = reports.iter().map(|report| report.examined.clone()).collect();
    arguments.report.print("compare", &examined, || FolderReport(reports).to_json(!in_folders));
    if arguments.report.is_text()
        && let Some(output) = &arguments.output
        && (is_page(output) || reports.iter().all(|report| report.verdict != PairVerdict::New))
    {
        tell(format_args!("wrote {}\n", output.display()));
    }
}

/// Accepts what shall be accepted, and says how it ended.
fn finish(arguments: &CompareArguments, reports: &[PairReport]) -> Result<Outcome> {
    let is_accepted =
        |report: &PairReport| arguments.update && matches!(report.verdict, PairVerdict::Differs | PairVerdict::New);
    let accepted: Vec<&str> =
        reports.iter().filter(|report| is_accepted(report)).map(|report| report.name.as_str()).collect();
    for target in accept(arguments, &accepted)? {
        if arguments.report.is_text() {
            tell(format_args!("accepted {}\n", target.display()));
        }
    }
    let failed = reports.iter().filter(|report| report.verdict == PairVerdict::Failed).count();
    if failed > 0 {
        return Err(Error::new(format!("{failed} of {} pairs could not be compared", reports.len())));
    }
    let faults = reports.iter().any(|report| !report.verdict.is_right() && !is_accepted(report));
    Ok(arguments.report.outcome(if faults { Outcome::Faults } else { Outcome::Clean }))
}

/// Copies the pictures of these names over the expected ones, all or none, and says which files were written.
fn accept(arguments: &CompareArguments, names: &[&str]) -> Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    if !arguments.mine.is_dir() {
        files.extend(names.iter().map(|_| (arguments.mine.clone(), arguments.expected.clone())));
    } else if !names.is_empty() {
        for Pair { name, mine, expected } in pairs(&arguments.mine, &arguments.expected)? {
            if let Some(mine) = mine.filter(|_| names.contains(&name.as_str())) {
                let inside = mine.strip_prefix(&arguments.mine).unwrap_or(&mine).to_path_buf();
                files.push((mine, expected.unwrap_or_else(|| arguments.expected.join(inside))));
            }
        }
    }
    let mut contents = Vec::new();
    for (mine, expected) in files {
        if mine.extension() != expected.extension() {
            return Err(Error::new(format!("{} has another extension: it is not copied over this", mine.display()))
                .in_file(expected)
                .help("write yours in the format of the expected picture, or remove the expected one"));
        }
        let bytes =
            std::fs::read(&mine).map_err(|error| Error::new(format!("cannot read it: {error}")).in_file(&mine))?;
        contents.push((expected, bytes));
    }
    for (target, _) in &contents {
        make_folder(folder_of(target))?;
    }
    write_together(contents.iter().map(|(target, bytes)| (target.as_path(), bytes.as_slice())))?;
    Ok(contents.into_iter().map(|(target, _)| target).collect())
}

fn is_page(output: &Path) -> bool {
    output.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("html"))
}

/// An error if the drawing cannot be written, before anything is computed.
fn check_output(arguments: &CompareArguments) -> Result<()> {
    let Some(output) = &arguments.output else { return Ok(()) };
    if !is_page(output) && arguments.mine.is_dir() {
        return Err(Error::new("folders are shown on a page").in_file(output).expected("a name with .html"));
    }
    if !is_page(output) {
        check_drawing_name(output)?;
    }
    let sources = [&arguments.mine, &arguments.expected].into_iter().filter(|path| path.is_file()).cloned();
    refuse_to_overwrite_sources(output, &sources.collect::<Vec<_>>())?;
    check_target(output)
}
