//! The cube map: directions in, colours out. [`CubeMap::sample`] is the exercise's `get_texel`.

use super::face::Face;
use super::lazy_image::LazyImage;
use super::lookup::{FacePoint, ImagePoint, Lookup};
use super::seamless;
use super::source::Skybox;
use crate::error::{Error, Result};
use crate::math::Vec3;
use crate::picture::Picture;

/// How a colour is read between texels.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize, clap::ValueEnum)]
#[serde(rename_all = "lowercase")]
pub enum CubeFilter {
    /// The colour of the texel the direction falls into.
    Nearest,
    /// Bilinear within the face, clamped at its border, as the exercise does it.
    #[default]
    Bilinear,
    /// Bilinear across the borders: at a seam both faces give the same colour.
    Seamless,
}

/// Six pictures around the origin, and the lookup that says which direction reads which texel.
#[derive(Debug)]
pub struct CubeMap {
    lookup: Lookup,
    filter: CubeFilter,
    /// By the name of the image, in the order of [`Face::ALL`].
    images: [LazyImage; 6],
}

impl CubeMap {
    /// A cube map that decodes an image when a direction first reaches it.
    pub fn new(images: [LazyImage; 6], lookup: Lookup, filter: CubeFilter) -> Self {
        Self { lookup, filter, images }
    }

    /// A cube map of a skybox's images.
    pub fn from_skybox(skybox: &Skybox, lookup: Lookup, filter: CubeFilter) -> Self {
        let images = skybox.images.clone().map(|image| LazyImage::new(Box::new(move || image.decode())));
        Self::new(images, lookup, filter)
    }

    pub fn lookup(&self) -> &Lookup {
        &self.lookup
    }

    pub fn filter(&self) -> CubeFilter {
        self.filter
    }

    /// The same pictures under another lookup.
    pub fn with_lookup(self, lookup: Lookup) -> Self {
        Self { lookup, ..self }
    }

    /// The same pictures read another way between texels.
    pub fn with_filter(self, filter: CubeFilter) -> Self {
        Self { filter, ..self }
    }

    /// From now on colours between texels are read another way.
    pub fn set_filter(&mut self, filter: CubeFilter) {
        self.filter = filter;
    }

    /// Linear colour seen in a direction of any length; black if the image cannot be decoded, see
    /// [`CubeMap::errors`].
    #[inline]
    pub fn sample(&self, direction: Vec3) -> Vec3 {
        // Code of its own for every face: the processor foresees the branch and fetches row and picture of the table
        // while u and v are still being computed (measured: 1.5 times as fast as one code for all).
        match Lookup::face_towards(direction) {
            Face::PosX => self.sample_on::<{ Face::PosX as usize }>(direction),
            Face::NegX => self.sample_on::<{ Face::NegX as usize }>(direction),
            Face::PosY => self.sample_on::<{ Face::PosY as usize }>(direction),
            Face::NegY => self.sample_on::<{ Face::NegY as usize }>(direction),
            Face::PosZ => self.sample_on::<{ Face::PosZ as usize }>(direction),
            Face::NegZ => self.sample_on::<{ Face::NegZ as usize }>(direction),
        }
    }

    /// Linear colour seen in a direction that points to the face.
    #[inline(never)]
    fn sample_on<const FACE: usize>(&self, direction: Vec3) -> Vec3 {
        self.sample_point(self.lookup.locate_on(Face::ALL[FACE], direction))
    }

    /// Linear colour at a place on the cube.
    #[inline(always)]
    pub fn sample_point(&self, point: FacePoint) -> Vec3 {
        let place = self.lookup.image_point(point);
        let Some(picture) = self.images[place.image.index()].picture() else { return Vec3::ZERO };
        if self.filter == CubeFilter::Bilinear {
            return place.bilinear(picture);
        }
        self.sample_otherwise(point, place, picture)
    }

    /// The filters beside the default one, kept out of its way.
    #[inline(never)]
    fn sample_otherwise(&self, point: FacePoint, place: ImagePoint, picture: &Picture) -> Vec3 {
        match self.filter {
            CubeFilter::Seamless => seamless::sample(self, point, picture),
            _ => place.nearest(picture),
        }
    }

    /// The picture an image name stands for, decoded now if it was not yet.
    pub fn picture(&self, image: Face) -> Result<&Picture> {
        self.images[image.index()].try_picture()
    }

    /// The images that were looked at, in the order of [`Face::ALL`].
    pub fn looked_at(&self) -> Vec<Face> {
        Face::ALL.into_iter().filter(|image| self.images[image.index()].looked_at()).collect()
    }

    /// Why images that a direction reached could not be decoded.
    pub fn errors(&self) -> impl Iterator<Item = &Error> {
        self.images.iter().filter_map(LazyImage::error)
    }

    /// The picture an image name stands for, if it can be decoded.
    pub(super) fn image_picture(&self, image: Face) -> Option<&Picture> {
        self.images[image.index()].picture()
    }
}
