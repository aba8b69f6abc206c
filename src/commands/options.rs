//! Options that several commands share.

use std::path::{Path, PathBuf};
use std::str::FromStr;
use std::time::Duration;

use clap::Args;

use super::threads::Threads;
use crate::choice::names_of;
use crate::colour::ToneMap;
use crate::envmap::source::{Layout, Skybox};
use crate::envmap::{Lookup, Preset};
use crate::error::{Error, Result};
use crate::picture::{PngDepth, WriteOptions, is_standard_stream};
use crate::sampling::{PixelFilter, SamplerKind};
use crate::scene::{Caustics, IntegratorKind, OutputSettings, Scene, Strategy};
use skycube_tracer::memory::check_memory;

/// Options that override the scene file.
#[derive(Debug, Args)]
pub struct SceneOverrides {
    /// Samples per pixel
    #[arg(long, visible_alias = "spp", value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1 << 24))]
    pub samples: Option<u32>,
    #[command(flatten)]
    settings: SettingOverrides,
}

/// The same but for the count of samples.
#[derive(Debug, Args)]
pub struct SettingOverrides {
    /// The integrator
    #[arg(long, value_enum)]
    pub integrator: Option<IntegratorKind>,
    /// The greatest number of reflections and refractions
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = clap::value_parser!(u32).range(0..=1000))]
    pub depth: Option<u32>,
    /// The strategy by which the path tracer finds light sources
    #[arg(long, value_enum)]
    pub strategy: Option<Strategy>,
    /// The sampler
    #[arg(long, value_enum)]
    pub sampler: Option<SamplerKind>,
    /// The pixel filter
    #[arg(long, value_enum, value_name = "FILTER")]
    pub pixel_filter: Option<PixelFilter>,
    /// The seed of the random numbers; another seed gives other noise
    #[arg(long, value_name = "N")]
    pub seed: Option<u32>,
    /// Whether the path tracer guides paths to light focused by glass and mirrors
    #[arg(long, value_enum)]
    pub caustics: Option<Caustics>,
    /// Use only the integrators of the lessons, not the faster code
    #[arg(long)]
    pub textbook: bool,
    /// Replace the map of the scene's environment by this one: a folder, a zip or a picture
    #[arg(long, value_name = "MAP")]
    pub environment: Option<PathBuf>,
    /// Number of threads; it does not change the picture
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1024))]
    pub threads: Option<u32>,
}

impl SceneOverrides {
    /// Reads the scene and applies the overrides.
    pub fn read_scene(&self, file: &Path) -> Result<Scene> {
        let mut scene = self.settings.read_scene(file)?;
        scene.samples = self.samples.unwrap_or(scene.samples);
        Ok(scene)
    }

    /// The threads to render on.
    pub fn threads(&self) -> Threads {
        self.settings.threads()
    }
}

impl SettingOverrides {
    /// Reads the scene and applies the overrides.
    pub fn read_scene(&self, file: &Path) -> Result<Scene> {
        let mut scene = Scene::read_with_environment(file, self.environment.clone())?;
        scene.integrator.kind = self.integrator.unwrap_or(scene.integrator.kind);
        scene.integrator.depth = self.depth.unwrap_or(scene.integrator.depth);
        scene.integrator.strategy = self.strategy.unwrap_or(scene.integrator.strategy);
        scene.integrator.caustics = self.caustics.unwrap_or(scene.integrator.caustics);
        scene.integrator.fast &= !self.textbook;
        scene.sampling.sampler = self.sampler.unwrap_or(scene.sampling.sampler);
        scene.sampling.filter = self.pixel_filter.unwrap_or(scene.sampling.filter);
        scene.sampling.seed = self.seed.unwrap_or(scene.sampling.seed);
        Ok(scene)
    }

    /// The threads to render on.
    pub fn threads(&self) -> Threads {
        Threads::new(self.threads)
    }
}

/// How pictures are written.
#[derive(Debug, Args)]
pub struct PictureOptions {
    /// How radiance above 1 is mapped into range in PNG and JPEG [default: the scene's, or clamp]
    #[arg(long, value_enum)]
    pub tone_map: Option<ToneMap>,
    /// Bits per channel in PNG
    #[arg(long, value_name = "BITS", default_value = "8", value_parser = ["8", "16"])]
    pub bits: String,
    /// JPEG quality, 1 to 100
    #[arg(long, value_name = "N", default_value_t = 92, value_parser = clap::value_parser!(u8).range(1..=100))]
    pub quality: u8,
}

impl PictureOptions {
    /// The options of the writer; the scene's settings hold where the command line is silent.
    pub fn write_options(&self, scene: OutputSettings) -> WriteOptions {
        WriteOptions {
            tone_map: self.tone_map.unwrap_or(scene.tone_map),
            encoding: scene.encoding,
            png_depth: if self.bits == "16" { PngDepth::Sixteen } else { PngDepth::Eight },
            jpeg_quality: self.quality,
        }
    }
}

/// Width and height in pixels, written `640x480`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PictureSize(pub [usize; 2]);

impl FromStr for PictureSize {
    type Err = String;

    fn from_str(text: &str) -> std::result::Result<Self, Self::Err> {
        let side = |digits: &str| digits.parse().ok().filter(|side| (1..=65_536).contains(side));
        let sides = text.split_once(['x', 'X']).and_then(|(width, height)| Some([side(width)?, side(height)?]));
        sides
            .map(Self)
            .ok_or_else(|| "expected width x height in pixels, such as 640x480, each from 1 to 65536".to_owned())
    }
}

/// A time with its unit.
pub fn parse_duration(text: &str) -> std::result::Result<Duration, String> {
    let split = text.find(|letter: char| letter.is_ascii_alphabetic()).unwrap_or(text.len());
    let (digits, unit) = text.split_at(split);
    let seconds = match unit {
        "ms" => 1e-3,
        "s" | "" => 1.0,
        "m" | "min" => 60.0,
        "h" => 3600.0,
        _ => return Err("expected a time such as 500ms, 10s, 2m or 1h".to_owned()),
    };
    let number: Option<f64> = digits.trim().parse().ok();
    let time = number.map(|number| number * seconds).filter(|time| (1e-3..=1e7).contains(time));
    time.map(Duration::from_secs_f64).ok_or_else(|| "expected a time such as 500ms, 10s, 2m or 1h".to_owned())
}

/// A count of bytes with its unit.
pub fn parse_bytes(text: &str) -> std::result::Result<u64, String> {
    let digits = text.trim_end_matches(|letter: char| letter.is_ascii_alphabetic());
    let unit = match text[digits.len()..].to_ascii_uppercase().as_str() {
        "" | "B" => 0,
        "K" | "KB" | "KIB" => 10,
        "M" | "MB" | "MIB" => 20,
        "G" | "GB" | "GIB" => 30,
        "T" | "TB" | "TIB" => 40,
        _ => 64,
    };
    let number: Option<f64> = digits.parse().ok().filter(|number: &f64| *number > 0.0 && unit < 64);
    let bytes = number.map(|number| number * 2f64.powi(unit)).filter(|bytes| (1.0..1e18).contains(bytes));
    bytes.map(|bytes| bytes as u64).ok_or_else(|| "expected a size such as 500M or 4G".to_owned())
}

/// Three numbers between commas, and nothing else.
pub fn parse_three<Number: FromStr>(text: &str) -> Option<[Number; 3]> {
    let numbers: Option<Vec<Number>> = text.split(',').map(|number| number.trim().parse().ok()).collect();
    numbers?.try_into().ok()
}

/// An error if two faces of the lookup read one image: a file cannot be written for both.
pub fn refuse_shared_images(lookup: &Lookup) -> Result<()> {
    for (index, row) in lookup.rows().iter().enumerate() {
        if lookup.rows()[..index].iter().any(|other| other.image == row.image) {
            let problem = format!("two faces of the lookup read {}: it cannot hold both", row.image.name());
            return Err(Error::new(problem).expected("a lookup whose faces read six different images"));
        }
    }
    Ok(())
}

/// The lookup of a name or a file.
pub fn read_lookup(name: &str) -> Result<Lookup> {
    if let Some(preset) = Preset::named(name) {
        return Ok(preset.lookup());
    }
    let file = Path::new(name);
    if file.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("toml")) {
        return crate::scene::read_lookup_file(file);
    }
    Err(Error::new(format!("there is no lookup \"{name}\""))
        .expected(format!("one of {}, or a TOML file with your table", names_of::<Preset>().join(", "))))
}

/// An error if writing to `target` would overwrite a file that something is read from.
pub fn refuse_to_overwrite_sources(target: &Path, sources: &[PathBuf]) -> Result<()> {
    let Ok(target_file) = target.canonicalize() else { return Ok(()) };
    let is_source = |source: &PathBuf| {
        source
            .canonicalize()
            .is_ok_and(|source| source == target_file || (source.is_dir() && target_file.starts_with(&source)))
    };
    if sources.iter().any(is_source) {
        return Err(Error::new("the same command reads this file: it is not overwritten")
            .in_file(target)
            .help("choose another file with -o"));
    }
    Ok(())
}

/// An error if files written to the folder would lie among the pictures of the map, and make them ambiguous.
pub fn refuse_source_folder(skybox: &Skybox, folder: &Path) -> Result<()> {
    let files = skybox.files();
    // Beside an archive or a single picture nothing becomes ambiguous.
    if skybox.layout != Layout::SixFiles || files.len() == 1 {
        return Ok(());
    }
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    refuse_folder_of(folder, &files)
}

/// An error unless a drawing is written as PNG; that is what standard output gets.
pub fn check_drawing_name(path: &Path) -> Result<()> {
    if is_standard_stream(path) || path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("png")) {
        return Ok(());
    }
    Err(Error::new("a drawing is written as PNG").in_file(path).expected("a name with .png"))
}

/// The most pixels a picture may have: what is computed is held in memory as floats.
const MOST_PIXELS: usize = 1 << 28;

/// Bytes that a pixel takes while it is computed, displayed and encoded.
const BYTES_A_PIXEL: u64 = 64;

/// An error if a picture would not fit into memory.
pub fn check_pixel_count([width, height]: [usize; 2]) -> Result<()> {
    if width.saturating_mul(height) <= MOST_PIXELS {
        let bytes = (width * height) as u64 * BYTES_A_PIXEL;
        return check_memory(bytes, format_args!("a picture of {width} x {height} pixels"));
    }
    Err(Error::new(format!("{width} x {height} pixels are too many")).expected(format!("at most {MOST_PIXELS} pixels")))
}

/// An error if files written to the folder would lie among those that something is read from.
pub fn refuse_folder_of(folder: &Path, sources: &[PathBuf]) -> Result<()> {
    let Ok(target) = folder.canonicalize() else { return Ok(()) };
    let inside = |file: &PathBuf| file.canonicalize().is_ok_and(|file| file.parent() == Some(&target));
    if sources.iter().any(inside) {
        return Err(Error::new("this folder holds files that the command reads: nothing is written to it")
            .in_file(folder)
            .help("choose another folder with -o"));
    }
    Ok(())
}
