//! The report of `skycube trace`.

mod events;
mod json;
mod report;

pub use report::TraceReport;
