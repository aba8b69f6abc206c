//! The legend below a plot, in columns.

use plotters::coord::Shift;
use plotters::drawing::DrawingAreaErrorKind;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::converge_plot::{EM, font};
use super::plot_marks::{colour, marker, thick};
use super::text_drawing::text_width;

/// One entry.
#[derive(Debug, Clone)]
pub(super) enum Entry {
    /// A line of measurements by its number.
    Series { index: usize, label: String },
    /// A dashed line.
    Dashed { label: String, style: ShapeStyle },
}

/// Distances in pixels.
const MARGIN: i32 = 56;
const SAMPLE_WIDTH: i32 = 60;
const GAP: i32 = 14;
const ROW: i32 = 36;

impl Entry {
    fn label(&self) -> &str {
        match self {
            Entry::Series { label, .. } | Entry::Dashed { label, .. } => label,
        }
    }
}

/// How many columns fit, and how wide each is.
fn columns(entries: &[Entry], width: i32) -> (usize, i32) {
    let widest = entries.iter().map(|entry| text_width(entry.label(), EM as f32).ceil() as i32).max().unwrap_or(0);
    // Room for fonts that are wider than ours.
    let column = SAMPLE_WIDTH + GAP + widest + widest / 10 + 2 * GAP;
    let fitting = ((width - 2 * MARGIN) / column).max(1) as usize;
    (fitting.min(entries.len().max(1)), column)
}

/// The height of a legend in a plot of the given width, in pixels.
pub(super) fn height(entries: &[Entry], width: u32) -> u32 {
    let (columns, _) = columns(entries, width as i32);
    (entries.len().div_ceil(columns) as i32 * ROW + ROW) as u32
}

/// Draws the entries row by row.
pub(super) fn draw<DB: DrawingBackend>(
    entries: &[Entry],
    area: &DrawingArea<DB, Shift>,
) -> Result<(), DrawingAreaErrorKind<DB::ErrorType>> {
    let (columns, column_width) = columns(entries, area.dim_in_pixel().0 as i32);
    let text = font(EM).pos(Pos::new(HPos::Left, VPos::Center));
    for (number, entry) in entries.iter().enumerate() {
        let x = MARGIN + (number % columns) as i32 * column_width;
        let y = ROW / 2 + (number / columns) as i32 * ROW;
        let line = [(x, y), (x + SAMPLE_WIDTH, y)];
        match entry {
            Entry::Series { index, .. } => {
                area.draw(&PathElement::new(line, thick(&colour(*index))))?;
                area.draw(&marker((x + SAMPLE_WIDTH / 2, y), *index))?;
            }
            Entry::Dashed { style, .. } => {
                for start in (x..x + SAMPLE_WIDTH).step_by(18) {
                    area.draw(&PathElement::new([(start, y), (start + 10, y)], *style))?;
                }
            }
        }
        area.draw(&Text::new(entry.label().to_owned(), (x + SAMPLE_WIDTH + GAP, y), text.clone()))?;
    }
    Ok(())
}
