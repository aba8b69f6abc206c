//! The validator: whether six pictures fit together under the lookup that the tracer uses, and if not, the smallest
//! change that makes them fit.
//!
//! 1. [`border`] reads four rows of texels along each side of each image, two deeper ones and, of JPEG files, the two at the
//!    first block boundary. Seams and orientations are judged by nothing else. Whole pictures are read to see whether two are the
//!    same ([`foreign`]), whether one is symmetric ([`decided`]), and, on a grid, where the sky is ([`sky`]).
//! 2. [`pair_cost`] says what it costs to let one border continue another, for all pairs, once.
//!    [`agreement`] says the same of the patterns along them, by rank: robust where compression hides the rest.
//! 3. [`search`] finds the cheapest way to lay the images on the faces: exactly, by branch and bound.
//! 4. [`evidence`] says whether one way is decisively better than another, [`solve`] picks the simplest of those that
//!    are equally good, [`decided`] leaves alone what the pixels do not decide, [`foreign`] finds faces that fit nowhere.
//!
//! Data only: this module neither prints nor draws.

mod agreement;
mod arrangement;
mod border;
mod check;
pub(crate) mod convention;
mod decided;
mod display;
mod edge;
mod evidence;
mod foreign;
mod handedness;
mod notes;
mod pair_cost;
mod seam;
mod search;
mod signal;
mod sky;
mod solve;
mod symmetry;

pub use check::{Check, CheckOptions, FaceFix, Fix, ImageFacts, Names, Verdict, check, load};
pub use convention::Convention;
pub use edge::{Edge, Side};
pub use foreign::{Foreign, Reason};
pub use handedness::mirrored_faces;
pub use notes::Note;
pub use seam::Seam;
