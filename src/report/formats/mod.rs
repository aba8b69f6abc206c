//! Reports for other programs than a terminal: SARIF for code scanning, JUnit for test reports, annotations for GitHub. All
//! three write the same list, [`Examined`]: what was examined, and what was found there.

mod examined;
mod github;
mod junit;
mod sarif;

use clap::ValueEnum;

pub(crate) use examined::Examined;
pub(super) use examined::ReportedFinding;

/// The form of a report.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub enum ReportFormat {
    /// Sentences for a person
    #[default]
    Text,
    /// One object, as lessons/json.md and `skycube schema` describe it
    Json,
    /// Annotations of a GitHub workflow
    Github,
    /// SARIF 2.1.0, for code scanning
    Sarif,
    /// JUnit XML, for test reports
    Junit,
}

/// What a command examined, in a form for other programs; the forms of text and JSON belong to each command.
pub(crate) fn listed(format: ReportFormat, command: &str, examined: &[Examined]) -> String {
    match format {
        ReportFormat::Github => github::annotations(examined),
        ReportFormat::Junit => junit::report(command, examined),
        ReportFormat::Sarif => sarif::log(command, examined),
        ReportFormat::Text | ReportFormat::Json => String::new(),
    }
}

#[cfg(test)]
mod tests;
