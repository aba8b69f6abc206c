//! The report of `skycube grade`.

mod report;
mod sentences;

pub use report::GradeReport;
