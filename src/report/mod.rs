//! What the tool says and draws.

mod render_report;

pub use render_report::RenderReport;
