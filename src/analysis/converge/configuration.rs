//! The settings of a scene that can be compared.

use serde::{Serialize, Serializer};

use crate::choice::name_of;
use crate::envmap::CubeFilter;
use crate::sampling::{PixelFilter, SamplerKind};
use crate::scene::{Caustics, IntegratorKind, Scene, Strategy};

/// One configuration of a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Configuration {
    /// The integrator.
    pub integrator: IntegratorKind,
    /// The greatest number of reflections and refractions.
    pub depth: u32,
    /// How the path tracer finds light.
    pub strategy: Strategy,
    /// Whether photons guide the path tracer.
    pub caustics: Caustics,
    /// Where the random numbers of a sample come from.
    pub sampler: SamplerKind,
    /// How samples near a pixel count for it.
    pub pixel_filter: PixelFilter,
    /// How the environment is read between texels; `None` if it is not a cube map.
    #[serde(serialize_with = "none_as_word")]
    pub environment_filter: Option<CubeFilter>,
}

impl Configuration {
    /// What the scene says.
    pub fn of_scene(scene: &Scene) -> Self {
        Self {
            integrator: scene.integrator.kind,
            depth: scene.integrator.depth,
            strategy: scene.integrator.strategy,
            caustics: scene.integrator.caustics,
            sampler: scene.sampling.sampler,
            pixel_filter: scene.sampling.filter,
            environment_filter: scene.environment.cube_map().map(|map| map.filter()),
        }
    }

    /// Applies this configuration to the scene.
    pub fn apply(&self, scene: &mut Scene) {
        scene.integrator.kind = self.integrator;
        scene.integrator.depth = self.depth;
        scene.integrator.strategy = self.strategy;
        scene.integrator.caustics = self.caustics;
        scene.sampling.sampler = self.sampler;
        scene.sampling.filter = self.pixel_filter;
        if let (Some(map), Some(filter)) = (scene.environment.cube_map_mut(), self.environment_filter) {
            map.set_filter(filter);
        }
    }

    /// The values under their names, in the order of the fields.
    pub fn named(&self) -> [(&'static str, String); 7] {
        [
            ("integrator", name_of(self.integrator)),
            ("depth", self.depth.to_string()),
            ("strategy", name_of(self.strategy)),
            ("caustics", name_of(self.caustics)),
            ("sampler", name_of(self.sampler)),
            ("pixel_filter", name_of(self.pixel_filter)),
            ("environment_filter", self.environment_filter.map_or_else(|| "none".to_owned(), name_of)),
        ]
    }
}

fn none_as_word<S: Serializer>(filter: &Option<CubeFilter>, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(&filter.map_or_else(|| "none".to_owned(), name_of))
}
