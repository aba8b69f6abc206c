//! Why a fix changes nothing.

use crate::validate::{Check, Verdict};

/// Why the fix of a map changes nothing, as a sentence without its full stop: the map may fit, be undecidable, or have
/// faces that do not belong, which no lookup mends.
pub fn nothing_to_fix(check: &Check) -> String {
    let outliers: Vec<&str> = check.outliers.iter().map(|outlier| outlier.face.name()).collect();
    match check.verdict {
        Verdict::Fits => "the map fits under this lookup: nothing to fix".to_owned(),
        _ if !check.has_equal_squares() => {
            "broken: the faces are not square or not of one size, which no lookup repairs".to_owned()
        }
        _ if !outliers.is_empty() => {
            format!("broken, and no lookup repairs it: {}: the picture does not belong here", outliers.join(", "))
        }
        Verdict::Undecidable => {
            "undecidable: the pixels do not tell whether these faces fit; nothing is changed".to_owned()
        }
        Verdict::Broken => "broken, but no change is certain; nothing is changed".to_owned(),
    }
}
