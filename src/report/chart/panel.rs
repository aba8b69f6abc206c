//! Panels side by side, each with a grid and lines, and a legend below.

use super::super::drawing::{Anchor, text_width};
use super::axis::Axis;
use super::marks::{Chart, Mark, Rgb};

/// A diagram.
pub(in crate::report) struct Panel {
    pub title: String,
    pub x: Axis,
    pub y: Axis,
    pub lines: Vec<Line>,
    /// A range along x that is shaded.
    pub shaded: Option<[f64; 2]>,
}

/// A line of a diagram; points are values, not places.
pub(in crate::report) struct Line {
    /// What the legend calls it; not there if it is empty.
    pub label: String,
    pub style: Style,
    pub points: Vec<(f64, f64)>,
}

/// How a line is drawn.
#[derive(Debug, Clone, Copy)]
pub(in crate::report) enum Style {
    /// Measurements: the colour and the marker of a number.
    Series(usize),
    /// Dashed: what is not measured. The line of a bound,
    #[cfg_attr(not(feature = "stress"), allow(dead_code))]
    Bound,
    Floor,
    Law,
}

/// Colours that people with any kind of colour vision tell apart (Okabe and Ito, Color Universal Design, 2008), without
/// the yellow that white paper swallows. They repeat after seven lines, markers after four: together they never do.
const COLOURS: [Rgb; 7] =
    [[0, 114, 178], [213, 94, 0], [0, 158, 115], [204, 121, 167], [86, 180, 233], [230, 159, 0], [90, 90, 90]];
const BLACK: Rgb = [0, 0, 0];
const GREY: Rgb = [120, 120, 120];
const RED: Rgb = [205, 40, 40];
const BOLD_GRID: Rgb = [205, 205, 205];
const LIGHT_GRID: Rgb = [238, 238, 238];
const SHADE: Rgb = [226, 238, 247];

/// Distances in pixels: the whole chart, a panel, its margins, and the legend.
const WIDTH: f32 = 1600.0;
const TITLE: f32 = 40.0;
const PANEL_HEIGHT: f32 = 640.0;
const LEFT: f32 = 120.0;
const TOP: f32 = 44.0;
const RIGHT: f32 = 32.0;
const BOTTOM: f32 = 92.0;
const ROW: f32 = 34.0;
const SAMPLE: f32 = 60.0;
const GAP: f32 = 14.0;

/// Length of an em.
const EM: f32 = 21.0;

/// Draws two panels per row. They share the legend of the first, or each has its own.
pub(in crate::report) fn draw_panels(title: &str, panels: &[Panel], share_legend: bool) -> Chart {
    let mut chart = Chart { width: WIDTH as usize, height: 0, marks: Vec::new() };
    chart.text(title, 1.25 * EM, (WIDTH / 2.0, 30.0), Anchor::Middle);
    let mut top = TITLE;
    for row in panels.chunks(2) {
        let mut bottom = top + PANEL_HEIGHT;
        for (panel, left) in row.iter().zip([0.0, WIDTH / 2.0]) {
            Frame::large(panel, left, top).draw(&mut chart);
            if !share_legend {
                let legend = [left + LEFT, top + PANEL_HEIGHT, left + WIDTH / 2.0];
                bottom = bottom.max(chart.legend(&panel.lines, legend));
            }
        }
        top = bottom;
    }
    if let Some(first) = panels.first().filter(|_| share_legend) {
        top = chart.legend(&first.lines, [LEFT / 2.0, top, WIDTH]);
    }
    chart.height = top as usize;
    chart
}

/// Small multiples: the width and height of a panel, its margins, the height of a heading, and the length of an em.
const SMALL: [f32; 2] = [400.0, 280.0];
const SMALL_MARGINS: [f32; 4] = [86.0, 34.0, 14.0, 62.0];
const HEADING: f32 = 48.0;
const SMALL_EM: f32 = 14.0;

/// Draws small panels, four in a row, under the heading of their group. `note` says what they have in common.
#[cfg_attr(not(feature = "stress"), allow(dead_code))]
pub(in crate::report) fn draw_multiples(title: &str, note: &str, groups: &[(String, Vec<Panel>)]) -> Chart {
    let mut chart = Chart { width: WIDTH as usize, height: 0, marks: Vec::new() };
    chart.text(title, 1.25 * EM, (WIDTH / 2.0, 30.0), Anchor::Middle);
    chart.text(note, 0.9 * EM, (WIDTH / 2.0, 62.0), Anchor::Middle);
    let mut top = TITLE + 34.0;
    let [width, height] = SMALL;
    for (heading, panels) in groups {
        chart.text(heading, 1.1 * EM, (SMALL_MARGINS[0], top + 34.0), Anchor::Start);
        top += HEADING;
        for row in panels.chunks((WIDTH / width) as usize) {
            for (index, panel) in row.iter().enumerate() {
                Frame::small(panel, index as f32 * width, top).draw(&mut chart);
            }
            top += height;
        }
    }
    chart.height = top as usize;
    chart
}

/// A panel and where its axes lie.
struct Frame<'a> {
    panel: &'a Panel,
    left: f32,
    top: f32,
    right: f32,
    bottom: f32,
    em: f32,
}

impl<'a> Frame<'a> {
    fn large(panel: &'a Panel, left: f32, top: f32) -> Self {
        let (right, bottom) = (left + WIDTH / 2.0 - RIGHT, top + PANEL_HEIGHT - BOTTOM);
        Self { panel, left: left + LEFT, top: top + TOP, right, bottom, em: EM }
    }

    fn small(panel: &'a Panel, left: f32, top: f32) -> Self {
        let ([width, height], [before, above, behind, below]) = (SMALL, SMALL_MARGINS);
        let (right, bottom) = (left + width - behind, top + height - below);
        Self { panel, left: left + before, top: top + above, right, bottom, em: SMALL_EM }
    }

    fn x(&self, value: f64) -> f32 {
        self.left + self.panel.x.place(value) * (self.right - self.left)
    }

    fn y(&self, value: f64) -> f32 {
        self.bottom + self.panel.y.place(value) * (self.top - self.bottom)
    }

    fn draw(&self, chart: &mut Chart) {
        let Panel { title, x: across, y: up, lines, shaded } = self.panel;
        let em = self.em;
        chart.text(title, 1.1 * em, (self.left, self.top - 0.7 * em), Anchor::Start);
        if let Some(range) = shaded {
            let [from, to] = range.map(|end| self.x(end).clamp(self.left, self.right));
            let points = vec![(from, self.top), (to, self.top), (to, self.bottom), (from, self.bottom)];
            chart.marks.push(Mark::Area { points, colour: SHADE });
        }
        self.draw_grid(chart);
        let middle = ((self.left + self.right) / 2.0, (self.top + self.bottom) / 2.0);
        chart.text(across.title, 1.1 * em, (middle.0, self.bottom + 3.15 * em), Anchor::Middle);
        chart.upwards(up.title, 1.1 * em, (self.left - 4.3 * em, middle.1));
        // Guides lie under what was measured.
        let (series, guides): (Vec<&Line>, Vec<&Line>) =
            lines.iter().partition(|line| matches!(line.style, Style::Series(_)));
        for line in guides.into_iter().chain(series) {
            let places: Vec<(f32, f32)> = line.points.iter().map(|&(x, y)| (self.x(x), self.y(y))).collect();
            chart.styled(&places, line.style);
            places.iter().for_each(|&place| chart.marker(place, line.style));
        }
    }

    fn draw_grid(&self, chart: &mut Chart) {
        // Lines run through the middles of pixels: so they are sharp.
        let sharp = |place: f32| place.floor() + 0.5;
        let Self { left, top, right, bottom, .. } = *self;
        let Panel { x: across, y: up, .. } = self.panel;
        for (values, colour) in [(&across.lines, LIGHT_GRID), (&across.ticks, BOLD_GRID)] {
            let places = values.iter().map(|&value| sharp(self.x(value)));
            places.for_each(|x| chart.line(vec![(x, top), (x, bottom)], 1.0, colour));
        }
        for (values, colour) in [(&up.lines, LIGHT_GRID), (&up.ticks, BOLD_GRID)] {
            let places = values.iter().map(|&value| sharp(self.y(value)));
            places.for_each(|y| chart.line(vec![(left, y), (right, y)], 1.0, colour));
        }
        let (axis_x, axis_y) = (sharp(left), sharp(bottom));
        chart.line(vec![(axis_x, top), (axis_x, axis_y), (right, axis_y)], 1.0, BLACK);
        for &value in &across.ticks {
            chart.text(&label(value), self.em, (self.x(value), bottom + 1.45 * self.em), Anchor::Middle);
        }
        for &value in &up.ticks {
            chart.text(&label(value), self.em, (left - 10.0, self.y(value) + 0.36 * self.em), Anchor::End);
        }
    }
}

/// Plain digits where they are short.
fn label(value: f64) -> String {
    if (1e-4..1e6).contains(&value) { format!("{value}") } else { format!("{value:e}") }
}

impl Chart {
    fn line(&mut self, points: Vec<(f32, f32)>, width: f32, colour: Rgb) {
        self.marks.push(Mark::Line { points, width, dashed: false, colour });
    }

    fn text(&mut self, text: &str, size: f32, place: (f32, f32), anchor: Anchor) {
        self.marks.push(Mark::Text { text: text.to_owned(), size, place, turn: 0.0, anchor });
    }

    fn upwards(&mut self, text: &str, size: f32, place: (f32, f32)) {
        self.marks.push(Mark::Text { text: text.to_owned(), size, place, turn: 270.0, anchor: Anchor::Middle });
    }

    fn styled(&mut self, points: &[(f32, f32)], style: Style) {
        let (width, dashed, colour) = match style {
            Style::Series(number) => (3.0, false, COLOURS[number % COLOURS.len()]),
            Style::Bound => (2.0, true, RED),
            Style::Floor => (3.0, true, BLACK),
            Style::Law => (2.0, true, GREY),
        };
        if points.len() > 1 {
            self.marks.push(Mark::Line { points: points.to_vec(), width, dashed, colour });
        }
    }

    /// The point of a measurement: disc, square, triangle or diamond.
    fn marker(&mut self, (x, y): (f32, f32), style: Style) {
        let Style::Series(number) = style else { return };
        const CORNERS: [&[(f32, f32)]; 4] = [
            &[(-7.0, 0.0), (-5.0, -5.0), (0.0, -7.0), (5.0, -5.0), (7.0, 0.0), (5.0, 5.0), (0.0, 7.0), (-5.0, 5.0)],
            &[(-6.0, -6.0), (6.0, -6.0), (6.0, 6.0), (-6.0, 6.0)],
            &[(0.0, -9.0), (8.0, 6.0), (-8.0, 6.0)],
            &[(0.0, -9.0), (9.0, 0.0), (0.0, 9.0), (-9.0, 0.0)],
        ];
        let points = CORNERS[number % 4].iter().map(|(across, down)| (x + across, y + down)).collect();
        self.marks.push(Mark::Area { points, colour: COLOURS[number % COLOURS.len()] });
    }

    /// What the lines are, in columns from `left` to `right`. Returns where it ends.
    fn legend(&mut self, lines: &[Line], [left, top, right]: [f32; 3]) -> f32 {
        let entries: Vec<&Line> = lines.iter().filter(|line| !line.label.is_empty()).collect();
        let widest = entries.iter().map(|line| text_width(&line.label, EM)).fold(0.0, f32::max);
        // Room for fonts that are wider than ours.
        let column = SAMPLE + 3.0 * GAP + 1.1 * widest;
        let columns = (((right - left) / column) as usize).max(1);
        for (number, line) in entries.iter().enumerate() {
            let x = left + (number % columns) as f32 * column;
            let y = top + ROW / 2.0 + (number / columns) as f32 * ROW;
            self.styled(&[(x, y), (x + SAMPLE, y)], line.style);
            self.marker((x + SAMPLE / 2.0, y), line.style);
            self.text(&line.label, EM, (x + SAMPLE + GAP, y + 0.36 * EM), Anchor::Start);
        }
        top + (entries.len().div_ceil(columns) + 1) as f32 * ROW
    }
}
