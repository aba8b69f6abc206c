//! Reports and drawings: a module for each command, and the code they share. Only this module draws.

mod chart;
mod check;
mod code;
mod compare;
mod converge;
mod drawing;
mod grade;
mod grouped;
mod lessons;
mod probe;
mod render;
mod shots;
#[cfg(feature = "stress")]
mod stress;
mod trace;

pub use chart::Chart;
pub use check::{CheckReport, failed_check_json, nothing_to_fix};
pub use code::{CodeLanguage, lookup_code};
pub use compare::{CompareReport, Metric, draw_comparison};
pub use converge::{ConvergeReport, ConvergedScene, Measure, converge_csv, draw_convergence};
pub use drawing::{
    Anchor, CaptionedShot, CrossInput, Drawing, SeamMark, draw_compass_face, draw_contact_sheet, draw_cross, text_path,
};
pub use grade::GradeReport;
pub use lessons::{lesson_list, lesson_page, lesson_started};
pub use probe::ProbeReport;
pub use render::RenderReport;
pub use shots::ShotsReport;
#[cfg(feature = "stress")]
pub use stress::{StressReport, draw_stress};
pub use trace::TraceReport;
