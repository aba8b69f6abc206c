//! The field of view of the camera: the scale at which the shots show the images.
//!
//! ```text
//!     k = tan(angle / 2)      k < 1: the whole shot shows the middle k of an image
//!                             k > 1: the middle 1/k of the shot shows a whole image, the neighbours stand around it
//! ```
//!
//! So the estimate does not depend on the neighbours, which may be wrong, too.

use super::matching::{ImageLevels, Screen, best, candidates, mean_square, relief, variance};
use super::placement::{Placement, source_cells};
use super::thresholds::angle::{HARDLY_BETTER, NEARLY_UNIFORM, TELLING, TOLERANCE, WORTH_A_SEARCH};
use super::thresholds::shown::{MUCH_BETTER, UNEXPLAINED};
use super::thumbnail::{Codes, Middle};
use super::tone::Levels;
use crate::envmap::Face;
use crate::math::functions::{arctan2, exponential_f64};

/// Cells of the coarse search: wide enough to forgive aliasing, and cheap.
const COARSE: usize = 16;
/// Cells of the fine search.
const FINE: usize = 64;
/// Steps of the coarse search each way, and the logarithm of one: from 30 to 150 degrees.
const STEPS: i32 = 53;
const STEP: f64 = 0.025;
/// Steps of the fine search each way, and the logarithm of one.
pub(super) const FINE_STEPS: i32 = 24;
pub(super) const FINE_STEP: f64 = 0.004;

/// What is matched: shots and images as codes, and how each shot's face stands on the screen.
pub(super) struct Views<'a> {
    pub images: &'a [Codes; 6],
    pub shots: &'a [Codes; 6],
    pub screens: [Screen; 6],
    pub expected: [Face; 6],
}

/// The parts of images and shots that show the same at a scale.
pub(super) fn middles(scale: f64) -> (Middle, Middle) {
    (Middle(scale.min(1.0)), Middle((1.0 / scale).min(1.0)))
}

impl Views<'_> {
    pub fn levels(&self, scale: f64, side: usize) -> ImageLevels {
        let (of_image, _) = middles(scale);
        ImageLevels(Face::ALL.map(|image| Levels::new(&self.images[image.index()].reduced(of_image, side).values)))
    }

    pub fn shot(&self, index: usize, scale: f64, side: usize) -> Vec<f32> {
        self.shots[index].reduced(middles(scale).1, side).values
    }

    /// The scale of all shots; exactly 1 unless another one fits decisively better.
    pub fn scale(&self) -> f64 {
        let misfit_of_one = self.misfit(1.0);
        let mut coarse = 1.0;
        if misfit_of_one > WORTH_A_SEARCH {
            let scales = (-STEPS..=STEPS).map(|step| exponential_f64(STEP * f64::from(step)));
            let scored = scales.map(|scale| (scale, self.misfit(scale)));
            let (scale, misfit) = scored.min_by(|a, b| a.1.total_cmp(&b.1)).expect("there are scales");
            if misfit < MUCH_BETTER * misfit_of_one {
                coarse = scale;
            }
        }
        self.refined(coarse)
    }

    /// Mean over the shots of the share of their variance that no image explains, from 0 to 1.
    pub fn misfit(&self, scale: f64) -> f64 {
        let images = self.levels(scale, COARSE);
        let share = |index: usize| {
            let shot = self.shot(index, scale, COARSE);
            let candidates = candidates(&images, self.expected[index], &shot, self.screens[index], COARSE);
            (best(&candidates).error / (variance(&shot) + NEARLY_UNIFORM)).min(1.0)
        };
        (0..6).map(share).sum::<f64>() / 6.0
    }

    /// The best scale near a coarse one, the placements kept.
    fn refined(&self, coarse: f64) -> f64 {
        let placements = self.placements(coarse);
        if placements.is_empty() {
            return 1.0;
        }
        let scales = (-FINE_STEPS..=FINE_STEPS).map(|step| coarse * exponential_f64(FINE_STEP * f64::from(step)));
        let scored = scales.map(|scale| (scale, self.misfit_of(&placements, scale)));
        let (scale, misfit) = scored.min_by(|a, b| a.1.total_cmp(&b.1)).expect("there are scales");
        let narrowest = self.shots.iter().map(|shot| shot.width).min().unwrap_or(1);
        let misfit_of_one = self.misfit_of(&placements, 1.0);
        let is_one = (scale - 1.0).abs() < TOLERANCE.max(1.0 / narrowest as f64)
            || misfit > HARDLY_BETTER * misfit_of_one
            || misfit_of_one - misfit < TELLING;
        if is_one { 1.0 } else { scale }
    }

    /// The shots that show an image at a scale, and which.
    pub fn placements(&self, scale: f64) -> Vec<(usize, Placement)> {
        let images = self.levels(scale, COARSE);
        let placement = |index: usize| {
            let shot = self.shot(index, scale, COARSE);
            let candidates = candidates(&images, self.expected[index], &shot, self.screens[index], COARSE);
            let best = best(&candidates);
            (best.error < UNEXPLAINED * variance(&shot) && relief(&shot) > NEARLY_UNIFORM)
                .then_some((index, best.placement))
        };
        (0..6).filter_map(placement).collect()
    }

    pub fn misfit_of(&self, placements: &[(usize, Placement)], scale: f64) -> f64 {
        let (of_image, _) = middles(scale);
        let share = |&(index, placement): &(usize, Placement)| {
            let shot = self.shot(index, scale, FINE);
            let screen = self.screens[index];
            let image = &self.images[placement.image.index()];
            let source = source_cells(placement.orientation.after(screen.orientation), screen.v_origin, FINE);
            let fitted = Levels::new(&image.reduced(of_image, FINE).values).fitted(&source, &shot);
            mean_square(&fitted, &shot) / (variance(&shot) + NEARLY_UNIFORM)
        };
        placements.iter().map(share).sum::<f64>() / placements.len() as f64
    }
}

/// The angle of a scale in degrees.
pub(super) fn degrees(scale: f64) -> f64 {
    2.0 * arctan2(scale, 1.0) * 180.0 / std::f64::consts::PI
}
