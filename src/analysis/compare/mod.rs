//! What a student's picture does differently from the expected one.
//!
//! The search goes from the coarse to the fine:
//!
//! ```text
//!   orientation   and a rough shift, by correlation, which hardly sees tones
//!   tone          gamma, exposure, channels: a small search, the exposure solved in closed form
//!   shift         to a fraction of a pixel
//!   rest          clipped highlights, a region, edges, noise, or all over
//! ```
//!
//! Pictures without detail get their orientation from their colours. Where no orientation correlates, the search tries
//! another field of view or factor width/height, a part of the picture that fits in place, and outlines in other tones.
//!
//! A finding is kept only if the difference is decisively larger without its correction.

mod channels;
mod clipped;
mod comparison;
mod edges;
mod encoding;
mod evenness;
mod everywhere;
mod exposure;
mod finding;
mod noise;
mod not_finite;
mod operations;
mod orientation;
mod outlines;
mod partial;
mod region;
mod residue;
mod resized;
mod rest;
mod scaled;
mod search;
mod shift;
mod shifted;
mod size;
mod smooth;
mod structure;
mod subject;
mod tone;
mod tone_search;
mod turned_region;
mod undoing;
mod unrelated;
mod view;

pub use comparison::{Comparison, Verdict};
pub use finding::{Finding, Weight};
pub use region::Region;
pub use view::{View, Views};
