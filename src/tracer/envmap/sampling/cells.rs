//! Tables of cells: pictures cut into small rectangles, which are sampled in proportion to their weights.

use super::inversion::{self, Inversion};
use crate::parallel;

/// The cells along one side of a picture: whole texels, the same number in each but the last.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct CellAxis {
    /// Texels of a cell.
    pub group: usize,
    /// Texels of the picture.
    pub texels: usize,
    cells_per_side: f64,
    side_per_cell: f64,
}

impl CellAxis {
    /// As many cells as there are texels, or fewer, to stay within `limit`.
    pub(super) fn new(texels: usize, limit: usize) -> Self {
        let group = texels.div_ceil(limit);
        let cells_per_side = texels as f64 / group as f64;
        Self { group, texels, cells_per_side, side_per_cell: 1.0 / cells_per_side }
    }

    /// Number of cells.
    pub(super) fn count(&self) -> usize {
        self.texels.div_ceil(self.group)
    }

    /// The texels of a cell.
    pub(super) fn texels_of(&self, cell: usize) -> std::ops::Range<usize> {
        cell * self.group..((cell + 1) * self.group).min(self.texels)
    }

    /// The cell at a place in `[0, 1]` of the side.
    #[inline]
    pub(super) fn cell_at(&self, place: f64) -> usize {
        ((place * self.cells_per_side) as usize).min(self.count() - 1)
    }

    /// Where a cell starts and how long it is, the side being 1.
    #[inline]
    pub(super) fn extent(&self, cell: usize) -> (f64, f64) {
        let start = cell as f64 * self.side_per_cell;
        (start, self.side_per_cell.min(1.0 - start))
    }
}

/// A cell's share of the light, and of the sphere in steradians.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Cell {
    pub power: f64,
    pub solid_angle: f64,
}

/// The cells of one picture.
#[derive(Debug, Clone)]
pub(super) struct Grid {
    pub columns: CellAxis,
    pub rows: CellAxis,
    /// Number of its first row among the rows of all pictures.
    first_row: usize,
    first_start: usize,
    first_guide: usize,
}

/// Which cell was drawn.
#[derive(Debug, Clone, Copy)]
pub(super) struct DrawnCell {
    pub grid: usize,
    pub column: usize,
    pub row: usize,
    /// Where in the cell, from the left and from the top, in `[0, 1)`.
    pub within: [f64; 2],
    pub probability: f64,
}

/// Cells of several pictures. A row of any of them is drawn first, then a cell of the row.
#[derive(Debug, Clone, Default)]
pub(super) struct CellTable {
    grids: Vec<Grid>,
    /// Power of each row, until the table is finished.
    powers: Vec<f64>,
    row_starts: Vec<u32>,
    row_guide: Vec<u16>,
    /// Of all rows, one after the other.
    starts: Vec<u32>,
    guides: Vec<u16>,
    power: f64,
}

impl CellTable {
    /// Adds the cells of a picture, row by row.
    pub(super) fn push(&mut self, columns: CellAxis, rows: CellAxis, cells: &[Cell]) {
        let count = columns.count();
        let (starts_length, guide_length) = (inversion::starts_length(count), inversion::guide_length(count));
        let (first_start, first_guide) = (self.starts.len(), self.guides.len());
        self.grids.push(Grid { columns, rows, first_row: self.powers.len(), first_start, first_guide });
        self.starts.resize(first_start + starts_length * rows.count(), 0);
        self.guides.resize(first_guide + guide_length * rows.count(), 0);
        let starts = self.starts[first_start..].chunks_mut(starts_length);
        let guides = self.guides[first_guide..].chunks_mut(guide_length);
        let powers = cells.chunks(count).zip(starts.zip(guides));
        self.powers.extend(parallel::map(powers, |(cells, (starts, guide))| {
            inversion::prepare(cells.iter().map(|cell| cell.power), starts, guide)
        }));
    }

    /// Makes the table ready to draw from.
    pub(super) fn finish(mut self) -> Self {
        let powers = std::mem::take(&mut self.powers);
        self.row_starts = vec![0; inversion::starts_length(powers.len())];
        self.row_guide = vec![0; inversion::guide_length(powers.len())];
        self.power = inversion::prepare(powers.iter().copied(), &mut self.row_starts, &mut self.row_guide);
        self
    }

    /// Sum over all cells.
    pub(super) fn power(&self) -> f64 {
        self.power
    }

    #[inline]
    pub(super) fn grid(&self, grid: usize) -> &Grid {
        &self.grids[grid]
    }

    /// Draws a cell. The table must have power.
    #[inline]
    pub(super) fn draw(&self, place: [f64; 2]) -> DrawnCell {
        let rows = self.all_rows();
        let (row, down) = rows.draw(place[1]);
        let grid = self.grids[1..].iter().take_while(|grid| grid.first_row <= row).count();
        let within_grid = row - self.grids[grid].first_row;
        let cells = self.cells(grid, within_grid);
        let (column, right) = cells.draw(place[0]);
        let probability = rows.probability(row) * cells.probability(column);
        DrawnCell { grid, column, row: within_grid, within: [right, down], probability }
    }

    /// The probability of drawing a cell.
    #[inline]
    pub(super) fn probability(&self, grid: usize, column: usize, row: usize) -> f64 {
        let of_row = self.all_rows().probability(self.grids[grid].first_row + row);
        of_row * self.cells(grid, row).probability(column)
    }

    #[inline]
    fn all_rows(&self) -> Inversion<'_> {
        Inversion::new(&self.row_starts, &self.row_guide)
    }

    #[inline]
    fn cells(&self, grid: usize, row: usize) -> Inversion<'_> {
        let Grid { columns, first_start, first_guide, .. } = self.grids[grid];
        let count = columns.count();
        let (starts, guides) = (inversion::starts_length(count), inversion::guide_length(count));
        let (start, guide) = (first_start + row * starts, first_guide + row * guides);
        Inversion::new(&self.starts[start..start + starts], &self.guides[guide..guide + guides])
    }
}
