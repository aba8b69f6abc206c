//! FLIP: the visible difference between two alternating pictures (Andersson, Nilsson, Akenine-Moller, Oskarsson,
//! Astrom, Fairchild: FLIP, A Difference Evaluator for Alternating Images, 2020; the variant for displayed pictures).
//!
//! ```text
//!   colour:   what the eye resolves (contrast sensitivity) -> Lab, Hunt-adjusted -> HyAB distance -> [0, 1]
//!   features: edges and points of the lightness -> their difference -> [0, 1]
//!   FLIP = colour difference ^ (1 - feature difference)
//! ```

mod colour_difference;
mod colour_space;
mod contrast_sensitivity;
mod features;

pub use contrast_sensitivity::PIXELS_A_DEGREE;

use super::plane::check_sizes;
use crate::math::Vec3;
use crate::math::functions::power;
use crate::metrics::Plane;
use crate::picture::Raster;
use rayon::prelude::*;

/// The FLIP of every pixel, in `[0, 1]`: 0 for equal pictures. The pictures are cut off at 1, as displayed. Symmetric.
///
/// NaN where a pixel of either picture is not a number.
pub fn flip_map(picture: &Raster, reference: &Raster) -> Plane {
    check_sizes(picture, reference);
    let ((colours_a, features_a), (colours_b, features_b)) = rayon::join(|| seen(picture), || seen(reference));
    let value = |index: usize| {
        let colour = colour_difference::redistributed(colour_difference::distance(colours_a[index], colours_b[index]));
        let feature = features_a.difference(&features_b, index);
        let unknown = picture.pixels()[index].is_nan() || reference.pixels()[index].is_nan();
        if unknown { f32::NAN } else { power(colour, 1.0 - feature) }
    };
    let values = (0..colours_a.len()).into_par_iter().map(value).collect();
    Plane::new(picture.width(), picture.height(), values)
}

/// The colours the eye resolves (Hunt-adjusted Lab), and the features, of a picture.
fn seen(picture: &Raster) -> (Vec<Vec3>, features::Features) {
    let cut_off = |&colour: &Vec3| {
        let channel = |value: f32| if value > 0.0 { value.min(1.0) } else { 0.0 };
        colour_space::opponent_of_linear(Vec3::from_array(colour.to_array().map(channel)))
    };
    let opponents: Vec<Vec3> = picture.pixels().iter().map(cut_off).collect();
    let plane = |channel: usize| {
        Plane::new(picture.width(), picture.height(), opponents.iter().map(|colour| colour[channel]).collect())
    };
    let planes = [plane(0), plane(1), plane(2)];
    let lightness =
        Plane::new(picture.width(), picture.height(), planes[0].values().iter().map(|y| (y + 16.0) / 116.0).collect());
    let features = features::Features::of_lightness(&lightness);
    let [y, x, z] = contrast_sensitivity::resolved(&planes);
    let colour = |index: usize| {
        let opponent = Vec3::new(y.values()[index], x.values()[index], z.values()[index]);
        colour_space::hunt_adjusted(colour_space::lab_of_opponent(opponent))
    };
    ((0..opponents.len()).into_par_iter().map(colour).collect(), features)
}

#[cfg(test)]
mod tests;
