//! Pictures at one common small size, as display codes.

use crate::colour::encode_srgb;
use crate::math::Vec3;
use crate::picture::{Footprint, Picture, Texels};

/// A picture as sRGB-encoded codes in `[0, 1]`, three a pixel, row by row from the top left.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Codes {
    pub width: usize,
    pub height: usize,
    pub values: Vec<f32>,
}

/// The middle part of a square picture: this share of its width and height.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Middle(pub f64);

/// What a cell of a row or column covers: the first pixel and the weights from there on, their sum 1.
struct Span {
    first: usize,
    weights: Vec<f32>,
}

impl Codes {
    /// The codes a file holds, or would hold for linear pictures.
    pub fn of_picture(picture: &Picture) -> Self {
        let values = match picture.texels() {
            Texels::Srgb8(bytes) => bytes.iter().map(|&code| f32::from(code) / 255.0).collect(),
            Texels::Linear(colours) => colours.iter().flat_map(|colour| colour.to_array().map(encode_srgb)).collect(),
        };
        Self { width: picture.width(), height: picture.height(), values }
    }

    /// The middle part in `side` x `side` cells, each the mean of what it covers.
    pub fn reduced(&self, Middle(share): Middle, side: usize) -> Self {
        let (columns, rows) = (spans(self.width, share, side), spans(self.height, share, side));
        let mut values = vec![0.0; 3 * side * side];
        let mut summed = vec![0.0_f32; 3 * self.width];
        for (span, cells) in rows.iter().zip(values.chunks_exact_mut(3 * side)) {
            // First all rows into one, value by value, which compilers make fast; then that one into cells.
            summed.fill(0.0);
            for (row, &weight) in self.values.chunks_exact(3 * self.width).skip(span.first).zip(&span.weights) {
                summed.iter_mut().zip(row).for_each(|(sum, value)| *sum += weight * value);
            }
            narrow(&summed, &columns, cells);
        }
        Self { width: side, height: side, values }
    }

    /// The picture as code shows it that computes `u = (factor y + 1) / 2` from a direction of unit length, without dividing
    /// by its largest component: at `(a, b)` of `[-1, 1]^2` stands what should stand at `factor (a, b) / sqrt(1 + a^2 + b^2)`.
    pub fn undivided(&self, factor: f64) -> Self {
        let place = |index: usize, count: usize| 2.0 * (index as f64 + 0.5) / count as f64 - 1.0;
        let pixels = (0..self.height).flat_map(|row| (0..self.width).map(move |column| (column, row)));
        let values = pixels.flat_map(|(column, row)| {
            let (a, b) = (place(column, self.width), place(row, self.height));
            let length = (1.0 + a * a + b * b).sqrt();
            let texel =
                |coordinate: f64, count: usize| ((factor * coordinate / length + 1.0) / 2.0 * count as f64) as f32;
            self.interpolated(texel(a, self.width), texel(b, self.height))
        });
        Self { values: values.collect(), ..*self }
    }

    /// The codes at a point in pixels from the top left corner.
    fn interpolated(&self, x: f32, y: f32) -> [f32; 3] {
        let footprint = Footprint::new(x, y, self.width, self.height);
        footprint.interpolate(|column, row| Vec3::from_array(self.at(row * self.width + column))).to_array()
    }

    /// The values of a cell.
    pub fn at(&self, cell: usize) -> [f32; 3] {
        [self.values[3 * cell], self.values[3 * cell + 1], self.values[3 * cell + 2]]
    }
}

/// One row of pixels to one row of cells.
fn narrow(row: &[f32], columns: &[Span], cells: &mut [f32]) {
    for (span, cell) in columns.iter().zip(cells.chunks_exact_mut(3)) {
        let mut sums = [0.0; 3];
        for (pixel, &weight) in row[3 * span.first..].chunks_exact(3).zip(&span.weights) {
            (0..3).for_each(|channel| sums[channel] += weight * pixel[channel]);
        }
        cell.copy_from_slice(&sums);
    }
}

/// What `cells` cells cover of the middle of `count` pixels.
fn spans(count: usize, share: f64, cells: usize) -> Vec<Span> {
    let pixels = count as f64;
    let (start, step) = (pixels * (1.0 - share) / 2.0, pixels * share / cells as f64);
    let span = |cell: usize| {
        let (from, to) = (start + step * cell as f64, start + step * (cell + 1) as f64);
        let first = (from.max(0.0) as usize).min(count - 1);
        let last = (to.ceil() as usize).clamp(first + 1, count);
        let covered = |pixel: usize| (to.min((pixel + 1) as f64) - from.max(pixel as f64)).max(0.0);
        let total: f64 = (first..last).map(covered).sum();
        let weights = (first..last).map(|pixel| (covered(pixel) / total.max(1e-12)) as f32).collect();
        Span { first, weights }
    };
    (0..cells).map(span).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_are_means_of_what_they_cover() {
        let values = (0..5 * 5).flat_map(|k| [k as f32, 1.0, (k % 5) as f32]).collect();
        let codes = Codes { width: 5, height: 5, values };
        let whole = codes.reduced(Middle(1.0), 2);
        // The first column of cells covers columns 0, 1 and half of 2: (0 + 1 + 0.5 * 2) / 2.5.
        assert!((whole.at(0)[2] - 0.8).abs() < 1e-6 && (whole.at(1)[2] - 3.2).abs() < 1e-6);
        assert!((whole.at(0)[1] - 1.0).abs() < 1e-6);
        let middle = codes.reduced(Middle(0.2), 1);
        assert!((middle.at(0)[0] - 12.0).abs() < 1e-5);
        // Finer than the pixels: each cell lies in one.
        let finer = codes.reduced(Middle(1.0), 10);
        assert!((finer.at(0)[2]).abs() < 1e-6 && (finer.at(9)[2] - 4.0).abs() < 1e-6);
    }
}
