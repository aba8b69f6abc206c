//! An axis on which equal factors are equal lengths.

use std::ops::Range;

use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};

use crate::math::functions::{decimal_logarithm, power_f64};

/// A logarithmic axis. `plotters` has one, but it takes logarithms from the machine's library, which differ in the last
/// bits.
#[derive(Debug, Clone)]
pub(super) struct LogarithmicAxis {
    range: Range<f64>,
    /// Places with a label.
    ticks: Vec<f64>,
}

impl LogarithmicAxis {
    /// An axis that holds all values with some room around them, labelled at decades, or at 1, 2, 5 if they span less than
    /// two. Values that are not positive and finite are passed over; without any, from 0.1 to 10.
    pub fn around(values: impl IntoIterator<Item = f64>) -> Self {
        let logarithms = values.into_iter().filter(|value| *value > 0.0 && value.is_finite()).map(decimal_logarithm);
        let (low, high) =
            logarithms.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
        let (low, high) = if low <= high { (low, high) } else { (-1.0, 1.0) };
        let room = (0.06 * (high - low)).max(0.08);
        let range = power_f64(10.0, low - room)..power_f64(10.0, high + room);
        let decades = multiples(&range, &[1]);
        let ticks = if decades.len() > 2 { decades } else { multiples(&range, &[1, 2, 5]) };
        Self { range, ticks }
    }

    /// The same axis labelled at places of one's own.
    pub fn labelled_at(self, ticks: Vec<f64>) -> Self {
        Self { ticks, ..self }
    }

    /// The place of a value from 0 at the low end to 1 at the high one.
    fn place(&self, value: f64) -> f64 {
        let [low, high, value] = [self.range.start, self.range.end, value].map(decimal_logarithm);
        (value - low) / (high - low)
    }
}

/// The given multiples of powers of ten in a range.
fn multiples(range: &Range<f64>, factors: &[i32]) -> Vec<f64> {
    let exponent = |value: f64| decimal_logarithm(value).floor() as i32;
    let exponents = exponent(range.start)..=exponent(range.end);
    // From the decimal digits, so that 0.001 is the number that is printed so.
    let value = |exponent: i32, factor: i32| format!("{factor}e{exponent}").parse().unwrap_or(f64::NAN);
    exponents
        .flat_map(|exponent| factors.iter().map(move |&factor| value(exponent, factor)))
        .filter(|value| range.contains(value))
        .collect()
}

impl Ranged for LogarithmicAxis {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, (start, end): (i32, i32)) -> i32 {
        start + (f64::from(end - start) * self.place(*value)).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, hint: Hint) -> Vec<f64> {
        if hint.weight().allow_light_points() {
            multiples(&self.range, &[1, 2, 3, 4, 5, 6, 7, 8, 9])
        } else {
            self.ticks.clone()
        }
    }

    fn range(&self) -> Range<f64> {
        self.range.clone()
    }
}

impl ValueFormatter<f64> for LogarithmicAxis {
    /// Plain digits where they are short.
    fn format_ext(&self, value: &f64) -> String {
        if (1e-4..1e6).contains(value) { format!("{value}") } else { format!("{value:e}") }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_factors_are_equal_lengths() {
        let axis = LogarithmicAxis::around([0.01, 100.0]);
        let map = |value: f64| axis.map(&value, (1000, 0));
        assert_eq!((map(1.0), map(0.1) - map(1.0)), (500, map(1.0) - map(10.0)));
        assert!(map(0.01) < 1000 && map(100.0) > 0);
        assert_eq!(axis.ticks, [0.01, 0.1, 1.0, 10.0, 100.0]);
    }

    #[test]
    fn less_than_two_decades_have_ticks_between() {
        assert_eq!(LogarithmicAxis::around([0.011, 0.09]).ticks, [0.01, 0.02, 0.05, 0.1]);
        assert_eq!(LogarithmicAxis::around([f64::NAN, 0.0]).ticks, [0.1, 1.0, 10.0]);
    }
}
