//! Latitude-longitude pictures: cells between two meridians and two parallels.

use std::f64::consts::{PI, TAU};

use super::brightness::BrightnessHistogram;
use super::cells::{Cell, CellAxis, CellTable};
use super::texel_means::{Beyond, bilinear_means, texel_luminances};
use crate::envmap::Equirectangular;
use crate::error::Result;
use crate::math::DVec3;
use crate::math::functions::{cos, sin};
use crate::parallel;

/// Most cells around the horizon and from pole to pole. Larger pictures have several texels in a cell.
const MOST_CELLS: [usize; 2] = [4096, 2048];

/// Draws directions in proportion to a panorama's luminance; within a cell uniform by solid angle.
#[derive(Debug)]
pub(super) struct PanoramaSampler {
    table: CellTable,
    frame: PanoramaFrame,
    /// Cosine of the angle from the zenith at the borders of the rows.
    cosines: Vec<f64>,
}

/// Directions of a panorama, without its picture.
type PanoramaFrame = crate::envmap::background::Longitudes;

impl PanoramaSampler {
    pub(super) fn new(map: &Equirectangular, histogram: &mut BrightnessHistogram) -> Result<Self> {
        let picture = map.image.try_picture()?;
        let (width, height) = (picture.width(), picture.height());
        let means = bilinear_means(&texel_luminances(picture), width, Beyond::OtherEnd);
        let (columns, rows) = (CellAxis::new(width, MOST_CELLS[0]), CellAxis::new(height, MOST_CELLS[1]));
        let cells = cells(&means, columns, rows);
        cells.iter().for_each(|&cell| histogram.add(cell));
        let mut table = CellTable::default();
        table.push(columns, rows, &cells);
        let border = |row: usize| (row * rows.group).min(height) as f64 / height as f64;
        let cosines = (0..=rows.count()).map(|row| cos(PI * border(row))).collect();
        Ok(Self { table: table.finish(), frame: map.longitudes(), cosines })
    }

    /// Integral of the luminance over the sphere.
    pub(super) fn power(&self) -> f64 {
        self.table.power()
    }

    #[inline]
    pub(super) fn sample(&self, place: [f64; 2]) -> (DVec3, f64) {
        let cell = self.table.draw(place);
        let (left, width) = self.table.grid(0).columns.extent(cell.column);
        let (upper, lower) = (self.cosines[cell.row], self.cosines[cell.row + 1]);
        let cosine = upper + (lower - upper) * cell.within[1];
        let direction = self.frame.direction(left + width * cell.within[0], cosine);
        (direction, cell.probability / (TAU * width * (upper - lower)))
    }

    #[inline]
    pub(super) fn density(&self, direction: DVec3) -> f64 {
        let (u, v) = self.frame.place(direction);
        let grid = self.table.grid(0);
        let (column, row) = (grid.columns.cell_at(u), grid.rows.cell_at(v));
        let solid_angle = TAU * grid.columns.extent(column).1 * (self.cosines[row] - self.cosines[row + 1]);
        self.table.probability(0, column, row) / solid_angle
    }
}

/// Power and solid angle of the cells.
fn cells(means: &[f32], columns: CellAxis, rows: CellAxis) -> Vec<Cell> {
    let count = columns.count();
    let (width, height) = (columns.texels as f64, rows.texels as f64);
    let mut cells = vec![Cell::default(); count * rows.count()];
    parallel::for_each(cells.chunks_mut(count).enumerate(), |(row, cells)| {
        for texel_row in rows.texels_of(row) {
            // The difference of the cosines above and below, without cancellation.
            let zone = 2.0 * sin(PI * (texel_row as f64 + 0.5) / height) * sin(PI / (2.0 * height));
            let solid_angle = TAU / width * zone;
            for (column, cell) in cells.iter_mut().enumerate() {
                for texel in columns.texels_of(column) {
                    cell.solid_angle += solid_angle;
                    cell.power += f64::from(means[texel_row * columns.texels + texel]) * solid_angle;
                }
            }
        }
    });
    cells
}
