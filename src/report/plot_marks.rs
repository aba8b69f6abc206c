//! What tells the lines of a plot apart, in colour and without.

use plotters::prelude::*;

/// Colours that people with any kind of colour vision tell apart (Okabe and Ito, Color Universal Design, 2008), without
/// the yellow that white paper swallows.
const COLOURS: [RGBColor; 7] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(86, 180, 233),
    RGBColor(230, 159, 0),
    RGBColor(90, 90, 90),
];

/// The colour of what is no measurement.
pub(super) const GREY: RGBColor = RGBColor(120, 120, 120);

/// The colour of a line by its number. Colours repeat after seven lines, markers after four: together they never do.
pub(super) fn colour(index: usize) -> RGBColor {
    COLOURS[index % COLOURS.len()]
}

/// The line of a measurement.
pub(super) fn thick(colour: &RGBColor) -> ShapeStyle {
    colour.stroke_width(3)
}

/// The line of a guide.
pub(super) fn thin(colour: &RGBColor) -> ShapeStyle {
    colour.stroke_width(2)
}

/// The point of a line by its number at a place in pixels: disc, square, triangle or diamond.
pub(super) fn marker<DB: DrawingBackend>((x, y): (i32, i32), index: usize) -> DynElement<'static, DB, (i32, i32)> {
    let style = colour(index).filled();
    let corners: &[(i32, i32)] = match index % 4 {
        0 => return Circle::new((x, y), 7, style).into_dyn(),
        1 => &[(-6, -6), (6, -6), (6, 6), (-6, 6)],
        2 => &[(0, -9), (8, 6), (-8, 6)],
        _ => &[(0, -9), (9, 0), (0, 9), (-9, 0)],
    };
    Polygon::new(corners.iter().map(|(across, down)| (x + across, y + down)).collect::<Vec<_>>(), style).into_dyn()
}
