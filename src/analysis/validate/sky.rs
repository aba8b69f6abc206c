//! Where the sky seems to be: a hint from brightness and detail, never a verdict.

use super::borders::border::{Borders, display_of_map};
use super::search::arrangement::{Arrangement, Problem};
use super::search::branch_and_bound::{Freedom, cheapest};
use crate::envmap::{CubeMap, Face};
use crate::error::Result;
use crate::math::functions::logarithm;

/// Rows and columns of the grid on which an image is looked at.
const GRID: usize = 24;

/// The images that show sky and ground: opposite each other, the sky brighter and plainer, and clearly more so than
/// the other two pairs. `None` if the pictures do not tell.
pub fn hint(map: &CubeMap, borders: &Borders, problem: &Problem) -> Result<Option<[Face; 2]>> {
    let laid = cheapest(problem, &Arrangement::given(Face::ALL), Freedom::ANY_ORDER);
    let mut heights = [0.0; 6];
    for image in Face::ALL {
        heights[image.index()] = skyness(map, borders, image)?;
    }
    let mut pairs: Vec<(f64, [Face; 2])> = (0..3)
        .map(|axis| {
            let [one, other] = [true, false].map(|positive| laid.images[Face::on_axis(axis, positive).index()]);
            let contrast = heights[one.index()] - heights[other.index()];
            if contrast >= 0.0 { (contrast, [one, other]) } else { (-contrast, [other, one]) }
        })
        .collect();
    pairs.sort_by(|a, b| b.0.total_cmp(&a.0));
    let clear = pairs[0].0 > 1.0 && pairs[0].0 > 1.5 * pairs[1].0;
    Ok(clear.then_some(pairs[0].1))
}

/// Brightness (of 255, in units of 64) less the logarithm of the detail.
fn skyness(map: &CubeMap, borders: &Borders, image: Face) -> Result<f64> {
    let picture = map.picture(image)?;
    let display = display_of_map(borders);
    let (mut brightness, mut detail) = (0.0, 0.0);
    for row in 0..GRID {
        for column in 0..GRID {
            let x = (2 * column + 1) * picture.width() / (2 * GRID);
            let y = (2 * row + 1) * picture.height() / (2 * GRID);
            let colour = |x: usize| display.encode(picture.texel(x, y)).iter().sum::<f32>() / 3.0;
            let (here, beside) = (colour(x), colour(if x > 0 { x - 1 } else { (x + 1).min(picture.width() - 1) }));
            brightness += f64::from(here);
            detail += f64::from((here - beside).abs());
        }
    }
    let count = (GRID * GRID) as f64;
    Ok(brightness / count / 64.0 - f64::from(logarithm((detail / count) as f32 + 1.0)))
}
