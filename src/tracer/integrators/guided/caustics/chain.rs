//! Light on its way through glass and mirrors, from the source to the first surface that scatters it.

use super::way::Turn;
use crate::colour::luminance;
use crate::integrators::common::media::Media;
use crate::integrators::common::vertex::Vertex;
use crate::integrators::common::view::View;
use crate::materials::{MediumStack, ScatteringSample};
use crate::math::{DVec3, Ray};
use crate::scene::{Plan, Scene};

/// Ways that keep less of the light are not followed, nor those of more turns.
const LEAST_SHARE: f64 = 0.003;
const MOST_TURNS: usize = 32;

/// Where light lands after at least one mirror or smooth glass.
#[derive(Debug, Clone, Copy)]
pub(super) struct Landing {
    pub position: DVec3,
    /// Unit normal of the surface, on the side the light comes from.
    pub normal: DVec3,
    /// Unit direction the light comes from.
    pub towards: DVec3,
}

/// A way that light took, and where it landed.
#[derive(Debug, Clone)]
pub(super) struct Chain {
    /// From the source on.
    pub turns: Vec<Turn>,
    /// Share of the light that takes this way.
    pub share: f64,
    pub landing: Landing,
}

/// Follows light through the scene.
pub(super) struct ChainTracer<'a> {
    scene: &'a Scene,
    media: Media<'a>,
    /// Mirrors and glasses passed at most.
    longest: usize,
}

/// Light that is under way.
#[derive(Clone)]
struct Flight {
    ray: Ray,
    media: MediumStack,
    turns: Vec<Turn>,
    share: f64,
}

impl<'a> ChainTracer<'a> {
    pub fn new(scene: &'a Scene, plan: &Plan) -> Self {
        let media = Media { scene, absorption: plan.absorption };
        Self { scene, media, longest: MOST_TURNS.min(scene.integrator.depth as usize) }
    }

    /// Follows a ray of light both ways at every glass. Returns where it lands; not without a mirror or smooth glass on the
    /// way.
    pub fn explore(&self, ray: Ray) -> Vec<Chain> {
        let mut chains = Vec::new();
        let mut flights = vec![Flight { ray, media: MediumStack::default(), turns: Vec::new(), share: 1.0 }];
        while let Some(flight) = flights.pop() {
            let Some(vertex) = self.meet(&flight.ray, &flight.media) else { continue };
            if !vertex.scattering.is_specular() {
                if !flight.turns.is_empty() {
                    let landing = landing(&vertex, &flight.ray);
                    chains.push(Chain { turns: flight.turns, share: flight.share, landing });
                }
            } else if flight.turns.len() < self.longest {
                for transmitted in [false, true] {
                    flights.extend(self.turned(&flight, &vertex, transmitted));
                }
            }
        }
        chains
    }

    /// The light that goes on one way; `None` if that is none, or hardly any.
    fn turned(&self, flight: &Flight, vertex: &Vertex, transmitted: bool) -> Option<Flight> {
        let (sample, _) = branch(vertex, transmitted)?;
        let share = flight.share * f64::from(luminance(sample.weight));
        let mut next = Flight { share, ..flight.clone() };
        next.ray = vertex.departure(&sample, &mut next.media)?;
        next.turns.push(Turn { shape: vertex.surface.id.shape, transmitted });
        (share >= LEAST_SHARE).then_some(next)
    }

    /// Follows a ray that lies beside another one by the same turns. `None` if it goes another way.
    pub fn follow(&self, mut ray: Ray, turns: &[Turn]) -> Option<Landing> {
        let mut media = MediumStack::default();
        for turn in turns {
            let vertex = self.meet(&ray, &media)?;
            if vertex.surface.id.shape != turn.shape {
                return None;
            }
            let (sample, _) = branch(&vertex, turn.transmitted)?;
            ray = vertex.departure(&sample, &mut media)?;
        }
        let vertex = self.meet(&ray, &media)?;
        (!vertex.scattering.is_specular()).then(|| landing(&vertex, &ray))
    }

    fn meet(&self, ray: &Ray, media: &MediumStack) -> Option<Vertex<'a>> {
        let hit = self.scene.shapes.intersect(ray)?;
        let surface = self.scene.shapes.surface(ray, &hit);
        let view = View::new(&surface, ray.direction);
        let material = &self.scene.materials[surface.material as usize];
        Vertex::new(&self.media, media, ray.direction, material, surface, view)
    }
}

fn landing(vertex: &Vertex, ray: &Ray) -> Landing {
    Landing { position: vertex.surface.position, normal: vertex.view.normal, towards: -ray.direction }
}

/// One of the delta lobes of a mirror or smooth glass, with the whole weight of its way, and the probability with which
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
    use crate::integrators::guided::caustics::way::WayCode;

    #[test]
    fn light_divides_among_its_ways_and_lands_where_it_is_followed_to() {
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
                let code = WayCode::of(&chain.turns);
                assert!(chains[..index].iter().all(|other| WayCode::of(&other.turns) != code));
                let again = tracer.follow(ray, &chain.turns).unwrap();
                assert_eq!((again.position, again.towards), (chain.landing.position, chain.landing.towards));
                assert!(tracer.follow(ray, &chain.turns[1..]).is_none());
            }
        }
        // Straight down through the middle of the glass: what enters and leaves is (1 - 0.04)^2.
        let down = tracer.explore(Ray::new(DVec3::new(0.0, 0.0, 9.0), DVec3::NEG_Z));
        let through = down.iter().find(|chain| chain.turns.len() == 2).unwrap();
        assert!((through.share - 0.96 * 0.96).abs() < 1e-6, "{}", through.share);
        assert!(through.landing.position.length() < 1e-12, "{:?}", through.landing);
    }
}
