//! `skycube fix`: six corrected files for the given lookup, or the corrected lookup as code.

use std::path::{Path, PathBuf};

use clap::Args;

use super::check::ValidationOptions;
use super::engine_option::EngineOption;
use super::library::for_each_map;
use super::options::{refuse_shared_images, refuse_source_folder, refuse_to_overwrite_sources};
use super::own_output::refuse_rivals;
use super::terminal::{Outcome, print, remark, tell};
use crate::envmap::Orientation;
use crate::envmap::source::Skybox;
use crate::error::{Error, Result};
use crate::picture::{check_folder_target, make_folder, write_together};
use crate::report::{CodeLanguage, lookup_code};
use crate::validate::{Check, FaceFix, Verdict};

#[derive(Debug, Args)]
pub struct FixArguments {
    /// A folder, zip, cross or strip; a folder of maps; - for a zip or picture on standard input
    map: PathBuf,
    /// The folder to write the six corrected files to, under the names of --engine; made if it is missing. Of a folder of maps,
    /// each gets its own inside
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// Print the corrected lookup instead
    #[arg(long, value_name = "LANGUAGE", conflicts_with = "output")]
    code: Option<CodeLanguage>,
    #[command(flatten)]
    validation: ValidationOptions,
}

/// A corrected file before it is written.
struct Corrected {
    target: PathBuf,
    bytes: Vec<u8>,
    what: String,
}

/// Repairs a map, or each map of a folder. Ends with faults if a map is still broken.
pub fn run(arguments: &FixArguments) -> Result<Outcome> {
    if arguments.output.is_none() && arguments.code.is_none() {
        return Err(Error::new("neither -o nor --code is given")
            .expected("-o FOLDER for six corrected files, or --code cpp|glsl|rust|java|python|csharp|toml for the corrected lookup"));
    }
    for_each_map(&arguments.map, arguments.output.as_deref(), |map, output| fix(arguments, map, output))
}

fn fix(arguments: &FixArguments, map: &Path, output: Option<&Path>) -> Result<Outcome> {
    let skybox = Skybox::open_lenient(map)?;
    let (check, config, reading) = arguments.validation.check(map, &skybox)?;
    config.iter().for_each(|config| remark(format_args!("{}\n", config.line())));
    if let Some(language) = arguments.code {
        print(lookup_code(&check.fix.lookup(&check.lookup), &check.lookup, language));
    } else if let Some(folder) = output {
        write_files(&skybox, &check, folder, reading.engine)?;
        if check.verdict == Verdict::Fits && check.fix.changes == 0 {
            remark(format_args!("nothing to fix: the faces fit as they are\n"));
        }
    }
    for note in check.unrepaired() {
        remark(format_args!("not repaired: {note}\n"));
    }
    let undecided = check.fix.faces.iter().filter(|fix| !fix.decided && fix.is_unchanged(&check.lookup));
    if check.verdict == Verdict::Broken && check.outliers.is_empty() {
        for fix in undecided {
            let file = &check.images[fix.image.index()].file;
            remark(format_args!("left as it is: the pixels do not determine the orientation of {file}\n"));
        }
    }
    if check.verdict == Verdict::Undecidable {
        remark(format_args!("undecidable: the pixels cannot decide whether these faces fit; nothing was changed\n"));
    }
    let still_broken = check.verdict == Verdict::Broken && (check.fix.changes == 0 || !check.unrepaired().is_empty());
    if still_broken && check.unrepaired().is_empty() {
        remark(format_args!("broken, but no change is certain; nothing was changed\n"));
    }
    Ok(if still_broken { Outcome::Faults } else { Outcome::Clean })
}

fn write_files(skybox: &Skybox, check: &Check, folder: &Path, engine: EngineOption) -> Result<()> {
    refuse_source_folder(skybox, folder)?;
    refuse_shared_images(&check.lookup)?;
    check_folder_target(folder)?;
    let mut files = Vec::new();
    for fix in &check.fix.faces {
        let slot = check.lookup.row(fix.face).image;
        let target = folder.join(engine.file_name(fix.face).unwrap_or(slot.name()));
        files.push(corrected(skybox, fix, &target)?);
    }
    for file in &files {
        refuse_to_overwrite_sources(&file.target, &skybox.files())?;
    }
    let targets: Vec<PathBuf> = files.iter().map(|file| file.target.clone()).collect();
    refuse_rivals(&targets)?;
    make_folder(folder)?;
    write_together(files.iter().map(|file| (file.target.as_path(), file.bytes.as_slice())))?;
    for file in &files {
        tell(format_args!("wrote {}: {}\n", file.target.display(), file.what));
    }
    for sentence in check.fix.story.sentences() {
        tell(format_args!("{sentence}\n"));
    }
    Ok(())
}

/// The file that the given lookup will read for a face; `target` has no extension yet.
fn corrected(skybox: &Skybox, fix: &FaceFix, target: &Path) -> Result<Corrected> {
    let image = skybox.image(fix.image);
    let target = |extension: &str| target.with_extension(extension);
    if fix.orientation == Orientation::IDENTITY
        && let Some(bytes) = image.encoded_bytes()?
    {
        let what = format!("{} as it is", image.name());
        return Ok(Corrected { target: target(image.header().format.extension()), bytes, what });
    }
    let picture = image.decode()?;
    if picture.width() != picture.height() && fix.orientation != Orientation::IDENTITY {
        return Err(Error::new(format!("{} x {} pixels cannot be turned", picture.width(), picture.height()))
            .in_file(image.name())
            .expected("a square picture"));
    }
    let operation = fix.image_operation;
    let (bytes, extension) = operation.applied(&picture).encode_lossless()?;
    let alpha = if picture.header().alpha { ", without its alpha channel" } else { "" };
    let what = match fix.orientation {
        Orientation::IDENTITY => format!("{} cut out{alpha}", image.name()),
        _ => format!("{}, {}{alpha}", image.name(), operation.name()),
    };
    Ok(Corrected { target: target(extension), bytes, what })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::envmap::{Face, ImageOperation};
    use crate::picture;

    #[test]
    fn unchanged_faces_are_copied_and_others_placed() {
        let folder = tempfile::tempdir().unwrap();
        let compass = Path::new(env!("CARGO_MANIFEST_DIR")).join("envmaps/compass");
        for face in Face::ALL {
            let name = format!("{}.png", face.name());
            std::fs::copy(compass.join(&name), folder.path().join(&name)).unwrap();
        }
        let broken = folder.path().join("posy.png");
        let original = picture::read(&broken).unwrap();
        let (bytes, _) = ImageOperation::TurnClockwise.applied(&original).encode_lossless().unwrap();
        std::fs::write(&broken, bytes).unwrap();
        let output = folder.path().join("fixed");
        let validation = ValidationOptions {
            lookup: None,
            engine: EngineOption::default(),
            world_up: None,
            trust_names: false,
            any_order: false,
            no_config: true,
        };
        let arguments =
            FixArguments { map: folder.path().to_owned(), output: Some(output.clone()), code: None, validation };
        assert_eq!(run(&arguments).unwrap(), Outcome::Clean);
        for face in Face::ALL {
            let name = format!("{}.png", face.name());
            if face == Face::PosY {
                assert_eq!(picture::read(&output.join(&name)).unwrap().texels(), original.texels());
            } else {
                assert_eq!(std::fs::read(output.join(&name)).unwrap(), std::fs::read(compass.join(&name)).unwrap());
            }
        }
        let again = FixArguments { output: Some(folder.path().to_owned()), ..arguments };
        assert!(run(&again).is_err(), "the folder of the sources is refused");
    }
}
