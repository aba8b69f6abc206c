//! `skycube convert`: a map in another layout, for another lookup, in another size or format.

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};

use super::encoding_options::EncodingOptions;
use super::options::{
    check_pixel_count, read_lookup, refuse_shared_images, refuse_source_folder, refuse_to_overwrite_sources,
};
use super::own_output::refuse_rivals;
use super::terminal::{Outcome, tell};
use crate::choice::name_of;
use crate::envmap::source::{AnyMap, Layout, Skybox};
use crate::envmap::{
    Face, ImageOperation, Lookup, MovedImage, Preset, SignedAxis, Sky, equirectangular_image, face_image, moved_images,
};
use crate::error::{Error, Result};
use crate::memory::check_memory;
use crate::parallel;
use crate::picture::{
    self, Header, OutputFormat, Picture, Raster, Texels, check_folder_target, check_target, folder_of, make_folder,
    write_together,
};
use crate::report::{ConvertReport, ConvertedFile};
use crate::validate::load;

#[derive(Debug, Args)]
pub struct ConvertArguments {
    /// The map: a folder, a zip, a cross, strip or sheet, an OpenEXR cube, an equirectangular picture
    map: PathBuf,
    /// The folder to write six files to, made if it is missing; or the picture, whose extension names its format
    #[arg(short, long, value_name = "PATH")]
    output: PathBuf,
    /// The layout to write
    #[arg(long, value_enum)]
    to: Target,
    /// The lookup that reads the faces of the map: a preset or a TOML file [default: humus-y-up]
    #[arg(long, value_name = "NAME|FILE.toml")]
    lookup: Option<String>,
    /// The lookup that will read the faces of the result; every direction keeps its colour [default: that of --lookup]
    #[arg(long, value_name = "NAME|FILE.toml")]
    to_lookup: Option<String>,
    /// Side of a face, or height of an equirectangular picture, in pixels [default: that of the map; a face has a quarter of
    /// the width of an equirectangular picture]
    #[arg(long, value_name = "PIXELS", value_parser = clap::value_parser!(u32).range(1..=16384))]
    size: Option<u32>,
    /// The axis that points to the top of an equirectangular picture [default: +y for opengl and humus-y-up, else +z]
    #[arg(long, value_name = "AXIS", allow_hyphen_values = true)]
    world_up: Option<SignedAxis>,
    /// Turn the equirectangular picture about the up axis, counterclockwise seen from above
    #[arg(long, value_name = "DEGREES", allow_negative_numbers = true)]
    rotate: Option<f64>,
    #[command(flatten)]
    encoding: EncodingOptions,
}

/// A layout that is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Target {
    /// Six files in a folder: posx, negx, posy, negy, posz, negz
    Faces,
    /// A horizontal cross, four cells by three
    Cross,
    /// A vertical cross, three cells by four, -Z upside down
    CrossVertical,
    /// +X -X +Y -Y +Z -Z from left to right
    Strip,
    /// +X -X +Y -Y +Z -Z from top to bottom
    StripVertical,
    /// Three cells by two, row by row +X -X +Y -Y +Z -Z
    #[value(name = "sheet-3x2")]
    SheetWide,
    /// Two cells by three, row by row +X -X +Y -Y +Z -Z
    #[value(name = "sheet-2x3")]
    SheetTall,
    /// One picture of longitudes and latitudes, twice as wide as high
    Equirectangular,
}

impl Target {
    /// The layout of six faces; `None` for an equirectangular picture.
    fn layout(self) -> Option<Layout> {
        match self {
            Target::Faces => Some(Layout::SixFiles),
            Target::Cross => Some(Layout::HorizontalCross),
            Target::CrossVertical => Some(Layout::VerticalCross),
            Target::Strip => Some(Layout::HorizontalStrip),
            Target::StripVertical => Some(Layout::VerticalStrip),
            Target::SheetWide => Some(Layout::WideSheet),
            Target::SheetTall => Some(Layout::TallSheet),
            Target::Equirectangular => None,
        }
    }
}

/// What is to be done, found free of contradictions.
struct Job<'a> {
    arguments: &'a ConvertArguments,
    map: AnyMap,
    /// The lookups of the map and of the result; of an equirectangular picture that of the other side.
    from: Lookup,
    to: Lookup,
    /// The name of the latter.
    lookup_name: &'a str,
    /// Side of a face of the result, or its height.
    size: usize,
    world_up: SignedAxis,
    turns: f64,
}

/// The pictures of the result before they are encoded, and what each is made of.
struct Made {
    pictures: Vec<Picture>,
    origins: Vec<String>,
    /// True if the map holds 8 bits.
    bytes: bool,
    /// How the texels came there.
    how: &'static str,
}

/// A file before it is written.
struct Converted {
    target: PathBuf,
    bytes: Vec<u8>,
    origin: String,
}

/// Converts, writes all files or none, and says what they are.
pub fn run(arguments: &ConvertArguments) -> Result<Outcome> {
    let job = Job::new(arguments)?;
    let (files, how) = job.files()?;
    let targets: Vec<PathBuf> = files.iter().map(|file| file.target.clone()).collect();
    for target in &targets {
        refuse_to_overwrite_sources(target, &job.map.files())?;
    }
    if arguments.to == Target::Faces {
        refuse_rivals(&targets)?;
        make_folder(&arguments.output)?;
    }
    write_together(files.iter().map(|file| (file.target.as_path(), file.bytes.as_slice())))?;
    let converted = |file: Converted| ConvertedFile { file: file.target.display().to_string(), origin: file.origin };
    let summary = format!("{}: {how}", job.description());
    tell(ConvertReport { files: files.into_iter().map(converted).collect(), summary });
    Ok(Outcome::Clean)
}

impl<'a> Job<'a> {
    fn new(arguments: &'a ConvertArguments) -> Result<Self> {
        let map = AnyMap::open(&arguments.map)?;
        refuse_contradictions(arguments, &map)?;
        let from_name = arguments.lookup.as_deref().unwrap_or("humus-y-up");
        let lookup_name = arguments.to_lookup.as_deref().unwrap_or(from_name);
        let (from, to) = (read_lookup(from_name)?, read_lookup(lookup_name)?);
        if arguments.to != Target::Equirectangular {
            refuse_shared_images(&to)?;
        }
        refuse_output(arguments, &map)?;
        let Header { width, height, .. } = map.headers()[0];
        let usual = match (&map, arguments.to) {
            (AnyMap::Faces(_), Target::Equirectangular) => 2 * width,
            (AnyMap::Equirectangular(..), to) if to != Target::Equirectangular => (width / 4).max(1),
            _ => height,
        };
        let size = arguments.size.map_or(usual, |size| size as usize);
        check_pixel_count([6 * size, size])?;
        let world_up = arguments.world_up.unwrap_or(Preset::usual_up_of(lookup_name));
        let turns = arguments.rotate.unwrap_or(0.0).rem_euclid(360.0) / 360.0;
        Ok(Self { arguments, map, from, to, lookup_name, size, world_up, turns })
    }

    /// Six faces of what size for which lookup, or how large a picture.
    fn description(&self) -> String {
        let Self { size, lookup_name, .. } = self;
        match self.arguments.to {
            Target::Equirectangular => format!("equirectangular, {size} texels high"),
            Target::Faces => format!("six faces of {size} x {size} texels for the lookup {lookup_name}"),
            to => format!("{}, faces of {size} x {size} texels for the lookup {lookup_name}", name_of(to)),
        }
    }

    /// The files, encoded, and how their texels came there.
    fn files(&self) -> Result<(Vec<Converted>, &'static str)> {
        let (arguments, headers) = (self.arguments, self.map.headers());
        if let Some(files) = self.copied()? {
            return Ok((files, "files copied"));
        }
        let folder = (arguments.to == Target::Faces).then_some(arguments.output.as_path());
        let format = match folder {
            Some(_) => arguments.encoding.format(None, &headers)?,
            None => arguments.encoding.format(Some(&arguments.output), &headers)?,
        };
        let Made { mut pictures, origins, bytes, how } = self.made()?;
        let options = arguments.encoding.write_options(format, &pictures, bytes)?;
        let Some(folder) = folder else {
            if let Some(layout) = arguments.to.layout() {
                let faces = pictures.try_into().expect("there are six faces");
                pictures = vec![layout.composed(&faces)];
            }
            let origin = match &origins[..] {
                [origin] => origin.clone(),
                _ => {
                    let line = |(face, it): (Face, &String)| format!("\n  {}: {it}", face.signed_name());
                    let lines: String = Face::ALL.into_iter().zip(&origins).map(line).collect();
                    format!("six faces{lines}")
                }
            };
            let bytes = pictures[0].encode_as(format, &options)?;
            return Ok((vec![Converted { target: arguments.output.clone(), bytes, origin }], how));
        };
        let encoded = parallel::map(&pictures, |picture| picture.encode_as(format, &options));
        let mut files = Vec::new();
        for ((face, origin), bytes) in Face::ALL.into_iter().zip(origins).zip(encoded) {
            let target = folder.join(face.name()).with_extension(format.extension());
            files.push(Converted { target, bytes: bytes?, origin });
        }
        Ok((files, how))
    }

    /// The files of the map under new names, if nothing else has to change.
    fn copied(&self) -> Result<Option<Vec<Converted>>> {
        let AnyMap::Faces(skybox) = &self.map else { return Ok(None) };
        let headers = self.map.headers();
        let as_it_is = self.arguments.to == Target::Faces && self.size == headers[0].width;
        if !as_it_is || !self.arguments.encoding.keep_files(&headers) {
            return Ok(None);
        }
        let mut files = Vec::new();
        for moved in self.moves() {
            let image = skybox.image(moved.source);
            let bytes = if moved.operation == ImageOperation::None { image.encoded_bytes()? } else { None };
            let Some(bytes) = bytes else { return Ok(None) };
            let extension = image.header().format.extension();
            let target = self.arguments.output.join(moved.target.name()).with_extension(extension);
            files.push(Converted { target, bytes, origin: format!("{} as it is", image.name()) });
        }
        Ok(Some(files))
    }

    /// What becomes of the images, in the order of the new ones.
    fn moves(&self) -> [MovedImage; 6] {
        let mut moves = moved_images(&self.from, &self.to);
        moves.sort_by_key(|moved| moved.target);
        moves
    }

    /// The six faces of the result by their names, or its equirectangular picture.
    fn made(&self) -> Result<Made> {
        let to_faces = self.arguments.to != Target::Equirectangular;
        match &self.map {
            AnyMap::Faces(skybox) if to_faces && self.size == skybox.images[0].header().width => self.moved(skybox),
            AnyMap::Faces(skybox) => {
                let map = load(skybox, self.from)?;
                let bytes = Face::ALL.iter().all(|&image| map.picture(image).is_ok_and(holds_bytes));
                let sky = Sky::of_cube_map(map)?;
                self.resampled(&sky, bytes)
            }
            AnyMap::Equirectangular(path, header) => {
                let picture = picture::read(path)?;
                let bytes = holds_bytes(&picture);
                if !to_faces && self.size == header.height {
                    let origins = vec![self.source_name()];
                    return Ok(Made { pictures: vec![picture], origins, bytes, how: "not resampled" });
                }
                let texels = (header.width * header.height) as u64;
                check_memory(texels * size_of::<[f32; 3]>() as u64, format_args!("the picture as light"))?;
                let turns = if to_faces { self.turns } else { 0.0 };
                let sky = Sky::of_equirectangular(&picture, self.world_up, turns);
                drop(picture);
                self.resampled(&sky, bytes)
            }
        }
    }

    /// The images of the map, exchanged, turned and mirrored.
    fn moved(&self, skybox: &Skybox) -> Result<Made> {
        let moves = self.moves();
        let moved = |moved: MovedImage| Ok(moved.operation.applied(&skybox.image(moved.source).decode()?));
        let pictures = parallel::map(moves, moved).into_iter().collect::<Result<Vec<_>>>()?;
        let bytes = pictures.iter().all(holds_bytes);
        Ok(Made {
            pictures,
            origins: moves.map(|moved| origin(skybox, moved)).into(),
            bytes,
            how: "moved, not resampled",
        })
    }

    fn resampled(&self, sky: &Sky, bytes: bool) -> Result<Made> {
        let header = self.map.headers()[0];
        let picture = |raster: Raster| {
            let header = Header { width: raster.width(), height: raster.height(), alpha: false, ..header };
            Picture::new(header, Texels::Linear(raster.pixels().to_vec()))
        };
        let pictures: Vec<Picture> = match self.arguments.to {
            Target::Equirectangular => vec![picture(equirectangular_image(sky, self.world_up, self.turns, self.size))],
            _ => {
                let mut faces = Face::ALL;
                faces.sort_by_key(|&face| self.to.row(face).image);
                faces.map(|face| picture(face_image(sky, &self.to, face, self.size))).into()
            }
        };
        let origins = vec![self.source_name(); pictures.len()];
        Ok(Made { pictures, origins, bytes, how: "resampled" })
    }

    /// The name of the map.
    fn source_name(&self) -> String {
        self.arguments.map.file_name().unwrap_or(self.arguments.map.as_os_str()).to_string_lossy().into_owned()
    }
}

fn holds_bytes(picture: &Picture) -> bool {
    matches!(picture.texels(), Texels::Srgb8(_))
}

/// `posz.png, turn 90° clockwise`.
fn origin(skybox: &Skybox, moved: MovedImage) -> String {
    let image = skybox.image(moved.source);
    let alpha = if image.header().alpha { ", without its alpha channel" } else { "" };
    match moved.operation {
        ImageOperation::None => format!("{}{alpha}", image.name()),
        operation => format!("{}, {}{alpha}", image.name(), operation.name()),
    }
}

/// An error if an option says something about faces or a picture that are not there.
fn refuse_contradictions(arguments: &ConvertArguments, map: &AnyMap) -> Result<()> {
    let from_picture = matches!(map, AnyMap::Equirectangular(..));
    let to_picture = arguments.to == Target::Equirectangular;
    if arguments.lookup.is_some() && from_picture {
        return Err(Error::new("--lookup reads six faces, and this is an equirectangular picture")
            .in_file(&arguments.map)
            .help("--to-lookup names the lookup that will read the result"));
    }
    if arguments.to_lookup.is_some() && to_picture {
        return Err(Error::new("--to-lookup reads six faces, and --to equirectangular writes one picture")
            .help("--lookup names the lookup that reads the map"));
    }
    for (option, given) in [("--world-up", arguments.world_up.is_some()), ("--rotate", arguments.rotate.is_some())] {
        if given && from_picture == to_picture {
            return Err(Error::new(format!("{option} has no effect here"))
                .expected(format!("{option} from an equirectangular picture to faces, or from faces to one")));
        }
    }
    match arguments.rotate {
        Some(angle) if !angle.is_finite() => {
            Err(Error::new(format!("--rotate {angle}")).expected("a number of degrees"))
        }
        _ => Ok(()),
    }
}

/// An error if the output is of the wrong kind, or lies among the pictures of the map.
fn refuse_output(arguments: &ConvertArguments, map: &AnyMap) -> Result<()> {
    let output = &arguments.output;
    let refuse_sources = |folder: &Path| match map {
        AnyMap::Faces(skybox) => refuse_source_folder(skybox, folder),
        AnyMap::Equirectangular(..) => Ok(()),
    };
    if arguments.to != Target::Faces {
        refuse_sources(folder_of(output))?;
        return check_target(output);
    }
    if OutputFormat::of_path(output).is_ok() && !output.is_dir() {
        return Err(Error::new("this is the name of a picture, and --to faces writes six")
            .in_file(output)
            .expected("a folder; --format names the format"));
    }
    check_folder_target(output)?;
    refuse_sources(output)
}
