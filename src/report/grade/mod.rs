//! The report of `skycube grade`.

mod json;
mod report;
mod sentences;

pub use report::GradeReport;
