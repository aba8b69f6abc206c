//! Rasters enlarged and reduced by integer factors.

use super::Raster;
use crate::math::Vec3;

impl Raster {
    /// Every pixel as a square of `factor` pixels.
    pub fn enlarged(&self, factor: usize) -> Self {
        let (width, height) = (self.width() * factor, self.height() * factor);
        Self::from_function(width, height, |x, y| self.pixel(x / factor, y / factor))
    }

    /// The means of squares of `factor` pixels; what is left over to the right and below is cut off.
    pub fn reduced(&self, factor: usize) -> Self {
        let mean = |x: usize, y: usize| {
            let pixel = |index: usize| self.pixel(x * factor + index % factor, y * factor + index / factor);
            (0..factor * factor).map(pixel).sum::<Vec3>() / (factor * factor) as f32
        };
        Self::from_function(self.width() / factor, self.height() / factor, mean)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_enlarged_is_reduced_to_the_same() {
        let raster = Raster::from_function(5, 3, |x, y| Vec3::new(x as f32, y as f32, 1.0));
        assert_eq!(raster.enlarged(4).pixel(11, 7), raster.pixel(2, 1));
        assert_eq!(raster.enlarged(4).reduced(4), raster);
        assert_eq!((raster.reduced(2).width(), raster.reduced(2).pixel(1, 0)), (2, Vec3::new(2.5, 0.5, 1.0)));
    }
}
