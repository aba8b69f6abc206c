//! What `skycube compare` says and draws.

mod drawing;
mod report;

pub use drawing::draw_comparison;
pub use report::{CompareReport, Metric};
