//! The report and the drawings of `skycube converge`.

mod plot;
mod report;
mod series;
mod table;

pub use plot::draw_convergence;
pub use report::{ConvergeReport, ConvergedScene};
pub use series::Measure;
pub use table::converge_csv;
