//! What `skycube grade` says.

mod json;
mod report;
mod sentences;

pub use report::GradeReport;
