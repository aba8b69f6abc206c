//! The lookup of one direction step by step, with every intermediate number.

use super::cube_map::{CubeFilter, CubeMap};
use super::face::Face;
use super::lookup::{FaceLookup, FacePoint, ImagePoint};
use super::seamless;
use super::v_origin::VOrigin;
use crate::error::{Error, Result};
use crate::math::Vec3;
use crate::picture::{Footprint, Picture};

/// What [`CubeMap::sample`] does for one direction.
#[derive(Debug, Clone, PartialEq)]
pub struct Probe {
    /// The direction that was looked up, in the world; of any length.
    pub direction: Vec3,
    /// The largest absolute value of a component.
    pub largest: f32,
    /// Numbers of the axes whose components are that large: more than one on a tie, of which the first wins.
    pub largest_axes: Vec<usize>,
    /// Face, u and v.
    pub point: FacePoint,
    /// The face's row of the table: image, axis of u, axis of v.
    pub row: FaceLookup,
    /// Where v = 0 lies in the image.
    pub v_origin: VOrigin,
    /// Width and height of the image in texels.
    pub size: [usize; 2],
    /// The place in the image, in texels from its top left corner; texel centres are at half integers.
    pub position: [f32; 2],
    /// How the texels are blended.
    pub filter: CubeFilter,
    /// The texels that count, one or four, in the order in which they are added.
    pub texels: Vec<ProbedTexel>,
    /// Linear colour: the same bits that [`CubeMap::sample`] gives.
    pub colour: Vec3,
}

/// A texel and what it counts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ProbedTexel {
    /// The image and the column and row in it; `None` for the texel that is missing at a corner of the cube and is the
    /// mean of the other three.
    pub place: Option<TexelPlace>,
    /// What the texel counts; the weights of all texels sum to 1.
    pub weight: f32,
    /// Linear.
    pub colour: Vec3,
}

/// A texel of an image, counted from the top left.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TexelPlace {
    /// The image, by its name.
    pub image: Face,
    /// From the left, starting at 0.
    pub column: usize,
    /// From the top, starting at 0.
    pub row: usize,
}

impl Probe {
    /// Follows a direction. An error if it points nowhere (zero, infinite, not a number) or an image it reaches cannot
    /// be decoded.
    pub fn new(map: &CubeMap, direction: Vec3) -> Result<Self> {
        if !direction.is_finite() || direction == Vec3::ZERO {
            return Err(
                Error::new(format!("{direction} has no direction")).expected("three finite numbers, not all zero")
            );
        }
        let absolute = direction.abs();
        let largest = absolute.max_element();
        let point = map.lookup().locate(direction);
        let row = map.lookup().row(point.face);
        let picture = map.picture(row.image)?;
        let place = map.lookup().image_point(point);
        let position = place.texels(picture);
        let (texels, colour) = match map.filter() {
            CubeFilter::Nearest => nearest(place, picture),
            CubeFilter::Bilinear => bilinear(place, picture),
            CubeFilter::Seamless => across_borders(map, point, picture)?,
        };
        Ok(Self {
            direction,
            largest,
            largest_axes: (0..3).filter(|&axis| absolute[axis] == largest).collect(),
            point,
            row,
            v_origin: map.lookup().v_origin(),
            size: [picture.width(), picture.height()],
            position: position.into(),
            filter: map.filter(),
            texels,
            colour,
        })
    }
}

fn nearest(place: ImagePoint, picture: &Picture) -> (Vec<ProbedTexel>, Vec3) {
    let texel = texel_at(place, picture);
    let colour = place.nearest(picture);
    (vec![ProbedTexel { place: Some(texel), weight: 1.0, colour }], colour)
}

fn bilinear(place: ImagePoint, picture: &Picture) -> (Vec<ProbedTexel>, Vec3) {
    let (x, y) = place.texels(picture);
    let footprint = Footprint::new(x, y, picture.width(), picture.height());
    let texels = footprint.weighted_texels().map(|(column, row, weight)| ProbedTexel {
        place: Some(TexelPlace { image: place.image, column, row }),
        weight,
        colour: picture.texel(column, row),
    });
    (texels.to_vec(), footprint.interpolate(|column, row| picture.texel(column, row)))
}

fn across_borders(map: &CubeMap, point: FacePoint, picture: &Picture) -> Result<(Vec<ProbedTexel>, Vec3)> {
    let Some(corners) = seamless::Corners::new(map.lookup(), point, picture.width()) else {
        return Ok(bilinear(map.lookup().image_point(point), picture));
    };
    let mut places = [None; 4];
    for (place, image_point) in places.iter_mut().zip(corners.places) {
        *place = match image_point {
            Some(image_point) => Some(texel_at(image_point, map.picture(image_point.image)?)),
            None => None,
        };
    }
    let colours = corners.colours(|place| map.texel(place));
    let weights = corners.weights();
    let texels = (0..4).map(|k| ProbedTexel { place: places[k], weight: weights[k], colour: colours[k] }).collect();
    Ok((texels, corners.blend(colours)))
}

/// The texel that a place falls into, as `Picture::nearest` reads it.
fn texel_at(place: ImagePoint, picture: &Picture) -> TexelPlace {
    let (x, y) = place.texels(picture);
    let index = |position: f32, count: usize| (position.max(0.0) as usize).min(count - 1);
    TexelPlace { image: place.image, column: index(x, picture.width()), row: index(y, picture.height()) }
}
