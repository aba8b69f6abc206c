//! The report and the drawings of `skycube compare`.

mod drawing;
mod page;
mod pairs;
mod report;

pub use drawing::draw_comparison;
pub use pairs::{FolderReport, PairReport, PairVerdict};
pub use report::{CompareReport, Metric};
