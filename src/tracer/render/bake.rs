//! Baking: the images of a cube map, rendered from a point of a scene.

use super::progress::Progress;
use super::ray_source::RaySource;
use super::renderer::Renderer;
use super::rendering::Rendering;
use crate::envmap::{Face, Lookup};
use crate::error::Result;
use crate::math::DVec3;
use crate::scene::{Plan, Scene};

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
