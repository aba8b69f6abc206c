//! The tables `[integrator]` and `[output]`.

use skycube_files::document::Table;

use crate::colour::{Encoding, ToneMap};
use crate::error::Result;

/// How light is followed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct IntegratorSettings {
    /// The integrator that the scene or the command line asks for.
    pub kind: IntegratorKind,
    /// The greatest number of reflections and refractions from a camera ray.
    pub depth: u32,
    /// Russian roulette for rays that carry less than this share of the pixel: some noise, no bias. 0 follows all rays.
    /// The path tracer has another criterion and only distinguishes 0.
    pub weight_cutoff: f32,
    /// How the path tracer finds light.
    pub strategy: Strategy,
    /// Whether a photon pass tells the path tracer where glass and mirrors focus light.
    pub caustics: Caustics,
    /// Whether faster code replaces the textbook where it applies.
    pub fast: bool,
    /// Which BVH finds the shapes.
    pub hierarchy: HierarchyChoice,
    /// A mistake made on purpose, for lessons.
    pub mistake: Option<Mistake>,
}

/// Deliberate mistakes for lessons.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum Mistake {
    /// Shadow rays forget the surface they leave, and start where single precision puts them: a little above or below
    /// it. From below they hit it again.
    ShadowAcne,
}

/// How the path tracer finds light sources from a surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, clap::ValueEnum)]
#[serde(rename_all = "lowercase")]
pub enum Strategy {
    /// `mis`, but `bsdf` where the only light is a uniform sky, for which shadow rays do not pay off.
    #[default]
    Auto,
    /// Directions sampled from the material only: good for large lights and sharp materials.
    Bsdf,
    /// Points sampled on the light sources only: good for small lights and diffuse materials.
    Light,
    /// Both, weighted by the density with which each could have found the path (multiple importance sampling: Veach and
    /// Guibas, Optimally Combining Sampling Techniques for Monte Carlo Rendering, 1995).
    Mis,
}

/// Whether a photon pass searches for light that glass and mirrors focus.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, clap::ValueEnum)]
#[serde(rename_all = "lowercase")]
pub enum Caustics {
    /// If the scene can have bright caustics.
    #[default]
    Auto,
    /// Never: caustics are still found by chance, with much noise.
    Off,
}

/// The hierarchy over more than a few shapes; it does not change the picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, clap::ValueEnum)]
pub enum HierarchyChoice {
    /// The fast one.
    #[default]
    Auto,
    /// The one of lesson 10.
    Textbook,
    /// None: every ray is tested against every shape.
    Off,
}

/// The integrators.
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
    /// All light, along random paths (Kajiya, The Rendering Equation, 1986).
    Path,
}

/// What is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct OutputSettings {
    /// How radiance above 1 is brought into `[0, 1]`.
    pub tone_map: ToneMap,
    /// `Linear` is a mistake made on purpose, for lessons.
    pub encoding: Encoding,
}

impl Default for IntegratorSettings {
    fn default() -> Self {
        Self {
            kind: IntegratorKind::default(),
            depth: 8,
            weight_cutoff: 1.0 / 1024.0,
            strategy: Strategy::default(),
            caustics: Caustics::default(),
            fast: true,
            hierarchy: HierarchyChoice::default(),
            mistake: None,
        }
    }
}

impl IntegratorSettings {
    pub(super) fn read(table: Option<Table>) -> Result<Self> {
        let mut settings = Self::default();
        let Some(mut table) = table else { return Ok(settings) };
        if let Some(kind) = table.optional("kind") {
            settings.kind = kind.choice()?;
        }
        if let Some(depth) = table.optional("depth") {
            settings.depth = depth.integer(0..=1000)?;
        }
        if let Some(cutoff) = table.optional("weight_cutoff") {
            let number = cutoff.number_where("a number from 0 to 1", |number| (0.0..=1.0).contains(&number))?;
            settings.weight_cutoff = number as f32;
        }
        if let Some(strategy) = table.optional("strategy") {
            settings.strategy = strategy.choice()?;
        }
        if let Some(caustics) = table.optional("caustics") {
            settings.caustics = caustics.choice()?;
        }
        if let Some(fast) = table.optional("fast") {
            settings.fast = fast.boolean()?;
        }
        if let Some(hierarchy) = table.optional("hierarchy") {
            settings.hierarchy = hierarchy.choice()?;
        }
        if let Some(mistake) = table.optional("mistake") {
            settings.mistake = Some(mistake.choice()?);
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
            settings.tone_map = tone_map.choice()?;
        }
        if let Some(encode) = table.optional("encode") {
            settings.encoding = encode.choice()?;
        }
        table.finish()?;
        Ok(settings)
    }
}
