//! The validator: whether six pictures fit together under the lookup that the tracer uses, and if not, the smallest
//! change that makes them fit.
//!
//! 1. [`borders`] reads four rows of texels along each side of each image, two deeper ones and, of JPEG files, the two at the
//!    first block boundary. Seams and orientations are judged by nothing else. Whole pictures are read to see whether two are the
//!    same ([`outlier`]), whether one is symmetric ([`solve`]), and, on a grid, where the sky is ([`sky`]).
//! 2. [`borders::pair_cost`] says what it costs to let one border continue another, for all pairs, once.
//!    [`borders::agreement`] says the same of the patterns along them, by rank: robust where compression hides the rest.
//! 3. [`search::branch_and_bound`] finds the cheapest way to lay the images on the faces: exactly, by branch and bound.
//! 4. [`search::evidence`] says whether one way is decisively better than another, [`solve`] picks the simplest of those that
//!    are equally good and leaves alone what the pixels do not decide, [`outlier`] finds faces that fit nowhere.
//!
//! 5. [`story`] tells what happened to the files; [`thresholds`] has every number that decides something.
//!
//! Data only: this module neither prints nor draws.

mod borders;
mod check;
mod findings;
mod note;
mod notes;
mod options;
mod outlier;
mod seam;
mod search;
mod sky;
mod solve;
mod story;
mod thresholds;
mod verdict;

pub use borders::edge::{Edge, Side};
pub use check::{check, load};
pub use findings::{Check, FaceFix, Fix, ImageFacts};
pub use note::Note;
pub use options::{CheckOptions, Names};
pub use outlier::{Outlier, Reason};
pub use seam::Seam;
pub use search::convention::Convention;
pub use search::convention::mirrored_faces;
pub use story::Story;
pub use verdict::Verdict;
