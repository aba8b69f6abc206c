//! What the tool says and draws. Only this module draws.

mod canvas;
mod chart_marks;
mod check_report;
mod code;
mod colour_map;
mod compare_drawing;
mod compare_report;
mod compare_sentences;
mod compass;
mod compass_marks;
mod contact_sheet;
mod converge_plot;
mod converge_report;
mod converge_series;
mod converge_table;
mod cross_drawing;
mod cross_layout;
mod cross_legend;
mod drawing;
mod grouped;
mod logarithmic_axis;
mod plot_backend;
mod plot_legend;
mod plot_marks;
mod probe_report;
mod render_report;
mod seam_mark;
mod shots_report;
mod stress_plot;
mod stress_report;
mod text_drawing;

pub use check_report::{CheckReport, failed_check_json};
pub use code::{CodeLanguage, lookup_code};
pub use compare_drawing::draw_comparison;
pub use compare_report::{CompareReport, Metric};
pub use compass::draw_compass_face;
pub use contact_sheet::{CaptionedShot, draw_contact_sheet};
pub use converge_plot::{draw_convergence, draw_convergence_svg};
pub use converge_report::{ConvergeReport, ConvergedScene};
pub use converge_series::Measure;
pub use converge_table::converge_csv;
pub use cross_drawing::{CrossInput, draw_cross};
pub use cross_layout::{CrossCell, CrossEdge, CrossLayout, Side};
pub use drawing::Drawing;
pub use probe_report::ProbeReport;
pub use render_report::RenderReport;
pub use seam_mark::SeamMark;
pub use shots_report::ShotsReport;
pub use stress_plot::StressPlot;
pub use stress_report::StressReport;
pub use text_drawing::{Anchor, draw_text, text_path, text_width};

#[cfg(test)]
mod tests;
