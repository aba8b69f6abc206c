//! Pictures of another size.

use crate::math::Vec3;
use crate::picture::Raster;

/// The picture in another size: every new pixel is the mean of the area it covers, or, where it is smaller than an old
/// pixel, interpolated between the old centres.
pub(super) fn resized(raster: &Raster, width: usize, height: usize) -> Raster {
    if (width, height) == (raster.width(), raster.height()) {
        return raster.clone();
    }
    let columns = footprints(raster.width(), width);
    let rows = footprints(raster.height(), height);
    let narrow =
        Raster::from_function(width, raster.height(), |x, y| mean(&columns[x], |column| raster.pixel(column, y)));
    Raster::from_function(width, height, |x, y| mean(&rows[y], |row| narrow.pixel(x, row)))
}

/// The old pixels that a new one is made of: the first, and what they count; the sum is 1.
struct Footprint {
    first: usize,
    weights: Vec<f32>,
}

fn mean(footprint: &Footprint, pixel: impl Fn(usize) -> Vec3) -> Vec3 {
    let parts = footprint.weights.iter().enumerate();
    parts.fold(Vec3::ZERO, |sum, (offset, &weight)| sum + pixel(footprint.first + offset) * weight)
}

/// The footprints of `new` pixels over `old` ones.
fn footprints(old: usize, new: usize) -> Vec<Footprint> {
    let scale = old as f64 / new as f64;
    (0..new).map(|index| if scale > 1.0 { covered(index, scale, old) } else { between(index, scale, old) }).collect()
}

/// The pixels that `[index, index + 1] * scale` covers.
fn covered(index: usize, scale: f64, old: usize) -> Footprint {
    let (start, end) = (index as f64 * scale, (index + 1) as f64 * scale);
    let first = start as usize;
    let last = (end.ceil() as usize).min(old).max(first + 1);
    let share = |pixel: usize| ((end.min((pixel + 1) as f64) - start.max(pixel as f64)).max(0.0) / scale) as f32;
    Footprint { first, weights: (first..last).map(share).collect() }
}

/// The two pixels around the centre of a new one.
fn between(index: usize, scale: f64, old: usize) -> Footprint {
    let centre = ((index as f64 + 0.5) * scale - 0.5).clamp(0.0, (old - 1) as f64);
    let first = (centre as usize).min(old.saturating_sub(2));
    let share = (centre - first as f64) as f32;
    let weights = if old == 1 { vec![1.0] } else { vec![1.0 - share, share] };
    Footprint { first, weights }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keeps_ramps_and_means() {
        let ramp = Raster::from_function(12, 8, |x, y| Vec3::new(x as f32 + 0.5, y as f32 + 0.5, 1.0));
        for (width, height) in [(6, 4), (4, 2), (12, 8), (24, 16)] {
            let other = resized(&ramp, width, height);
            // The centre keeps its place; borders of an enlarged ramp are flat.
            for (x, y) in (1..width - 1).flat_map(|x| (0..height).map(move |y| (x, y))) {
                let place = (x as f32 + 0.5) * 12.0 / width as f32;
                assert!((other.pixel(x, y).x - place).abs() < 1e-4, "{width} {x} {y}");
            }
        }
        // Areas that cut old pixels: each counts as much in all, so the mean stays.
        let mean = |raster: &Raster| raster.pixels().iter().sum::<Vec3>() / raster.pixels().len() as f32;
        assert!((mean(&resized(&ramp, 5, 3)) - mean(&ramp)).abs().max_element() < 1e-4);
    }
}
