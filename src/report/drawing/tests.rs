use std::path::Path;

use super::compass::GRADIENT;
use super::*;
use crate::colour::ToneMap;
use crate::envmap::{CubeFilter, CubeMap, Face, LazyImage, Lookup, Orientation, Preset};
use crate::picture::{self, Picture};
use crate::validate::Edge;

const SIZE: usize = 64;

#[test]
fn repository_holds_the_compass_as_it_is_drawn() {
    for face in Face::ALL {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("envmaps/compass").join(face.name());
        let stored = picture::read(&file.with_extension("png")).unwrap();
        let drawn = draw_compass_face(face, stored.width());
        assert_eq!(stored.texels(), drawn.texels(), "{face:?}: run the example draw-compass");
    }
}

fn draw_compass() -> [Picture; 6] {
    Face::ALL.map(|face| draw_compass_face(face, SIZE))
}

fn map(faces: &[Picture; 6], lookup: Lookup) -> CubeMap {
    CubeMap::new(faces.clone().map(LazyImage::ready), lookup, CubeFilter::Nearest)
}

/// The mean step across a seam, of 255 linear display units of the drawing.
fn step(map: &CubeMap, edge: Edge) -> f32 {
    let free = Face::on_axis(3 - edge.first.axis() - edge.second.axis(), true).normal();
    let colour = |face: Face, neighbour: Face, texel: usize| {
        let along = (2 * texel + 1) as f32 / SIZE as f32 - 1.0;
        let direction = face.normal() + (1.0 - 1.0 / SIZE as f32) * neighbour.normal() + along * free;
        ToneMap::Clamp.display(map.sample(direction)) * 255.0
    };
    let step = |texel| colour(edge.first, edge.second, texel) - colour(edge.second, edge.first, texel);
    (0..SIZE).map(|texel| step(texel).abs().element_sum() / 3.0).sum::<f32>() / SIZE as f32
}

#[test]
fn the_seams_of_the_compass_close_through_the_lookups_of_downloads() {
    // Border texels of two faces lie a texel apart, in which the gradient changes along two axes of three.
    let gradient = 255.0 * GRADIENT * (2.0 / 3.0) / SIZE as f32;
    let compass = draw_compass();
    for preset in Preset::ALL {
        let map = map(&compass, preset.lookup());
        let worst = Edge::ALL.into_iter().map(|edge| step(&map, edge)).fold(0.0, f32::max);
        // `course` reads a y-up download under the wrong names, `exercise` is wrong on purpose.
        let closes = !matches!(preset, Preset::Course | Preset::Exercise);
        assert_eq!(worst < 1.5 * gradient, closes, "{}: {worst}, the gradient alone {gradient}", preset.name());
    }
}

#[test]
fn a_face_of_the_compass_fits_in_one_orientation_only() {
    let (compass, right) = (draw_compass(), Preset::Opengl.lookup());
    for face in Face::ALL {
        let maps = Orientation::ALL.map(|orientation| {
            let mut rows = *right.rows();
            rows[face.index()] = orientation.of_row(right.row(face));
            map(&compass, Lookup::new(rows, right.v_origin()).unwrap())
        });
        for edge in Edge::ALL.into_iter().filter(|edge| edge.touches(face)) {
            let [as_drawn, wrong @ ..] = maps.each_ref().map(|map| step(map, edge));
            let best = wrong.into_iter().fold(f32::INFINITY, f32::min);
            assert!(best > 10.0 * as_drawn, "{face:?} at {}: {best} against {as_drawn} as drawn", edge.name());
        }
    }
}

#[test]
fn text_is_as_wide_as_its_outline_and_anchored() {
    let width = text_width("skybox", 40.0);
    for (anchor, start) in [(Anchor::Start, 0.0), (Anchor::Middle, -0.5 * width), (Anchor::End, -width)] {
        let bounds = text_path("skybox", 40.0, anchor).unwrap().bounds();
        // Side bearings of s and x are a few hundredths of the size.
        assert!((bounds.left() - start).abs() < 3.0, "{anchor:?}: {bounds:?}");
        assert!((bounds.right() - start - width).abs() < 3.0, "{anchor:?}: {bounds:?}");
    }
    assert!(text_path(" ", 40.0, Anchor::Start).is_none());
}

#[test]
fn font_holds_printable_ascii() {
    for character in '!'..='~' {
        let outline = text_path(&character.to_string(), 20.0, Anchor::Start);
        assert!(outline.is_some(), "{character}");
        assert_ne!(outline, text_path("\u{fff0}", 20.0, Anchor::Start), "{character} is not in the font");
    }
}
