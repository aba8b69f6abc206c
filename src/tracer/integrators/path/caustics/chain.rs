//! Light on its way through glass and mirrors, from the source to the first surface that scatters it.

use super::super::super::direct::View;
use super::super::super::media::Media;
use super::super::vertex::Vertex;
use crate::materials::MediumStack;
use crate::math::{DVec3, Ray};
use crate::sampling::PixelSampler;
use crate::scene::{Plan, Scene};

/// Where light lands after at least one mirror or smooth glass.
#[derive(Clone, Copy)]
pub(super) struct Landing {
    pub position: DVec3,
    /// Unit normal of the surface, on the side the light comes from.
    pub normal: DVec3,
    /// Unit direction the light comes from.
    pub towards: DVec3,
}

/// One meeting with glass or a mirror on the way.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) struct Turn {
    shape: u32,
    transmitted: bool,
}

/// Follows light through the scene.
pub(super) struct ChainTracer<'a> {
    pub scene: &'a Scene,
    pub media: Media<'a>,
    /// Mirrors and glasses passed at most.
    pub longest: usize,
}

/// Who decides between reflection and refraction.
enum Decision<'d> {
    /// Chance, by the shares of the light; the turns taken are noted.
    Chance { sampler: &'d mut PixelSampler, turns: &'d mut Vec<Turn> },
    /// The same turns again.
    Again(&'d [Turn]),
}

impl<'a> ChainTracer<'a> {
    pub fn new(scene: &'a Scene, plan: &Plan) -> Self {
        let media = Media { scene, absorption: plan.absorption };
        Self { scene, media, longest: scene.integrator.depth as usize }
    }

    /// Follows a ray of light by chance. `None` if it lands nowhere, or without having met a mirror or smooth glass.
    pub fn follow(&self, ray: Ray, sampler: &mut PixelSampler, turns: &mut Vec<Turn>) -> Option<Landing> {
        turns.clear();
        self.walk(ray, Decision::Chance { sampler, turns })
    }

    /// Follows a ray that lies beside another one by the same turns. `None` if it goes another way.
    pub fn follow_again(&self, ray: Ray, turns: &[Turn]) -> Option<Landing> {
        self.walk(ray, Decision::Again(turns))
    }

    fn walk(&self, mut ray: Ray, mut decision: Decision) -> Option<Landing> {
        let mut media = MediumStack::default();
        for count in 0..=self.longest {
            let hit = self.scene.shapes.intersect(&ray)?;
            let surface = self.scene.shapes.surface(&ray, &hit);
            let view = View::new(&surface, ray.direction);
            let material = &self.scene.materials[surface.material as usize];
            let vertex = Vertex::new(&self.media, &media, ray.direction, material, surface, view)?;
            if !vertex.scattering.is_specular() {
                let complete = match &decision {
                    Decision::Chance { .. } => count > 0,
                    Decision::Again(turns) => turns.len() == count,
                };
                let landing = Landing { position: surface.position, normal: view.normal, towards: -ray.direction };
                return complete.then_some(landing);
            }
            ray = self.turn(&vertex, &mut decision, count, &mut media)?;
        }
        None
    }

    /// One mirror or smooth glass; `media` become those behind it.
    fn turn(&self, vertex: &Vertex, decision: &mut Decision, count: usize, media: &mut MediumStack) -> Option<Ray> {
        let sample = |choice: f64| vertex.scattering.sample(vertex.towards_viewer, [0.5; 2], choice);
        let shape = vertex.surface.id.shape;
        let sample = match decision {
            Decision::Chance { sampler, turns } => {
                let sample = sample(f64::from(sampler.uniform()))?;
                turns.push(Turn { shape, transmitted: sample.transmitted });
                sample
            }
            Decision::Again(turns) => {
                let wanted = turns.get(count).filter(|turn| turn.shape == shape)?;
                // The smallest and the largest choice are reflection and refraction, if there are both.
                let ends = [0.0, 1.0 - f64::EPSILON].into_iter().filter_map(sample);
                ends.into_iter().find(|sample| sample.transmitted == wanted.transmitted)?
            }
        };
        vertex.departure(&sample, media)
    }
}
