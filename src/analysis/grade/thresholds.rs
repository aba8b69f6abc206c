//! All thresholds of the grader: what each separates, and how far right and wrong shots lie on either side of it.
//!
//! `cargo test --release -p skycube-analysis grade::thresholds -- --ignored --nocapture` prints the margins for the maps at
//! hand. Codes are sRGB-encoded and in `[0, 1]`. The sizes of grids and of search steps stand with their algorithms: they
//! decide nothing.

/// Whether a shot shows an image at all: [`super`].
pub mod shown {
    /// The largest part of a shot's variance that its image may leave unexplained. Measured: right shots reach 0.44 in a night
    /// sky of single stars, which 64 pixels hardly show; shots of another map have 0.21 or more, if a plain sky is in both:
    /// the two overlap, and what is left unexplained never names a face by itself.
    pub const UNEXPLAINED: f64 = 0.4;
    /// What may be left unexplained in any case, as a mean square of codes.
    pub const NEGLIGIBLE: f64 = 0.03 * 0.03;
    /// Variance of codes below which a picture is of one colour.
    pub const FLAT: f64 = 0.005 * 0.005;
    /// Codes from here on are as bright as can be, and may be cut off: a definition, without a margin.
    pub const WHITE: f32 = 0.98;
    /// The part of the variance that may be left unexplained before code without the division is thought of. Measured: right
    /// shots reach 0.08 (stars), undivided ones have 0.13 or more; [`MUCH_BETTER`] protects the former.
    pub const UNDIVIDED: f64 = 0.02;
    /// The part of what is left unexplained that another explanation must leave at most.
    pub const MUCH_BETTER: f64 = 0.5;
}

/// The angle of the camera: [`super::field_of_view`] and [`super::cause`].
pub mod angle {
    /// A scale off by less is not off; nor one off by half a pixel at the borders of a small shot.
    pub const TOLERANCE: f64 = 0.02;
    /// What another scale must explain at least, as a part of the variance: what it explains of a plain colour or of a
    /// gradient, which fits at any scale, is rounding.
    pub const TELLING: f64 = 0.02;
    /// The part of the variance that must be left unexplained at 90 degrees before other angles are tried. Measured: right shots
    /// reach 0.08.
    pub const WORTH_A_SEARCH: f64 = 0.1;
    /// The part of what is left at 90 degrees from which on another angle is no better.
    pub const HARDLY_BETTER: f64 = 0.9;
    /// Variance below which a shot is nearly uniform and tells little. Measured: shots with detail have 0.0017 or more.
    pub const NEARLY_UNIFORM: f64 = 0.03 * 0.03;
    /// Degrees by which a measured angle may be off that of code which does not halve the coordinates.
    pub const DEGREES: f64 = 2.0;
}

/// Which images and orientations the pixels exclude: [`super::matching`] and [`super::alternative`].
pub mod decisive {
    /// Deviations that decide: a large number, because misfits of neighbouring cells are correlated. Measured: the images that a
    /// right shot does not show are behind by 0.3 (two plain skies) or more: what is not excluded is told as possible.
    pub const DEVIATIONS: f64 = 12.0;
    /// Where the shot lies between the other prediction (0) and the best one (1), at least. Measured: right shots lie at 0.999
    /// or more.
    pub const NEARNESS: f64 = 0.7;
    /// What codes are off by in any case: rounding, filtering, curves that are not quite met.
    pub const SURE_NOISE: f64 = 0.006;
    /// Faces that must be decided before their lookup is called by a name: half of them, a rule rather than a measure.
    pub const TELLING_FACES: usize = 3;
    /// When the camera is blamed for faces that are wrong, a rule of what is simpler: one camera that explains three faces
    /// is, and it may leave one face that is wrong by itself.
    pub const LEFT_WRONG: usize = 1;
    pub const SET_RIGHT: usize = 3;
}

/// The words for a shot without an image: [`super::misfit`]. They choose a description and no verdict, and have no margin.
pub mod misfit {
    /// Codes up to here are black.
    pub const BLACK: f32 = 0.02;
    /// The share of black cells from which on a shot is black.
    pub const ALL_BLACK: f64 = 0.98;
    /// Neighbouring cells that differ by less are the same.
    pub const SAME: f32 = 0.004;
    /// Cells that differ from the first by less make one colour with it: those on either side of it may differ by [`SAME`].
    pub const LIKE_THE_FIRST: f32 = 2.0 * SAME;
    /// The share of cells from which on a shot is of one colour.
    pub const ONE_COLOUR: f64 = 0.999;
    /// A column or row varies if two of its cells differ by more.
    pub const VARIES: f32 = 4.0 * SAME;
    /// How much less two halves differ from each other than within themselves if one repeats the other.
    pub const REPEATED: f32 = 0.3;
    /// A share of a shot that is worth naming.
    pub const PART: f64 = 0.2;
    /// All of it, but for rounding.
    pub const ALL: f64 = 0.95;
}

#[cfg(test)]
mod margins;
