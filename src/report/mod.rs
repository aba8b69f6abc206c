//! Reports and drawings: a module for each command, and the code they share. Only this module draws.

mod chart;
mod check;
mod code;
mod compare;
mod converge;
mod convert;
mod drawing;
mod grade;
mod grouped;
mod json;
mod lessons;
mod probe;
mod render;
mod shots;
#[cfg(feature = "stress")]
mod stress;
mod trace;
mod view;

pub use check::{CheckReport, MapCheck, check_json};
pub use compare::{CompareReport, Metric, draw_comparison};
pub use converge::{ConvergeReport, ConvergedScene, Measure, converge_csv, draw_convergence};
pub use drawing::{Anchor, Drawing, draw_compass_face, text_path};
pub use grade::GradeReport;
#[cfg(feature = "stress")]
pub use stress::StressReport;

pub(crate) use check::{Totals, nothing_to_fix};
pub(crate) use code::{CodeLanguage, lookup_code};
pub(crate) use convert::{ConvertReport, ConvertedFile};
pub(crate) use drawing::{CaptionedShot, CrossInput, draw_contact_sheet, draw_cross};
pub(crate) use lessons::{lesson_list, lesson_page, lesson_started};
pub(crate) use probe::ProbeReport;
pub(crate) use render::RenderReport;
pub(crate) use shots::ShotsReport;
#[cfg(feature = "stress")]
pub(crate) use stress::draw_stress;
pub(crate) use trace::TraceReport;
pub(crate) use view::{ViewInput, view_page};
