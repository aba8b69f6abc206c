//! Your picture, the expected one and a heat map of the difference, side by side.

use tiny_skia::{Color, Pixmap};

use super::super::drawing::{Anchor, Canvas, Drawing, blank, broken_text, dark, displayed, ground, pixmap_of};
use crate::colour::{ToneMap, magma_bytes};
use crate::compare::{Comparison, Region, View};
use crate::error::Result;
use crate::metrics::Plane;

const MARGIN: usize = 16;
const CAPTION: usize = 34;
/// The bar of the heat map and its numbers.
const LEGEND: usize = 52;
/// Size of the text of findings, and the distance of its lines.
const FINDING: f32 = 16.0;
const LINE: usize = 22;
/// Pictures narrower than this are enlarged by a whole factor,
const NARROWEST: usize = 200;
/// unless that makes them higher than this.
const HIGHEST: usize = 4000;

/// Draws the pictures as they are and, if anything was undone, once more with it undone. The worst region is framed in
/// the last row.
///
/// ```text
///   yours           expected    FLIP of every pixel
///   yours, undone   expected    FLIP of every pixel
///   legend
///   what was found
/// ```
pub fn draw_comparison(comparison: &Comparison) -> Drawing {
    let framed = (comparison.worst.flip > 0.0).then_some(comparison.worst);
    let before = &comparison.views.before;
    let drawing = match &comparison.views.after {
        None => draw_row(before, "yours", framed),
        Some(after) => draw_row(before, "yours", None).above(&draw_row(after, "yours, undone", framed)),
    };
    drawing.above(&draw_legend(drawing.width())).above(&draw_text(comparison, drawing.width()))
}

/// What the colours mean, and the sentences on what was found, in lines.
fn draw_text(comparison: &Comparison, width: usize) -> Drawing {
    let meaning = "FLIP: 0 no visible difference, 1 the largest; framed: the worst region";
    let sentences = comparison.findings.iter().map(|finding| finding.sentence.as_str());
    let wrapped = |sentence: &str| broken_text(sentence, FINDING, (width - 2 * MARGIN) as f32);
    let lines: Vec<String> = std::iter::once(meaning).chain(sentences).flat_map(wrapped).collect();
    let mut pixmap = blank(width, lines.len() * LINE + MARGIN, ground());
    let mut canvas = Canvas::new(pixmap.as_mut(), 1.0);
    for (index, line) in lines.iter().enumerate() {
        let place = (MARGIN as f32, (index * LINE) as f32 + FINDING);
        canvas.plain_text(line, FINDING, place, Anchor::Start, dark());
    }
    Drawing(pixmap)
}

/// PNG files of yours, the expected picture and the heat map of the difference.
pub(super) fn encoded_views(view: &View) -> Result<[Vec<u8>; 3]> {
    let [mine, expected] = [&view.mine, &view.expected].map(|raster| displayed(raster, ToneMap::Clamp));
    let encoded = [mine, expected, heat_map(&view.flip)].map(|pixmap| Drawing(pixmap).encode());
    let [mine, expected, difference] = encoded;
    Ok([mine?, expected?, difference?])
}

fn draw_row(view: &View, name: &str, framed: Option<Region>) -> Drawing {
    let factor = enlargement(view.mine.width(), view.mine.height());
    let [mine, expected] =
        [&view.mine, &view.expected].map(|raster| displayed(&raster.enlarged(factor), ToneMap::Clamp));
    let pictures = [mine, expected, heat_map(&view.flip.enlarged(factor))];
    let (width, height) = (pictures[0].width() as usize, pictures[0].height() as usize);
    let mut pixmap = blank(3 * width + 4 * MARGIN, height + CAPTION + MARGIN / 2, ground());
    let mut canvas = Canvas::new(pixmap.as_mut(), 1.0);
    let mean = format!("difference: FLIP {:.3} on average", view.metrics.flip);
    for (index, (picture, caption)) in pictures.iter().zip([name, "expected", &mean]).enumerate() {
        let left = MARGIN + index * (width + MARGIN);
        canvas.fitted_text(caption, 18.0, (left as f32, CAPTION as f32 - 11.0), width as f32);
        canvas.picture(picture, [left, CAPTION]);
        if let Some(region) = framed {
            draw_frame(&mut canvas, region, view, factor, left);
        }
    }
    Drawing(pixmap)
}

/// The whole factor by which a picture is drawn larger than it is.
fn enlargement(width: usize, height: usize) -> usize {
    NARROWEST.div_ceil(width.max(1)).min(HIGHEST / height.max(1)).max(1)
}

/// A light frame with a dark rim around a region.
fn draw_frame(canvas: &mut Canvas, region: Region, view: &View, factor: usize, left: usize) {
    let [x, y] = [region.x - view.corner[0], region.y - view.corner[1]].map(|place| (place * factor) as f32);
    let (width, height) = ((region.width * factor) as f32, (region.height * factor) as f32);
    let (x, y) = (x + left as f32, y + CAPTION as f32);
    let corners = [(x, y), (x + width, y), (x + width, y + height), (x, y + height), (x, y)];
    canvas.line(&corners, 4.0, dark());
    canvas.line(&corners, 2.0, Color::from_rgba8(60, 230, 255, 255));
}

fn draw_legend(width: usize) -> Drawing {
    let mut pixmap = blank(width, LEGEND, ground());
    let mut canvas = Canvas::new(pixmap.as_mut(), 1.0);
    let bar = (width - 2 * MARGIN).min(512);
    let left = width - MARGIN - bar;
    let colours = Plane::new(bar, 14, (0..14 * bar).map(|index| (index % bar) as f32 / (bar - 1) as f32).collect());
    canvas.picture(&heat_map(&colours), [left, 6]);
    for tenth in [0, 2, 4, 6, 8, 10] {
        let x = left as f32 + tenth as f32 / 10.0 * (bar - 1) as f32;
        let anchor = match tenth {
            0 => Anchor::Start,
            10 => Anchor::End,
            _ => Anchor::Middle,
        };
        let label = if tenth == 10 { "1".to_owned() } else { format!("0.{tenth}") };
        canvas.plain_text(&label, 16.0, (x, 40.0), anchor, dark());
    }
    Drawing(pixmap)
}

fn heat_map(plane: &Plane) -> Pixmap {
    pixmap_of(magma_bytes(plane.values()), [plane.width(), plane.height()])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn narrow_pictures_are_enlarged_and_high_ones_are_not_made_endless() {
        assert_eq!(
            [(8, 5), (200, 100), (1, 2000), (1, 9000)].map(|(width, height)| enlargement(width, height)),
            [25, 1, 2, 1]
        );
    }
}
