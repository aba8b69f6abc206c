//! What a second of computing buys, as a plot: error against samples and against time, all axes logarithmic.
//!
//! ```text
//!   +------------------+  +------------------+
//!   | error            |  | error            |
//!   |   \_             |  |  \               |
//!   |     \__ samples  |  |   \__ seconds    |
//!   +------------------+  +------------------+
//!     -- variant   -- variant   - - reference
//! ```

use plotters::coord::Shift;
use plotters::coord::cartesian::Cartesian2d;
use plotters::coord::ranged1d::ValueFormatter;
use plotters::drawing::DrawingAreaErrorKind;
use plotters::prelude::*;

use super::canvas::blank;
use super::converge_report::ConvergeReport;
use super::converge_series::{Cost, Measure, Series, floors, series};
use super::drawing::Drawing;
use super::logarithmic_axis::LogarithmicAxis;
use super::plot_backend::{PlotBackend, SIZE_OVER_EM};
use super::plot_legend::{self, Entry};
use super::plot_marks::{GREY, colour, marker, thick, thin};
use crate::error::{Error, Result};

type Drawn<DB> = std::result::Result<(), DrawingAreaErrorKind<<DB as DrawingBackend>::ErrorType>>;
type Chart<'a, DB> = ChartContext<'a, DB, Cartesian2d<LogarithmicAxis, LogarithmicAxis>>;

/// Width of a plot and height of its panels, in pixels.
const WIDTH: u32 = 1600;
const PANEL_HEIGHT: u32 = 720;

/// Length of an em of the text along the axes, in pixels.
pub(super) const EM: f64 = 21.0;

/// The dashes of lines that are no measurements.
const DASH: (u32, u32) = (10, 8);

/// The plot as a picture.
pub fn draw_convergence(report: &ConvergeReport, measure: Measure) -> Result<Drawing> {
    let plot = Plot::new(report, measure);
    let (width, height) = plot.size();
    let mut pixmap = blank(width as usize, height as usize, tiny_skia::Color::WHITE);
    plot.draw(&PlotBackend(&mut pixmap).into_drawing_area()).map_err(|error| cannot_draw(&error))?;
    Ok(Drawing(pixmap))
}

/// The plot as SVG; its text takes the viewer's sans-serif font.
pub fn draw_convergence_svg(report: &ConvergeReport, measure: Measure) -> Result<String> {
    let plot = Plot::new(report, measure);
    let mut text = String::new();
    plot.draw(&SVGBackend::with_string(&mut text, plot.size()).into_drawing_area())
        .map_err(|error| cannot_draw(&error))?;
    Ok(text)
}

fn cannot_draw(error: &dyn std::error::Error) -> Error {
    Error::new(format!("cannot draw the plot: {error}"))
}

/// A style of text for `plotters`, from the length of an em.
pub(super) fn font(em: f64) -> TextStyle<'static> {
    ("sans-serif", em * SIZE_OVER_EM).into_text_style(&(0, 0))
}

/// What is drawn.
struct Plot<'a> {
    measure: Measure,
    title: String,
    series: Vec<Series<'a>>,
    floors: Vec<f64>,
}

impl<'a> Plot<'a> {
    fn new(report: &'a ConvergeReport, measure: Measure) -> Self {
        let names: Vec<&str> = report.scenes.iter().map(|scene| scene.name.as_str()).collect();
        let title = format!("What computing buys: {}", names.join(", "));
        Self { measure, title, series: series(report, measure), floors: floors(report, measure) }
    }

    fn size(&self) -> (u32, u32) {
        (WIDTH, PANEL_HEIGHT + plot_legend::height(&self.legend(), WIDTH))
    }

    fn legend(&self) -> Vec<Entry> {
        let lines = self.series.iter().enumerate();
        let mut entries: Vec<Entry> =
            lines.map(|(index, line)| Entry::Series { index, label: line.label.clone() }).collect();
        entries.push(Entry::Dashed { label: self.measure.law().1.to_owned(), style: thin(&GREY) });
        if !self.floors.is_empty() {
            entries.push(Entry::Dashed { label: "error of the reference".to_owned(), style: thick(&BLACK) });
        }
        entries
    }

    fn draw<DB: DrawingBackend>(&self, root: &DrawingArea<DB, Shift>) -> Drawn<DB> {
        root.fill(&WHITE)?;
        let (panels, legend) = root.titled(&self.title, font(1.25 * EM))?.split_vertically(PANEL_HEIGHT - 40);
        let (left, right) = panels.split_horizontally(WIDTH / 2);
        self.draw_panel(root, &left, Cost::Samples)?;
        self.draw_panel(root, &right, Cost::Seconds)?;
        plot_legend::draw(&self.legend(), &legend)?;
        root.present()
    }

    fn draw_panel<DB: DrawingBackend>(
        &self,
        root: &DrawingArea<DB, Shift>,
        area: &DrawingArea<DB, Shift>,
        cost: Cost,
    ) -> Drawn<DB> {
        let points = || self.series.iter().flat_map(|line| line.points(cost));
        let x_axis = LogarithmicAxis::around(points().map(|(x, _)| x));
        let x_axis = if cost == Cost::Samples { self.labelled_at_steps(x_axis) } else { x_axis };
        let y_axis = LogarithmicAxis::around(points().map(|(_, y)| y).chain(self.floors.iter().copied()));
        let (format_x, format_y) = (x_axis.clone(), y_axis.clone());
        let mut chart = ChartBuilder::on(area)
            .margin(16)
            .margin_right(28)
            .x_label_area_size(66)
            .y_label_area_size(112)
            .build_cartesian_2d(x_axis, y_axis)?;
        chart
            .configure_mesh()
            .x_desc(cost.title())
            .y_desc(self.measure.title())
            .axis_desc_style(font(1.1 * EM))
            .label_style(font(EM))
            .bold_line_style(RGBColor(205, 205, 205))
            .light_line_style(RGBColor(238, 238, 238))
            .x_label_formatter(&|value| format_x.format_ext(value))
            .y_label_formatter(&|value| format_y.format_ext(value))
            .draw()?;
        self.draw_guides(&mut chart, cost)?;
        self.draw_series(root, &mut chart, cost)
    }

    /// The samples axis is labelled where it was measured, if all steps find room.
    fn labelled_at_steps(&self, axis: LogarithmicAxis) -> LogarithmicAxis {
        let mut steps: Vec<f64> =
            self.series.iter().flat_map(|line| line.points(Cost::Samples)).map(|(x, _)| x).collect();
        steps.sort_by(f64::total_cmp);
        steps.dedup();
        let spread = steps.windows(2).all(|pair| pair[1] >= 2.0 * pair[0]);
        if spread && (1..=8).contains(&steps.len()) { axis.labelled_at(steps) } else { axis }
    }

    /// What is no measurement: the errors of the references, and how an error falls with independent samples, from the
    /// worst first point.
    fn draw_guides<DB: DrawingBackend>(&self, chart: &mut Chart<DB>, cost: Cost) -> Drawn<DB> {
        let (across, up) = (chart.x_range(), chart.y_range());
        for &floor in &self.floors {
            draw_dashed(chart, [(across.start, floor), (across.end, floor)], thick(&BLACK))?;
        }
        let first = self.series.iter().filter_map(|line| line.points(cost).first().copied());
        if let Some((x, y)) = first.max_by(|one, other| one.1.total_cmp(&other.1)) {
            let exponent = self.measure.law().0;
            let law = |x_end: f64| y * crate::math::functions::power_f64(x_end / x, exponent);
            // As far as the right or the lower border.
            let lowest = x * crate::math::functions::power_f64(up.start / y, 1.0 / exponent);
            let end = across.end.min(lowest);
            draw_dashed(chart, [(x, y), (end, law(end))], thin(&GREY))?;
        }
        Ok(())
    }

    fn draw_series<DB: DrawingBackend>(
        &self,
        root: &DrawingArea<DB, Shift>,
        chart: &mut Chart<DB>,
        cost: Cost,
    ) -> Drawn<DB> {
        for (index, line) in self.series.iter().enumerate() {
            let points = line.points(cost);
            chart.draw_series(LineSeries::new(points.iter().copied(), thick(&colour(index))))?;
            points.iter().try_for_each(|point| root.draw(&marker(chart.backend_coord(point), index)))?;
        }
        Ok(())
    }
}

fn draw_dashed<DB: DrawingBackend>(chart: &mut Chart<DB>, ends: [(f64, f64); 2], style: ShapeStyle) -> Drawn<DB> {
    chart.draw_series(DashedLineSeries::new(ends, DASH.0, DASH.1, style)).map(|_| ())
}
