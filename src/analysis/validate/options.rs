//! What the user says about a map.

use crate::envmap::SignedAxis;

/// Whether images may change places.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Names {
    /// Only if nothing else closes the seams.
    #[default]
    Auto,
    /// Never.
    Trusted,
    /// As if the names meant nothing.
    AnyOrder,
}

/// What the user says about the map.
#[derive(Debug, Clone, Default)]
pub struct CheckOptions {
    /// The axis that points up in the user's world, if named.
    pub world_up: Option<SignedAxis>,
    /// Whether the names of the files tell which face an image is.
    pub names: Names,
    /// What the report calls the lookup.
    pub lookup_name: String,
}
