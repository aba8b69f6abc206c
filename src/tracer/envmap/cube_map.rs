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

    /// The table in use.
    pub fn lookup(&self) -> &Lookup {
        &self.lookup
    }

    /// How colours between texels are read.
    pub fn filter(&self) -> CubeFilter {
        self.filter
    }

    /// The same pictures under another lookup.
    pub fn with_lookup(self, lookup: Lookup) -> Self {
        Self { lookup, ..self }
    }

    /// From now on colours between texels are read another way.
    pub fn set_filter(&mut self, filter: CubeFilter) {
        self.filter = filter;
    }

    /// Linear colour seen in a direction of any length: the exercise's `get_texel`. Black if the image cannot be decoded, see
    /// [`CubeMap::errors`].
    #[inline(never)]
    pub fn sample(&self, direction: Vec3) -> Vec3 {
        // Which face the direction meets, and where.
        let point = self.lookup.locate(direction);
        // Where that is in which picture.
        let place = self.lookup.image_point(point);
        let Some(picture) = self.images[place.image.index()].picture() else { return Vec3::ZERO };
        // The colour between the texels.
        let (x, y) = place.texels(picture);
        match self.filter {
            CubeFilter::Nearest => picture.nearest(x, y),
            CubeFilter::Bilinear => picture.bilinear(x, y),
            CubeFilter::Seamless => self.across_seams(point, picture).unwrap_or_else(|| picture.bilinear(x, y)),
        }
    }

    /// Kept out of the other filters' way.
    #[inline(never)]
    fn across_seams(&self, point: FacePoint, picture: &Picture) -> Option<Vec3> {
        let corners = seamless::Corners::new(&self.lookup, point, picture.width())?;
        Some(corners.blend(corners.colours(|place| self.texel(place))))
    }

    /// The colour of the texel that a place falls into; `None` if its picture cannot be decoded.
    #[inline]
    pub(super) fn texel(&self, place: ImagePoint) -> Option<Vec3> {
        Some(place.nearest(self.picture(place.image).ok()?))
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
}
