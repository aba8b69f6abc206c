//! The validator's own limits: how small, noisy or compressed pictures may be until its verdict is undecided.
//!
//! Worlds that are drawn by direction ([`world`]) are damaged ([`damage`]), their pixels suffer ([`defects`]), and the
//! answer of the validator is compared with what was done ([`trial`]). Stands above `stress` and `validate`, which do not
//! know each other. Data only.

mod damage;
mod defects;
mod subjects;
mod trial;
mod world;

pub use subjects::SUBJECTS;

use crate::picture::{Format, Header, Picture, Texels};

/// A square picture of sRGB codes.
fn picture_of(size: usize, bytes: Vec<u8>) -> Picture {
    Picture::new(
        Header { width: size, height: size, format: Format::Png, bit_depth: 8, alpha: false },
        Texels::Srgb8(bytes),
    )
}
