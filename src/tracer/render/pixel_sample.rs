//! One pixel, watched sample by sample.

use super::film::{FilmRow, Keeps};
use super::renderer::Renderer;
use crate::integrators::{Observer, RayCounts};
use crate::math::{Ray, Vec3};
use crate::sampling::{FilteredPlace, PixelSampler};
use crate::scene::Wing;

/// One sample of a pixel.
#[derive(Debug, Clone, Copy)]
pub struct PixelSample {
    /// The camera ray, in the world.
    pub ray: Ray,
    /// The place in the pixel and what the sample counts.
    pub place: FilteredPlace,
    /// Linear RGB that came back along the ray.
    pub radiance: Vec3,
}

impl Renderer<'_> {
    /// The code that renders the picture.
    pub fn wing(&self) -> Wing {
        self.sampler.integrator.wing()
    }

    /// One sample of a pixel, watched as the textbook's code takes it; the picture does not change.
    pub fn watch<O: Observer>(&self, [x, y]: [usize; 2], index: u32, observer: &mut O) -> PixelSample {
        let mut sampler = PixelSampler::chosen(self.sampler.sampling, x, y, index);
        let (origin, towards, place) = self.sampler.set_out([x, y], &mut sampler);
        let ray = Ray::new(origin, towards.normalize());
        let radiance =
            self.sampler.integrator.watch(&ray, &self.sampler.media, &mut sampler, &mut RayCounts::default(), observer);
        PixelSample { ray, place, radiance }
    }

    /// What a pixel shows after samples that were taken one by one, in their order: the same bits as in the picture.
    pub fn develop_pixel(&self, samples: &[PixelSample]) -> Vec3 {
        let mut row = FilmRow::new(Keeps { layers: false, ..self.keeps });
        samples.iter().for_each(|sample| row.add(&[sample.radiance], &[sample.place.weight]));
        row.pixel(0)
    }
}
