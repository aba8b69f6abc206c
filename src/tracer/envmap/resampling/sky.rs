//! What a map shows in any direction, between its texels by cubic convolution.

use std::f64::consts::{PI, TAU};

use super::super::axis::SignedAxis;
use super::super::background::Longitudes;
use super::super::cube_map::{CubeFilter, CubeMap};
use super::super::face::Face;
use super::super::lookup::Lookup;
use super::padded::Padded;
use crate::error::Result;
use crate::math::{DVec3, Vec3};
use crate::picture::Picture;

/// A map to resample.
#[derive(Debug)]
pub struct Sky(Kind);

#[derive(Debug)]
enum Kind {
    /// The images as the faces read them, in the order of [`Face::ALL`].
    Cube {
        lookup: Lookup,
        images: Vec<(usize, Padded)>,
    },
    Equirectangular {
        longitudes: Longitudes,
        size: [usize; 2],
        picture: Padded,
    },
}

impl Sky {
    /// A cube map; its images are square. Beyond the border of a face lies what the neighbours show there.
    pub fn of_cube_map(mut map: CubeMap) -> Result<Self> {
        map.set_filter(CubeFilter::Seamless);
        let lookup = *map.lookup();
        let mut images = Vec::new();
        for face in Face::ALL {
            let picture = map.picture(lookup.row(face).image)?;
            let side = picture.width();
            let texel = |x: i64, y: i64| {
                let inside = [x, y].iter().all(|place| (0..side as i64).contains(place));
                let [right, down] = [x, y].map(|place| (place as f64 + 0.5) / side as f64);
                match inside {
                    true => picture.texel(x as usize, y as usize),
                    false => map.sample(lookup.image_direction(face, right, down).as_vec3()),
                }
            };
            images.push((side, Padded::new(side, side, texel)));
        }
        // The border of a face may have been the first to look at its neighbour.
        map.errors().next().map_or(Ok(()), |error| Err(error.clone()))?;
        Ok(Self(Kind::Cube { lookup, images }))
    }

    /// An equirectangular picture that lies around the viewer as [`Equirectangular`](super::super::Equirectangular) draws it.
    pub fn of_equirectangular(picture: &Picture, up: SignedAxis, turns: f64) -> Self {
        let (width, height) = (picture.width() as i64, picture.height() as i64);
        let texel = |x: i64, y: i64| {
            // Beyond a pole the same rows come again, half a turn further.
            let (x, y) = match y {
                ..0 => (x + width / 2, -1 - y),
                _ if y >= height => (x + width / 2, 2 * height - 1 - y),
                _ => (x, y),
            };
            picture.texel(x.rem_euclid(width) as usize, y.clamp(0, height - 1) as usize)
        };
        let size = [picture.width(), picture.height()];
        let picture = Padded::new(picture.width(), picture.height(), texel);
        Self(Kind::Equirectangular { longitudes: Longitudes::new(up, turns), size, picture })
    }

    /// The colour in a direction of any length.
    pub fn colour(&self, direction: DVec3) -> Vec3 {
        match &self.0 {
            Kind::Cube { lookup, images } => {
                let point = lookup.locate(direction.as_vec3());
                let place = lookup.image_point(point);
                let (side, image) = &images[point.face.index()];
                image.cubic(f64::from(place.right) * *side as f64, f64::from(place.down) * *side as f64)
            }
            Kind::Equirectangular { longitudes, size: [width, height], picture } => {
                let (u, v) = longitudes.place(direction);
                picture.cubic(u * *width as f64, v.min(1.0) * *height as f64)
            }
        }
    }

    /// The angle that a texel around a direction spans, in radians, where it is narrowest.
    pub(super) fn texel_angle(&self, direction: DVec3) -> f64 {
        let direction = direction.normalize();
        match &self.0 {
            // On the plane of the face a texel is 2 / side wide, seen at a slant from the distance 1 / largest.
            Kind::Cube { images, .. } => {
                let largest = direction.abs().max_element();
                2.0 / images[0].0 as f64 * largest * largest
            }
            // Rows are alike; the circles of latitude become shorter towards the poles.
            Kind::Equirectangular { longitudes, size: [width, height], .. } => {
                (PI / *height as f64).min(TAU / *width as f64 * longitudes.radius(direction))
            }
        }
    }
}
