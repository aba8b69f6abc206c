//! The tables `[integrator]` and `[output]`.

use super::document::Table;
use crate::colour::ToneMap;
use crate::error::Result;

/// How light is followed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct IntegratorSettings {
    pub kind: IntegratorKind,
    /// Reflections and refractions followed at most from a camera ray.
    pub depth: u32,
    /// Rays that carry less than this share of the pixel are followed at random, the survivors weighted up: the
    /// picture gains noise below this share but no bias. 0 follows all.
    pub weight_cutoff: f32,
}

/// The ways to compute a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, clap::ValueEnum)]
#[serde(rename_all = "lowercase")]
pub enum IntegratorKind {
    /// The shading normal as a colour.
    Normals,
    /// Local light and shadows.
    Phong,
    /// Local light, shadows, reflection and refraction (Whitted, 1980).
    #[default]
    Whitted,
}

/// What is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct OutputSettings {
    pub tone_map: ToneMap,
}

impl Default for IntegratorSettings {
    fn default() -> Self {
        Self { kind: IntegratorKind::default(), depth: 8, weight_cutoff: 1.0 / 1024.0 }
    }
}

impl IntegratorKind {
    /// The name in scenes and on the command line.
    pub fn name(self) -> &'static str {
        match self {
            IntegratorKind::Normals => "normals",
            IntegratorKind::Phong => "phong",
            IntegratorKind::Whitted => "whitted",
        }
    }
}

impl IntegratorSettings {
    pub(super) fn read(table: Option<Table>) -> Result<Self> {
        let mut settings = Self::default();
        let Some(mut table) = table else { return Ok(settings) };
        if let Some(kind) = table.optional("kind") {
            settings.kind = kind.choice(&[
                ("normals", IntegratorKind::Normals),
                ("phong", IntegratorKind::Phong),
                ("whitted", IntegratorKind::Whitted),
            ])?;
        }
        if let Some(depth) = table.optional("depth") {
            settings.depth = depth.integer(0..=1000)?;
        }
        if let Some(cutoff) = table.optional("weight_cutoff") {
            let number = cutoff.number_where("a number from 0 to 1", |number| (0.0..=1.0).contains(&number))?;
            settings.weight_cutoff = number as f32;
        }
        table.finish()?;
        Ok(settings)
    }
}

impl OutputSettings {
    pub(super) fn read(table: Option<Table>) -> Result<Self> {
        let mut settings = Self::default();
        let Some(mut table) = table else { return Ok(settings) };
        if let Some(tone_map) = table.optional("tone_map") {
            settings.tone_map = tone_map.choice(&[("clamp", ToneMap::Clamp), ("reinhard", ToneMap::Reinhard)])?;
        }
        table.finish()?;
        Ok(settings)
    }
}
