//! What `skycube stress` says and draws.

mod plot;
mod report;

pub use plot::draw_stress;
pub use report::StressReport;
