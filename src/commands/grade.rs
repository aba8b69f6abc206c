//! `skycube grade`: the fault in a student's cube-map code, from six of their renders.

use std::path::{Path, PathBuf};

use clap::Args;

use super::engine_option::EngineOption;
use super::map_options::name_of_map;
use super::progress_bar::Spinner;
use super::report_options::ReportOptions;
use super::terminal::{Outcome, print, tell};
use crate::envmap::source::Skybox;
use crate::envmap::{Face, Lookup, Preset, SignedAxis, World};
use crate::error::{Error, Result};
use crate::grade::{Grade, GradeVerdict, Grader, ShotFrame};
use crate::picture::{Picture, read};
use crate::render::AxisShot;
use crate::report::{CodeLanguage, GradeReport, lookup_code};
use crate::validate::load;

#[derive(Debug, Args)]
#[command(
    after_help = "Exit codes: 0 right (or undecided), 1 faults found, 2 could not run. `skycube shots` prints the \
                  camera to copy."
)]
pub struct GradeArguments {
    /// The folder of your six pictures, posx.png to negz.png, named after the direction of the camera; any format
    shots: PathBuf,
    /// The map your tracer read: a folder, a zip, a cross or strip picture, an OpenEXR cube
    #[arg(long, value_name = "MAP")]
    map: PathBuf,
    /// The lookup that your code should have: a preset or a TOML file [default: course]
    #[arg(long)]
    lookup: Option<String>,
    #[command(flatten)]
    engine: EngineOption,
    /// The axis that points up in your world [default: +y for opengl and humus-y-up, else +z]
    #[arg(long, value_name = "AXIS", allow_hyphen_values = true)]
    world_up: Option<SignedAxis>,
    /// Print the repaired function instead, with marks where your code differs
    #[arg(long, value_name = "LANGUAGE", conflicts_with_all = ["json", "format"])]
    code: Option<CodeLanguage>,
    #[command(flatten)]
    pub(super) report: ReportOptions,
}

/// Grades and prints.
pub fn run(arguments: &GradeArguments) -> Result<Outcome> {
    let (engine, given) = (arguments.engine, arguments.lookup.as_deref());
    let lookup_name = engine.name(given, "course");
    let skybox = Skybox::open_lenient(&arguments.map)?;
    let lookup = engine.lookup(given, "course", &skybox)?;
    let world_up = arguments.world_up.or(engine.world_up()).unwrap_or_else(|| Preset::usual_up_of(&lookup_name));
    let spinner = Spinner::new("grading");
    let grade = grade(&skybox, &arguments.shots, lookup, world_up).inspect_err(|_| spinner.finish())?;
    spinner.finish();
    let name = name_of_map(&arguments.map);
    let report = GradeReport {
        grade: &grade,
        map: &name,
        lookup: &lookup_name,
        lookup_given: given.is_some() || engine.world_up().is_some(),
        table: lookup,
        world_up,
    };
    let clean = matches!(grade.verdict(), GradeVerdict::Right | GradeVerdict::Undecided);
    if let Some(language) = arguments.code {
        print(lookup_code(&lookup, &grade.lookup_of_code(&lookup), language));
    } else if arguments.report.is_text() {
        tell(&report);
    } else if arguments.report.is_quiet_text() && !clean {
        tell(format_args!("{}: {}\n", arguments.shots.display(), report.verdict()));
    }
    arguments.report.print("grade", &[report.examined(&arguments.shots)], || report.to_json());
    Ok(arguments.report.outcome(if clean { Outcome::Clean } else { Outcome::Faults }))
}

/// Reads the images and the shots, and grades them.
fn grade(skybox: &Skybox, shots: &Path, lookup: Lookup, world_up: SignedAxis) -> Result<Grade> {
    let shots = read_shots(shots)?;
    let map = load(skybox, lookup)?;
    let frames = AxisShot::all(World { up: world_up, handedness: lookup.handedness() }).map(|shot| ShotFrame {
        face: shot.direction,
        right: shot.right(),
        up: shot.up,
    });
    Ok(Grader::new(&map, frames)?.grade(&shots))
}

/// The six shots in the order of [`Face::ALL`].
fn read_shots(folder: &Path) -> Result<[Picture; 6]> {
    let entries = std::fs::read_dir(folder).map_err(|error| {
        let problem = match folder {
            missing if !missing.exists() => "the folder does not exist".to_owned(),
            file if file.is_file() => "this is a file, not a folder".to_owned(),
            _ => format!("cannot read the folder of shots: {error}"),
        };
        Error::new(problem)
            .in_file(folder)
            .expected("a folder with posx.png, negx.png, posy.png, negy.png, posz.png and negz.png")
    })?;
    let mut files: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).filter(|path| path.is_file()).collect();
    files.sort();
    let mut shots = Vec::new();
    for face in Face::ALL {
        shots.push(read_shot(folder, face, &files)?);
    }
    Ok(shots.try_into().expect("there are six faces"))
}

fn read_shot(folder: &Path, face: Face, files: &[PathBuf]) -> Result<Picture> {
    let name = face.name();
    let named = |path: &&PathBuf| path.file_stem().is_some_and(|stem| stem.eq_ignore_ascii_case(name));
    let path = match files.iter().filter(named).collect::<Vec<_>>()[..] {
        [path] => path,
        [] => {
            let found: Vec<_> = files.iter().filter_map(|path| path.file_name()?.to_str()).take(12).collect();
            let found = if found.is_empty() { "no file".to_owned() } else { found.join(", ") };
            return Err(Error::new(format!("the shot {name} is missing; the folder holds {found}"))
                .in_file(folder)
                .expected(format!("{name}.png (or .jpg, .exr, ...), the picture along {}", face.signed_name())));
        }
        [first, second, ..] => {
            return Err(Error::new(format!(
                "two files are the shot {name}: {} and {}",
                first.display(),
                second.display()
            ))
            .in_file(folder)
            .help("leave one of them"));
        }
    };
    let picture = read(path)?;
    if picture.width() != picture.height() {
        return Err(Error::new(format!("the shot is {} x {} pixels", picture.width(), picture.height()))
            .in_file(path)
            .expected("a square picture of a camera that is 90° wide and high"));
    }
    if picture.width() < SMALLEST {
        return Err(Error::new(format!("the shot is {} pixels wide: too small to judge", picture.width()))
            .in_file(path)
            .expected(format!("at least {SMALLEST} x {SMALLEST} pixels")));
    }
    Ok(picture)
}

/// Smaller shots show too little.
const SMALLEST: usize = 16;
