//! Pixels that are not numbers.

use serde::Serialize;

use super::finding::{Finding, Kind, Weight};
use crate::math::Vec3;
use crate::picture::Raster;

/// Pixels that are not finite numbers, and where the first from the top is. They count as black.
#[derive(Serialize)]
struct NotFinite {
    pixels: usize,
    x: usize,
    y: usize,
}

impl Kind for NotFinite {
    const NAME: &'static str = "not_finite";
    const WEIGHT: Weight = Weight::Fault;

    fn sentence(&self) -> String {
        let Self { pixels, x, y } = self;
        let (are, they) = match pixels {
            1 => (format!("1 of your pixels is not a finite number (column {x}, row {y})"), "It is"),
            _ => {
                let first = format!("the first from the top is column {x}, row {y}");
                (format!("{pixels} of your pixels are not finite numbers ({first})"), "They are")
            }
        };
        format!("{are}: somewhere you divide by zero or take the root of a negative number. {they} compared as black.")
    }
}

/// The raster with black in place of what is not a finite number, and the finding if there was any.
pub(super) fn finite(raster: &Raster) -> (Raster, Option<Finding>) {
    let is_unknown = |colour: &Vec3| !colour.is_finite();
    let Some(first) = raster.pixels().iter().position(is_unknown) else { return (raster.clone(), None) };
    let pixels = raster.pixels().iter().filter(|colour| is_unknown(colour)).count();
    let known = |colour: &Vec3| if colour.is_finite() { *colour } else { Vec3::ZERO };
    let repaired = raster.pixels().iter().map(known).collect();
    let found = NotFinite { pixels, x: first % raster.width(), y: first / raster.width() };
    (Raster::from_pixels(raster.width(), raster.height(), repaired), Some(found.into()))
}
