//! Where focused light starts: rays from bright sources towards the glass and mirrors of a scene.
//!
//! ```text
//!     *  source            A beam is a ray from a point of the source through the disc, two rays from the same point
//!      \\                  moved along the disc, and two through the same point of the disc from beside the source's
//!       \\  ___            point. Their spread tells how the light is focused and how large the source looks.
//!        .-\\  '-.
//!       (   \\    )  disc around a mirror or glass, facing the source
//! ```

use crate::colour::luminance;
use crate::integrators::common::lights::LightTables;
use crate::math::{Bounds, DVec3, Frame, Ray};
use crate::sampling::PixelSampler;
use crate::sampling::warp::concentric_disc;
use crate::scene::Scene;
use crate::shapes::{BoundingSphere, Primitive};

/// How much brighter than the mean of the environment its light must be to be worth sending out.
const BRIGHT: f64 = 16.0;
/// Sideways steps of a beam, in radii of the disc.
const STEP: f64 = 1e-4;
/// Rotations of a beam, as tangents.
const ROTATION: f64 = 1e-5;

/// A mirror or glass with an end, as a sphere around it.
#[derive(Debug, Clone, Copy)]
struct Caster {
    centre: DVec3,
    radius: f64,
    /// Sum of the discs' areas up to this one.
    cumulative: f64,
}

/// The mirrors and glasses that light is sent to.
pub(super) struct Casters {
    casters: Vec<Caster>,
    /// A length beyond which nothing lies that has an end.
    reach: f64,
}

/// Rays that start close to one another.
pub(super) struct Beam {
    pub ray: Ray,
    /// From the same point of the source, moved along the two axes of the disc.
    pub moved: [Ray; 2],
    /// Turned about the point on the disc, from other points of the source.
    pub turned: [Ray; 2],
    /// Length of the sideways step, and of the rotation.
    pub steps: [f64; 2],
    /// Radius of a disc at distance 1 that looks as large as the source.
    pub width: f64,
}

impl Casters {
    /// `None` if there are none.
    pub fn new(scene: &Scene) -> Option<Self> {
        let specular = |number: u32| scene.materials[number as usize].focuses();
        let mut cumulative = 0.0;
        let mut casters = Vec::new();
        for primitive in scene.shapes.primitives() {
            if !primitive.material.numbers().iter().any(|&number| specular(number)) {
                continue;
            }
            let Some(BoundingSphere { centre, radius }) = primitive.bounding_sphere() else { continue };
            cumulative += radius * radius;
            casters.push(Caster { centre, radius, cumulative });
        }
        let reach = reach(scene, &casters);
        (!casters.is_empty()).then_some(Self { casters, reach })
    }

    /// Rays from a source to a random one of them. `None` if the chosen direction is not bright.
    pub fn beam(&self, scene: &Scene, lights: &LightTables, sampler: &mut PixelSampler) -> Option<Beam> {
        let [direction_x, direction_y, disc_x, disc_y] = sampler.four().map(f64::from);
        let [choice, light_choice, ..] = sampler.four().map(f64::from);
        let total = self.casters.last()?.cumulative;
        let index = self.casters.partition_point(|caster| caster.cumulative <= choice * total);
        let caster = self.casters.get(index)?;
        let light = lights.sample(caster.centre, [direction_x, direction_y], light_choice)?;
        // The source fills the solid angle 1 / density, of those that its share of all choices goes to.
        let width = (light.share / (light.density * std::f64::consts::PI)).sqrt();
        let frame = Frame::around(light.direction);
        let point = concentric_disc([disc_x, disc_y]) * caster.radius;
        let through = caster.centre + frame.tangent * point.x + frame.bitangent * point.y;
        let (towards, distance) = if light.distance.is_finite() {
            let offset = caster.centre + light.direction * light.distance - through;
            (offset.normalize(), offset.length())
        } else {
            let bright = f64::from(luminance(scene.environment.radiance(light.direction)));
            if bright < BRIGHT * lights.mean_luminance() {
                return None;
            }
            (light.direction, self.reach)
        };
        let start = |through: DVec3, towards: DVec3| Ray::new(through + towards * distance, -towards);
        let axes = [frame.tangent, frame.bitangent];
        let step = STEP * caster.radius;
        let ray = start(through, towards);
        // From the same point of the source: parallel if it is infinitely far, else in directions that differ.
        let moved = |beside: DVec3| match light.distance.is_finite() {
            true => Ray::new(ray.origin, (beside - ray.origin).normalize()),
            false => start(beside, towards),
        };
        Some(Beam {
            ray,
            moved: axes.map(|axis| moved(through + axis * step)),
            turned: axes.map(|axis| start(through, (towards + axis * ROTATION).normalize())),
            steps: [step, ROTATION],
            width,
        })
    }
}

/// A length beyond which nothing with an end lies, seen from any of the spheres.
fn reach(scene: &Scene, casters: &[Caster]) -> f64 {
    let all = scene.shapes.primitives().iter().filter_map(Primitive::bounds).fold(Bounds::EMPTY, Bounds::union);
    let farthest = |caster: &Caster| {
        all.corners().into_iter().map(|corner| (corner - caster.centre).length()).fold(0.0, f64::max) + caster.radius
    };
    casters.iter().map(farthest).fold(0.0, f64::max)
}
