//! Reports and drawings: a module for each command, and the code they share. Only this module draws.

mod chart;
mod check;
mod code;
mod compare;
mod converge;
mod convert;
mod drawing;
mod formats;
mod grade;
mod grouped;
mod html;
mod json;
mod lessons;
mod map_check;
mod page;
mod probe;
mod render;
mod shots;
#[cfg(feature = "stress")]
mod stress;
mod trace;
mod view;

pub use check::{CheckReport, MapCheck, Totals, map_line, totals_line};
pub use compare::{CompareReport, FolderReport, Metric, PairReport, PairVerdict, draw_comparison};
pub use converge::{ConvergeReport, ConvergedScene, Measure, converge_csv, draw_convergence};
pub use drawing::{Anchor, Drawing, draw_compass_face, text_path};
pub use formats::ReportFormat;
pub use grade::GradeReport;
pub use map_check::{CheckedMap, ConfigReport, check_json};
pub use page::{Column, Look, Meaning, Page, Span, Table};
#[cfg(feature = "stress")]
pub use stress::StressReport;

pub(crate) use check::{counted_maps, nothing_to_fix, picture_repairs};
pub(crate) use code::{CodeLanguage, lookup_code};
pub(crate) use convert::{ConvertReport, ConvertedFile};
pub(crate) use drawing::{CaptionedShot, CrossInput, MapThumbnail, draw_contact_sheet, draw_cross, draw_map_sheet};
pub(crate) use formats::{Examined, listed};
pub(crate) use json::failure_json;
pub(crate) use lessons::{lesson_list, lesson_page, lesson_started};
pub(crate) use probe::ProbeReport;
pub(crate) use render::RenderReport;
pub(crate) use shots::ShotsReport;
#[cfg(feature = "stress")]
pub(crate) use stress::draw_stress;
pub(crate) use trace::TraceReport;
pub(crate) use view::{ViewInput, view_page};
