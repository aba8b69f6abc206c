//! The rendering loop.

use rayon::prelude::*;

use super::progress::Progress;
use crate::envmap::{Face, Lookup};
use crate::error::{Error, Result};
use crate::integrators::{RayCounts, media_around, radiance};
use crate::materials::MediumStack;
use crate::math::{DVec3, Ray, Vec3};
use crate::picture::Raster;
use crate::sampling::PixelSampler;
use crate::scene::{Plan, Scene};

/// Side of a tile in pixels: small enough to balance the load, large enough to keep rays coherent.
const TILE: usize = 16;

/// A finished picture and what it cost.
#[derive(Debug, Clone, PartialEq)]
pub struct Rendering {
    /// Linear radiance.
    pub raster: Raster,
    pub counts: RayCounts,
}

/// Where a picture is taken from, and its width and height in pixels.
struct View {
    position: DVec3,
    size: [usize; 2],
}

/// A part of the picture.
struct Tile {
    x: usize,
    y: usize,
    width: usize,
    height: usize,
}

/// Renders the scene on the threads of the current pool. Every pixel depends on the scene alone, so the result is
/// the same on any number of threads.
///
/// An error tells that a picture of the environment could not be decoded, or that the rendering was cancelled.
pub fn render(scene: &Scene, plan: &Plan, progress: &impl Progress) -> Result<Rendering> {
    let camera = &scene.camera;
    let view = View { position: camera.position(), size: camera.size() };
    render_rays(scene, plan, view, |x, y| camera.ray(x, y), progress)
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
    progress: &impl Progress,
) -> Result<Rendering> {
    let ray = |x: f64, y: f64| {
        let direction = lookup.image_direction(face, x / size as f64, y / size as f64);
        Ray::new(position, direction.normalize())
    };
    render_rays(scene, plan, View { position, size: [size, size] }, ray, progress)
}

/// Renders a picture whose places in pixels, from the top left corner, look along given rays.
fn render_rays(
    scene: &Scene,
    plan: &Plan,
    view: View,
    ray_through: impl Fn(f64, f64) -> Ray + Sync,
    progress: &impl Progress,
) -> Result<Rendering> {
    let [width, height] = view.size;
    let media = media_around(scene, plan, view.position);
    let tiles = tiles(width, height);
    let finished: Vec<(Vec<Vec3>, RayCounts)> = tiles
        .par_iter()
        .map(|tile| {
            if progress.cancelled() {
                return Err(cancelled());
            }
            let pixel = |x, y, counts: &mut RayCounts| render_pixel(scene, plan, [x, y], &media, &ray_through, counts);
            let (pixels, counts) = render_tile(tile, pixel, progress);
            if progress.cancelled() {
                return Err(cancelled());
            }
            if let Some(error) = scene.environment.error() {
                return Err(error.clone());
            }
            progress.advance(pixels.len() as u64, counts.traced());
            Ok((pixels, counts))
        })
        .collect::<Result<_>>()?;
    let mut raster = Raster::filled(width, height, Vec3::ZERO);
    let mut counts = RayCounts::default();
    for (tile, (pixels, tile_counts)) in tiles.iter().zip(finished) {
        for (row, line) in pixels.chunks_exact(tile.width).enumerate() {
            let start = (tile.y + row) * width + tile.x;
            raster.pixels_mut()[start..start + tile.width].copy_from_slice(line);
        }
        counts += tile_counts;
    }
    Ok(Rendering { raster, counts })
}

fn cancelled() -> Error {
    Error::new("cancelled: nothing was written")
}

fn tiles(width: usize, height: usize) -> Vec<Tile> {
    let corners = (0..height).step_by(TILE).flat_map(|y| (0..width).step_by(TILE).map(move |x| (x, y)));
    corners.map(|(x, y)| Tile { x, y, width: TILE.min(width - x), height: TILE.min(height - y) }).collect()
}

fn render_tile(
    tile: &Tile,
    pixel: impl Fn(usize, usize, &mut RayCounts) -> Vec3,
    progress: &impl Progress,
) -> (Vec<Vec3>, RayCounts) {
    let mut counts = RayCounts::default();
    let mut pixels = Vec::with_capacity(tile.width * tile.height);
    for y in tile.y..tile.y + tile.height {
        for x in tile.x..tile.x + tile.width {
            // With many samples a pixel takes long: a cancelled tile is not finished, nobody will see it.
            if progress.cancelled() {
                return (pixels, counts);
            }
            pixels.push(pixel(x, y, &mut counts));
        }
    }
    (pixels, counts)
}

/// The mean over the samples of a pixel, summed in `f64` so that many samples do not lose the small ones.
fn render_pixel(
    scene: &Scene,
    plan: &Plan,
    [x, y]: [usize; 2],
    media: &MediumStack,
    ray_through: &impl Fn(f64, f64) -> Ray,
    counts: &mut RayCounts,
) -> Vec3 {
    let mut sum = DVec3::ZERO;
    for index in 0..scene.samples {
        let mut sampler = PixelSampler::new(x, y, index);
        let [across, down] = sampler.place(scene.samples);
        let ray = ray_through(x as f64 + across, y as f64 + down);
        sum += radiance(scene, plan, &ray, media, &mut sampler, counts).as_dvec3();
    }
    (sum / f64::from(scene.samples)).as_vec3()
}
