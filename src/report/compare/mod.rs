//! The report and the drawings of `skycube compare`.

mod drawing;
mod report;

pub use drawing::draw_comparison;
pub use report::{CompareReport, Metric};
