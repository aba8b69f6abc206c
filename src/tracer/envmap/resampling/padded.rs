//! A picture with a rim of what lies beyond its borders, read by cubic convolution.

use crate::math::Vec3;
use crate::parallel;

/// Texels beyond each border: the cubic filter reads two on either side of a point.
const RIM: i64 = 2;

/// A picture and its rim, so that no border is a special case.
#[derive(Debug)]
pub(super) struct Padded {
    /// Columns with the rim.
    width: usize,
    texels: Vec<Vec3>,
}

impl Padded {
    /// A picture of `width` by `height` texels. `texel` tells the colours in column and row, from `-RIM` to the size plus `RIM`.
    pub fn new(width: usize, height: usize, texel: impl Fn(i64, i64) -> Vec3 + Sync) -> Self {
        let columns = -RIM..width as i64 + RIM;
        let row = |y| columns.clone().map(|x| texel(x, y)).collect::<Vec<_>>();
        Self { width: columns.clone().count(), texels: parallel::map(-RIM..height as i64 + RIM, row).concat() }
    }

    /// The colour at `(x, y)` in texels from the top left corner of the picture, within it: the sixteen texels around, weighted
    /// by cubic convolution (Keys 1981). It is never brighter or darker than all sixteen: no dark ring lies around a sun.
    pub fn cubic(&self, x: f64, y: f64) -> Vec3 {
        let (column, horizontal) = taps(x);
        let (row, vertical) = taps(y);
        let (mut sum, mut low, mut high) = (Vec3::ZERO, Vec3::INFINITY, Vec3::NEG_INFINITY);
        for (line, weight) in self.texels.chunks_exact(self.width).skip(row).zip(vertical) {
            let texels = &line[column..column + 4];
            let mut across = Vec3::ZERO;
            for (&texel, weight) in texels.iter().zip(horizontal) {
                across += weight * texel;
                (low, high) = (low.min(texel), high.max(texel));
            }
            sum += weight * across;
        }
        sum.max(low).min(high)
    }
}

/// The first of the four texels around a point on one axis, counted with the rim, and what they count.
fn taps(position: f64) -> (usize, [f32; 4]) {
    // Texel centres are at half integers; the second of the four lies before the point.
    let centred = position - 0.5 + RIM as f64;
    let second = centred as usize;
    (second - 1, weights((centred - second as f64) as f32))
}

/// Cubic convolution with a = -1/2: exact for parabolas. `t` is the distance from the second texel.
fn weights(t: f32) -> [f32; 4] {
    [
        0.5 * t * (-1.0 + t * (2.0 - t)),
        1.0 + 0.5 * t * t * (3.0 * t - 5.0),
        0.5 * t * (1.0 + t * (4.0 - 3.0 * t)),
        0.5 * t * t * (t - 1.0),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parabolas_are_exact_up_to_the_border() {
        let parabola = |x: f64, y: f64| Vec3::new((x * x - 3.0 * y) as f32, (x * y) as f32, 1.0);
        let picture = Padded::new(5, 4, |x, y| parabola(x as f64 + 0.5, y as f64 + 0.5));
        for (x, y) in [(0.0, 0.0), (0.5, 0.5), (2.3, 1.9), (5.0, 4.0), (4.75, 0.1)] {
            assert!(picture.cubic(x, y).abs_diff_eq(parabola(x, y), 1e-4), "{x} {y}");
        }
    }

    #[test]
    fn a_sun_casts_no_dark_ring() {
        let picture = Padded::new(8, 8, |x, y| Vec3::splat(if (x, y) == (4, 4) { 1e4 } else { 1.0 }));
        let places = (0..64).flat_map(|x| (0..64).map(move |y| (f64::from(x) / 8.0, f64::from(y) / 8.0)));
        let colours: Vec<f32> = places.map(|(x, y)| picture.cubic(x, y).x).collect();
        assert!(colours.iter().all(|&colour| (1.0..=1e4).contains(&colour)));
        assert_eq!(colours.iter().copied().fold(0.0, f32::max), 1e4);
    }
}
