//! The verdict on a map or a seam.

/// What a map, or one seam of it, is found to be.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Verdict {
    /// No other orientation is decisively better, and the pixels would tell.
    Fits,
    /// Another orientation fits decisively better, or a face does not belong.
    Broken,
    /// The pixels cannot tell.
    Undecidable,
}

impl Verdict {
    /// The word in reports and JSON.
    pub fn name(self) -> &'static str {
        match self {
            Self::Fits => "fits",
            Self::Broken => "broken",
            Self::Undecidable => "undecidable",
        }
    }
}
