//! The appearance of a shot that shows no image of the map in any orientation.

use super::thresholds::misfit::{ALL, ALL_BLACK, BLACK, LIKE_THE_FIRST, ONE_COLOUR, PART, REPEATED, SAME, VARIES};
use super::thumbnail::{Codes, Middle};

/// Cells of a side in which a shot is looked at.
const SIDE: usize = 64;

/// What the shot looks like.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Misfit {
    /// Every pixel is black.
    Black,
    /// A part is black, the rest is not.
    PartlyBlack,
    /// One colour that is not black.
    OneColour,
    /// Streaks: whole stretches of rows or columns repeat their neighbours.
    Smeared,
    /// Nothing changes along rows, or along columns.
    OneCoordinate,
    /// Its halves are the same.
    Repeated,
    /// A picture, but of nothing in the map.
    Unlike,
}

impl Misfit {
    pub(super) fn of(shot: &Codes) -> Self {
        let cells = shot.reduced(Middle(1.0), SIDE);
        let black = share_of_cells(&cells, |[red, green, blue]| red.max(green).max(blue) <= BLACK);
        if black > ALL_BLACK {
            return Self::Black;
        }
        if is_of_one_colour(&cells) {
            return Self::OneColour;
        }
        if black > PART {
            return Self::PartlyBlack;
        }
        if smeared(&cells, true) > ALL || smeared(&cells, false) > ALL {
            return Self::OneCoordinate;
        }
        if smeared(&cells, true) > PART || smeared(&cells, false) > PART {
            return Self::Smeared;
        }
        if halves_are_alike(&cells, true) || halves_are_alike(&cells, false) {
            return Self::Repeated;
        }
        Self::Unlike
    }
}

fn share_of_cells(cells: &Codes, holds: impl Fn([f32; 3]) -> bool) -> f64 {
    (0..SIDE * SIDE).filter(|&cell| holds(cells.at(cell))).count() as f64 / (SIDE * SIDE) as f64
}

fn is_of_one_colour(cells: &Codes) -> bool {
    let first = cells.at(0);
    share_of_cells(cells, |colour| difference(colour, first) < LIKE_THE_FIRST) > ONE_COLOUR
}

fn difference(one: [f32; 3], other: [f32; 3]) -> f32 {
    (0..3).map(|channel| (one[channel] - other[channel]).abs()).fold(0.0, f32::max)
}

fn cell(cells: &Codes, along: usize, across: usize, horizontally: bool) -> [f32; 3] {
    cells.at(if horizontally { across * SIDE + along } else { along * SIDE + across })
}

/// The share of steps from a column to the next (or row to the next) over which nothing changes, though the column itself
/// is not of one colour.
fn smeared(cells: &Codes, horizontally: bool) -> f64 {
    let unchanged = |along: usize| {
        (0..SIDE).all(|across| {
            let at = |along| cell(cells, along, across, horizontally);
            difference(at(along), at(along + 1)) < SAME
        })
    };
    let varies = |along: usize| {
        let first = cell(cells, along, 0, horizontally);
        (1..SIDE).any(|across| difference(first, cell(cells, along, across, horizontally)) > VARIES)
    };
    (0..SIDE - 1).filter(|&along| unchanged(along) && varies(along)).count() as f64 / (SIDE - 1) as f64
}

/// True if one half of the shot repeats the other, and the half is not of one colour.
fn halves_are_alike(cells: &Codes, horizontally: bool) -> bool {
    let (mut between, mut within) = (0.0, 0.0);
    for (along, across) in (0..SIDE / 2).flat_map(|along| (0..SIDE).map(move |across| (along, across))) {
        let at = |along| cell(cells, along, across, horizontally);
        between += difference(at(along), at(along + SIDE / 2));
        within += difference(at(along), at((along + SIDE / 4) % (SIDE / 2)));
    }
    within > 0.0 && between < REPEATED * within
}
