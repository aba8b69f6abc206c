//! Where two pictures differ most.

use serde::Serialize;

use super::finding::{Finding, Kind};
use crate::digits::digits;
use crate::metrics::Plane;

/// A box of pixels, and how it differs.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Region {
    /// Left column and top row, from the top left corner of the expected picture.
    pub x: usize,
    /// Top row.
    pub y: usize,
    /// Columns of pixels.
    pub width: usize,
    /// Rows of pixels.
    pub height: usize,
    /// Mean FLIP inside.
    #[serde(serialize_with = "digits::<4, _>")]
    pub flip: f64,
    /// Mean FLIP outside.
    #[serde(serialize_with = "digits::<4, _>")]
    pub flip_outside: f64,
    /// Share of all FLIP that lies inside, `[0, 1]`.
    #[serde(serialize_with = "digits::<4, _>")]
    pub share: f64,
}

/// Side of the cells that the picture is divided into.
const CELL: usize = 8;
/// Cells this bright, relative to the brightest, belong to its region.
const BELONGS: f64 = 0.4;
/// The same where the box of those would hide that its middle is clearly different.
const BELONGS_TIGHTLY: f64 = 0.75;
/// Mean FLIP of a region that is clearly different.
pub(super) const PLAIN: f64 = 0.3;
/// A region stands out if it holds this share of the difference, and differs this much.
const STANDS_OUT: (f64, f64) = (0.4, 0.15);
/// A region that holds this share of the difference is where the pictures differ.
const MOST: f64 = 0.4;

/// What is left is mostly in one place.
#[derive(Serialize)]
#[serde(transparent)]
struct OnePlace {
    region: Region,
}

impl Kind for OnePlace {
    const NAME: &'static str = "region";

    fn sentence(&self) -> String {
        let Region { x, y, width, height, flip, flip_outside, share } = self.region;
        let place = format!("columns {x} to {}, rows {y} to {}", x + width - 1, y + height - 1);
        let percent = 100.0 * share;
        if share >= MOST {
            return format!("It differs in one place: {place} hold {percent:.0} % of the difference.");
        }
        format!(
            "It is clearly different in {place}: FLIP {flip:.2} there, {flip_outside:.3} elsewhere ({percent:.0} % of the \
             difference)."
        )
    }
}

pub(super) fn finding(region: Region) -> Finding {
    OnePlace { region }.into()
}

impl Region {
    pub(super) fn stands_out(&self) -> bool {
        let (share, flip) = STANDS_OUT;
        self.share >= share && self.flip >= flip && self.flip >= 4.0 * self.flip_outside
    }
}

/// The worst region: the cells around the worst one that differ nearly as much and hang together, as a box.
pub(super) fn worst(map: &Plane) -> Region {
    let (smooth, columns) = smoothed_cells(map);
    let mut peak = 0;
    for index in 1..smooth.len() {
        if smooth[index] > smooth[peak] {
            peak = index;
        }
    }
    let boxed = |belongs: f64| {
        let [left, top, right, bottom] = component(&smooth, columns, peak, belongs);
        let (xs, ys) = (left * CELL..(right * CELL).min(map.width()), top * CELL..(bottom * CELL).min(map.height()));
        described(map, xs, ys)
    };
    let region = boxed(BELONGS);
    if region.flip < PLAIN && smooth[peak] >= PLAIN { boxed(BELONGS_TIGHTLY) } else { region }
}

/// The box around all cells that differ nearly as much as the worst one. `corner` is where the map begins in the expected
/// picture.
pub(super) fn around_all(map: &Plane, corner: [usize; 2]) -> Region {
    let (cells, columns) = smoothed_cells(map);
    let peak = cells.iter().copied().fold(0.0, f64::max);
    let belongs: Vec<usize> = (0..cells.len()).filter(|&index| cells[index] >= BELONGS * peak).collect();
    let range = |place: &dyn Fn(usize) -> usize, length: usize| {
        let places = || belongs.iter().map(|&index| place(index));
        places().min().unwrap_or(0) * CELL..((places().max().unwrap_or(0) + 1) * CELL).min(length)
    };
    let region =
        described(map, range(&|index| index % columns, map.width()), range(&|index| index / columns, map.height()));
    Region { x: region.x + corner[0], y: region.y + corner[1], ..region }
}

/// The mean FLIP of every cell and its neighbours, and the number of cells in a row.
fn smoothed_cells(map: &Plane) -> (Vec<f64>, usize) {
    let (columns, rows) = (map.width().div_ceil(CELL), map.height().div_ceil(CELL));
    let range = |cell: usize, length: usize| cell * CELL..((cell + 1) * CELL).min(length);
    let cell_mean = |column: usize, row: usize| mean_within(map, range(column, map.width()), range(row, map.height()));
    let cells: Vec<f64> = (0..columns * rows).map(|index| cell_mean(index % columns, index / columns)).collect();
    (smoothed(&cells, columns, rows), columns)
}

fn described(map: &Plane, xs: std::ops::Range<usize>, ys: std::ops::Range<usize>) -> Region {
    let inside = mean_within(map, xs.clone(), ys.clone());
    let (area, all) = ((xs.len() * ys.len()) as f64, (map.width() * map.height()) as f64);
    let total = map.mean() * all;
    let outside = if all > area { ((total - inside * area) / (all - area)).max(0.0) } else { 0.0 };
    let share = if total > 0.0 { (inside * area / total).min(1.0) } else { 0.0 };
    Region { x: xs.start, y: ys.start, width: xs.len(), height: ys.len(), flip: inside, flip_outside: outside, share }
}

fn mean_within(map: &Plane, xs: std::ops::Range<usize>, ys: std::ops::Range<usize>) -> f64 {
    let count = xs.len() * ys.len();
    let rows = ys.map(|y| xs.clone().map(|x| f64::from(map.at(x, y))).sum::<f64>());
    rows.sum::<f64>() / count.max(1) as f64
}

/// Every cell with its eight neighbours, so that one firefly is not a region.
fn smoothed(cells: &[f64], columns: usize, rows: usize) -> Vec<f64> {
    let around = |cell: usize, count: usize| cell.saturating_sub(1)..(cell + 2).min(count);
    let mean = |index: usize| {
        let (xs, ys) = (around(index % columns, columns), around(index / columns, rows));
        let count = xs.len() * ys.len();
        ys.flat_map(|y| xs.clone().map(move |x| cells[y * columns + x])).sum::<f64>() / count as f64
    };
    (0..cells.len()).map(mean).collect()
}

/// Left, top, right and bottom (the latter exclusive) of the cells that hang together with the peak.
fn component(cells: &[f64], columns: usize, peak: usize, belongs: f64) -> [usize; 4] {
    let threshold = belongs * cells[peak];
    let mut visited = vec![false; cells.len()];
    let mut waiting = vec![peak];
    visited[peak] = true;
    let (mut left, mut top) = (peak % columns, peak / columns);
    let (mut right, mut bottom) = (left + 1, top + 1);
    while let Some(index) = waiting.pop() {
        let (x, y) = (index % columns, index / columns);
        (left, top, right, bottom) = (left.min(x), top.min(y), right.max(x + 1), bottom.max(y + 1));
        let beside = [
            (x > 0).then(|| index - 1),
            (x + 1 < columns).then(|| index + 1),
            (y > 0).then(|| index - columns),
            Some(index + columns).filter(|&below| below < cells.len()),
        ];
        for next in beside.into_iter().flatten() {
            if !visited[next] && cells[next] >= threshold && cells[next] > 0.0 {
                visited[next] = true;
                waiting.push(next);
            }
        }
    }
    [left, top, right, bottom]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_patch_is_framed_and_a_single_pixel_is_not_preferred() {
        let (width, height) = (160, 120);
        let mut values = vec![0.01; width * height];
        for y in 40..64 {
            for x in 80..120 {
                values[y * width + x] = 0.5;
            }
        }
        values[5 * width + 5] = 1.0;
        let region = worst(&Plane::new(width, height, values));
        assert!(region.x <= 80 && region.x >= 64 && region.y <= 40 && region.y >= 24, "{region:?}");
        assert!(region.x + region.width >= 120 && region.y + region.height >= 64, "{region:?}");
        assert!(region.share > 0.6 && region.flip > 10.0 * region.flip_outside, "{region:?}");
    }
}
