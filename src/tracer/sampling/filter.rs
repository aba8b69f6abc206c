//! Pixel filters: the weights of the picture around a pixel's centre.
//!
//! ```text
//!      box            tent          Gaussian        Mitchell
//!     ______           /\              _              _
//!    |      |         /  \           /   \           / \
//!    |      |        /    \        _/     \_     _  /   \  _
//!   -1/2   1/2     -1      1     -1.5     1.5   -2 \/   \/ 2
//! ```
//!
//! Samples are placed with the density of the filter instead of being weighted by it (Ernst, Stamminger and Greiner, Filter
//! Importance Sampling, 2006): every pixel has its own samples and needs no others, at any number of threads.

use std::sync::LazyLock;

use crate::math::functions::exponential;

/// The shape of a pixel, as wide as it is high. Lengths in pixels.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, clap::ValueEnum)]
#[serde(rename_all = "lowercase")]
pub enum PixelFilter {
    /// The square of the pixel.
    #[default]
    Box,
    /// Falls linearly to 0 at the middles of the neighbours.
    Tent,
    /// Standard deviation 1/2, lowered to reach 0 at 1.5, and 0 beyond.
    Gaussian,
    /// Mitchell and Netravali's cubic with B = C = 1/3: sharp, with small negative lobes (Reconstruction Filters in
    /// Computer Graphics, 1988).
    Mitchell,
}

/// A place in the picture relative to the pixel's top left corner, and what a sample there counts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FilteredPlace {
    /// To the right, in pixels; 0 to 1 lies inside the pixel.
    pub across: f64,
    /// Downwards, in pixels.
    pub down: f64,
    /// Mean 1 over all places; negative in negative lobes.
    pub weight: f64,
}

impl PixelFilter {
    /// True if every sample counts the same.
    pub fn is_even(self) -> bool {
        matches!(self, PixelFilter::Box | PixelFilter::Tent)
    }

    /// Distance from the middle beyond which the filter is 0.
    pub fn radius(self) -> f64 {
        match self {
            PixelFilter::Box => 0.5,
            PixelFilter::Tent => 1.0,
            PixelFilter::Gaussian => 1.5,
            PixelFilter::Mitchell => 2.0,
        }
    }

    /// The place of a sample from two uniform numbers.
    #[inline]
    pub fn place(self, [a, b]: [f64; 2]) -> FilteredPlace {
        if self == PixelFilter::Box {
            return FilteredPlace { across: a, down: b, weight: 1.0 };
        }
        let ((x, one), (y, other)) = (self.offset(a), self.offset(b));
        FilteredPlace { across: 0.5 + x, down: 0.5 + y, weight: one * other }
    }

    /// Distance from the middle along one axis, and its weight.
    fn offset(self, uniform: f64) -> (f64, f64) {
        match self {
            PixelFilter::Box => (uniform - 0.5, 1.0),
            PixelFilter::Tent if uniform < 0.5 => ((2.0 * uniform).sqrt() - 1.0, 1.0),
            PixelFilter::Tent => (1.0 - (2.0 * (1.0 - uniform)).sqrt(), 1.0),
            PixelFilter::Gaussian => GAUSSIAN.offset(uniform),
            PixelFilter::Mitchell => MITCHELL.offset(uniform),
        }
    }

    /// Height of the filter at a distance from the middle, along one axis, not normalised.
    fn height(self, distance: f64) -> f64 {
        let x = distance.abs();
        if x > self.radius() {
            return 0.0;
        }
        match self {
            PixelFilter::Box => 1.0,
            PixelFilter::Tent => 1.0 - x,
            PixelFilter::Gaussian => {
                let bell = |x: f64| f64::from(exponential((-2.0 * x * x) as f32));
                bell(x) - bell(self.radius())
            }
            // B = C = 1/3 in the paper's formula (8).
            PixelFilter::Mitchell if x < 1.0 => (7.0 * x * x * x - 12.0 * x * x + 16.0 / 3.0) / 6.0,
            PixelFilter::Mitchell => (-7.0 / 3.0 * x * x * x + 12.0 * x * x - 20.0 * x + 32.0 / 3.0) / 6.0,
        }
    }
}

static GAUSSIAN: LazyLock<Table> = LazyLock::new(|| Table::new(PixelFilter::Gaussian));
static MITCHELL: LazyLock<Table> = LazyLock::new(|| Table::new(PixelFilter::Mitchell));

/// Steps of the table of a filter's height.
const STEPS: usize = 256;

/// A filter's height in steps, to draw from. The weight of a place makes good for the steps, so the table does not bend
/// the filter.
struct Table {
    filter: PixelFilter,
    /// Integral of the filter.
    integral: f64,
    /// Share of the absolute height left of each step, and all of it at the end.
    cumulative: [f64; STEPS + 1],
}

impl Table {
    fn new(filter: PixelFilter) -> Self {
        let width = 2.0 * filter.radius() / STEPS as f64;
        let middle = |step: usize| filter.height((step as f64 + 0.5) * width - filter.radius());
        let mut cumulative = [0.0; STEPS + 1];
        for step in 0..STEPS {
            cumulative[step + 1] = cumulative[step] + middle(step).abs();
        }
        let total = cumulative[STEPS];
        Self { filter, integral: integral(filter), cumulative: cumulative.map(|sum| sum / total) }
    }

    fn offset(&self, uniform: f64) -> (f64, f64) {
        let step = self.cumulative.partition_point(|&sum| sum <= uniform).clamp(1, STEPS) - 1;
        let share = self.cumulative[step + 1] - self.cumulative[step];
        let width = 2.0 * self.filter.radius() / STEPS as f64;
        let within = if share > 0.0 { (uniform - self.cumulative[step]) / share } else { 0.5 };
        let offset = (step as f64 + within) * width - self.filter.radius();
        (offset, self.filter.height(offset) * width / (share * self.integral))
    }
}

/// The integral of a filter along one axis by Simpson's rule, exact for cubics between whole numbers.
fn integral(filter: PixelFilter) -> f64 {
    let step = 1.0 / 64.0;
    let count = (2.0 * filter.radius() / step).round() as usize;
    let height = |index: f64| filter.height(index * step - filter.radius());
    (0..count).map(|k| k as f64).map(|k| (height(k) + 4.0 * height(k + 0.5) + height(k + 1.0)) * step / 6.0).sum()
}

#[cfg(test)]
mod tests {
    use clap::ValueEnum;

    use super::*;

    /// Moments of the drawn places with their weights: integral, second moment along one axis.
    fn moments(filter: PixelFilter) -> [f64; 3] {
        let count = 200_000;
        let mut sums = [0.0; 3];
        for index in 0..count {
            let (offset, weight) = filter.offset((f64::from(index) + 0.5) / f64::from(count));
            assert!(offset.abs() <= filter.radius());
            sums = [sums[0] + weight, sums[1] + weight * offset, sums[2] + weight * offset * offset];
        }
        sums.map(|sum| sum / f64::from(count))
    }

    #[test]
    fn places_have_the_moments_of_the_filter() {
        // The second moment by a plain sum that does not use the table; that of a tent is 1/6 in closed form.
        let second = |filter: PixelFilter| {
            let count = 100_000;
            let place = |k: usize| ((k as f64 + 0.5) / count as f64 * 2.0 - 1.0) * filter.radius();
            let (mut whole, mut squared) = (0.0, 0.0);
            for x in (0..count).map(place) {
                whole += filter.height(x);
                squared += filter.height(x) * x * x;
            }
            squared / whole
        };
        assert!((second(PixelFilter::Tent) - 1.0 / 6.0).abs() < 1e-6);
        for filter in PixelFilter::value_variants().iter().copied() {
            let [weight, first, square] = moments(filter);
            assert!((weight - 1.0).abs() < 1e-4, "{filter:?} {weight}");
            assert!(first.abs() < 1e-4, "{filter:?} {first}");
            assert!((square - second(filter)).abs() < 2e-4, "{filter:?} {square} {}", second(filter));
        }
    }

    #[test]
    fn mitchell_is_the_published_cubic() {
        // Heights 8/9 at the middle and 1/18 at a distance of 1; the curve and its slope are continuous there.
        let height = |x: f64| PixelFilter::Mitchell.height(x);
        assert!((height(0.0) - 8.0 / 9.0).abs() < 1e-15);
        assert!((height(1.0) - 1.0 / 18.0).abs() < 1e-15 && (height(1.0 - 1e-9) - 1.0 / 18.0).abs() < 1e-8);
        assert!((integral(PixelFilter::Mitchell) - 1.0).abs() < 1e-12);
        assert!(height(1.5) < 0.0 && height(2.0).abs() < 1e-15);
    }
}
