//! `skycube stress`: the numerical kernels on extreme inputs.

use std::path::{Path, PathBuf};

use clap::Args;

use super::progress_bar::RenderBar;
use super::terminal::{Outcome, print, show};
use crate::error::{Error, Result};
use crate::picture::{check_target, write_atomically};
use crate::report::{StressReport, draw_stress};
use crate::stress::{Case, Effort, Subject, Verdict, subjects};
use crate::validator_limits;

#[derive(Debug, Args)]
#[command(after_help = "Exit codes: 0 all bounds hold in their promised ranges, 1 a bound fails, 2 could not run.")]
pub struct StressArguments {
    /// Only the cases whose names begin with NAME, for instance leaks, with every step. The cases `check-…` sweep the limits
    /// of the validator, and run only if they are named
    #[arg(long, value_name = "NAME")]
    case: Option<String>,
    /// Rays for self-intersection; the other cases take a share of this number
    #[arg(long, value_name = "N", default_value_t = Effort::FULL.rays as u64, value_parser = clap::value_parser!(u64).range(1..=10_000_000_000))]
    rays: u64,
    /// Draw error against magnitude, one curve per case: .svg or .png
    #[arg(long, value_name = "FILE")]
    plot: Option<PathBuf>,
    /// Print the report as JSON
    #[arg(long)]
    pub(super) json: bool,
}

/// Sweeps and prints.
pub fn run(arguments: &StressArguments) -> Result<Outcome> {
    let effort = Effort { rays: arguments.rays as usize };
    let chosen = chosen(arguments.case.as_deref())?;
    if let Some(file) = &arguments.plot {
        is_svg(file)?;
        check_target(file)?;
    }
    let bar = RenderBar::new(chosen.len() as u64, "measuring");
    let measured = |subject: Subject| {
        bar.begin(subject.name);
        let case = subject.measured(effort);
        bar.step();
        case
    };
    let cases: Vec<Case> = chosen.into_iter().map(measured).collect();
    bar.finish();
    let report = StressReport { cases: &cases, effort, steps: arguments.case.is_some() };
    if arguments.json {
        print(format_args!("{}\n", report.to_json()));
    } else {
        show(&report.page());
    }
    if let Some(file) = &arguments.plot {
        draw(&cases, file)?;
    }
    let fails = cases.iter().any(|case| case.verdict() == Verdict::Fails);
    Ok(if fails { Outcome::Faults } else { Outcome::Clean })
}

/// The cases whose names begin with the given text, or all but those of the validator.
fn chosen(name: Option<&str>) -> Result<Vec<Subject>> {
    let Some(name) = name else { return Ok(subjects()) };
    let all = [subjects(), validator_limits::SUBJECTS.to_vec()].concat();
    let chosen: Vec<Subject> = all.iter().copied().filter(|subject| subject.name.starts_with(name)).collect();
    if chosen.is_empty() {
        let names: Vec<&str> = all.iter().map(|subject| subject.name).collect();
        return Err(Error::new(format!("there is no case \"{name}\"")).expected(format!("one of {}", names.join(", "))));
    }
    Ok(chosen)
}

/// Whether a file is to hold an SVG; the other choice is PNG.
fn is_svg(file: &Path) -> Result<bool> {
    let extension = file.extension().map(|extension| extension.to_string_lossy().to_ascii_lowercase());
    match extension.as_deref() {
        Some("svg") => Ok(true),
        Some("png") => Ok(false),
        _ => Err(Error::new("the name does not tell the format of the chart")
            .in_file(file)
            .expected("the extension .svg or .png")),
    }
}

fn draw(cases: &[Case], file: &Path) -> Result<()> {
    let chart = draw_stress(cases);
    if is_svg(file)? { write_atomically(file, chart.to_svg().as_bytes()) } else { chart.to_drawing().write(file) }
}
