//! A sheet of many maps: each unfolded, small, with its name and its verdict.

use tiny_skia::Color;

use super::canvas::{Canvas, blank, dark, ground};
use super::finished::Drawing;
use super::text_drawing::{Anchor, text_width};
use super::verdict_colour::verdict_colour;
use crate::validate::Verdict;

const MARGIN: usize = 16;
/// Name and verdict below each map.
const CAPTION: usize = 56;
const TEXT: f32 = 17.0;

/// A map on the sheet.
pub struct MapThumbnail {
    /// As the user calls it.
    pub name: String,
    /// None if the map could not be checked.
    pub verdict: Option<Verdict>,
    /// The verdict, and what to do.
    pub sentence: String,
    /// The unfolded map; all of one size, none if it could not be checked.
    pub cross: Option<Drawing>,
}

/// Draws the maps in rows, about as wide as high.
pub fn draw_map_sheet(maps: &[MapThumbnail]) -> Drawing {
    let sizes = maps.iter().filter_map(|map| map.cross.as_ref()).map(|cross| [cross.width(), cross.height()]);
    let [width, height] = sizes.fold([256, 192], |[w, h], [width, height]| [w.max(width), h.max(height)]);
    let (step_x, step_y) = (width + MARGIN, height + CAPTION + MARGIN);
    let columns = (1..=maps.len().max(1)).find(|&columns| columns * step_x >= maps.len().div_ceil(columns) * step_y);
    let columns = columns.unwrap_or(maps.len()).max(1);
    let rows = maps.len().div_ceil(columns);
    let mut pixmap = blank(columns * step_x + MARGIN, rows * step_y + MARGIN, ground());
    let mut canvas = Canvas::new(pixmap.as_mut(), 1.0);
    for (index, map) in maps.iter().enumerate() {
        let place = [MARGIN + index % columns * step_x, MARGIN + index / columns * step_y];
        draw_map(&mut canvas, map, place, [width, height]);
    }
    Drawing(pixmap)
}

fn draw_map(canvas: &mut Canvas, map: &MapThumbnail, [left, top]: [usize; 2], [width, height]: [usize; 2]) {
    if let Some(cross) = &map.cross {
        canvas.picture(&cross.0, [left, top]);
    }
    let (x, y, wide) = (left as f32, (top + height) as f32, width as f32);
    // A bar in the colour of the verdict: the eye finds the broken ones before it reads.
    let colour = map.verdict.map_or(Color::BLACK, verdict_colour);
    canvas.line(&[(x, y + 4.0), (x + wide, y + 4.0)], 6.0, colour);
    canvas.plain_text(&cut(&map.name, wide, true), TEXT, (x, y + 27.0), Anchor::Start, dark());
    canvas.plain_text(&cut(&map.sentence, wide, false), TEXT, (x, y + 49.0), Anchor::Start, dark());
}

/// The text as far as it fits, with an ellipsis at its beginning or end for what is left out.
fn cut(text: &str, width: f32, at_beginning: bool) -> String {
    let mut letters: std::collections::VecDeque<char> = text.chars().collect();
    let shown = |letters: &std::collections::VecDeque<char>| -> String {
        let kept: String = letters.iter().collect();
        match letters.len() == text.chars().count() {
            true => kept,
            false if at_beginning => format!("…{kept}"),
            false => format!("{kept}…"),
        }
    };
    while text_width(&shown(&letters), TEXT) > width && !letters.is_empty() {
        if at_beginning {
            letters.pop_front()
        } else {
            letters.pop_back()
        };
    }
    shown(&letters)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_texts_are_cut_with_an_ellipsis() {
        assert_eq!(cut("short", 200.0, true), "short");
        let (name, sentence) = (cut(&"a/".repeat(80), 200.0, true), cut(&"b ".repeat(80), 200.0, false));
        assert!(name.starts_with('…') && sentence.ends_with('…'), "{name} {sentence}");
        assert!(text_width(&name, TEXT) <= 200.0 && text_width(&sentence, TEXT) <= 200.0);
    }

    #[test]
    fn a_sheet_has_room_for_every_map_and_a_bar_in_the_colour_of_its_verdict() {
        let cross = || Some(Drawing(blank(240, 180, Color::WHITE)));
        let map = |verdict: Option<Verdict>, cross| MapThumbnail {
            name: "a map".to_owned(),
            verdict,
            sentence: "a verdict".to_owned(),
            cross,
        };
        let maps = [map(Some(Verdict::Broken), cross()), map(Some(Verdict::Fits), cross()), map(None, None)];
        let sheet = draw_map_sheet(&maps);
        let bar = |column: usize, row: usize| {
            let (x, y) = (MARGIN + column * (256 + MARGIN) + 100, MARGIN + row * (192 + CAPTION + MARGIN) + 196);
            let bytes = sheet.bytes();
            let start = 3 * (y * sheet.width() + x);
            [bytes[start], bytes[start + 1], bytes[start + 2]]
        };
        let colour = |verdict| {
            let colour = verdict_colour(verdict).to_color_u8();
            [colour.red(), colour.green(), colour.blue()]
        };
        assert_eq!((sheet.width(), sheet.height()), (2 * 272 + MARGIN, 2 * 264 + MARGIN));
        assert_eq!([bar(0, 0), bar(1, 0)], [colour(Verdict::Broken), colour(Verdict::Fits)]);
        assert_eq!(bar(0, 1), [0, 0, 0]);
    }
}
