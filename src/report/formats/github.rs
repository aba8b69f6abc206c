//! Workflow commands: GitHub shows a line `::error file=…,title=…::…` as an annotation of that file.
//! <https://docs.github.com/actions/reference/workflow-commands-for-github-actions>

use super::Examined;
use crate::validate::Level;

/// A line for each fault.
pub(super) fn annotations(examined: &[Examined]) -> String {
    let mut lines = String::new();
    for one in examined {
        for fault in one.faults() {
            let command = if fault.level == Level::Error { "error" } else { "warning" };
            let title = property(&format!("{}: {}", one.name, one.verdict));
            let (file, sentence) = (property(&fault.path()), message(&fault.sentence));
            lines.push_str(&format!("::{command} file={file},title={title}::{sentence}\n"));
        }
    }
    lines
}

/// Percent, and what ends a line.
fn message(text: &str) -> String {
    text.replace('%', "%25").replace('\r', "%0D").replace('\n', "%0A")
}

/// The same, and what ends a property.
fn property(text: &str) -> String {
    message(text).replace(':', "%3A").replace(',', "%2C")
}
