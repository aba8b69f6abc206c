//! Specular chains: light through glass and mirrors, from the source to the first surface that scatters it.

use super::signature::SpecularEvent;
use crate::colour::luminance;
use crate::integrators::common::media::Media;
use crate::integrators::common::vertex::Vertex;
use crate::integrators::common::view::View;
use crate::materials::{MediumStack, ScatteringSample};
use crate::math::{DVec3, Ray};
use crate::scene::{Plan, Scene};

/// Chains that keep less of the light are not followed, nor those of more events.
const LEAST_SHARE: f64 = 0.003;
const MOST_EVENTS: usize = 32;

/// Where light hits a surface that scatters it, after at least one mirror or smooth glass.
#[derive(Debug, Clone, Copy)]
pub(super) struct PhotonHit {
    pub position: DVec3,
    /// Unit normal of the surface, on the side the light comes from.
    pub normal: DVec3,
    /// Unit direction the light comes from.
    pub towards: DVec3,
}

/// A specular chain, and where it ends.
#[derive(Debug, Clone)]
pub(super) struct Chain {
    /// From the source on.
    pub events: Vec<SpecularEvent>,
    /// Share of the light that takes this chain.
    pub share: f64,
    pub hit: PhotonHit,
}

/// Follows light through the scene.
pub(super) struct ChainTracer<'a> {
    scene: &'a Scene,
    media: Media<'a>,
    /// Mirrors and glasses passed at most.
    longest: usize,
}

/// A chain that is not at its end.
#[derive(Clone)]
struct Flight {
    ray: Ray,
    media: MediumStack,
    events: Vec<SpecularEvent>,
    share: f64,
}

impl<'a> ChainTracer<'a> {
    pub fn new(scene: &'a Scene, plan: &Plan) -> Self {
        let media = Media { scene, absorption: plan.absorption };
        Self { scene, media, longest: MOST_EVENTS.min(scene.integrator.depth as usize) }
    }

    /// Follows a ray of light along both branches of every glass. Returns the chains of at least one mirror or smooth glass.
    pub fn explore(&self, ray: Ray) -> Vec<Chain> {
        let mut chains = Vec::new();
        let mut flights = vec![Flight { ray, media: MediumStack::default(), events: Vec::new(), share: 1.0 }];
        while let Some(flight) = flights.pop() {
            let Some(vertex) = self.meet(&flight.ray, &flight.media) else { continue };
            if !vertex.scattering.is_specular() {
                if !flight.events.is_empty() {
                    let hit = hit(&vertex, &flight.ray);
                    chains.push(Chain { events: flight.events, share: flight.share, hit });
                }
            } else if flight.events.len() < self.longest {
                for transmitted in [false, true] {
                    flights.extend(self.branched(&flight, &vertex, transmitted));
                }
            }
        }
        chains
    }

    /// The light in one branch; `None` if it is negligible.
    fn branched(&self, flight: &Flight, vertex: &Vertex, transmitted: bool) -> Option<Flight> {
        let (sample, _) = branch(vertex, transmitted)?;
        let share = flight.share * f64::from(luminance(sample.weight));
        let mut next = Flight { share, ..flight.clone() };
        next.ray = vertex.departure(&sample, &mut next.media)?;
        next.events.push(SpecularEvent { shape: vertex.surface.id.shape, transmitted });
        (share >= LEAST_SHARE).then_some(next)
    }

    /// Follows a ray beside another one through the same events. `None` if it meets others.
    pub fn follow(&self, mut ray: Ray, events: &[SpecularEvent]) -> Option<PhotonHit> {
        let mut media = MediumStack::default();
        for event in events {
            let vertex = self.meet(&ray, &media)?;
            if vertex.surface.id.shape != event.shape {
                return None;
            }
            let (sample, _) = branch(&vertex, event.transmitted)?;
            ray = vertex.departure(&sample, &mut media)?;
        }
        let vertex = self.meet(&ray, &media)?;
        (!vertex.scattering.is_specular()).then(|| hit(&vertex, &ray))
    }

    fn meet(&self, ray: &Ray, media: &MediumStack) -> Option<Vertex<'a>> {
        let hit = self.scene.shapes.intersect(ray)?;
        let surface = self.scene.shapes.surface(ray, &hit);
        let view = View::new(&surface, ray.direction);
        let material = &self.scene.materials[surface.material as usize];
        Vertex::new(&self.media, media, ray.direction, material, surface, view)
    }
}

fn hit(vertex: &Vertex, ray: &Ray) -> PhotonHit {
    PhotonHit { position: vertex.surface.position, normal: vertex.view.normal, towards: -ray.direction }
}

/// One of the delta lobes of a mirror or smooth glass, with its whole weight, and the probability with which
/// [`Scattering::sample`](crate::materials::Scattering::sample) chooses it; `None` if there is none on that side, or if the
/// surface is neither.
#[inline]
pub fn branch(vertex: &Vertex, transmitted: bool) -> Option<(ScatteringSample, f64)> {
    if !vertex.scattering.is_specular() {
        return None;
    }
    if let Some([reflected, refracted]) = vertex.scattering.branches(vertex.towards_viewer) {
        let sample = if transmitted { refracted } else { reflected };
        return Some((sample, f64::from(sample.weight.x)));
    }
    let sample = vertex.scattering.sample(vertex.towards_viewer, [0.5; 2], 0.0)?;
    (sample.transmitted == transmitted && sample.specular).then_some((sample, 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::integrators::guided::caustics::signature::Signature;

    #[test]
    fn light_divides_among_its_chains_and_hits_where_it_is_followed_to() {
        let text = "camera = { position = [0, -5, 1], target = [0, 0, 0], size = [8, 8] }\n\
                    integrator = { kind = \"path\", depth = 8 }\nmaterials.floor = { kind = \"lambert\", colour = 0.5 }\n\
                    materials.glass = { kind = \"glass\" }\nmaterials.mirror = { kind = \"mirror\" }\n\
                    shapes = [{ kind = \"plane\", material = \"floor\" },\n\
                              { kind = \"sphere\", centre = [0, 0, 1.5], material = \"glass\" },\n\
                              { kind = \"sphere\", centre = [2.2, 0, 1], material = \"mirror\" }]\n";
        let scene = Scene::from_text(text, std::path::Path::new("test.toml")).unwrap();
        let plan = Plan::new(&scene);
        let tracer = ChainTracer::new(&scene, &plan);
        for across in -9..=9 {
            let direction = DVec3::new(0.3, 0.1, -1.0).normalize();
            let ray = Ray::new(DVec3::new(f64::from(across) / 10.0, 0.2, 1.0) - direction * 9.0, direction);
            let chains = tracer.explore(ray);
            let shares: f64 = chains.iter().map(|chain| chain.share).sum();
            assert!(shares <= 1.0 + 1e-6, "{shares}");
            for (index, chain) in chains.iter().enumerate() {
                let signature = Signature::of(&chain.events);
                assert!(chains[..index].iter().all(|other| Signature::of(&other.events) != signature));
                let again = tracer.follow(ray, &chain.events).unwrap();
                assert_eq!((again.position, again.towards), (chain.hit.position, chain.hit.towards));
                assert!(tracer.follow(ray, &chain.events[1..]).is_none());
            }
        }
        // Straight down through the middle of the glass: what enters and leaves is (1 - 0.04)^2.
        let down = tracer.explore(Ray::new(DVec3::new(0.0, 0.0, 9.0), DVec3::NEG_Z));
        let through = down.iter().find(|chain| chain.events.len() == 2).unwrap();
        assert!((through.share - 0.96 * 0.96).abs() < 1e-6, "{}", through.share);
        assert!(through.hit.position.length() < 1e-12, "{:?}", through.hit);
    }
}
