//! The report and the chart of `skycube stress`.

mod plot;
mod report;

pub use plot::draw_stress;
pub use report::StressReport;
