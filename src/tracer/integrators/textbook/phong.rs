//! Direct light with shadows and Phong highlights, without secondary rays.
//!
//! ```text
//!     light *     n               L =  sum over the lights of   V E cos(theta) f
//!            \    ^    r
//!         l   \   |   /           V      1 if nothing stands between surface and light, else 0
//!              \  |  /            E      irradiance of a surface that faces the light: I / distance^2 for a point
//!               \ | /             theta  angle between the normal n and the direction l to the light
//!     -----------\|/----------    f      k_d / pi + k_s (m + 2) / (2 pi) max(0, r.l)^m,  r: the mirrored view
//! ```
//!
//! (Phong, Illumination for Computer Generated Pictures, 1975; Shirley and Marschner, Fundamentals of Computer Graphics,
//! chapter "Ray Tracing", sections on shading and shadows.)

use crate::integrators::common::observer::{Event, LightOutcome, Observer};
use crate::integrators::common::task::Task;
use crate::integrators::common::view::{Appearance, Reflection, View, appearance, shadow_ray};
use crate::lights::Light;
use crate::math::{Ray, Vec3};
use crate::shapes::Surface;

/// The radiance along a ray: the light of the sources at the nearest surface, or the environment.
pub fn radiance<O: Observer>(task: &mut Task<O>, ray: &Ray) -> Vec3 {
    let scene = task.scene;
    let radiance = match scene.shapes.intersect(ray) {
        Some(hit) => {
            let surface = scene.shapes.surface(ray, &hit);
            let view = View::new(&surface, ray.direction);
            task.observer.note(|| view.hit(&surface, ray, hit.t, Vec3::ONE));
            shade(task, ray, &surface, &view)
        }
        None => {
            let environment = scene.environment.radiance(ray.direction);
            task.counts.environment += 1;
            task.observer.note(|| Event::Missed { direction: ray.direction, environment, transmittance: Vec3::ONE });
            environment
        }
    };
    task.observer.note(|| Event::End { radiance: Some(radiance) });
    radiance
}

/// What a surface shows to a ray in the light of the sources.
pub fn shade<O: Observer>(task: &mut Task<O>, ray: &Ray, surface: &Surface, view: &View) -> Vec3 {
    let scene = task.scene;
    let reflection = match appearance(&scene.materials[surface.material as usize], surface, view, ray.direction) {
        Appearance::Own(what, colour) => {
            task.observer.note(|| Event::Own { what, colour });
            return colour;
        }
        Appearance::Reflecting(reflection) => reflection,
    };
    let mut radiance = Vec3::ZERO;
    if task.plan.direct_light {
        for (number, light) in scene.lights.iter().enumerate() {
            let outcome = illuminate(task, light, &reflection, surface, view);
            if let LightOutcome::Ambient { contribution } | LightOutcome::Free { contribution, .. } = outcome {
                radiance += contribution;
            }
            task.observer.note(|| Event::Light { number, outcome });
        }
    }
    radiance
}

/// What one light does at a surface.
fn illuminate<O: Observer>(
    task: &mut Task<O>,
    light: &Light,
    reflection: &Reflection,
    surface: &Surface,
    view: &View,
) -> LightOutcome {
    if let Light::Ambient { radiance } = light {
        return LightOutcome::Ambient { contribution: reflection.diffuse * *radiance };
    }
    let Some(arriving) = light.illumination(surface.position) else { return LightOutcome::Unreached };
    let (to_light, distance) = (arriving.to_light, arriving.distance);

    // The light must reach the true surface from the side that is looked at.
    let cosine = view.shading_normal.dot(to_light);
    if cosine <= 0.0 || view.normal.dot(to_light) <= 0.0 {
        return LightOutcome::Behind;
    }
    let ray = shadow_ray(task.scene.integrator.mistake, surface.position, surface.id, view.side, to_light);
    if task.plan.shadow_rays {
        task.counts.shadow += 1;
        if task.scene.shapes.occluded(&ray, distance) {
            return LightOutcome::Blocked { ray, distance };
        }
    }
    let contribution = reflection.reflectance(to_light) * arriving.irradiance * cosine as f32;
    LightOutcome::Free { ray, distance, cosine, contribution }
}
