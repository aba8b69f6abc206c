//! A logarithmic axis.

use crate::math::functions::{decimal_logarithm, power_f64};

/// A logarithmic axis.
#[derive(Debug, Clone)]
pub(in crate::report) struct Axis {
    pub title: &'static str,
    /// The least and the largest value.
    pub range: [f64; 2],
    /// Places with a label.
    pub ticks: Vec<f64>,
    /// Places with a line.
    pub lines: Vec<f64>,
}

/// Labels find room if there are no more.
const MOST_TICKS: usize = 9;

impl Axis {
    /// An axis that holds all values with some room around them. Values that are not positive and finite are passed over;
    /// without any, from 0.1 to 10.
    pub fn around(title: &'static str, values: impl IntoIterator<Item = f64>) -> Self {
        let logarithms = values.into_iter().filter(|value| *value > 0.0 && value.is_finite()).map(decimal_logarithm);
        let (low, high) =
            logarithms.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
        let (low, high) = if low <= high { (low, high) } else { (-1.0, 1.0) };
        let room = (0.06 * (high - low)).max(0.08);
        Self::between(title, [low - room, high + room].map(|exponent| power_f64(10.0, exponent)))
    }

    /// An axis labelled at decades, at some of them if they are many, or at 1, 2, 5 if it spans less than two.
    pub fn between(title: &'static str, range: [f64; 2]) -> Self {
        let decades = multiples(range, 1, &[1]).len();
        let stride = decades.div_ceil(MOST_TICKS).max(1);
        let ticks = multiples(range, stride, if decades > 2 { &[1] } else { &[1, 2, 5] });
        let lines =
            if decades > MOST_TICKS { ticks.clone() } else { multiples(range, 1, &[1, 2, 3, 4, 5, 6, 7, 8, 9]) };
        Self { title, range, ticks, lines }
    }

    /// With every second, third, ... label only, so that there are no more than `most`.
    #[cfg_attr(not(feature = "stress"), allow(dead_code))]
    pub fn thinned(mut self, most: usize) -> Self {
        let stride = self.ticks.len().div_ceil(most).max(1);
        self.ticks = self.ticks.into_iter().step_by(stride).collect();
        self
    }

    /// The place of a value from 0 at the low end to 1 at the high one.
    pub fn place(&self, value: f64) -> f32 {
        let [low, high] = self.range.map(decimal_logarithm);
        ((decimal_logarithm(value) - low) / (high - low)) as f32
    }
}

/// The given multiples in a range of every `stride`th power of ten.
fn multiples(range: [f64; 2], stride: usize, factors: &[i32]) -> Vec<f64> {
    let [first, last] = range.map(|value| decimal_logarithm(value).floor() as i32);
    let exponents = (first..=last).filter(|exponent| exponent.rem_euclid(stride as i32) == 0);
    // From the decimal digits, so that 0.001 is the number that is printed so.
    let value = |exponent: i32, factor: i32| format!("{factor}e{exponent}").parse().unwrap_or(f64::NAN);
    exponents
        .flat_map(|exponent| factors.iter().map(move |&factor| value(exponent, factor)))
        .filter(|value| (range[0]..=range[1]).contains(value))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_factors_are_equal_lengths() {
        let axis = Axis::around("", [0.01, 100.0]);
        let steps = [0.1, 1.0, 10.0].map(|value| axis.place(10.0 * value) - axis.place(value));
        assert!((axis.place(1.0) - 0.5).abs() < 1e-6 && steps.iter().all(|step| (step - steps[0]).abs() < 1e-6));
        assert!(axis.place(0.01) > 0.0 && axis.place(100.0) < 1.0);
        assert_eq!(axis.ticks, [0.01, 0.1, 1.0, 10.0, 100.0]);
    }

    #[test]
    fn few_decades_have_ticks_between_and_many_not_all() {
        assert_eq!(Axis::around("", [0.011, 0.09]).ticks, [0.01, 0.02, 0.05, 0.1]);
        assert_eq!(Axis::around("", [f64::NAN, 0.0]).ticks, [0.1, 1.0, 10.0]);
        assert_eq!(Axis::between("", [1e-10, 1e6]).ticks, [1e-10, 1e-8, 1e-6, 1e-4, 1e-2, 1.0, 1e2, 1e4, 1e6]);
    }
}
