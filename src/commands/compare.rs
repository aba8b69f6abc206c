//! `skycube compare`: a picture against the expected one, and what it does differently.

use std::path::PathBuf;

use clap::Args;

use super::options::{check_drawing_name, refuse_to_overwrite_sources};
use super::terminal::{Outcome, leave_stdout_to, print, tell};
use crate::compare::{Comparison, Verdict};
use crate::error::{Error, Result};
use crate::picture::{check_target, read};
use crate::report::{CompareReport, Metric, draw_comparison};

#[derive(Debug, Args)]
#[command(after_help = "Exit codes: 0 within the threshold, 1 outside it, or with a fault that no threshold allows \
                        (flipped, turned, red and blue exchanged, not finite, clearly different in one place or \
                        altogether), 2 could not run.")]
pub struct CompareArguments {
    /// Your picture; - for standard input
    #[arg(value_name = "MINE")]
    mine: PathBuf,
    /// The expected picture
    #[arg(value_name = "EXPECTED")]
    expected: PathBuf,
    /// Draw yours, the expected one and a heat map of the difference, as .png; - for standard output
    #[arg(short, long, value_name = "PICTURE")]
    output: Option<PathBuf>,
    /// The measure that decides
    #[arg(long, value_enum, default_value = "flip")]
    metric: Metric,
    /// The limit for the measure [default: flip 0.05, rmse 0.05, psnr 28, ssim 0.85]
    #[arg(long, value_name = "X", allow_negative_numbers = true)]
    threshold: Option<f64>,
    /// Print the report as JSON
    #[arg(long)]
    json: bool,
}

/// Compares, draws if asked to, and prints.
pub fn run(arguments: &CompareArguments) -> Result<Outcome> {
    let threshold = arguments.threshold.unwrap_or_else(|| arguments.metric.default_threshold());
    if !threshold.is_finite() {
        return Err(Error::new(format!("the threshold is {threshold}")).expected("a number"));
    }
    check_output(arguments)?;
    arguments.output.iter().for_each(|output| leave_stdout_to(output));
    let (mine, expected) = (read(&arguments.mine)?, read(&arguments.expected)?);
    let comparison = Comparison::of(&mine, &expected);
    let report = CompareReport::new(&comparison, arguments.metric, threshold);
    if let Some(output) = &arguments.output {
        draw_comparison(&comparison).write(output)?;
    }
    if arguments.json {
        print(format_args!("{}\n", report.to_json()));
    } else {
        tell(&report);
        if let Some(output) = &arguments.output {
            tell(format_args!("wrote {}\n", output.display()));
        }
    }
    Ok(if report.verdict == Verdict::Differs { Outcome::Faults } else { Outcome::Clean })
}

/// An error if the drawing cannot be written, before anything is computed.
fn check_output(arguments: &CompareArguments) -> Result<()> {
    let Some(output) = &arguments.output else { return Ok(()) };
    check_drawing_name(output)?;
    refuse_to_overwrite_sources(output, &[arguments.mine.clone(), arguments.expected.clone()])?;
    check_target(output)
}
