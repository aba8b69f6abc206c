//! The chart of `skycube stress`: error over bound against magnitude, both logarithmic, a panel a group, a curve a case.
//!
//! ```text
//!   10^3 |            ,'
//!        |          ,'            Above the red line the error is beyond its bound. Where the bound is 0 faults of a
//!      1 |--------,'------        million rays are drawn instead: any fault is on the line or above.
//!        |  ___,-'
//!  10^-8 |_________________       Errors of 0 lie on the floor.
//! ```

use super::chart_marks::{Marks, Rgb};
use super::drawing::Drawing;
use super::text_drawing::Anchor;
use crate::math::functions::decimal_logarithm;
use crate::stress::{Case, Group, Measurement};

const PANEL: [f32; 2] = [620.0, 420.0];
const COLUMNS: usize = 2;
/// Room beside the axes: left, top, right (for the names), bottom.
const MARGINS: [f32; 4] = [64.0, 44.0, 150.0, 34.0];
/// Exponents at the floor and the ceiling.
const FLOOR: f64 = -10.0;
const CEILING: f64 = 6.0;

const INK: Rgb = [40, 40, 48];
const GRID: Rgb = [224, 224, 230];
const BOUND: Rgb = [205, 40, 40];
/// Colours that stay apart (Okabe and Ito, Color Universal Design, 2008, and darker ones of the same hues).
const COLOURS: [Rgb; 15] = [
    [230, 159, 0],
    [86, 180, 233],
    [0, 158, 115],
    [0, 114, 178],
    [213, 94, 0],
    [204, 121, 167],
    [0, 0, 0],
    [140, 97, 0],
    [120, 120, 130],
    [0, 92, 67],
    [120, 60, 160],
    [160, 190, 40],
    [150, 60, 20],
    [40, 70, 110],
    [240, 130, 130],
];

/// The chart, ready to be written.
pub struct StressPlot(Marks);

/// One panel: where it is, and the exponents of the magnitudes at its left and right end.
struct Panel {
    left: f32,
    top: f32,
    exponents: [f64; 2],
}

impl StressPlot {
    /// Draws the cases.
    pub fn new(cases: &[Case]) -> Self {
        let members = |group: Group| cases.iter().filter(|case| case.subject.group == group).collect::<Vec<_>>();
        let groups: Vec<_> = Group::ALL.into_iter().map(|group| (group, members(group))).collect();
        let groups: Vec<_> = groups.into_iter().filter(|(_, members)| !members.is_empty()).collect();
        let (columns, rows) = (groups.len().min(COLUMNS), groups.len().div_ceil(COLUMNS));
        let mut marks = Marks::new(columns * PANEL[0] as usize, rows * PANEL[1] as usize);
        for (place, (group, members)) in groups.iter().enumerate() {
            let left = (place % COLUMNS) as f32 * PANEL[0] + MARGINS[0];
            let top = (place / COLUMNS) as f32 * PANEL[1] + MARGINS[1];
            Panel { left, top, exponents: exponents(members) }.draw(&mut marks, *group, members);
        }
        Self(marks)
    }

    /// As an SVG file.
    pub fn to_svg(&self) -> String {
        self.0.to_svg()
    }

    /// As a picture.
    pub fn to_drawing(&self) -> Drawing {
        self.0.to_drawing()
    }
}

/// The exponents of the smallest and the largest magnitude, a decade apart at least.
fn exponents(cases: &[&Case]) -> [f64; 2] {
    let steps = || cases.iter().flat_map(|case| &case.measurements).map(|step| decimal_logarithm(step.magnitude));
    let (least, most) = (steps().fold(f64::INFINITY, f64::min), steps().fold(f64::NEG_INFINITY, f64::max));
    [least.floor(), most.ceil().max(least.floor() + 1.0)]
}

impl Panel {
    fn size() -> (f32, f32) {
        (PANEL[0] - MARGINS[0] - MARGINS[2], PANEL[1] - MARGINS[1] - MARGINS[3])
    }

    fn x(&self, exponent: f64) -> f32 {
        let [least, most] = self.exponents;
        self.left + ((exponent - least) / (most - least)) as f32 * Self::size().0
    }

    fn y(&self, exponent: f64) -> f32 {
        self.top + ((CEILING - exponent.clamp(FLOOR, CEILING)) / (CEILING - FLOOR)) as f32 * Self::size().1
    }

    fn draw(&self, marks: &mut Marks, group: Group, cases: &[&Case]) {
        marks.text(group.title(), 18.0, (self.left, self.top - 20.0), Anchor::Start, INK);
        marks.text("error / bound, or faults per million", 11.0, (self.left, self.top - 6.0), Anchor::Start, INK);
        self.draw_grid(marks);
        for (number, case) in cases.iter().enumerate() {
            let colour = COLOURS[number % COLOURS.len()];
            let place = |step: &Measurement| {
                let error = over_bound(step.error, case.subject.bound);
                (self.x(decimal_logarithm(step.magnitude)), self.y(error))
            };
            marks.line(&case.measurements.iter().map(place).collect::<Vec<_>>(), 2.0, colour);
            let right = self.left + Self::size().0 + 12.0;
            let down = self.top + 8.0 + 18.0 * number as f32;
            marks.line(&[(right, down), (right + 18.0, down)], 3.0, colour);
            marks.text(case.subject.name, 12.0, (right + 24.0, down + 4.0), Anchor::Start, INK);
        }
    }

    fn draw_grid(&self, marks: &mut Marks) {
        let (width, height) = Self::size();
        let [least, most] = self.exponents;
        let stride = ((most - least) / 8.0).ceil().max(1.0);
        let mut exponent = (least / stride).ceil() * stride;
        while exponent <= most {
            let x = self.x(exponent);
            marks.line(&[(x, self.top), (x, self.top + height)], 1.0, GRID);
            marks.text(&format!("1e{exponent}"), 12.0, (x, self.top + height + 16.0), Anchor::Middle, INK);
            exponent += stride;
        }
        for exponent in (FLOOR as i32..=CEILING as i32).step_by(2) {
            let y = self.y(f64::from(exponent));
            let (colour, thickness) = if exponent == 0 { (BOUND, 2.0) } else { (GRID, 1.0) };
            marks.line(&[(self.left, y), (self.left + width, y)], thickness, colour);
            let label = if f64::from(exponent) == FLOOR { "0".to_owned() } else { format!("1e{exponent}") };
            marks.text(&label, 12.0, (self.left - 6.0, y + 4.0), Anchor::End, INK);
        }
    }
}

/// The exponent of the error over the bound; of faults of a million, if none are allowed.
fn over_bound(error: f64, bound: f64) -> f64 {
    if error == 0.0 {
        return FLOOR;
    }
    let error = if bound == 0.0 { error.max(1.0) } else { error / bound };
    decimal_logarithm(error)
}
