//! Where v = 0 lies in an image.

/// The row of the image at v = 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize, clap::ValueEnum)]
#[serde(rename_all = "lowercase")]
pub enum VOrigin {
    /// v = 0 is the top row: v grows downwards.
    Top,
    /// v = 0 is the bottom row: v grows upwards.
    Bottom,
}
