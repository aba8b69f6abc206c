//! What the tool says and draws. Only this module draws.

mod check_report;
mod code;
mod compass;
mod compass_marks;
mod render_report;
mod text_drawing;

pub use check_report::{CheckReport, failed_check_json};
pub use code::{CodeLanguage, lookup_code};
pub use compass::draw_compass_face;
pub use render_report::RenderReport;
pub use text_drawing::{Anchor, draw_text, text_path, text_width};

#[cfg(test)]
mod tests;
