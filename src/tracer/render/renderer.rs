//! The rendering loop: passes of samples over all rows, on all cores.

use rayon::prelude::*;

use super::film::{CoarseFilm, Film, FilmRow, Keeps};
use super::progress::{Progress, Uncounted};
use super::ray_source::RaySource;
use super::rendering::Rendering;
use super::watcher::watched;
use crate::error::{Error, Result};
use crate::integrators::{FirstHit, Integrator, RayCounts, RayStream};
use crate::materials::MediumStack;
use crate::math::{DVec3, Ray, Vec3};
use crate::sampling::{FilteredPlace, PixelSampler, Sampling};
use crate::scene::{Plan, Scene, finished};

/// A picture that grows by passes of samples. Every sample depends on the scene and its own number alone: the picture after
/// N samples is the same however they were split, on any number of threads.
pub struct Renderer<'a> {
    pub(super) sampler: SceneSampler<'a>,
    film: Film,
    pub(super) keeps: Keeps,
    samples: u32,
}

impl<'a> Renderer<'a> {
    /// A picture by the scene's camera. An error if a picture of the environment cannot be decoded.
    pub fn new(scene: &'a Scene, plan: &'a Plan) -> Result<Self> {
        Self::from_source(scene, plan, RaySource::Camera(&scene.camera), false)
    }

    /// The same with layers.
    pub fn with_layers(scene: &'a Scene, plan: &'a Plan) -> Result<Self> {
        Self::from_source(scene, plan, RaySource::Camera(&scene.camera), true)
    }

    pub(super) fn from_source(scene: &'a Scene, plan: &'a Plan, source: RaySource<'a>, layers: bool) -> Result<Self> {
        let integrator = Integrator::new(scene, plan)?;
        let media = integrator.media_around(source.position());
        let keeps = Keeps { weights: !scene.sampling.filter.is_even(), layers };
        let film = Film::new(source.size(), keeps);
        let centred = scene.samples == 1;
        let sampler = SceneSampler { scene, integrator, source, media, sampling: scene.sampling, centred, layers };
        Ok(Self { sampler, film, keeps, samples: 0 })
    }

    /// The same picture with other noise. Only before the first sample.
    pub fn seeded(mut self, seed: u32) -> Self {
        self.sampler.sampling.seed = seed;
        self
    }

    /// From now on every sample has a random place in the pixel, even a single one.
    pub fn scattered(mut self) -> Self {
        self.sampler.centred = false;
        self
    }

    /// Samples per pixel so far.
    pub fn samples(&self) -> u32 {
        self.samples
    }

    /// Adds samples to every pixel. After an error (a picture that cannot be decoded, or the rendering was cancelled)
    /// some rows may have them and others not; each is right by itself.
    pub fn add_samples(&mut self, count: u32, progress: &dyn Progress) -> Result<()> {
        let last = self.samples + count;
        self.sampler.expose(&mut self.film, &Pass { side: 1, last, progress })?;
        self.samples = last;
        Ok(())
    }

    /// Takes a sample of one pixel in each square with sides of `side` pixels. Rows without a sample then show it.
    pub fn add_coarse_sample(&mut self, side: usize, progress: &dyn Progress) -> Result<()> {
        let size = self.sampler.source.size().map(|length| length.div_ceil(side));
        let mut film = Film::new(size, self.keeps);
        self.sampler.expose(&mut film, &Pass { side, last: 1, progress: &Uncounted(progress) })?;
        self.film.coarse = Some(CoarseFilm { film: Box::new(film), side });
        progress.presentable();
        Ok(())
    }

    /// True if there is something to show for every pixel.
    pub fn is_presentable(&self) -> bool {
        self.film.coarse.is_some() || self.film.blank_rows() == 0
    }

    /// The picture so far.
    pub fn rendering(&self, stopped: bool) -> Rendering {
        Rendering {
            raster: self.film.develop(),
            counts: self.film.counts(),
            samples: self.film.samples(),
            coarse_rows: self.film.blank_rows(),
            stopped,
            layers: self.film.develop_layers(),
            left_out: self.sampler.integrator.left_out(),
            wing: self.sampler.integrator.wing(),
        }
    }
}

/// A pass over a film.
struct Pass<'p> {
    /// Each pixel of the film stands for a square of the picture with sides of this many pixels: for the one in its middle.
    side: usize,
    /// Samples that every pixel has in the end.
    last: u32,
    progress: &'p dyn Progress,
}

impl Pass<'_> {
    /// The column or row of the picture, which has `length` of them, for one of the film.
    #[inline]
    fn place(&self, position: usize, length: usize) -> usize {
        (position * self.side + self.side / 2).min(length - 1)
    }
}

/// Takes samples of pixels.
pub(super) struct SceneSampler<'a> {
    scene: &'a Scene,
    pub integrator: Integrator<'a>,
    source: RaySource<'a>,
    /// The glasses around the camera.
    pub media: MediumStack,
    pub sampling: Sampling,
    /// True if the only sample goes through the middle of the pixel.
    centred: bool,
    /// True if layers were requested.
    layers: bool,
}

/// Room for one sample of every pixel of a row, used again and again.
#[derive(Default)]
struct Room {
    radiances: Vec<Vec3>,
    weights: Vec<f64>,
    /// Empty unless layers were requested.
    first_hits: Vec<Option<FirstHit>>,
    /// Where rays are traced side by side.
    stream: Option<RayStream>,
}

impl Room {
    fn clear(&mut self) {
        self.radiances.clear();
        self.weights.clear();
        self.first_hits.clear();
    }
}

impl SceneSampler<'_> {
    fn room(&self) -> Room {
        let stream = self.integrator.side_by_side().map(|tracer| tracer.stream(self.source.origin()));
        Room { stream, ..Room::default() }
    }

    /// Adds samples to all pixels of a film.
    fn expose(&self, film: &mut Film, pass: &Pass) -> Result<()> {
        let rows = film.rows.par_iter_mut().enumerate();
        watched(&self.scene.shapes.stop, pass.progress, || {
            rows.try_for_each_init(|| self.room(), |room, (y, row)| self.expose_row(row, y, room, pass))
        })
    }

    /// Adds samples to all pixels of a row. An error if it is cancelled, or if a picture of the environment cannot be
    /// decoded: the whole row then lacks the sample that was begun.
    fn expose_row(&self, row: &mut FilmRow, y: usize, room: &mut Room, pass: &Pass) -> Result<()> {
        let (before, width) = (row.counts.traced(), self.source.size()[0]);
        let work = width as u64 * u64::from(pass.last.saturating_sub(row.samples));
        for index in row.samples..pass.last {
            let mut counts = row.counts;
            let sampled = finished(|| self.sample_row(y, index, room, &mut counts, pass));
            sampled.unwrap_or_else(|| Err(cancelled()))?;
            row.counts = counts;
            row.add(&room.radiances, &room.weights);
            if self.layers {
                row.add_to_layers(&room.radiances, &room.first_hits);
            }
        }
        pass.progress.advance(work, row.counts.traced() - before);
        Ok(())
    }

    /// Takes one sample of every pixel of a row.
    fn sample_row(&self, y: usize, index: u32, room: &mut Room, counts: &mut RayCounts, pass: &Pass) -> Result<()> {
        room.clear();
        let Room { radiances, weights, first_hits, stream } = room;
        let [width, height] = self.source.size();
        let (y, columns) = (pass.place(y, height), width.div_ceil(pass.side));
        let samplers = self.sampling.row(y, index);
        for first in (0..columns).step_by(RayStream::LENGTH) {
            // With many samples or pixels a row takes long: a cancelled one is not finished.
            if pass.progress.cancelled() {
                return Err(cancelled());
            }
            stream.iter_mut().for_each(RayStream::clear);
            for column in first..(first + RayStream::LENGTH).min(columns) {
                let x = pass.place(column, width);
                let mut sampler = samplers.pixel(x);
                let (origin, towards, place) = self.set_out([x, y], &mut sampler);
                weights.push(place.weight);
                match stream {
                    Some(stream) => stream.push(origin, towards, &self.media, sampler),
                    None => {
                        let ray = Ray::new(origin, towards.normalize());
                        radiances.push(self.integrator.radiance(&ray, &self.media, &mut sampler, counts));
                    }
                }
                if self.layers {
                    first_hits.push(FirstHit::of(self.scene, &Ray::new(origin, towards.normalize())));
                }
            }
            if let (Some(tracer), Some(stream)) = (self.integrator.side_by_side(), stream.as_mut()) {
                tracer.trace(stream, counts);
                radiances.extend_from_slice(stream.radiances());
            }
        }
        self.scene.environment.error().map_or(Ok(()), |error| Err(error.clone()))
    }

    /// Origin and direction, of any length, of the camera ray of a sample, and its place in the pixel.
    #[inline(always)]
    pub fn set_out(&self, [x, y]: [usize; 2], sampler: &mut PixelSampler) -> (DVec3, DVec3, FilteredPlace) {
        let (place, lens_place) = if self.centred && self.scene.camera.lens().is_none() {
            (FilteredPlace { across: 0.5, down: 0.5, weight: 1.0 }, [0.5, 0.5])
        } else {
            let [across, down, lens_x, lens_y] = sampler.four().map(f64::from);
            (self.sampling.filter.place([across, down]), [lens_x, lens_y])
        };
        let (origin, towards) = self.source.sight(x as f64 + place.across, y as f64 + place.down, lens_place);
        (origin, towards, place)
    }
}

fn cancelled() -> Error {
    Error::new("cancelled: nothing was written")
}

/// Renders all samples of the scene. An error if a picture of the environment cannot be decoded, or if the
/// rendering is cancelled.
pub fn render(scene: &Scene, plan: &Plan, progress: &dyn Progress) -> Result<Rendering> {
    let mut renderer = Renderer::new(scene, plan)?;
    renderer.add_samples(scene.samples, progress)?;
    Ok(renderer.rendering(false))
}
