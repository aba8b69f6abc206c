//! Environments without a cube: gradient and equirectangular picture.

use super::axis::SignedAxis;
use super::lazy_image::LazyImage;
use crate::math::functions::{arctan2_turns, clamp_number, cos, floor, sin};
use crate::math::{DVec3, Vec3};
use crate::picture::{Footprint, neighbours};

/// Three colours blended by the height of the direction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gradient {
    /// The direction of the zenith.
    pub up: SignedAxis,
    /// Linear RGB radiance straight up.
    pub zenith: Vec3,
    /// Linear RGB radiance at the horizon.
    pub horizon: Vec3,
    /// Linear RGB radiance straight down.
    pub nadir: Vec3,
}

impl Gradient {
    /// The colour in a unit direction, linear in the sine of the elevation.
    pub fn sample(&self, direction: DVec3) -> Vec3 {
        let height = self.up.sign() * [direction.x, direction.y, direction.z][usize::from(self.up.axis)] as f32;
        let end = if height >= 0.0 { self.zenith } else { self.nadir };
        self.horizon.lerp(end, height.abs().min(1.0))
    }
}

/// A latitude-longitude picture: columns are longitudes, rows are latitudes from the zenith down.
///
/// ```text
///   y-up world     u = 0 (left border): -z      z-up world     u = 0: +y
///                  u = 1/4:             +x                     u = 1/4: +x
///                  u = 1/2 (middle):    +z                     u = 1/2: -y
///                  u = 3/4:             -x                     u = 3/4: -x
/// ```
///
/// Growing u goes to the right as seen from inside: the picture is not mirrored. In a y-up world this is the
/// convention of OpenEXR's `envmap = latlong`.
#[derive(Debug)]
pub struct Equirectangular {
    /// Columns are angles about the up axis; rows run from the zenith (top) to the nadir.
    pub image: LazyImage,
    /// The direction of the zenith.
    pub up: SignedAxis,
    /// Turns the picture about the up axis, counterclockwise seen from above, in turns (1 = 360 degrees).
    pub turns: f32,
}

impl Equirectangular {
    /// The colour in a unit direction; black if the picture cannot be decoded.
    #[inline]
    pub fn sample(&self, direction: DVec3) -> Vec3 {
        let (u, v) = self.coordinates(direction);
        self.image.picture().map_or(Vec3::ZERO, |picture| {
            let (width, height) = (picture.width(), picture.height());
            let footprint = footprint_around(u * width as f32, v * height as f32, width, height);
            picture.interpolated(&footprint)
        })
    }

    /// Place in the picture in `[0, 1]` from the left and from the top.
    pub fn coordinates(&self, direction: DVec3) -> (f32, f32) {
        let (u, v) = self.longitudes().place(direction);
        (u as f32, v as f32)
    }

    /// The unit direction of a place in the picture: the inverse of [`Equirectangular::coordinates`].
    pub fn direction(&self, u: f64, v: f64) -> DVec3 {
        self.longitudes().direction(u, cos(std::f64::consts::PI * v))
    }

    /// How the picture lies around the viewer.
    pub(super) fn longitudes(&self) -> Longitudes {
        Longitudes::new(self.up, f64::from(self.turns))
    }
}

/// The footprint in a picture whose right border continues at its left one; rows are clamped. `x` from 0 to the width; beyond,
/// it is clamped.
fn footprint_around(x: f32, y: f32, width: usize, height: usize) -> Footprint {
    let (rows, vertical) = neighbours(y, height);
    // Counted from one texel further left, so that truncation is the floor: 0 is the last column.
    let shifted = clamp_number(x + 0.5, 0.0, width as f32 + 0.5);
    let second = shifted as i32 as usize;
    let left = if second == 0 { width - 1 } else { second - 1 };
    let right = if second >= width { 0 } else { second };
    Footprint { columns: [left, right], rows, horizontal: shifted - second as f32, vertical }
}

/// Longitude and latitude about an axis: the drawing at [`Equirectangular`], without the picture.
#[derive(Debug, Clone, Copy)]
pub(super) struct Longitudes {
    up: SignedAxis,
    turns: f64,
}

impl Longitudes {
    /// `up` and `turns` as in [`Equirectangular`].
    pub(super) fn new(up: SignedAxis, turns: f64) -> Self {
        Self { up, turns }
    }

    /// The distance of a unit direction from the axis: the radius of its circle of latitude.
    pub(super) fn radius(&self, direction: DVec3) -> f64 {
        let [x, _, z] = self.y_up(direction).to_array();
        (x * x + z * z).sqrt()
    }

    /// Place in the picture in `[0, 1]` from the left and from the top.
    pub(super) fn place(&self, direction: DVec3) -> (f64, f64) {
        let [x, y, z] = self.y_up(direction).to_array();
        // Longitude counted from -z towards +x.
        let longitude = arctan2_turns(x, -z) + self.turns;
        let from_zenith = 2.0 * arctan2_turns((x * x + z * z).sqrt(), y);
        (longitude - floor(longitude) as f64, from_zenith)
    }

    /// The unit direction at `u` from the left, `cosine` being that of the angle from the zenith.
    pub(super) fn direction(&self, u: f64, cosine: f64) -> DVec3 {
        let longitude = (u - self.turns) * std::f64::consts::TAU;
        let radius = ((1.0 - cosine) * (1.0 + cosine)).max(0.0).sqrt();
        self.leave_y_up(DVec3::new(radius * sin(longitude), cosine, -radius * cos(longitude)))
    }

    /// The direction in a frame whose up is +y: for up = +z, forward +y becomes forward -z.
    fn y_up(&self, direction: DVec3) -> DVec3 {
        let [x, y, z] = direction.to_array();
        let turned = match self.up.axis {
            0 => DVec3::new(-y, x, z),
            1 => direction,
            _ => DVec3::new(x, z, -y),
        };
        // A negative up axis: half a turn about z of the y-up frame.
        if self.up.negative { DVec3::new(-turned.x, -turned.y, turned.z) } else { turned }
    }

    /// The inverse of [`Longitudes::y_up`].
    fn leave_y_up(&self, direction: DVec3) -> DVec3 {
        let [x, y, z] = direction.to_array();
        let [x, y, z] = if self.up.negative { [-x, -y, z] } else { [x, y, z] };
        match self.up.axis {
            0 => DVec3::new(y, -x, z),
            1 => DVec3::new(x, y, z),
            _ => DVec3::new(x, -z, y),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::Error;

    fn map(up: SignedAxis) -> Equirectangular {
        let image = LazyImage::new(Box::new(|| Err(Error::new("not needed"))));
        Equirectangular { image, up, turns: 0.0 }
    }

    #[test]
    fn longitudes_lie_where_the_drawing_says() {
        let y_up = map(SignedAxis::POS_Y);
        let u = |map: &Equirectangular, d: DVec3| map.coordinates(d).0;
        assert_eq!([DVec3::NEG_Z, DVec3::X, DVec3::Z, DVec3::NEG_X].map(|d| u(&y_up, d)), [0.0, 0.25, 0.5, 0.75]);
        let z_up = map(SignedAxis::POS_Z);
        assert_eq!([DVec3::Y, DVec3::X, DVec3::NEG_Y, DVec3::NEG_X].map(|d| u(&z_up, d)), [0.0, 0.25, 0.5, 0.75]);
    }

    #[test]
    fn the_up_axis_is_the_first_row() {
        for name in ["+x", "-x", "+y", "-y", "+z", "-z"] {
            let up: SignedAxis = name.parse().unwrap();
            let map = map(up);
            assert_eq!(map.coordinates(up.direction().as_dvec3()).1, 0.0, "{name}");
            assert_eq!(map.coordinates(-up.direction().as_dvec3()).1, 1.0, "{name}");
        }
    }

    #[test]
    fn direction_is_the_inverse_of_coordinates() {
        for name in ["+x", "-x", "+y", "-y", "+z", "-z"] {
            for turns in [0.0, 0.3, 0.75] {
                let map = Equirectangular { turns, ..map(name.parse().unwrap()) };
                for (u, v) in [(0.01, 0.02), (0.2, 0.4), (0.49, 0.5), (0.7, 0.9), (0.99, 0.97)] {
                    let direction = map.direction(u, v);
                    assert!((direction.length() - 1.0).abs() < 1e-15);
                    let (back_u, back_v) = map.coordinates(direction);
                    assert!(
                        (f64::from(back_u) - u).abs() < 1e-6 && (f64::from(back_v) - v).abs() < 1e-6,
                        "{name} {u} {v}"
                    );
                }
            }
        }
    }
}
