//! The validator: whether six pictures fit together under the lookup that the tracer uses, and if not, the smallest
//! change that makes them fit.
//!
//! 1. [`borders`] reads four rows of texels along each side of each image, two deeper ones and, of JPEG files, the two
//!    at the first block boundary. Only these texels decide seams and orientations. Whole pictures are read to find
//!    equal pictures ([`outlier`]), symmetric ones ([`solve`]) and, on a grid, the sky ([`sky`]).
//! 2. [`borders::pair_cost`] gives the cost of one border as the continuation of another, for all pairs.
//!    [`borders::agreement`] compares the patterns along them by rank, which is robust against compression.
//! 3. [`search::branch_and_bound`] finds the cheapest arrangement of the images on the faces exactly, by branch and
//!    bound.
//! 4. [`search::evidence`] says whether one arrangement is decisively better than another, [`solve`] picks the simplest
//!    of the equally good ones and changes nothing that the pixels do not decide, [`outlier`] finds faces that fit
//!    nowhere.
//!
//! 5. [`story`] tells what happened to the files; [`thresholds`] has every threshold.
//!
//! Data only: this module neither prints nor draws.

mod borders;
mod check;
mod copies;
mod finding;
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

pub use borders::edge::Edge;
pub use check::{check, load};
pub use finding::{Finding, KINDS, Level};
pub use findings::{Check, FaceFix, Fix, ImageFacts};
pub use note::{Note, PictureNames, joined, listed, why_outlier};
pub use options::{CheckOptions, Names};
pub use outlier::{Outlier, Reason};
pub use seam::Seam;
pub use search::convention::Convention;
pub use search::convention::mirrored_faces;
pub use story::{Story, exchange_reason, rings};
pub use verdict::Verdict;
