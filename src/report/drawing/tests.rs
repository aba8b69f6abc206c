use std::path::Path;

use super::compass::{FaceFrame, GRADIENT};
use super::cross_layout::CrossLayout;
use super::*;
use crate::colour::ToneMap;
use crate::envmap::{CubeFilter, CubeMap, Face, LazyImage, Preset, SignedAxis};
use crate::picture::{self, Picture};

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

/// Texels of a face along one border, turned to one of the eight orientations of a square picture (bit 0: u is `1 - u`,
/// bit 1: v is `1 - v`, bit 2: u and v change places). Texel `i` touches the border towards `neighbour`, at `(i + 0.5)
/// / SIZE` along the growing free axis.
fn border(faces: &[Picture], frame: &FaceFrame, neighbour: Face, orientation: usize) -> Vec<[f32; 3]> {
    let texel = |index: usize| {
        let along = 2.0 * (index as f32 + 0.5) / SIZE as f32 - 1.0;
        let towards = 1.0 - 1.0 / SIZE as f32;
        let free_axis = 3 - frame.face.axis() - neighbour.axis();
        let point =
            frame.face.normal() + towards * neighbour.normal() + along * Face::on_axis(free_axis, true).normal();
        let (s, t) = (point.dot(frame.right.normal()), point.dot(frame.below.normal()));
        let (s, t) = if orientation & 4 == 0 { (s, t) } else { (t, s) };
        let s = if orientation & 1 == 0 { s } else { -s };
        let t = if orientation & 2 == 0 { t } else { -t };
        let texel = |coordinate: f32| ((0.5 * coordinate + 0.5) * SIZE as f32) as usize;
        let picture = &faces[frame.face.index()];
        match picture.texels() {
            picture::Texels::Srgb8(bytes) => {
                let start = 3 * (texel(t) * picture.width() + texel(s));
                [0, 1, 2].map(|channel| f32::from(bytes[start + channel]))
            }
            picture::Texels::Linear(_) => unreachable!("the compass has 8 bits a channel"),
        }
    };
    (0..SIZE).map(texel).collect()
}

fn mean_step(left: &[[f32; 3]], right: &[[f32; 3]]) -> f32 {
    let differences = left.iter().flatten().zip(right.iter().flatten()).map(|(a, b)| (a - b).abs());
    differences.sum::<f32>() / (3 * left.len()) as f32
}

fn neighbours(face: Face) -> impl Iterator<Item = Face> {
    Face::ALL.into_iter().filter(move |other| other.axis() != face.axis())
}

#[test]
fn every_seam_of_the_compass_closes() {
    let faces = Face::ALL.map(|face| draw_compass_face(face, SIZE));
    for face in Face::ALL {
        for neighbour in neighbours(face) {
            let here = border(&faces, &FaceFrame::opengl(face), neighbour, 0);
            let there = border(&faces, &FaceFrame::opengl(neighbour), face, 0);
            // Border texels of two faces lie a texel apart, in which the gradient changes along two axes of three.
            let gradient = 255.0 * GRADIENT * (2.0 / 3.0) / SIZE as f32;
            let step = mean_step(&here, &there);
            assert!(step < 1.5 * gradient, "{face:?} to {neighbour:?}: {step}, the gradient alone {gradient}");
        }
    }
}

#[test]
fn a_face_of_the_compass_fits_in_one_orientation_only() {
    let faces = Face::ALL.map(|face| draw_compass_face(face, SIZE));
    for face in Face::ALL {
        for neighbour in neighbours(face) {
            let there = border(&faces, &FaceFrame::opengl(neighbour), face, 0);
            let step =
                |orientation| mean_step(&border(&faces, &FaceFrame::opengl(face), neighbour, orientation), &there);
            let wrong = (1..8).map(step).fold(f32::INFINITY, f32::min);
            assert!(wrong > 10.0 * step(0), "{face:?} to {neighbour:?}: {wrong} against {} as drawn", step(0));
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

/// The mean step across each seam through `CubeMap::sample`, of 255 linear display units of the drawing.
#[test]
fn the_seams_of_the_compass_close_through_the_lookups_of_downloads() {
    for preset in Preset::ALL {
        let images = Face::ALL.map(|face| LazyImage::ready(draw_compass_face(face, SIZE)));
        let map = CubeMap::new(images, preset.lookup(), CubeFilter::Nearest);
        let edges = CrossLayout::new(SignedAxis::POS_Z).edges;
        let worst = edges.iter().map(|edge| sampled_step(&map, edge.faces)).fold(0.0, f32::max);
        let gradient = 255.0 * GRADIENT * (2.0 / 3.0) / SIZE as f32;
        // `course` reads a y-up download under the wrong names, `exercise` is wrong on purpose.
        let closes = !matches!(preset, Preset::Course | Preset::Exercise);
        assert_eq!(worst < 1.5 * gradient, closes, "{}: {worst}, the gradient alone {gradient}", preset.name());
    }
}

fn sampled_step(map: &CubeMap, [one, other]: [Face; 2]) -> f32 {
    let free = Face::on_axis(3 - one.axis() - other.axis(), true).normal();
    let colour = |face: Face, neighbour: Face, texel: usize| {
        let along = (2 * texel + 1) as f32 / SIZE as f32 - 1.0;
        let direction = face.normal() + (1.0 - 1.0 / SIZE as f32) * neighbour.normal() + along * free;
        ToneMap::Clamp.display(map.sample(direction)) * 255.0
    };
    let step = |texel| (colour(one, other, texel) - colour(other, one, texel)).abs().element_sum() / 3.0;
    (0..SIZE).map(step).sum::<f32>() / SIZE as f32
}
