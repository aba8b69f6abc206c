//! What the tool says and draws. Only this module draws.

mod canvas;
mod check_report;
mod code;
mod colour_map;
mod compare_drawing;
mod compare_report;
mod compare_sentences;
mod compass;
mod compass_marks;
mod contact_sheet;
mod cross_drawing;
mod cross_layout;
mod cross_legend;
mod drawing;
mod grade_json;
mod grade_report;
mod lessons_report;
mod probe_report;
mod render_report;
mod seam_mark;
mod shots_report;
mod text_drawing;
mod trace_events;
mod trace_json;
mod trace_report;

pub use check_report::{CheckReport, failed_check_json};
pub use code::{CodeLanguage, lookup_code};
pub use compare_drawing::draw_comparison;
pub use compare_report::{CompareReport, Metric};
pub use compass::draw_compass_face;
pub use contact_sheet::{CaptionedShot, draw_contact_sheet};
pub use cross_drawing::{CrossInput, draw_cross};
pub use cross_layout::{CrossCell, CrossEdge, CrossLayout, Side};
pub use drawing::Drawing;
pub use grade_report::GradeReport;
pub use lessons_report::{lesson_list, lesson_page, lesson_started};
pub use probe_report::ProbeReport;
pub use render_report::RenderReport;
pub use seam_mark::SeamMark;
pub use shots_report::ShotsReport;
pub use text_drawing::{Anchor, draw_text, text_path, text_width};
pub use trace_report::TraceReport;

#[cfg(test)]
mod tests;
