//! Where the sky seems to be: a hint from brightness and detail, never a verdict. It only chooses between equally short
//! stories.

use super::borders::border::{Borders, display_of_map};
use super::borders::edge::{Border, Side};
use super::thresholds::sky::{CODES, CONTRAST, CONTRAST_RATIO};
use crate::envmap::{CubeMap, Face, Lookup, SignedAxis, VOrigin};
use crate::error::Result;
use crate::math::functions::logarithm;

/// Rows and columns of the grid on which an image is looked at.
const GRID: usize = 24;

/// What the images look like from afar.
#[derive(Debug, Clone)]
pub struct Sky {
    /// By image and [`Side`]: how bright the half towards that side is.
    halves: [[f64; 4]; 6],
    /// By image: bright and plain like a sky.
    skyness: [f64; 6],
}

impl Sky {
    pub fn of(map: &CubeMap, borders: &Borders) -> Result<Self> {
        let mut sky = Self { halves: [[0.0; 4]; 6], skyness: [0.0; 6] };
        for image in Face::ALL {
            (sky.halves[image.index()], sky.skyness[image.index()]) = looked_at(map, borders, image)?;
        }
        Ok(sky)
    }

    /// How far the sky lies above under a lookup, in whole factors of e: the sides are lighter towards the axis that points
    /// up, and what lies there is plainer and lighter than what lies below. 0 where the pictures hardly tell, as indoors.
    pub fn above(&self, lookup: &Lookup, up: SignedAxis) -> i64 {
        let [top, bottom] = [true, false].map(|above| Face::on_axis(usize::from(up.axis), above != up.negative));
        let sides = Face::ALL.into_iter().filter(|side| side.axis() != top.axis());
        let lighter = |side: Face| {
            let row = lookup.row(side);
            let half = |towards: Face| self.halves[row.image.index()][Border::of_face(row, side, towards).side.index()];
            (half(top) - half(bottom)) / CODES
        };
        let skyness = |face: Face| self.skyness[lookup.row(face).image.index()];
        let sum = sides.map(lighter).sum::<f64>() + skyness(top) - skyness(bottom);
        sum.round() as i64
    }

    /// The image that seems to show the sky under a lookup: clearly more so than the one opposite, and than the other
    /// two pairs. `None` if the pictures do not tell.
    pub fn image(&self, lookup: &Lookup) -> Option<Face> {
        let mut pairs: Vec<(f64, Face)> = (0..3)
            .map(|axis| {
                let [one, other] = [true, false].map(|positive| lookup.row(Face::on_axis(axis, positive)).image);
                let contrast = self.skyness[one.index()] - self.skyness[other.index()];
                (contrast.abs(), if contrast >= 0.0 { one } else { other })
            })
            .collect();
        pairs.sort_by(|a, b| b.0.total_cmp(&a.0));
        let clear = pairs[0].0 > CONTRAST && pairs[0].0 > CONTRAST_RATIO * pairs[1].0;
        clear.then_some(pairs[0].1)
    }
}

/// The brightness of the four halves of an image, and its brightness (in units of [`CODES`]) less the logarithm of
/// the detail.
fn looked_at(map: &CubeMap, borders: &Borders, image: Face) -> Result<([f64; 4], f64)> {
    let picture = map.picture(image)?;
    let display = display_of_map(borders);
    let (mut halves, mut brightness, mut detail) = ([0.0; 4], 0.0, 0.0);
    for (row, column) in (0..GRID).flat_map(|row| (0..GRID).map(move |column| (row, column))) {
        let x = (2 * column + 1) * picture.width() / (2 * GRID);
        let y = (2 * row + 1) * picture.height() / (2 * GRID);
        let colour = |x: usize| f64::from(display.encode(picture.texel(x, y)).iter().sum::<f32>() / 3.0);
        let (here, beside) = (colour(x), colour(if x > 0 { x - 1 } else { (x + 1).min(picture.width() - 1) }));
        let upper = (row < GRID / 2) == (map.lookup().v_origin() == VOrigin::Top);
        halves[(if column < GRID / 2 { Side::Left } else { Side::Right }).index()] += here;
        halves[(if upper { Side::Zero } else { Side::One }).index()] += here;
        brightness += here;
        detail += (here - beside).abs();
    }
    let count = (GRID * GRID) as f64;
    let skyness = brightness / count / CODES - f64::from(logarithm((detail / count) as f32 + 1.0));
    Ok((halves.map(|half| half / (count / 2.0)), skyness))
}
