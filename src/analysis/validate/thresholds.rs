//! All thresholds of the validator: what each separates, and the margins of the maps at hand on either side.
//!
//! `cargo test --release -p skycube-analysis thresholds -- --ignored --nocapture` prints the margins for the project's maps
//! and those beside the repository: "measured" below is what it printed for 15 maps. Steps are of 255 display codes; fits are
//! those of [`super::search::arrangement`]. The sizes of grids and bands stand with their algorithms: they decide nothing.

/// When one arrangement fits decisively better than another: [`super::search::evidence`].
pub mod evidence {
    /// Standard errors by which an arrangement must be better. Measured: no right map is worse than a changed one at all;
    /// decided turned faces have 2.96 or more (a night sky, decided by [`FEW_STANDARD_ERRORS`]), 3.8 on the other maps.
    pub const STANDARD_ERRORS: f64 = 3.5;
    /// The part of the cost that it must save: less is a trifle, whatever its standard errors are. Measured: a turned face
    /// wastes 0.41 or more.
    pub const IMPROVEMENT: f64 = 0.12;
    /// Nearly nothing is left of the cost: fewer standard errors will do, as where only a few lines cross the borders.
    pub const FEW_STANDARD_ERRORS: f64 = 2.5;
    pub const NEARLY_ALL: f64 = 0.5;
    /// A difference of a unit that rounding and noise do not make: a factor of e in likelihood. A definition, without a margin:
    /// [`STRONG_GAIN`], [`STRONG_COUNT`] and [`STRONG_LOSS`] decide.
    pub const STRONG: f64 = 1.0;
    /// In a plain sky only a few coarse coefficients tell one orientation from another: those that differ strongly must
    /// agree. Least logarithm of the likelihood, least count, and largest part of losses. Measured: decided turned faces have
    /// 37.8 and 18 or more; their losses reach 0.20, where other evidence decides.
    pub const STRONG_GAIN: f64 = 15.0;
    pub const STRONG_COUNT: usize = 6;
    pub const STRONG_LOSS: f64 = 0.12;
    /// Coarse ground under strong compression: neither the costs nor the patterns along the borders decide alone, but both
    /// point the same way. Logarithms of likelihood of the two together: of n standard errors n^2 / 2, and the agreement. Each
    /// must tell something. A clear sky whose turned faces were stored at JPEG quality 50 reaches 0.9 standard errors for a
    /// wrong orientation by chance, so the least number of them protects from little: what protects is the agreement, which
    /// counts only what two patterns do not have in common ([`super::super::borders::agreement`]), and the sum of both.
    pub const TOGETHER: f64 = 5.5;
    pub const SOME_AGREEMENT: f64 = 3.0;
    pub const SOME_STANDARD_ERRORS: f64 = 0.5;
    pub const SOME_IMPROVEMENT: f64 = 0.03;
    /// Another arrangement is noticeably better, though not decisively, from this logarithm of likelihood (as in
    /// [`TOGETHER`]) and this part of the cost on: then nobody can say that a map fits. Measured: on right maps none is better
    /// at all. Small files reach 0.8 (a folder for krpano) and, under noise of 16 codes, 1.6 at a part of 0.06; turned
    /// faces that were stored at JPEG quality 40 or blurred, and not decided, have 1.7 or more.
    pub const NOTICEABLE: f64 = 1.5;
    pub const NOTICEABLE_IMPROVEMENT: f64 = 0.05;
}

/// The least change from row to row, squared, that a border is credited with: [`super::borders::pair_cost`]. Estimates of what
/// files do to a border, in codes; they separate nothing and have no margin.
pub mod noise {
    /// Resampling, at all scales.
    pub const RESAMPLED: f32 = 0.1 * 0.1;
    /// Rounding of a texel to whole codes.
    pub const ROUNDED: f32 = 0.5 * 0.5;
    /// Rounding of the mean of a JPEG block of eight texels.
    pub const BLOCK_ROUNDED: f32 = 0.4 * 0.4;
    /// Files of more than 8 bits round a tenth as much or less: the square of that.
    pub const FINER_FILES: f32 = 0.01;
}

/// Faces that do not belong: [`super::outlier`].
pub mod outlier {
    /// The mean fit of the four seams of a face from which on it is an outlier. Measured: right faces reach 0.53, faces of
    /// another map have 0.75 or more (a wall of the hall among the pictures of another plain room), most 0.9 or more.
    pub const OUTLIER: f64 = 0.8;
    /// The same for a face that everybody sees, since at least three of its seams gape and those of the others do not. Measured:
    /// right faces reach 0.53, faces of another map have 0.75 or more. A face in grey reaches 1.08: [`KINDRED`] protects it.
    pub const OUTLIER_GLARING: f64 = 0.65;
    /// How many times further the seams of such a face step than those between the others. Charts of one colour a face, and six
    /// unrelated pictures, step everywhere. Measured: faces of another map have 3.9 or more. Right ones reach 5.2, on coarse
    /// ground that meets plain sky everywhere else: their fit protects them.
    pub const STEP_RATIO: f64 = 2.0;
    /// The seams of a face, of four, that must gape.
    pub const GAPING_SEAMS: usize = 3;
    /// As [`OUTLIER`], for one of two equal images.
    pub const OUTLIER_COPY: f64 = 0.5;
    /// The mean step of the seams of a copy, and how many times as far they step as those of the original, which has the same
    /// detail and noise. Measured: no two faces of a map without a copy are taken for the same, but in a chart whose seams all
    /// close; copies that step by 3 codes or more step 4.1 times as far as their originals (in the hall).
    pub const COPY_STEP: f64 = 3.0;
    pub const COPY_RATIO: f64 = 2.0;
    /// The same for one flat colour, which continues any plain picture but for its brightness. Measured: faces made flat
    /// have 0.70 or more; that right ones with detail reach 0.53 says nothing of flat ones.
    pub const OUTLIER_FLAT: f64 = 0.3;
    /// The mean step by which the neighbours must end in other colours than an outlier: a flat sky whose neighbours fade into
    /// about its colour is a picture of a flat sky, and a nearly black floor (4 to 6 codes) belongs to nearly black walls.
    /// Measured: faces of another map step by 18.9 or more, right ones by up to 19.0, which their fit protects.
    pub const OUTLIER_STEP: f64 = 16.0;
    /// The mean fit that the eight other seams must reach. Measured: those of right maps reach 0.48, those of six pictures of
    /// different maps have 0.70 or more.
    pub const FAMILIAR: f64 = 0.7;
    /// The mean score (step over detail) below which the seams are not a visible fault. Measured: right faces reach 3.04,
    /// faces of another map have 5.3 or more.
    pub const VISIBLE: f64 = 3.0;
    /// The mean cost, brightness apart, that two unlike patterns have at least. Measured: faces of another map have 38 or more
    /// (in a night sky; elsewhere 151). Right ones reach 135, which their fit protects: the two overlap.
    pub const ANOTHER_PATTERN: f64 = 30.0;
    /// The agreement of the brightness along its four borders from which on a face is no outlier, however much its colours
    /// differ: a grey face among coloured ones, a face in a frame. Measured: outliers reach 6.7, faces in grey have 10.4 or more
    /// (below a cloudy sky; 32 elsewhere).
    pub const KINDRED: f64 = 10.0;
}

/// Images that show the same picture: [`super::copies`].
pub mod copies {
    /// The correlation of the fine detail of two images from which on they show the same. Measured: different faces of one map
    /// reach 0.28, but for a chart with a letter on each (0.84), whose seams close; a face and itself under noise of 8 codes
    /// have 0.87 or more.
    pub const SAME_DETAIL: f64 = 0.6;
    /// The root of the mean square of detail, in codes, below which an image is too plain to tell: rounding makes 0.3. No
    /// margin: plain skies have any detail from 0 on.
    pub const LEAST_DETAIL: f64 = 1.5;
}

/// Seams as the report shows them: [`super::seam`].
pub mod seam {
    /// The fit of a seam from which on its borders go as well with most others. Measured: those of right maps reach 0.70.
    pub const UNDECIDED: f64 = 0.85;
    /// Words for single seams, which decide no verdict and have no margin: a seam is broken if it costs more than this times what
    /// its sides cost in the arrangement found, and so much more.
    pub const BROKEN_FACTOR: f64 = 1.3;
    pub const BROKEN_COST: f64 = 4.0;
    /// Detail below half a code is that of rounding: a definition, without a margin.
    pub const LEAST_DETAIL: f64 = 0.5;
    /// The cost of rounding errors alone, which counts on both sides of a fit: it separates nothing.
    pub const NOTHING: f64 = 2.0;
    /// The score above which a seam is called rough although the geometry fits. No margin: right maps reach 7.1.
    pub const ROUGH: f64 = 3.0;
    /// Codes by which all neighbours of a face must differ in one direction before a note calls it exposed otherwise. It decides no
    /// verdict and has no margin: the note says how many codes it is.
    pub const EXPOSED: f64 = 2.0;
}

/// Verdicts: [`super::solve`] and [`super::check`].
pub mod verdict {
    /// The mean fit of seams from which on the six pictures have nothing to do with each other. Measured: right maps reach 0.45,
    /// pictures of six maps have 0.83 or more (five of them dark; 0.85 elsewhere), and too few of their faces tell.
    pub const UNRELATED: f64 = 0.85;
    /// Half of the orientations and of the faces, a rule rather than a measure: orientations of a face that must be decisively worse before the face tells anything, and faces that must tell.
    pub const TELLING_ORIENTATIONS: usize = 4;
    pub const TELLING_FACES: usize = 3;
    /// Orientations that must be decisively worse before a file is edited.
    pub const EDITED_ORIENTATIONS: usize = 3;
    /// The mean step of seams that gape as nobody would overlook, and the part of it that a repair must leave at most: then a
    /// map is broken even where fewer faces tell. Measured: seams of right maps step by up to 10; a smooth sky with two files
    /// exchanged has 15 to 49 against 2, and a repair leaves at most 0.19. A chart whose borders are all alike has 0.01.
    pub const TORN_STEP: f64 = 12.0;
    pub const REPAIRED: f64 = 1.0 / 3.0;
    /// Undecidable seams from which on a map does not fit: half of them. Measured: right maps have none.
    pub const UNDECIDABLE_SEAMS: usize = 6;
    /// Rough seams from which on a map of which no face is decided does not fit: half of them. Measured: such right maps
    /// have 2; pictures blurred over a quarter of their width have 12.
    pub const ROUGH_SEAMS: usize = 6;
}

/// What happened to the files: [`super::story`] and [`super::search::convention`]. The costs order stories and mean nothing
/// else; `the_costs_keep_their_order` has the order that they must keep.
pub mod story {
    /// Two files of opposite faces in each other's place: left and right, front and back, top and bottom are easily mixed up.
    pub const EXCHANGE_OF_OPPOSITES: u32 = 20;
    /// Two other files in each other's place.
    pub const EXCHANGE: u32 = 26;
    /// The same where names cost nothing: enough to prefer files that stay where they are.
    pub const EXCHANGE_OF_FREE_NAMES: u32 = 1;
    /// A file turned by a quarter or a half.
    pub const TURN: u32 = 30;
    /// A file flipped left-right or top-bottom.
    pub const FLIP: u32 = 40;
    /// A mirroring about a diagonal, which nobody does by mistake.
    pub const DIAGONAL: u32 = 50;
    /// The faults that an order leaves at most: with more of them it explains nothing.
    pub const MOST_FAULTS: usize = 2;

    /// Names, of six, that must be an order's before they announce it: those of the four sides, by which the orders differ.
    pub const ANNOUNCING_NAMES: usize = 4;
    /// Assuming an order that the names or the format of the files announce.
    pub const ANNOUNCED: u32 = 5;
    /// Assuming a usual order of numbers or cells, which have no names: less than to tell the same file by file.
    pub const NUMBERED: u32 = 2;
    /// Assuming the table of another lookup for an upright world.
    pub const OTHER_TABLE: u32 = 10;
    /// As much as two files exchanged: where both explain a map, the pictures decide.
    pub const LIKE_AN_EXCHANGE: u32 = 20;
    /// Under a table that turns the world on its side.
    pub const SIDEWAYS: u32 = 25;
    /// Six mirrored files: more than two exchanged ones, which look the same, but for a mirror.
    pub const MIRRORED: u32 = 35;
}

/// Where the sky seems to be: [`super::sky`]. A hint that only chooses between equally short stories.
pub mod sky {
    /// Codes of brightness that count as much as a factor of e in detail. A weight, without a margin.
    pub const CODES: f64 = 64.0;
    /// A hint for a note, without a margin: how far the sky must differ from the face opposite before it is named, and how many times further than the next pair.
    pub const CONTRAST: f64 = 1.0;
    pub const CONTRAST_RATIO: f64 = 1.5;
}

/// The evidence of patterns along two borders: [`super::borders::agreement`]. These follow from statistics, separate nothing by
/// themselves and have no margin: [`evidence::SOME_AGREEMENT`] decides.
pub mod agreement {
    /// The most that a single seam can tell: one alone decides nothing.
    pub const MOST: f32 = 8.0;
    /// What the mean, the scale and a trend take off the independent texels (Fisher: n - 3 for a correlation). A border that
    /// only grows brighter counts as 4.4 of them by Bartlett's formula, so a trend is little evidence: 2.7 a seam.
    pub const TREND: f32 = 3.0;
    /// The highest correlation that is believed when two are compared: nearer to 1 Fisher's approximation exaggerates.
    pub const HIGHEST: f32 = 0.9;
    /// The least spread of the brightness along a border that is not rounding, in display units.
    pub const LEAST_SPREAD: f32 = 0.5;
}

/// A frame around a picture: [`super::borders::border`].
pub mod frame {
    /// Codes by which a texel of a frame of one colour may differ from its corner. A definition of one colour, without a margin:
    /// borders of plain skies have it, too, and [`PLAIN`] tells them from frames.
    pub const SAME_COLOUR: f32 = 12.0;
    /// The share of a side's texels that must agree, that is nearly all of them.
    pub const MOST_TEXELS: f64 = 0.9;
    /// How many times further the outermost row steps than the next one, and how many codes more: for a frame of one colour,
    /// and for one that is only darker. Measured: pictures without a frame step 1.3 times as far (4 for a dark frame).
    pub const PLAIN: (f64, f64) = (1.5, 4.0);
    pub const DARKER: (f64, f64) = (4.0, 6.0);
}

#[cfg(test)]
mod margins;
