//! The light that the whole sky, with nothing in its way, throws onto a plane.
//!
//! ```text
//!      \   |   /                irradiance = integral of L(w) cos(theta) dw over the hemisphere above the plane
//!       \  |  / theta
//!     ----------------          the picture is cut into cells, one a texel (small pictures: several); each counts by
//!                               the radiance in its middle, its solid angle and the cosine of its middle
//! ```
//!
//! What the filter does between texels keeps the mean, and cosine and solid angle are smooth, so the error falls with
//! the square of the cells' size: a few 1e-5 of the light for pictures of any size, for panoramas 1e-4 (tested).

use std::f64::consts::{PI, TAU};

use super::background::{Equirectangular, Gradient, Longitudes};
use super::cube_map::CubeMap;
use super::environment::{Environment, EnvironmentKind};
use super::face::Face;
use super::lookup::Lookup;
use crate::error::Result;
use crate::math::functions::{cos, sin};
use crate::math::{DVec3, Vec3};
use crate::parallel;

/// Least number of cells from pole to pole, and along the side of a face.
const FEWEST_CELLS: usize = 512;

/// Cells along a texel, so that there are enough along the picture: one, or an even number, so that texel centres, between
/// which filters interpolate, lie between cells.
fn cells_across(texels: usize, fewest: usize) -> usize {
    if texels >= fewest { 1 } else { fewest.div_ceil(texels).next_multiple_of(2) }
}

/// The light on the two sides of a plane.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Irradiance {
    /// On the side that the normal points to.
    pub front: Vec3,
    pub back: Vec3,
}

impl Environment {
    /// The irradiance of a plane under the open environment, by its unit normal. An error if a picture cannot be decoded.
    pub fn irradiance(&self, normal: DVec3) -> Result<Irradiance> {
        let sums = match &self.kind {
            EnvironmentKind::Constant(radiance) => return Ok(even(*radiance * self.scale)),
            EnvironmentKind::Gradient(gradient) => of_gradient(gradient, normal),
            EnvironmentKind::Equirectangular(map) => of_panorama(map, normal)?,
            EnvironmentKind::CubeMap(map) => of_cube_map(map, normal)?,
        };
        let scaled = |sum: DVec3| (sum * f64::from(self.scale)).as_vec3();
        Ok(Irradiance { front: scaled(sums.front), back: scaled(sums.back) })
    }
}

/// The same radiance from everywhere: pi times as much irradiance.
fn even(radiance: Vec3) -> Irradiance {
    let irradiance = radiance * PI as f32;
    Irradiance { front: irradiance, back: irradiance }
}

/// Light summed so far.
#[derive(Debug, Clone, Copy, Default)]
struct Sums {
    front: DVec3,
    back: DVec3,
}

impl Sums {
    /// Adds light from one side; `share` is cosine times solid angle, negative from behind.
    #[inline(always)]
    fn add(&mut self, share: f64, radiance: Vec3) {
        self.front += radiance.as_dvec3() * share.max(0.0);
        self.back += radiance.as_dvec3() * (-share).max(0.0);
    }

    fn plus(self, other: Self) -> Self {
        Self { front: self.front + other.front, back: self.back + other.back }
    }

    /// The sum of the rows, in their order.
    fn of_rows(rows: usize, row: impl Fn(usize) -> Self + Sync) -> Self {
        parallel::map(0..rows, row).into_iter().fold(Self::default(), Self::plus)
    }
}

fn of_gradient(gradient: &Gradient, normal: DVec3) -> Sums {
    let longitudes = Longitudes::about(gradient.up);
    of_latitudes(longitudes, [2 * FEWEST_CELLS, FEWEST_CELLS], normal, |_, _, direction| gradient.sample(direction))
}

fn of_panorama(map: &Equirectangular, normal: DVec3) -> Result<Sums> {
    let picture = map.image.try_picture()?;
    let (width, height) = (picture.width(), picture.height());
    let [across, down] = [cells_across(width, 2 * FEWEST_CELLS), cells_across(height, FEWEST_CELLS)];
    Ok(of_latitudes(map.longitudes(), [width * across, height * down], normal, |column, row, direction| {
        // In the middle of a texel every filter shows the texel.
        if across == 1 && down == 1 { picture.texel(column, row) } else { map.sample(direction) }
    }))
}

/// Cells between meridians and parallels; `radiance` by column, row and direction of the middle.
fn of_latitudes(
    longitudes: Longitudes,
    [columns, rows]: [usize; 2],
    normal: DVec3,
    radiance: impl Fn(usize, usize, DVec3) -> Vec3 + Sync,
) -> Sums {
    let zenith = longitudes.direction(0.0, 1.0);
    let on_horizon: Vec<DVec3> =
        (0..columns).map(|column| longitudes.direction((column as f64 + 0.5) / columns as f64, 0.0)).collect();
    Sums::of_rows(rows, |row| {
        let angle = PI * (row as f64 + 0.5) / rows as f64;
        let (sine, cosine) = (sin(angle), cos(angle));
        // The difference of the cosines above and below, without cancellation.
        let solid_angle = TAU / columns as f64 * 2.0 * sine * sin(PI / (2.0 * rows as f64));
        let mut sums = Sums::default();
        for (column, &horizontal) in on_horizon.iter().enumerate() {
            let direction = horizontal * sine + zenith * cosine;
            sums.add(direction.dot(normal) * solid_angle, radiance(column, row, direction));
        }
        sums
    })
}

fn of_cube_map(map: &CubeMap, normal: DVec3) -> Result<Sums> {
    let mut sums = Sums::default();
    for face in Face::ALL {
        sums = sums.plus(of_face(map, face, normal)?);
    }
    Ok(sums)
}

/// Cells of one face, on the plane at distance 1: the area `dA` at p is seen under `dA / |p|^3`, with the cosine
/// `p . normal / |p|`.
fn of_face(map: &CubeMap, face: Face, normal: DVec3) -> Result<Sums> {
    let picture = map.picture(map.lookup().row(face).image)?;
    let finer = [picture.width(), picture.height()].map(|texels| cells_across(texels, FEWEST_CELLS));
    let (columns, rows) = (picture.width() * finer[0], picture.height() * finer[1]);
    let lookup: &Lookup = map.lookup();
    let area = 4.0 / (columns * rows) as f64;
    let step = (lookup.image_direction(face, 1.0, 0.5) - lookup.image_direction(face, 0.0, 0.5)) / columns as f64;
    Ok(Sums::of_rows(rows, |row| {
        let start = lookup.image_direction(face, 0.5 / columns as f64, (row as f64 + 0.5) / rows as f64);
        let mut sums = Sums::default();
        for column in 0..columns {
            let point = start + step * column as f64;
            let square = point.length_squared();
            // In the middle of a texel every filter shows the texel.
            let radiance = if finer == [1, 1] { picture.texel(column, row) } else { map.sample(point.as_vec3()) };
            sums.add(point.dot(normal) * area / (square * square), radiance);
        }
        sums
    }))
}
