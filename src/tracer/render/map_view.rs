//! What an axis shot sees of a map, without a scene around it.

use super::AxisShot;
use crate::envmap::{CubeMap, SignedAxis};
use crate::picture::Raster;

impl AxisShot {
    /// What is seen of a map, `size` pixels each way: directions in, colours out. Averaged over up to 4 x 4 samples a
    /// pixel where the images have more texels. Images that cannot be decoded are black; [`CubeMap::errors`] tells.
    pub fn of_map(self, map: &CubeMap, size: usize) -> Raster {
        let image = map.lookup().row(self.direction).image;
        let texels = map.picture(image).map_or(1, |picture| picture.width());
        let samples = texels.div_ceil(size).clamp(1, 4);
        let count = (size * samples) as f32;
        let [forward, up, right] = [self.direction.signed_axis(), self.up, self.right()].map(SignedAxis::direction);
        let seen = Raster::from_function(size * samples, size * samples, |x, y| {
            let across = (2 * x + 1) as f32 / count - 1.0;
            let down = (2 * y + 1) as f32 / count - 1.0;
            map.sample(forward + right * across - up * down)
        });
        seen.reduced(samples)
    }
}
