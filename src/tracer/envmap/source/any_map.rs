//! A map of either kind: six faces, or an equirectangular picture.

use std::path::{Path, PathBuf};

use super::layout::EnvironmentPicture;
use super::picture_file::{read_file, read_header};
use super::{Skybox, is_zip};
use crate::error::Result;
use crate::picture::{self, Header};

/// What a path leads to.
#[derive(Debug)]
pub enum AnyMap {
    /// Six faces, square and of one size.
    Faces(Box<Skybox>),
    /// A picture of longitudes and latitudes; only its header is read.
    Equirectangular(PathBuf, Header),
}

impl AnyMap {
    /// Opens what [`Skybox::open`] does, or an equirectangular picture.
    pub fn open(path: &Path) -> Result<Self> {
        if path.is_file() && !is_zip(path)? {
            let (header, head) = read_header(|limit| read_file(path, limit), path)?;
            let attribute = picture::exr_environment(&head);
            let recognised = EnvironmentPicture::recognise(header.width, header.height, attribute);
            if let Ok(EnvironmentPicture::Equirectangular) = recognised {
                return Ok(Self::Equirectangular(path.to_owned(), header));
            }
        }
        Skybox::open(path).map(|skybox| Self::Faces(Box::new(skybox)))
    }

    /// The files that it is read from.
    pub fn files(&self) -> Vec<PathBuf> {
        match self {
            Self::Faces(skybox) => skybox.files(),
            Self::Equirectangular(path, _) => vec![path.clone()],
        }
    }

    /// The headers of the six faces, or of the one picture.
    pub fn headers(&self) -> Vec<Header> {
        match self {
            Self::Faces(skybox) => skybox.images.iter().map(|image| image.header()).collect(),
            Self::Equirectangular(_, header) => vec![*header],
        }
    }
}
