//! Numbers for reports, rounded to their significant digits.

use serde::{Serialize, Serializer};

/// A number rounded to this number of decimals.
pub fn rounded(value: f64, digits: i32) -> f64 {
    let scale = 10f64.powi(digits);
    (value * scale).round() / scale
}

/// The same for `#[serde(serialize_with = "digits::<3, _>")]`. JSON has no infinity: it is written as null.
pub fn digits<const DIGITS: i32, S: Serializer>(value: &f64, serializer: S) -> Result<S::Ok, S::Error> {
    rounded(*value, DIGITS).serialize(serializer)
}

/// The same with this number of significant digits.
#[cfg(feature = "stress")]
pub fn significant<const DIGITS: usize, S: Serializer>(value: &f64, serializer: S) -> Result<S::Ok, S::Error> {
    format!("{value:.0$e}", DIGITS - 1).parse().unwrap_or(*value).serialize(serializer)
}
