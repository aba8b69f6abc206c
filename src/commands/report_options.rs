//! The options that say in which form a command reports, and what its exit code tells.

use clap::Args;

use super::terminal::{Outcome, print};
use crate::report::{Examined, ReportFormat, listed};

/// How a command reports.
#[derive(Debug, Args)]
pub struct ReportOptions {
    /// The form of the report
    #[arg(long, value_enum, default_value = "text", conflicts_with = "json")]
    format: ReportFormat,
    /// The same as --format json
    #[arg(long)]
    json: bool,
    /// Print faults only, a line each; nothing if all is well
    #[arg(short, long)]
    quiet: bool,
    /// Exit with 0 although faults were found
    #[arg(long)]
    exit_zero: bool,
}

impl ReportOptions {
    /// The form that the user chose.
    pub fn format(&self) -> ReportFormat {
        if self.json { ReportFormat::Json } else { self.format }
    }

    /// True if a person reads all of the report.
    pub fn is_text(&self) -> bool {
        self.format() == ReportFormat::Text && !self.quiet
    }

    /// True if a person reads the faults only.
    pub fn is_quiet_text(&self) -> bool {
        self.format() == ReportFormat::Text && self.quiet
    }

    /// Prints what was examined in the form that the user chose, if it is not text. `json` is the report as JSON.
    pub fn print(&self, command: &str, examined: &[Examined], json: impl FnOnce() -> String) {
        match self.format() {
            ReportFormat::Text => {}
            ReportFormat::Json => print(format_args!("{}\n", json())),
            format => print(listed(format, command, examined)),
        }
    }

    /// The outcome for the exit code, unless faults shall not change it.
    pub fn outcome(&self, outcome: Outcome) -> Outcome {
        if self.exit_zero && outcome == Outcome::Faults { Outcome::Clean } else { outcome }
    }
}
