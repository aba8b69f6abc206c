//! The rendering loop: passes of samples over all tiles, on all cores.

use rayon::prelude::*;

use super::film::Film;
use super::layers::Layers;
use super::progress::Progress;
use super::ray_source::RaySource;
use super::tile::Tile;
use super::tile_film::{Keeps, TileFilm};
use crate::envmap::{Face, Lookup};
use crate::error::{Error, Result};
use crate::integrators::{Bundle, Integrator, Observer, RayCounts};
use crate::materials::MediumStack;
use crate::math::{DVec3, Ray, Vec3};
use crate::picture::Raster;
use crate::sampling::{FilteredPlace, PixelSampler, Sampling};
use crate::scene::{Plan, Scene};

/// A finished picture and what it cost.
#[derive(Debug, Clone, PartialEq)]
pub struct Rendering {
    /// Linear radiance.
    pub raster: Raster,
    pub counts: RayCounts,
    /// Samples that every pixel has; some may have more if the rendering was stopped.
    pub samples: u32,
    /// True if it was stopped before all samples were taken.
    pub stopped: bool,
    /// What was asked for beside the picture.
    pub layers: Option<Layers>,
    /// What was left out beyond the plan, after a look at the light itself; one sentence an item.
    pub left_out: Vec<String>,
}

/// A picture that grows by passes of samples. Every sample depends on the scene and its own number alone: the picture after
/// N samples is the same however they were split, on any number of threads.
pub struct Renderer<'a> {
    scene: &'a Scene,
    integrator: Integrator<'a>,
    source: RaySource<'a>,
    /// The glasses around the camera.
    media: MediumStack,
    sampling: Sampling,
    /// True if the only sample goes through the middle of the pixel.
    centred: bool,
    film: Film,
    samples: u32,
}

impl<'a> Renderer<'a> {
    /// A picture by the scene's camera. An error tells that a picture of the environment cannot be decoded.
    pub fn new(scene: &'a Scene, plan: &'a Plan) -> Result<Self> {
        Self::from_source(scene, plan, RaySource::Camera(&scene.camera), false)
    }

    /// The same with layers.
    pub fn with_layers(scene: &'a Scene, plan: &'a Plan) -> Result<Self> {
        Self::from_source(scene, plan, RaySource::Camera(&scene.camera), true)
    }

    fn from_source(scene: &'a Scene, plan: &'a Plan, source: RaySource<'a>, layers: bool) -> Result<Self> {
        let integrator = Integrator::new(scene, plan)?;
        let media = integrator.media_around(source.position());
        let sampling = scene.sampling;
        let keeps = Keeps { weights: !sampling.filter.is_even(), layers };
        let film = Film::new(source.size(), keeps);
        Ok(Self { scene, integrator, source, media, sampling, centred: scene.samples == 1, film, samples: 0 })
    }

    /// The same picture with noise of its own. Before the first sample.
    pub fn seeded(self, seed: u32) -> Self {
        Self { sampling: Sampling { seed, ..self.sampling }, ..self }
    }

    /// From now on every sample has a place of its own in the pixel, even if there is only one.
    pub fn scattered(self) -> Self {
        Self { centred: false, ..self }
    }

    /// Samples a pixel so far.
    pub fn samples(&self) -> u32 {
        self.samples
    }

    /// Adds samples to every pixel. After an error (a picture that cannot be decoded, or the rendering was cancelled)
    /// some tiles may have them and others not; each is right by itself.
    pub fn add_samples(&mut self, count: u32, progress: &dyn Progress) -> Result<()> {
        let last = self.samples + count;
        let Self { scene, integrator, source, media, sampling, centred, film, .. } = self;
        let pass = Pass { scene, integrator, source, media, sampling: *sampling, centred: *centred, last };
        // Room that is used for one tile after the other.
        let room = || (TileFilm::blank(), pass.integrator.bundle(pass.source.origin()));
        film.slots().into_par_iter().try_for_each_init(room, |(tile, bundle), mut slot| {
            slot.load(tile);
            pass.expose(tile, bundle, progress)?;
            slot.store(tile);
            Ok(())
        })?;
        self.samples = last;
        Ok(())
    }

    /// One sample of a pixel, watched; the picture does not change.
    pub fn watch<O: Observer>(&self, pixel: [usize; 2], index: u32, observer: &mut O) -> PixelSample {
        let Self { scene, integrator, source, media, sampling, centred, .. } = self;
        let pass = Pass { scene, integrator, source, media, sampling: *sampling, centred: *centred, last: index + 1 };
        let mut bundle = integrator.bundle(source.origin());
        let sampler = PixelSampler::chosen(*sampling, pixel[0], pixel[1], index);
        let place = pass.set_out(pixel, sampler, &mut bundle);
        integrator.trace_observed(&mut bundle, &mut RayCounts::default(), observer);
        let ray = *bundle.rays().next().expect("one ray set out");
        PixelSample { ray, place, radiance: bundle.radiances()[0] }
    }

    /// What a pixel shows after samples that were taken one by one, in their order: the same bits as in the picture.
    pub fn develop_pixel(&self, samples: &[PixelSample]) -> Vec3 {
        let mut film = TileFilm::of_pixel(Keeps { layers: false, ..self.film.keeps });
        samples.iter().for_each(|sample| film.add(0, &[sample.radiance], &[sample.place.weight]));
        film.samples = samples.len() as u32;
        film.pixel(0)
    }

    /// The picture so far.
    pub fn rendering(&self, stopped: bool) -> Rendering {
        Rendering {
            raster: self.film.develop(),
            counts: self.film.counts(),
            samples: self.film.samples(),
            stopped,
            layers: self.film.develop_layers(),
            left_out: self.integrator.left_out(),
        }
    }
}

/// One sample of a pixel.
#[derive(Debug, Clone, Copy)]
pub struct PixelSample {
    pub ray: Ray,
    /// The place in the pixel and what the sample counts.
    pub place: FilteredPlace,
    pub radiance: Vec3,
}

/// One pass over the picture.
struct Pass<'p, 'a> {
    scene: &'p Scene,
    integrator: &'p Integrator<'a>,
    source: &'p RaySource<'a>,
    media: &'p MediumStack,
    sampling: Sampling,
    centred: bool,
    /// Samples a pixel after the pass.
    last: u32,
}

impl Pass<'_, '_> {
    /// Adds the samples of the pass to a tile, all of them or none.
    fn expose(&self, film: &mut TileFilm, bundle: &mut Bundle, progress: &dyn Progress) -> Result<()> {
        let before = film.counts.traced();
        for row in 0..film.tile.height {
            self.expose_row(film, row, bundle, progress)?;
        }
        if let Some(error) = self.scene.environment.error() {
            return Err(error.clone());
        }
        let work = film.tile.area() as u64 * u64::from(self.last - film.samples);
        film.samples = self.last;
        progress.advance(work, film.counts.traced() - before);
        Ok(())
    }

    /// Adds the samples of the pass to a row of a tile. An error tells that it was cancelled.
    fn expose_row(&self, film: &mut TileFilm, row: usize, bundle: &mut Bundle, progress: &dyn Progress) -> Result<()> {
        let mut weights = [1.0; Tile::SIDE];
        let Tile { x, y, width, .. } = film.tile;
        for index in film.samples..self.last {
            // With many samples a row takes long: a cancelled tile is not finished.
            if progress.cancelled() {
                return Err(Error::new("cancelled: nothing was written"));
            }
            bundle.clear();
            let samplers = self.sampling.row(y + row, index);
            for (column, weight) in (x..x + width).zip(&mut weights) {
                *weight = self.set_out([column, y + row], samplers.pixel(column), bundle).weight;
            }
            self.integrator.trace(bundle, &mut film.counts);
            film.add(row * width, bundle.radiances(), &weights);
            if film.has_layers() {
                for (pixel, (ray, &radiance)) in (row * width..).zip(bundle.rays().zip(bundle.radiances())) {
                    film.add_to_layers(pixel, radiance, self.integrator.first_hit(ray));
                }
            }
        }
        Ok(())
    }

    /// Adds the camera ray of a sample to a bundle.
    #[inline(always)]
    fn set_out(&self, [x, y]: [usize; 2], mut sampler: PixelSampler, bundle: &mut Bundle) -> FilteredPlace {
        let (place, lens_place) = self.place(&mut sampler);
        let (origin, towards) = self.source.sight(x as f64 + place.across, y as f64 + place.down, lens_place);
        bundle.push(origin, towards, self.media, sampler);
        place
    }

    /// The places of a sample in its pixel and on the lens.
    #[inline(always)]
    fn place(&self, sampler: &mut PixelSampler) -> (FilteredPlace, [f64; 2]) {
        if self.centred && self.scene.camera.lens().is_none() {
            return (FilteredPlace { across: 0.5, down: 0.5, weight: 1.0 }, [0.5, 0.5]);
        }
        let [across, down, lens_x, lens_y] = sampler.four().map(f64::from);
        (self.sampling.filter.place([across, down]), [lens_x, lens_y])
    }
}

/// Renders all samples of the scene. An error tells that a picture of the environment could not be decoded, or that the
/// rendering was cancelled.
pub fn render(scene: &Scene, plan: &Plan, progress: &dyn Progress) -> Result<Rendering> {
    let mut renderer = Renderer::new(scene, plan)?;
    renderer.add_samples(scene.samples, progress)?;
    Ok(renderer.rendering(false))
}

/// Renders the image that `lookup` reads for a face, seen from a point: each texel looks along its own direction.
/// The inverse of [`CubeMap::sample`](crate::envmap::CubeMap::sample), from the same table.
pub fn bake_face(
    scene: &Scene,
    plan: &Plan,
    lookup: &Lookup,
    face: Face,
    size: usize,
    position: DVec3,
    progress: &dyn Progress,
) -> Result<Rendering> {
    let mut renderer = Renderer::from_source(scene, plan, RaySource::Face { lookup, face, size, position }, false)?;
    renderer.add_samples(scene.samples, progress)?;
    Ok(renderer.rendering(false))
}
