//! A border as a signal: resampled to a common length, in brightness and two colour differences, by scales.
//!
//! The scales are those of the Haar wavelet (Haar, "Zur Theorie der orthogonalen Funktionensysteme", 1910), as plain
//! means and half differences: coefficient 0 is the mean of the row; 1 is half the difference of its two halves; 2 and
//! 3 those of its quarters, and so on. Common content at a seam shows at every scale with detail; a different exposure
//! shows in coefficient 0 alone.

use super::agreement::Pattern;
use super::border::{ImageBorders, Row};
use super::edge::Side;

/// Brightness, orange against blue, green against magenta.
pub type Colour = [f32; 3];

/// The Haar coefficients of a row.
pub type Coefficients = Vec<Colour>;

/// One side of an image, walked in one direction.
#[derive(Debug, Clone)]
pub struct Signal {
    /// The outermost row.
    pub border: Coefficients,
    /// The slope towards the side over the depth h, corrected for the bend of the cube: see [`slope`].
    pub slope: Coefficients,
    /// The brightness along the outermost row.
    pub pattern: Pattern,
    /// Mean square, by band and colour, of the change from one row to the next inside the picture. Within a block of a JPEG
    /// file rows are more alike than across two, as they are at a seam: there the larger change counts.
    pub change: Vec<Colour>,
    /// Mean square of the change of the slope inside the picture.
    pub bend: Vec<Colour>,
}

impl Signal {
    pub fn new(image: &ImageBorders, side: Side, reversed: bool, length: usize) -> Self {
        let row = |row: &Row| resampled(row, length, reversed);
        let rows = [0, 1, 2].map(|index| row(image.row(side, index)));
        let deep = [0, 1].map(|index| row(&image.sides[side.index()].deep[index]));
        let first = slope(&rows[0], &deep[0], &rows[0], image.depth, image.texels);
        let second = slope(&deep[0], &deep[1], &rows[0], image.depth, image.texels);
        let changes = [difference(&rows[0], &rows[1]), difference(&rows[1], &rows[2])].map(haar);
        let mut change = band_means(&changes);
        if let Some(blocks) = &image.sides[side.index()].blocks {
            let [within, beyond] = [0, 1].map(|index| row(&blocks[index]));
            let across = band_means(&[haar(difference(&within, &beyond))]);
            for (change, across) in change.iter_mut().zip(across) {
                *change = std::array::from_fn(|channel| change[channel].max(across[channel]));
            }
        }
        Self {
            pattern: Pattern::new(&rows[0].iter().map(|colour| colour[0]).collect::<Vec<f32>>()),
            change,
            bend: band_means(&[haar(difference(&first, &second))]),
            border: haar(rows[0].clone()),
            slope: haar(first),
        }
    }
}

/// The band of a coefficient: 0 is the mean, then one for each doubling.
pub fn band_of(coefficient: usize) -> usize {
    coefficient.checked_ilog2().map_or(0, |doublings| doublings as usize + 1)
}

/// A row of another length by the mean of what each sample covers, in the three colours of [`Colour`].
fn resampled(row: &Row, length: usize, reversed: bool) -> Vec<Colour> {
    let texels = row.len();
    let scale = texels as f64 / length as f64;
    let mut samples: Vec<Colour> = (0..length)
        .map(|index| {
            let (from, to) = (index as f64 * scale, (index + 1) as f64 * scale);
            let mut sum = [0.0_f32; 3];
            let mut weight = 0.0_f32;
            let last = (to.ceil() as usize).min(texels);
            for (texel, colour) in row.iter().enumerate().take(last).skip(from as usize) {
                let covered = (to.min((texel + 1) as f64) - from.max(texel as f64)) as f32;
                weight += covered;
                sum = std::array::from_fn(|channel| sum[channel] + covered * colour[channel]);
            }
            let [red, green, blue] = sum.map(|channel| channel / weight);
            [(red + 2.0 * green + blue) / 4.0, red - blue, green - (red + blue) / 2.0]
        })
        .collect();
    if reversed {
        samples.reverse();
    }
    samples
}

/// The difference of a row and one that lies deeper by h, plus half of what the bend of the cube adds.
///
/// A colour that is smooth on the sphere is a function f of the direction alone, so its gradient at the direction
/// (1, 1, t) of an edge is at right angles to it: f_x + f_y + t f_z = 0. The slope outwards on one face is f_y, that
/// inwards on the other -f_x: they differ by t f_z, f_z being the slope along the edge. Each side takes half of it, so
/// that the corrected slopes of two faces that continue each other add up to nothing.
fn slope(outer: &[Colour], inner: &[Colour], along: &[Colour], depth: usize, texels: usize) -> Vec<Colour> {
    let length = outer.len();
    let depth = 2.0 * depth as f32 / texels as f32;
    (0..length)
        .map(|index| {
            let (before, after) = (index.saturating_sub(1), (index + 1).min(length - 1));
            let distance = 2.0 * (after - before).max(1) as f32 / length as f32;
            let t = 2.0 * (index as f32 + 0.5) / length as f32 - 1.0;
            std::array::from_fn(|channel| {
                let along = (along[after][channel] - along[before][channel]) / distance;
                outer[index][channel] - inner[index][channel] + 0.5 * t * along * depth
            })
        })
        .collect()
}

fn difference(one: &[Colour], other: &[Colour]) -> Vec<Colour> {
    let subtract = |(a, b): (&Colour, &Colour)| std::array::from_fn(|channel| a[channel] - b[channel]);
    one.iter().zip(other).map(subtract).collect()
}

/// The transform of the module's description. The length is a power of two.
pub fn haar(mut row: Vec<Colour>) -> Coefficients {
    let mut coefficients = vec![[0.0; 3]; row.len()];
    while row.len() > 1 {
        let half = row.len() / 2;
        let pair = |index: usize, sign: f32| -> Colour {
            let (first, second) = (row[2 * index], row[2 * index + 1]);
            std::array::from_fn(|channel| 0.5 * (first[channel] + sign * second[channel]))
        };
        for index in 0..half {
            coefficients[half + index] = pair(index, -1.0);
        }
        row = (0..half).map(|index| pair(index, 1.0)).collect();
    }
    coefficients[0] = row[0];
    coefficients
}

/// The mean square of every band. Bands of fewer than eight coefficients share one value: alone they are too few.
fn band_means(signals: &[Coefficients]) -> Vec<Colour> {
    let length = signals[0].len();
    let bands = band_of(length - 1) + 1;
    let mean = |from: usize, to: usize| -> Colour {
        let count = ((to - from) * signals.len()) as f32;
        std::array::from_fn(|channel| {
            let square = |coefficient: &Colour| coefficient[channel] * coefficient[channel];
            signals.iter().flat_map(|signal| &signal[from..to]).map(square).sum::<f32>() / count
        })
    };
    (0..bands)
        .map(|band| {
            let end = (1 << band).min(length);
            if end <= 8 { mean(0, length.min(8)) } else { mean(end / 2, end) }
        })
        .collect()
}
