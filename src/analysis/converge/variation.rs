//! The variants of a comparison: varied settings of a scene, in all combinations.

use std::str::FromStr;

use clap::ValueEnum;

use super::configuration::Configuration;
use crate::choice::{name_of, names_of};
use crate::envmap::CubeFilter;
use crate::error::{Error, Result};
use crate::sampling::{PixelFilter, SamplerKind};
use crate::scene::{Caustics, IntegratorKind, Strategy};

/// A setting that may vary; its names are those of the options of `render`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Aspect {
    Integrator,
    Depth,
    Strategy,
    Caustics,
    Sampler,
    PixelFilter,
    EnvironmentFilter,
}

/// One value of a setting.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Setting {
    Integrator(IntegratorKind),
    Depth(u32),
    Strategy(Strategy),
    Caustics(Caustics),
    Sampler(SamplerKind),
    PixelFilter(PixelFilter),
    EnvironmentFilter(CubeFilter),
}

/// The values that one setting is given in turn, written `strategy=bsdf,light,mis`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Variation {
    pub(super) aspect: Aspect,
    pub(super) settings: Vec<Setting>,
}

/// The usual comparisons.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Comparison {
    /// How the path tracer finds light: bsdf, light, mis
    Strategies,
    /// phong, whitted, path
    Integrators,
    /// sobol, independent
    Samplers,
    /// box, tent, gaussian, mitchell
    Filters,
    /// 1, 2, 4, ... reflections up to the scene's depth
    Depths,
    /// How the environment is read between texels: nearest, bilinear, seamless
    Lookups,
    /// auto, off
    Caustics,
}

/// A variant of a scene, and its label in tables and plots.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Variant {
    /// The values that make it differ, as tables and plots name it.
    pub label: String,
    /// All its settings.
    pub configuration: Configuration,
}

/// The most variants of a scene: more are neither measured in sensible time nor told apart in a plot.
const MOST_VARIANTS: usize = 24;

impl Setting {
    fn parse(aspect: Aspect, text: &str) -> std::result::Result<Self, String> {
        Ok(match aspect {
            Aspect::Integrator => Setting::Integrator(value_of(text)?),
            Aspect::Strategy => Setting::Strategy(value_of(text)?),
            Aspect::Caustics => Setting::Caustics(value_of(text)?),
            Aspect::Sampler => Setting::Sampler(value_of(text)?),
            Aspect::PixelFilter => Setting::PixelFilter(value_of(text)?),
            Aspect::EnvironmentFilter => Setting::EnvironmentFilter(value_of(text)?),
            Aspect::Depth => {
                let depth = text.parse().ok().filter(|depth| (0..=1000).contains(depth));
                Setting::Depth(depth.ok_or_else(|| format!("found \"{text}\", expected a depth from 0 to 1000"))?)
            }
        })
    }

    /// Gives a configuration this value.
    pub fn apply(self, configuration: &mut Configuration) {
        match self {
            Setting::Integrator(value) => configuration.integrator = value,
            Setting::Depth(value) => configuration.depth = value,
            Setting::Strategy(value) => configuration.strategy = value,
            Setting::Caustics(value) => configuration.caustics = value,
            Setting::Sampler(value) => configuration.sampler = value,
            Setting::PixelFilter(value) => configuration.pixel_filter = value,
            Setting::EnvironmentFilter(value) => configuration.environment_filter = Some(value),
        }
    }

    /// The value as on the command line.
    fn value(self) -> String {
        match self {
            Setting::Integrator(value) => name_of(value),
            Setting::Depth(value) => value.to_string(),
            Setting::Strategy(value) => name_of(value),
            Setting::Caustics(value) => name_of(value),
            Setting::Sampler(value) => name_of(value),
            Setting::PixelFilter(value) => name_of(value),
            Setting::EnvironmentFilter(value) => name_of(value),
        }
    }
}

fn value_of<T: ValueEnum>(text: &str) -> std::result::Result<T, String> {
    T::from_str(text, false).map_err(|_| format!("found \"{text}\", expected one of {}", names_of::<T>().join(", ")))
}

impl FromStr for Variation {
    type Err = String;

    fn from_str(text: &str) -> std::result::Result<Self, String> {
        let (aspect, values) = text
            .split_once('=')
            .ok_or_else(|| "expected a setting and its values, such as strategy=bsdf,light,mis".to_owned())?;
        let aspect = value_of(aspect.trim())?;
        let settings: Vec<Setting> = values
            .split(',')
            .map(|value| Setting::parse(aspect, value.trim()))
            .collect::<std::result::Result<_, _>>()?;
        if let Some(index) = (1..settings.len()).find(|&index| settings[..index].contains(&settings[index])) {
            return Err(format!("{} is given twice", settings[index].value()));
        }
        Ok(Self { aspect, settings })
    }
}

impl Comparison {
    /// What is varied, for a scene with the given settings.
    pub fn variation(self, base: &Configuration) -> Variation {
        fn all<T: ValueEnum + Copy>(setting: fn(T) -> Setting) -> Vec<Setting> {
            T::value_variants().iter().map(|&value| setting(value)).collect()
        }
        let (aspect, settings) = match self {
            // `auto` is one of these three.
            Comparison::Strategies => {
                (Aspect::Strategy, [Strategy::Bsdf, Strategy::Light, Strategy::Mis].map(Setting::Strategy).to_vec())
            }
            Comparison::Samplers => (Aspect::Sampler, all(Setting::Sampler)),
            Comparison::Filters => (Aspect::PixelFilter, all(Setting::PixelFilter)),
            Comparison::Lookups => (Aspect::EnvironmentFilter, all(Setting::EnvironmentFilter)),
            Comparison::Caustics => (Aspect::Caustics, all(Setting::Caustics)),
            Comparison::Integrators => {
                let kinds = [IntegratorKind::Phong, IntegratorKind::Whitted, IntegratorKind::Path];
                (Aspect::Integrator, kinds.map(Setting::Integrator).to_vec())
            }
            Comparison::Depths => {
                let powers = (0..10).map(|exponent| 1 << exponent).take_while(|&depth| depth < base.depth);
                (Aspect::Depth, powers.chain([base.depth]).map(Setting::Depth).collect())
            }
        };
        Variation { aspect, settings }
    }
}

/// All combinations of the variations on a scene's own settings. An error if one of them could make no difference.
pub fn variants(base: &Configuration, variations: &[Variation]) -> Result<Vec<Variant>> {
    let mut variants = vec![Variant { label: String::new(), configuration: *base }];
    for (index, variation) in variations.iter().enumerate() {
        if variations[..index].iter().any(|other| other.aspect == variation.aspect) {
            return Err(Error::new(format!("{} is varied twice", name_of(variation.aspect)))
                .help("give all its values in one list, --vary SETTING=VALUE,VALUE"));
        }
        let combined = |variant: &Variant| -> Vec<Variant> {
            variation.settings.iter().map(|&setting| variant.with(variation.aspect, setting)).collect()
        };
        variants = variants.iter().flat_map(combined).collect();
    }
    if variants.len() > MOST_VARIANTS {
        return Err(Error::new(format!("{} combinations are too many", variants.len()))
            .expected(format!("at most {MOST_VARIANTS}")));
    }
    check_sense(base, variations, &variants)?;
    Ok(variants)
}

impl Variant {
    fn with(&self, aspect: Aspect, setting: Setting) -> Self {
        let gap = if self.label.is_empty() { "" } else { ", " };
        let label = format!("{}{gap}{}={}", self.label, name_of(aspect), setting.value());
        let mut configuration = self.configuration;
        setting.apply(&mut configuration);
        Self { label, configuration }
    }
}

/// An error if a setting is varied that the scene ignores.
fn check_sense(base: &Configuration, variations: &[Variation], variants: &[Variant]) -> Result<()> {
    let any =
        |kinds: &[IntegratorKind]| variants.iter().any(|variant| kinds.contains(&variant.configuration.integrator));
    for variation in variations {
        let aspect = name_of(variation.aspect);
        match variation.aspect {
            Aspect::Strategy | Aspect::Caustics if !any(&[IntegratorKind::Path]) => {
                return Err(Error::new(format!("{aspect} makes no difference: no scene uses the path tracer"))
                    .help("add --integrator path"));
            }
            Aspect::Depth if !any(&[IntegratorKind::Path, IntegratorKind::Whitted]) => {
                return Err(Error::new("depth makes no difference: no integrator follows reflections")
                    .help("add --integrator path or --integrator whitted"));
            }
            Aspect::EnvironmentFilter if base.environment_filter.is_none() => {
                return Err(Error::new("environment-filter makes no difference: the environment is not a cube map"));
            }
            _ => {}
        }
    }
    Ok(())
}
