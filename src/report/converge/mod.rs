//! The report and the drawings of `skycube converge`.

mod measure;
mod plot;
mod report;
mod table;

pub use measure::Measure;
pub use plot::draw_convergence;
pub use report::{ConvergeReport, ConvergedScene};
pub use table::converge_csv;
