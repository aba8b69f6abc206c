//! Numbers for reports, rounded to the digits that mean something.

use serde::{Serialize, Serializer};

/// A number rounded to so many digits behind the point.
pub fn rounded(value: f64, digits: i32) -> f64 {
    let scale = 10f64.powi(digits);
    (value * scale).round() / scale
}

/// The same for `#[serde(serialize_with = "digits::<3, _>")]`. JSON has no infinity: it is written as null.
pub fn digits<const DIGITS: i32, S: Serializer>(value: &f64, serializer: S) -> Result<S::Ok, S::Error> {
    rounded(*value, DIGITS).serialize(serializer)
}

/// The same with so many significant digits.
#[cfg(feature = "stress")]
pub fn significant<const DIGITS: usize, S: Serializer>(value: &f64, serializer: S) -> Result<S::Ok, S::Error> {
    format!("{value:.0$e}", DIGITS - 1).parse().unwrap_or(*value).serialize(serializer)
}
