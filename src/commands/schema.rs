//! `skycube schema`: the JSON Schema of a report.

use clap::{Args, ValueEnum};

use super::terminal::{Outcome, print};
use crate::error::Result;

#[derive(Debug, Args)]
pub struct SchemaArguments {
    /// The command whose report --json prints
    #[arg(value_enum)]
    command: Reporting,
}

/// The commands that report as JSON.
#[derive(Debug, Clone, Copy, ValueEnum)]
enum Reporting {
    Check,
    Compare,
    Converge,
    Grade,
    Probe,
    Render,
    Stress,
    Trace,
}

/// Prints a schema.
pub fn run(arguments: &SchemaArguments) -> Result<Outcome> {
    print(match arguments.command {
        Reporting::Check => include_str!("../report/schemas/check.json"),
        Reporting::Compare => include_str!("../report/schemas/compare.json"),
        Reporting::Converge => include_str!("../report/schemas/converge.json"),
        Reporting::Grade => include_str!("../report/schemas/grade.json"),
        Reporting::Probe => include_str!("../report/schemas/probe.json"),
        Reporting::Render => include_str!("../report/schemas/render.json"),
        Reporting::Stress => include_str!("../report/schemas/stress.json"),
        Reporting::Trace => include_str!("../report/schemas/trace.json"),
    });
    Ok(Outcome::Clean)
}
