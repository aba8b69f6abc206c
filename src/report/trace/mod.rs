//! What `skycube trace` says.

mod events;
mod json;
mod report;

pub use report::TraceReport;
