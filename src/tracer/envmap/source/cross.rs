//! The layout of a cross, found from its empty cells of one colour.

use super::super::orientation::ImageOperation;
use super::layout::{Cell, Layout};
use crate::colour::encode_srgb;
use crate::error::{Error, Result};
use crate::math::Vec3;
use crate::picture::Picture;

/// A picture as a grid of square cells.
pub(super) struct Grid<'a> {
    pub picture: &'a Picture,
    pub columns: usize,
    pub rows: usize,
}

/// Texels of a cell that are looked at, across and down.
const LOOKED_AT: usize = 128;
/// Codes by which an empty cell may differ from its colour, as JPEG files do, and the part of its texels that must not: some
/// authors sign there.
const EMPTY_SPREAD: f32 = 8.0;
const EMPTY_PART: f32 = 0.9;
/// The cell of -Z stands upright, not folded, if it continues so much better: the part of the folded step.
const CLEARLY_BETTER: f32 = 0.5;

/// The cells of a cross, +X -X +Y -Y +Z -Z.
pub(super) fn cells(grid: &Grid, layout: Layout) -> Result<[Cell; 6]> {
    use ImageOperation::{None, Turn180, TurnClockwise, TurnCounterclockwise};
    // An arm further from the centre than the front touches it with another side.
    match layout {
        Layout::HorizontalCross => {
            let ([top, bottom], front) = arms(grid, [0, 2], |lane, place| (place, lane))?;
            let side = |quarter: usize| cell((front + quarter) % 4, 1, None);
            let turn = [None, TurnClockwise, Turn180, TurnCounterclockwise][(bottom + 4 - front) % 4];
            Ok([side(1), side(3), cell(top, 0, None), cell(bottom, 2, turn), side(0), side(2)])
        }
        _ => {
            let ([left, right], front) = arms(grid, [0, 2], |lane, place| (lane, place))?;
            let row = |quarter: usize| (front + quarter) % 4;
            let turn = [None, TurnCounterclockwise, Turn180, TurnClockwise][(right + 4 - front) % 4];
            let upright = |row: usize| cell(1, row, None);
            let back = cell(1, row(2), if back_is_folded(grid, row(2)) { Turn180 } else { None });
            let left = cell(0, left, None);
            Ok([cell(2, right, turn), left, upright(row(3)), upright(row(1)), upright(front), back])
        }
    }
}

/// The cells of a sheet, row by row; an error if all cells continue each other: then it is one picture.
pub(super) fn sheet_cells(grid: &Grid, layout: Layout) -> Result<[Cell; 6]> {
    if grid.is_one_picture() {
        return Err(grid.refused("its cells continue each other: this is one picture, not a sheet of six faces"));
    }
    Ok(layout.cells())
}

fn cell(column: usize, row: usize, turn: ImageOperation) -> Cell {
    Cell { column, row, turn }
}

/// The places of the two arms along the cross, and that of the front: beside the first arm, or the second if the first
/// cannot be told from the empty cells around it. An error names what is not empty.
fn arms(grid: &Grid, lanes: [usize; 2], at: impl Fn(usize, usize) -> (usize, usize)) -> Result<([usize; 2], usize)> {
    let mut found = [None; 2];
    for (arm, lane) in found.iter_mut().zip(lanes) {
        *arm = grid.full_cell([0, 1, 2, 3].map(|place| at(lane, place)))?;
    }
    let front = found[0].or(found[1]).unwrap_or(1);
    Ok((found.map(|arm| arm.unwrap_or(front)), front))
}

/// True unless the cell of -Z, beside -Y or +Y, clearly continues it upright.
fn back_is_folded(grid: &Grid, row: usize) -> bool {
    let last = grid.side() - 1;
    // The cell beside it, the rows that touch, and the row of -Z that is the same edge when the cell stands upright.
    let (beside, edge, near, far) = if row > 0 { (row - 1, last, 0, last) } else { (row + 1, 0, last, 0) };
    let step = |y: usize, reversed: bool| {
        let across = (0..=last).map(|x| {
            let other = if reversed { last - x } else { x };
            (grid.code((1, beside), x, edge) - grid.code((1, row), other, y)).abs().element_sum()
        });
        across.sum::<f32>()
    };
    step(far, true) >= CLEARLY_BETTER * step(near, false)
}

impl Grid<'_> {
    fn side(&self) -> usize {
        self.picture.width() / self.columns
    }

    /// The display colour of a texel of a cell, of 255.
    fn code(&self, (column, row): (usize, usize), x: usize, y: usize) -> Vec3 {
        let side = self.side();
        let colour = self.picture.texel(column * side + x, row * side + y);
        Vec3::from_array(colour.to_array().map(|value| 255.0 * encode_srgb(value.clamp(0.0, 1.0))))
    }

    /// The one of four cells that is not empty; `None` if all are alike. A face may be of one colour too, a white ground say:
    /// then it is the only one of another colour, or the only one with anything in it at all.
    fn full_cell(&self, cells: [(usize, usize); 4]) -> Result<Option<usize>> {
        let colours = cells.map(|cell| self.colour(cell));
        let near = |one: Vec3, other: Vec3| (one - other).abs().max_element() <= EMPTY_SPREAD;
        let full = |place: &usize| self.part_of_colour(cells[*place], colours[*place], EMPTY_SPREAD) < EMPTY_PART;
        let differs = |place: &usize| (0..4).filter(|&other| near(colours[*place], colours[other])).count() == 1;
        let dotted = |place: &usize| self.part_of_colour(cells[*place], colours[*place], 0.0) < 1.0;
        match (0..4).filter(full).collect::<Vec<_>>()[..] {
            [] => {}
            [place] => return Ok(Some(place)),
            _ => {
                return Err(
                    self.refused("its corner cells are not empty: this is one picture, not a cross of six faces")
                );
            }
        }
        let only = |found: Vec<usize>| if let [place] = found[..] { Some(place) } else { None };
        Ok(only((0..4).filter(differs).collect()).or_else(|| only((0..4).filter(dotted).collect())))
    }

    /// The texels of a cell but for its rim, which JPEG files smear with the cells beside it; of large cells a part.
    fn inner_texels(&self, cell: (usize, usize)) -> impl Iterator<Item = Vec3> + '_ {
        let side = self.side();
        let rim = side / 16;
        let count = LOOKED_AT.min(side - 2 * rim);
        let place = move |index: usize| rim + (2 * index + 1) * (side - 2 * rim) / (2 * count);
        (0..count * count).map(move |index| self.code(cell, place(index % count), place(index / count)))
    }

    /// The median colour of a cell.
    fn colour(&self, cell: (usize, usize)) -> Vec3 {
        let median = |channel: usize| {
            let mut values: Vec<f32> = self.inner_texels(cell).map(|texel| texel[channel]).collect();
            values.sort_by(f32::total_cmp);
            values[values.len() / 2]
        };
        Vec3::new(median(0), median(1), median(2))
    }

    /// The part of a cell that has a colour, up to a spread.
    fn part_of_colour(&self, cell: (usize, usize), colour: Vec3, spread: f32) -> f32 {
        let near = |texel: &Vec3| (*texel - colour).abs().max_element() <= spread;
        self.inner_texels(cell).filter(near).count() as f32 / self.inner_texels(cell).count() as f32
    }

    /// True if every cell continues those beside it: the step from one to the next is not larger than those to the texels
    /// behind, and somewhere there is something to continue. In a sheet of six faces some pair always gapes: in the most
    /// favourable order of the cells of 11 maps by 4 times the steps behind. In one picture the worst pair reaches 1.8
    /// times, unless an outline runs along the cut.
    fn is_one_picture(&self) -> bool {
        const CONTINUES: f32 = 2.5;
        const DETAIL: f32 = 1.0;
        const ROUNDING: f32 = 0.5;
        if self.side() < 2 {
            return false;
        }
        let last = self.side() - 1;
        // The median step between two lines of texels, each a cell and a place across the cut.
        let step = |one: ((usize, usize), usize), other: ((usize, usize), usize), down: bool| {
            let texel = |(cell, place): ((usize, usize), usize), along: usize| {
                if down { self.code(cell, along, place) } else { self.code(cell, place, along) }
            };
            let step = |along| (texel(one, along) - texel(other, along)).abs().element_sum() / 3.0;
            let mut steps: Vec<f32> = (0..=last).map(step).collect();
            *steps.select_nth_unstable_by(last / 2, f32::total_cmp).1
        };
        let cells = (0..self.rows).flat_map(|row| (0..self.columns).map(move |column| (column, row)));
        let beside =
            cells.clone().filter(|cell| cell.0 > 0).map(|(column, row)| ((column - 1, row), (column, row), false));
        let below = cells.filter(|cell| cell.1 > 0).map(|(column, row)| ((column, row - 1), (column, row), true));
        // The step across every cut, and the larger one of those to the texels behind on either side.
        let cut = |(one, other, down)| {
            let behind = step((one, last - 1), (one, last), down).max(step((other, 0), (other, 1), down));
            (step((one, last), (other, 0), down), behind)
        };
        let cuts: Vec<(f32, f32)> = beside.chain(below).map(cut).collect();
        cuts.iter().all(|&(across, behind)| across <= CONTINUES * behind.max(ROUNDING))
            && cuts.iter().any(|&(_, behind)| behind >= DETAIL)
    }

    fn refused(&self, why: &str) -> Error {
        let (width, height) = (self.picture.width(), self.picture.height());
        Error::new(format!("{width} x {height} pixels, and {why}"))
            .expected("six faces: a cross whose other cells have one colour, a strip or a sheet, or six files")
    }
}
