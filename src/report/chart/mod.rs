//! Charts with logarithmic axes, as pictures and as SVG.

mod axis;
mod marks;
mod panel;

pub(super) use axis::Axis;
pub use marks::Chart;
#[cfg(feature = "stress")]
pub(super) use panel::draw_multiples;
pub(super) use panel::{Line, Panel, Style, draw_panels};
