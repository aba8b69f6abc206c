//! The sky over flat surfaces, without noise where nothing hides it.
//!
//! What a flat, dull surface gets from the sky if nothing stands in its way is known beforehand. Rays are sent only where
//! something may stand in the way, into the cones of directions that the shapes fill, and what such a ray finds counts
//! by how much it differs from the sky behind it:
//!
//! ```text
//!       open sky: computed          rays only in here: what is met, less the sky behind it
//!          .  .  .   .                   .  . - ~ - .
//!                                   .     '           '
//!                              .         |   a shape   |         a ray that meets nothing counts 0
//!                         .         .     '           '
//!     ----------------x-----------------------' - . - ' ------
//! ```
//!
//! So no noise is left where no shape is near. (A control variate: Owen, Monte Carlo Theory, Methods and Examples, 8.9;
//! the sky is the function whose integral is known. The cones are those of Shirley, Wang and Zimmerman, Monte Carlo
//! Techniques for Direct Lighting Calculations, 1996.) The light of a path is right on average, as without it; a single
//! path may carry less than nothing, where more sky is taken back than was found to be hidden.

use std::f64::consts::FRAC_1_PI;

use super::super::observer::{Event, Observer};
use super::super::view::View;
use super::obstacles::Obstacles;
use super::vertex::Vertex;
use super::{Arrival, Path, Walk};
use crate::envmap::Irradiance;
use crate::error::Result;
use crate::math::{DVec3, Side, Vec3};
use crate::scene::{Plan, Scene};
use crate::shapes::{BoundingBall, Primitive, Surface};

/// The open sky as flat surfaces see it, and what may stand in its way.
pub(super) struct OpenSky {
    /// By the number of a shape: the irradiance of its two sides under the open sky. `None` for shapes that are not flat and
    /// dull, or over which a shape without end may stand.
    of_shape: Vec<Option<Irradiance>>,
    /// By the number of a shape, where it is; `None` for planes, which have no end.
    balls: Vec<Option<BoundingBall>>,
}

impl OpenSky {
    /// `None` where no surface gains by it. An error tells that a picture of the environment cannot be decoded.
    pub fn new(scene: &Scene, plan: &Plan) -> Result<Option<Self>> {
        if !plan.open_sky {
            return Ok(None);
        }
        let mut known = Vec::new();
        let mut of_shape = Vec::new();
        for primitive in scene.shapes.primitives() {
            let light = match scene.open_normal(primitive) {
                Some(normal) => Some(irradiance(scene, normal, &mut known)?),
                None => None,
            };
            // A picture may hold what is not finite: then rays find it one by one.
            of_shape.push(light.filter(|light| light.front.is_finite() && light.back.is_finite()));
        }
        let balls = scene.shapes.primitives().iter().map(Primitive::bounding_ball).collect();
        Ok(of_shape.iter().any(Option::is_some).then_some(Self { of_shape, balls }))
    }

    /// The radiance of a white surface under the open sky, and what may hide the sky from it. `None` for surfaces that are
    /// not flat, or amidst shapes, or mostly hidden.
    #[inline]
    pub fn over(&self, surface: &Surface, view: &View) -> Option<(Vec3, Obstacles)> {
        let light = self.of_shape[surface.id.shape as usize]?;
        let obstacles = Obstacles::seen_from(&self.balls, surface, view)?;
        let irradiance = if view.side == Side::Front { light.front } else { light.back };
        Some((irradiance * FRAC_1_PI as f32, obstacles))
    }
}

/// The irradiance of a plane by its normal, computed once for all planes with the same.
fn irradiance(scene: &Scene, normal: DVec3, known: &mut Vec<(DVec3, Irradiance)>) -> Result<Irradiance> {
    if let Some(&(_, light)) = known.iter().find(|(other, _)| *other == normal) {
        return Ok(light);
    }
    let light = scene.environment.irradiance(normal)?;
    known.push((normal, light));
    Ok(light)
}

impl<'a, O: Observer> Walk<'a, O> {
    /// The radiance of a white surface under the open sky and what may hide it, for surfaces where that is known.
    #[inline]
    pub(super) fn open_sky_over(&self, path: &Path, vertex: &Vertex) -> Option<(Vec3, Obstacles)> {
        let open_sky = self.tables.open_sky.as_ref()?;
        // Through glass the sky looks otherwise.
        path.media.innermost().is_none().then(|| open_sky.over(&vertex.surface, &vertex.view))?
    }

    /// Takes the light of the open sky, and sends the path to where something may hide it. False if the path ends here.
    pub(super) fn leave_under_open_sky(
        &mut self,
        path: &mut Path<'a>,
        vertex: &Vertex,
        radiance: Vec3,
        obstacles: &Obstacles,
    ) -> bool {
        let colour = vertex.scattering.albedo();
        self.add("open sky as if nothing hid it; rays go only to what may", path.throughput * colour * radiance);
        if obstacles.is_empty() {
            return false;
        }
        path.throughput *= colour;
        let [x, y, choice, survival] = self.sampler.four().map(f64::from);
        // About as much as the ray will carry, known before it is.
        let carried = path.throughput.max_element() * obstacles.share() as f32;
        if !self.survives(path, carried, survival) {
            return false;
        }
        let (direction, density) = obstacles.draw([x, y], choice);
        let cosine = direction.dot(vertex.view.normal);
        let Some(ray) = vertex.ray_towards(direction).filter(|_| cosine > 0.0) else { return false };
        let factor = (cosine * FRAC_1_PI / density) as f32;
        let weight = colour * factor;
        self.observer.note(|| Event::Scattered { specular: false, transmitted: false, density, weight });
        self.counts.reflected += 1;
        path.ray = ray;
        path.arrival = Arrival::Obstructed;
        path.throughput *= factor;
        path.bounces += 1;
        true
    }

    /// Takes back the light of the sky behind what the path met, as it was taken: not weakened by what was passed to there.
    pub(super) fn return_hidden_sky(&mut self, path: &mut Path<'a>, throughput: Vec3) {
        let hidden = self.scene.environment.radiance(path.ray.direction);
        self.add("sky hidden by what was met", -throughput * hidden);
        // What else is found there could not have been found another way.
        path.arrival = Arrival::Camera;
    }
}
