//! `skycube converge`: error against run time.

use std::path::{Path, PathBuf};
use std::str::FromStr;
use std::time::Duration;

use clap::Args;

use super::interrupt;
use super::options::{
    PictureSize, SettingOverrides, check_pixel_count, parse_duration, refuse_folder_of, refuse_to_overwrite_sources,
};
use super::progress_bar::RenderBar;
use super::terminal::{Outcome, print, tell};
use crate::converge::{
    Comparison, Configuration, Protocol, Schedule, Variant, Variation, Watch, Work, converge, variants,
};
use crate::error::Result;
use crate::picture::{check_folder_target, check_target, make_folder, write_together};
use crate::render::Progress;
use crate::report::{ConvergeReport, ConvergedScene, Measure, converge_csv, draw_convergence};
use crate::scene::Scene;

#[derive(Debug, Args)]
#[command(
    after_help = "Writes converge.csv, converge.json, converge.png, converge.svg and the folder references; the next \
                  run with the same scene and settings reuses the references in it."
)]
pub struct ConvergeArguments {
    /// The scenes, TOML files
    #[arg(required = true, value_name = "SCENE")]
    scenes: Vec<PathBuf>,
    /// The folder to write to [default: converge- and the scene's name, in this folder]
    #[arg(short, long, value_name = "FOLDER")]
    output: Option<PathBuf>,
    /// Measure at these samples per pixel
    #[arg(long, visible_alias = "spp", value_name = "N,N,...", default_value = "1,4,16,64", conflicts_with = "time")]
    samples: SampleSteps,
    /// Measure at 1, 4, 16, ... samples until every rendering has taken this time: 10s, 500ms or 2m
    #[arg(long, value_name = "TIME", value_parser = parse_duration)]
    time: Option<Duration>,
    /// Compare the usual values of a setting; several give all combinations
    #[arg(long, value_enum, value_name = "WHAT", value_delimiter = ',')]
    compare: Vec<Comparison>,
    /// Compare values of a setting, for instance strategy=bsdf,light,mis or depth=1,2,8: integrator, depth, strategy,
    /// caustics, sampler, pixel-filter or environment-filter
    #[arg(long, value_name = "SETTING=VALUES")]
    vary: Vec<Variation>,
    /// Renderings of every variant, each with another seed; errors are their means, and they separate bias from noise
    #[arg(long, value_name = "N", default_value_t = 2, value_parser = clap::value_parser!(u32).range(2..=16))]
    seeds: u32,
    /// Samples per pixel of the reference [default: 16 times the last step; 1024 with --time]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(2..=1 << 24))]
    reference_samples: Option<u32>,
    /// The error that the plot shows
    #[arg(long, value_enum, default_value = "rmse")]
    measure: Measure,
    /// Picture size in pixels, for instance 320x240
    #[arg(long, value_name = "WxH")]
    size: Option<PictureSize>,
    #[command(flatten)]
    overrides: SettingOverrides,
    /// Print the report as JSON
    #[arg(long)]
    pub(super) json: bool,
}

/// Counts of samples, ascending.
#[derive(Debug, Clone)]
struct SampleSteps(Vec<u32>);

impl FromStr for SampleSteps {
    type Err = String;

    fn from_str(text: &str) -> std::result::Result<Self, String> {
        let step = |text: &str| text.trim().parse().ok().filter(|step| (1..=1 << 24).contains(step));
        let steps: Option<Vec<u32>> = text.split(',').map(step).collect();
        steps.filter(|steps| steps.windows(2).all(|pair| pair[0] < pair[1])).map(Self).ok_or_else(|| {
            "expected ascending counts of samples, such as 1,4,16,64, each from 1 to 16777216".to_owned()
        })
    }
}

/// The files that are written.
const FILES: [&str; 4] = ["converge.csv", "converge.json", "converge.png", "converge.svg"];

/// Measures, writes and prints.
pub fn run(arguments: &ConvergeArguments) -> Result<Outcome> {
    let folder = arguments.output.clone().unwrap_or_else(|| default_folder(&arguments.scenes));
    let mut scenes = arguments.scenes.iter().map(|file| Subject::read(arguments, file)).collect::<Result<Vec<_>>>()?;
    refuse(&folder, &scenes)?;
    interrupt::watch();
    let threads = arguments.overrides.threads();
    let cache = folder.join("references");
    let protocol = protocol(arguments, &cache);
    let mut report = ConvergeReport { scenes: Vec::new(), stopped: false };
    for subject in &mut scenes {
        match threads.install(|| converge(&mut subject.scene, &subject.variants, &protocol, &Terminal)) {
            Ok(convergence) => {
                let [width, height] = subject.scene.camera.size();
                report.scenes.push(ConvergedScene {
                    name: subject.name.clone(),
                    width,
                    height,
                    seeds: protocol.seeds,
                    convergence,
                });
            }
            // What was measured of other scenes is not lost.
            Err(_) if interrupt::requested() && !report.scenes.is_empty() => {}
            Err(error) => return Err(error),
        }
        report.stopped = interrupt::requested();
        if report.stopped {
            break;
        }
    }
    write(&report, arguments.measure, &folder)?;
    if arguments.json {
        print(format_args!("{}\n", report.to_json()));
    } else {
        tell(&report);
        tell(format_args!("wrote {} to {}\n", FILES.join(", "), folder.display()));
    }
    Ok(if report.stopped { Outcome::Interrupted } else { Outcome::Clean })
}

/// A scene and how it is rendered.
struct Subject {
    name: String,
    scene: Scene,
    variants: Vec<Variant>,
}

impl Subject {
    fn read(arguments: &ConvergeArguments, file: &Path) -> Result<Self> {
        let mut scene = arguments.overrides.read_scene(file)?;
        if let Some(PictureSize(size)) = arguments.size {
            scene.camera = scene.camera.resized(size);
        }
        check_pixel_count(scene.camera.size())?;
        let base = Configuration::of_scene(&scene);
        let compared = arguments.compare.iter().map(|comparison| comparison.variation(&base));
        let variations: Vec<Variation> = compared.chain(arguments.vary.iter().cloned()).collect();
        let variants = variants(&base, &variations).map_err(|error| error.in_file(file))?;
        let name = file.file_name().unwrap_or(file.as_os_str()).to_string_lossy().into_owned();
        Ok(Self { name, scene, variants })
    }
}

fn protocol<'a>(arguments: &ConvergeArguments, cache: &'a Path) -> Protocol<'a> {
    let steps = &arguments.samples.0;
    let (schedule, samples) = match arguments.time {
        Some(limit) => (Schedule::Time(limit), 1024),
        None => {
            (Schedule::Samples(steps.clone()), steps.last().map_or(16, |last| last.saturating_mul(16).min(1 << 24)))
        }
    };
    Protocol {
        schedule,
        seeds: arguments.seeds,
        reference_samples: arguments.reference_samples.unwrap_or(samples),
        cache: Some(cache),
    }
}

/// Everything that can be refused is refused before the work.
fn refuse(folder: &Path, scenes: &[Subject]) -> Result<()> {
    for subject in scenes {
        refuse_folder_of(folder, &subject.scene.sources)?;
        refuse_folder_of(&folder.join("references"), &subject.scene.sources)?;
        for name in FILES {
            refuse_to_overwrite_sources(&folder.join(name), &subject.scene.sources)?;
        }
    }
    check_folder_target(folder)?;
    if folder.is_dir() {
        FILES.iter().try_for_each(|name| check_target(&folder.join(name)))?;
    }
    Ok(())
}

/// All four are there before the first takes its name.
fn write(report: &ConvergeReport, measure: Measure, folder: &Path) -> Result<()> {
    let (csv, json) = (converge_csv(report), report.to_json() + "\n");
    let chart = draw_convergence(report, measure);
    let (picture, svg) = (chart.to_drawing().encode()?, chart.to_svg());
    make_folder(folder)?;
    let paths = FILES.map(|name| folder.join(name));
    let contents = [csv.as_bytes(), json.as_bytes(), &picture, svg.as_bytes()];
    write_together(paths.iter().map(PathBuf::as_path).zip(contents))
}

fn default_folder(scenes: &[PathBuf]) -> PathBuf {
    let stems = scenes.iter().filter_map(|scene| scene.file_stem()).map(|stem| stem.to_string_lossy());
    PathBuf::from(std::iter::once("converge".into()).chain(stems).collect::<Vec<_>>().join("-"))
}

/// Shows one bar per phase.
struct Terminal;

/// A bar that goes with its phase.
struct PhaseBar(RenderBar);

impl Watch for Terminal {
    type Phase = PhaseBar;

    fn begin(&self, what: &str, work: Work) -> PhaseBar {
        PhaseBar(match work {
            Work::Samples(samples) => RenderBar::new(samples, what),
            Work::Time(limit) => RenderBar::until(limit, what),
        })
    }

    fn cancelled(&self) -> bool {
        interrupt::requested()
    }
}

impl Progress for PhaseBar {
    fn advance(&self, samples: u64, rays: u64) {
        self.0.advance(samples, rays);
    }

    fn cancelled(&self) -> bool {
        self.0.cancelled()
    }
}

impl Drop for PhaseBar {
    fn drop(&mut self) {
        self.0.finish();
    }
}
