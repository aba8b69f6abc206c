//! The axis shot of a map, without a scene.

use super::AxisShot;
use crate::envmap::{CubeMap, SignedAxis};
use crate::math::Vec3;
use crate::picture::Raster;

impl AxisShot {
    /// What is seen of a map, `size` pixels each way: directions in, colours out. Averaged over up to 4 x 4 samples a
    /// pixel where the images have more texels. Images that cannot be decoded are black; [`CubeMap::errors`] tells.
    pub fn of_map(self, map: &CubeMap, size: usize) -> Raster {
        let image = map.lookup().row(self.direction).image;
        let texels = map.picture(image).map_or(1, |picture| picture.width());
        let samples = texels.div_ceil(size).clamp(1, 4);
        let side = size * samples;
        let [forward, up, right] = [self.direction.signed_axis(), self.up, self.right()].map(SignedAxis::direction);
        let offset = |index: usize| (2 * index + 1) as f32 / side as f32 - 1.0;
        let mut seen = Raster::filled(side, side, Vec3::ZERO);
        for (y, row) in seen.pixels_mut().chunks_mut(side).enumerate() {
            for (x, colour) in row.iter_mut().enumerate() {
                *colour = map.sample(forward + right * offset(x) - up * offset(y));
            }
        }
        seen.reduced(samples)
    }
}
