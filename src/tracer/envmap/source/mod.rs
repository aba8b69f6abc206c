//! Sources of the six images of a skybox: a folder, a zip as downloaded, six named files, or one picture.
//!
//! Opening reads names and headers. Pixels are decoded face by face, on demand.

mod any_map;
mod composed;
mod cross;
mod face_image;
mod folder;
mod layout;
mod listing;
mod listing_errors;
mod naming;
mod passing_over;
mod picture_file;
mod selection;
mod sheet;
mod sizes;
#[cfg(test)]
mod tests;

use std::path::{Path, PathBuf};
use std::sync::Arc;

pub use any_map::AnyMap;
pub use face_image::FaceImage;
pub use layout::{EnvironmentPicture, Layout};
pub use listing::Naming;
pub use passing_over::is_passed_over;
pub use sizes::{SizeFault, SizeFaultKind};
use skycube_files::archive::Archive;
use skycube_files::is_standard_stream;

use self::listing::Located;
use self::sheet::Sheet;
use crate::envmap::Face;
use crate::error::{Error, Result};

/// Six images, each the image of the face it is named after. Which image a direction reads is for the lookup to say.
#[derive(Debug, Clone)]
pub struct Skybox {
    /// In the order of [`Face::ALL`].
    pub images: [FaceImage; 6],
    /// How the images are stored.
    pub layout: Layout,
    /// What the names of the images say.
    pub naming: Naming,
    /// The files beside the faces that were not used, sorted.
    pub passed_over: Vec<String>,
}

impl Skybox {
    /// Opens a folder, a zip (or a folder in it: `sky.zip/night`), a cross or strip, or an OpenEXR file with
    /// `envmap = cube`. The faces are square and alike in size; an error names those that are not.
    pub fn open(path: &Path) -> Result<Self> {
        Self::open_lenient(path)?.in_order().and_then(Self::of_one_size).map_err(|error| error.in_file(path))
    }

    /// As [`Skybox::open`], but faces of any size are taken, [`Skybox::size_faults`] names them; and so are six pictures whose
    /// names do not say which face they are. `-` is a zip or a picture on standard input.
    pub fn open_lenient(path: &Path) -> Result<Self> {
        if path.is_dir() {
            return open_folder(path);
        }
        if let Some(set) = open_set(path)? {
            return Ok(set);
        }
        if path.is_file() || is_standard_stream(path) {
            return if is_zip(path)? { open_archive(path, None) } else { open_picture(path) };
        }
        match enclosing_file(path) {
            Some((archive, subfolder)) if is_zip(&archive)? => open_archive(&archive, Some(&subfolder)),
            _ => Err(Error::new("the file or folder does not exist").in_file(path)),
        }
    }

    /// Six named files, each face once in any order, square and alike in size.
    pub fn from_files(files: &[(Face, PathBuf)]) -> Result<Self> {
        Self::from_files_lenient(files)?.of_one_size()
    }

    /// As [`Skybox::from_files`], but faces of any size are taken: [`Skybox::size_faults`] names them.
    pub fn from_files_lenient(files: &[(Face, PathBuf)]) -> Result<Self> {
        let mut paths = Vec::new();
        for face in Face::ALL {
            let mut named = files.iter().filter(|(named, _)| *named == face).map(|(_, path)| path.clone());
            match (named.next(), named.next()) {
                (Some(path), None) => paths.push(path),
                (None, _) => return Err(Error::new(format!("no file is named for {}", face.name())).expected(ONE_EACH)),
                _ => return Err(Error::new(format!("several files are named for {}", face.name())).expected(ONE_EACH)),
            }
        }
        let images = images(|index| {
            let path = &paths[index];
            FaceImage::from_file(path.clone(), path.display().to_string())
        })?;
        Ok(Self { images, layout: Layout::SixFiles, naming: Naming::Faces, passed_over: Vec::new() })
    }

    /// Six pictures in the order of [`Face::ALL`]; `None` if one is not square.
    pub fn of_six_squares(paths: &[PathBuf]) -> Option<Self> {
        let files: Vec<(Face, PathBuf)> = Face::ALL.into_iter().zip(paths.iter().cloned()).collect();
        let all_files = paths.len() == 6 && paths.iter().all(|path| path.is_file());
        let skybox = if all_files { Self::from_files_lenient(&files).ok()? } else { return None };
        let square = |image: &FaceImage| image.header().width == image.header().height;
        skybox.images.iter().all(square).then_some(skybox)
    }

    /// The image named after a face.
    pub fn image(&self, face: Face) -> &FaceImage {
        &self.images[face.index()]
    }

    /// The files on disk that the images are read from, each once.
    pub fn files(&self) -> Vec<PathBuf> {
        let mut files: Vec<PathBuf> = self.images.iter().map(|image| image.file().to_path_buf()).collect();
        files.dedup();
        files
    }

    /// The faces that are not square, or differ in size from most.
    pub fn size_faults(&self) -> Vec<SizeFault> {
        sizes::size_faults([0, 1, 2, 3, 4, 5].map(|index| {
            let header = self.images[index].header();
            (header.width, header.height)
        }))
    }

    /// An error if the names do not say which face each image is; cells of a strip or sheet have a usual order.
    fn in_order(self) -> Result<Self> {
        match self.naming {
            Naming::Faces | Naming::Cells => Ok(self),
            Naming::Numbers | Naming::Nothing => {
                Err(Error::new("the names of these six pictures do not tell the faces")
                    .expected("names such as posx negx posy negy posz negz")
                    .help("`skycube fix` finds the order from the pixels and writes six files with such names"))
            }
        }
    }

    fn of_one_size(self) -> Result<Self> {
        let name = |face: Face| self.image(face).name().to_owned();
        sizes::size_error(&self.size_faults(), name).map_or(Ok(self), Err)
    }
}

const ONE_EACH: &str = "one file for each of posx, negx, posy, negy, posz, negz";

fn open_folder(path: &Path) -> Result<Skybox> {
    let paths = folder::list(path)?;
    let located = listing::find_faces(&paths).map_err(|error| error.in_file(path))?;
    let skybox = open_files(path, &paths, located)?;
    // Six arbitrary pictures are not a map, even if nothing else lies beside them.
    if skybox.naming == Naming::Nothing && !skybox.size_faults().is_empty() {
        return Err(listing_errors::no_faces(&paths).in_file(path));
    }
    Ok(skybox)
}

fn open_files(folder: &Path, paths: &[String], located: Located) -> Result<Skybox> {
    let images = images(|index| {
        let name = &paths[located.six[index]];
        FaceImage::from_file(folder.join(name), name.clone())
    });
    let images = images.map_err(|error| error.in_file(folder))?;
    let Located { naming, passed_over, .. } = located;
    Ok(Skybox { images, layout: Layout::SixFiles, naming, passed_over })
}

/// One of several sets in a folder, by what its files begin with; `None` if the path does not mean one.
fn open_set(path: &Path) -> Result<Option<Skybox>> {
    let (Some(folder), Some(name)) = (path.parent(), path.file_name()) else { return Ok(None) };
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    if path.exists() || !folder.is_dir() {
        return Ok(None);
    }
    let paths = folder::list(folder)?;
    let name = name.to_string_lossy();
    let mut sets = listing::sets(&paths).into_iter();
    let meant = sets.find(|(prefix, _)| prefix == selection::without_separators(&name));
    meant.map(|(_, located)| open_files(folder, &paths, located)).transpose()
}

/// The sets of six faces in a folder that holds several, as paths that [`Skybox::open`] takes.
pub fn sets_in(folder: &Path) -> Vec<PathBuf> {
    let sets = listing::sets(&folder::list(folder).unwrap_or_default());
    sets.into_iter().map(|(prefix, _)| folder.join(prefix)).collect()
}

fn open_archive(path: &Path, subfolder: Option<&str>) -> Result<Skybox> {
    let archive = Archive::open(path)?;
    // What follows the slash may be the prefix of a set instead.
    let sets = listing::sets(&archive.paths());
    let set =
        sets.into_iter().find(|(prefix, _)| subfolder.map(selection::without_separators) == Some(prefix.as_str()));
    let archive = match subfolder {
        Some(folder) if set.is_none() => archive.subfolder(folder)?,
        _ => archive,
    };
    let located = match set {
        Some((_, located)) => located,
        None => listing::find_faces(&archive.paths()).map_err(|error| error.in_file(path))?,
    };
    let images = images(|index| {
        let entry = archive.entry(located.six[index]);
        let name = entry.name();
        FaceImage::from_entry(entry, name)
    });
    let images = images.map_err(|error| error.in_file(path))?;
    let Located { naming, passed_over, .. } = located;
    Ok(Skybox { images, layout: Layout::SixFiles, naming, passed_over })
}

fn open_picture(path: &Path) -> Result<Skybox> {
    let sheet = Arc::new(Sheet::open(path)?);
    let images = Face::ALL.map(|face| FaceImage::from_cell(&sheet, face));
    let naming = if sheet.layout().has_free_order() { Naming::Cells } else { Naming::Faces };
    Ok(Skybox { images, layout: sheet.layout(), naming, passed_over: Vec::new() })
}

/// True if a folder is meant as a map, readable or not: most of the faces have a file of their name in it, its
/// subfolders apart.
pub fn is_meant_as_map(folder: &Path) -> bool {
    let paths = folder::list(folder).unwrap_or_default();
    let own: Vec<String> = paths.into_iter().filter(|path| !path.contains('/')).collect();
    listing::names_most_faces(&own)
}

/// Six images by their place in [`Face::ALL`]. One error names all that cannot be read.
fn images(open: impl Fn(usize) -> Result<FaceImage>) -> Result<[FaceImage; 6]> {
    let mut images = Vec::new();
    let mut errors = Vec::new();
    for (index, face) in Face::ALL.into_iter().enumerate() {
        match open(index) {
            Ok(image) => images.push(image),
            Err(error) => errors.push((face, error)),
        }
    }
    images.try_into().map_err(|_| unreadable(errors))
}

/// The error for faces whose headers cannot be read.
fn unreadable(mut errors: Vec<(Face, Error)>) -> Error {
    if errors.len() == 1 {
        return errors.remove(0).1;
    }
    let line =
        |(face, error): &(Face, Error)| format!("\n  {}: {}", face.name(), error.to_string().replace('\n', "\n  "));
    let lines: String = errors.iter().map(line).collect();
    Error::new(format!("{} of the six faces cannot be read{lines}", errors.len()))
}

/// True if a file begins as a zip archive does, or is named as one.
fn is_zip(path: &Path) -> Result<bool> {
    Ok(picture_file::read_file(path, Some(2))? == b"PK"
        || path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("zip")))
}

/// The file that a path leads into, and the rest of the path with `/` between its parts.
fn enclosing_file(path: &Path) -> Option<(PathBuf, String)> {
    let file = path.ancestors().skip(1).find(|ancestor| ancestor.is_file())?;
    let rest = path.strip_prefix(file).ok()?;
    let parts: Vec<_> = rest.components().map(|part| part.as_os_str().to_string_lossy()).collect();
    Some((file.to_path_buf(), parts.join("/")))
}
