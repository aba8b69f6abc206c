//! All thresholds of the validator: what each separates, and the margins of the maps at hand on either side.
//!
//! `cargo test --release -p skycube-analysis thresholds -- --ignored --nocapture` prints the margins for the project's maps
//! and those beside the repository. Steps are of 255 display codes; fits are those of [`super::search::arrangement`].

/// When one arrangement fits decisively better than another: [`super::search::evidence`].
pub mod evidence {
    /// Standard errors by which an arrangement must be better. Measured: a turned face has 3.8 or more (a chart of which only
    /// the background reaches the borders), 7.3 or more on all other maps.
    pub const STANDARD_ERRORS: f64 = 3.5;
    /// The part of the cost that it must save: less is a trifle, whatever its standard errors are. Measured: a turned face
    /// wastes 0.41 or more.
    pub const IMPROVEMENT: f64 = 0.12;
    /// Nearly nothing is left of the cost: fewer standard errors will do, as where only a few lines cross the borders.
    pub const FEW_STANDARD_ERRORS: f64 = 2.5;
    pub const NEARLY_ALL: f64 = 0.5;
    /// A difference of a unit that rounding and noise do not make: a factor of e in likelihood.
    pub const STRONG: f64 = 1.0;
    /// In a plain sky only a few coarse coefficients tell one orientation from another: those that differ strongly must
    /// agree. Least logarithm of the likelihood, least count, and largest part of losses.
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
    /// [`TOGETHER`]) and this part of the cost on: then nobody can say that a map fits. Measured over 11 right maps at 128 texels:
    /// none is better at all, but at JPEG quality 10 (up to -2.0) and under noise of 16 codes (up to 1.6, at a part of 0.06).
    pub const NOTICEABLE: f64 = 1.5;
    pub const NOTICEABLE_IMPROVEMENT: f64 = 0.05;
}

/// Faces that do not belong: [`super::outlier`].
pub mod outlier {
    /// The mean fit of the four seams of a face from which on it is an outlier. Measured: right faces reach 0.53, faces of
    /// another map have 0.80 or more.
    pub const OUTLIER: f64 = 0.8;
    /// The same for a face that everybody sees, since at least three of its seams gape and those of the others do not. Measured:
    /// right faces made grey reach 0.58, faces of another map have 0.75 or more, at 64 texels and JPEG quality 40.
    pub const OUTLIER_GLARING: f64 = 0.65;
    /// How many times further the seams of such a face step than those between the others. Charts of one colour a face, and six
    /// unrelated pictures, step everywhere.
    pub const STEP_RATIO: f64 = 2.0;
    /// As [`OUTLIER`], for one of two equal images.
    pub const OUTLIER_COPY: f64 = 0.5;
    /// The mean step of the seams of a copy, and how many times as far they step as those of the original, which has the same
    /// detail and noise.
    pub const COPY_STEP: f64 = 3.0;
    pub const COPY_RATIO: f64 = 2.0;
    /// The same for one flat colour, which continues any plain picture but for its brightness.
    pub const OUTLIER_FLAT: f64 = 0.3;
    /// The mean step by which the neighbours must end in other colours than an outlier: a flat sky whose neighbours fade into
    /// about its colour is a picture of a flat sky, and a nearly black floor (4 to 6 codes) belongs to nearly black walls.
    /// Measured: faces of another map step by 18.9 or more, right ones by up to 19.0, which their fit protects.
    pub const OUTLIER_STEP: f64 = 16.0;
    /// The mean fit that the eight other seams must reach.
    pub const FAMILIAR: f64 = 0.7;
    /// The mean score (step over detail) below which the seams are not a visible fault.
    pub const VISIBLE: f64 = 3.0;
    /// The mean cost, brightness apart, that two unlike patterns have at least. Measured: 151 or more for faces of another map.
    pub const ANOTHER_PATTERN: f64 = 30.0;
    /// The agreement of the brightness along its four borders from which on a face is no outlier, however much its colours
    /// differ: a grey face among coloured ones, a face in a frame. Measured: outliers reach 6.7, grey faces have 32.
    pub const KINDRED: f64 = 10.0;
}

/// Images that show the same picture: [`super::copies`].
pub mod copies {
    /// The correlation of the fine detail of two images from which on they show the same. Measured at 128 texels: different
    /// faces of one map reach 0.28, a face and itself under noise of 8 codes have 0.88 or more.
    pub const SAME_DETAIL: f64 = 0.6;
    /// The root of the mean square of detail, in codes, below which an image is too plain to tell.
    pub const LEAST_DETAIL: f64 = 1.5;
}

/// Seams as the report shows them: [`super::seam`].
pub mod seam {
    /// The fit of a seam from which on its borders go as well with most others.
    pub const UNDECIDED: f64 = 0.85;
    /// A seam is broken if it costs more than this times what its sides cost in the arrangement found, and so much more.
    pub const BROKEN_FACTOR: f64 = 1.3;
    pub const BROKEN_COST: f64 = 4.0;
    /// Detail below half a code is that of rounding.
    pub const LEAST_DETAIL: f64 = 0.5;
    /// The score above which a seam is called rough although the geometry fits.
    pub const ROUGH: f64 = 3.0;
    /// Codes by which all neighbours of a face must differ in one direction before it is called exposed otherwise.
    pub const EXPOSED: f64 = 2.0;
}

/// Verdicts: [`super::solve`] and [`super::check`].
pub mod verdict {
    /// The mean fit of seams from which on the six pictures have nothing to do with each other. Measured: right maps reach 0.45.
    pub const UNRELATED: f64 = 0.85;
    /// Orientations of a face that must be decisively worse before the face tells anything, and faces that must tell.
    pub const TELLING_ORIENTATIONS: usize = 4;
    pub const TELLING_FACES: usize = 3;
    /// Orientations that must be decisively worse before a file is edited.
    pub const EDITED_ORIENTATIONS: usize = 3;
    /// The mean step of seams that gape as nobody would overlook, and the part of it that a repair must leave at most: then a
    /// map is broken even where fewer faces tell. Measured: a smooth sky with two files exchanged has 15 to 49 against 2.
    pub const TORN_STEP: f64 = 12.0;
    pub const REPAIRED: f64 = 1.0 / 3.0;
    /// Undecidable seams from which on a map does not fit.
    pub const UNDECIDABLE_SEAMS: usize = 6;
}

#[cfg(test)]
mod tests {
    use std::path::{Path, PathBuf};

    use super::super::borders::border::{Borders, read_borders};
    use super::super::borders::edge::EdgeBorders;
    use super::super::borders::pair_cost::PairCosts;
    use super::super::outlier;
    use super::super::search::arrangement::{Arrangement, Problem};
    use super::super::search::branch_and_bound::{Freedom, cheapest};
    use crate::envmap::source::Skybox;
    use crate::envmap::{Face, Lookup, Preset};
    use crate::validate::load;

    /// The borders of every map at hand.
    fn maps() -> Vec<(String, Borders)> {
        let project = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../envmaps");
        let shared = std::env::var_os("SKYCUBE_SHARED_MAPS")
            .map_or_else(|| Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/envmaps"), PathBuf::from);
        let mut paths: Vec<PathBuf> = ["", "layouts", "openexr"]
            .iter()
            .flat_map(|inner| [project.join(inner), shared.join(inner)])
            .filter_map(|folder| std::fs::read_dir(folder).ok())
            .flat_map(|entries| entries.flatten().map(|entry| entry.path()))
            .collect();
        paths.sort();
        let borders = |path: PathBuf| {
            let map = load(&Skybox::open(&path).ok()?, Preset::Opengl.lookup()).ok()?;
            Some((path.file_name()?.to_string_lossy().into_owned(), read_borders(&map).ok()?))
        };
        paths.into_iter().filter_map(borders).collect()
    }

    fn problem(borders: &Borders, lookup: &Lookup) -> Problem {
        Problem { borders: EdgeBorders::new(lookup), costs: PairCosts::new(borders) }
    }

    #[test]
    #[ignore = "prints the margins of all maps at hand"]
    fn margins() {
        let lookup = Preset::Opengl.lookup();
        let maps = maps();
        println!(
            "map                    mean fit  worst face: fit  step  |  turned face: errors  improvement  |  outlier: fit  step  pattern  agreement"
        );
        for (index, (name, borders)) in maps.iter().enumerate() {
            let own = problem(borders, &lookup);
            let right = cheapest(&own, &Arrangement::given(Face::ALL), Freedom::ANY_ORDER);
            let judged = Face::ALL.map(|face| outlier::judge(&own, borders, &right, face));
            let fit = judged.iter().map(|judged| judged.fit).fold(0.0, f64::max);
            let step = judged.iter().map(|judged| judged.step).fold(0.0, f64::max);
            let turned = Face::ALL.into_iter().flat_map(|face| {
                (1..8).map(move |turn| right.with_orientation(face, (right.orientations[face.index()] + turn) % 8))
            });
            let compared: Vec<(f64, f64)> = turned
                .map(|turned| own.compare(&right, &turned))
                .filter(|comparison| comparison.is_decisive())
                .map(|comparison| (comparison.standard_errors(), comparison.improvement()))
                .collect();
            let errors = compared.iter().map(|one| one.0).fold(f64::INFINITY, f64::min);
            let improvement = compared.iter().map(|one| one.1).fold(f64::INFINITY, f64::min);
            print!("{name:22} {:8.2} {fit:17.2} {step:5.1}  | {errors:20.1} {improvement:12.2}", own.mean_fit(&right));
            let other = &maps[(index + 1) % maps.len()].1;
            let strange = Face::ALL.map(|face| {
                let image = right.images[face.index()];
                let mut mixed = borders.clone();
                mixed[image.index()] = other[image.index()].clone();
                outlier::judge(&problem(&mixed, &lookup), &mixed, &right, face)
            });
            let least = |of: &dyn Fn(&outlier::Judged) -> f64| strange.iter().map(of).fold(f64::INFINITY, f64::min);
            let agreement = strange.iter().map(|judged| judged.agreement).fold(f64::NEG_INFINITY, f64::max);
            println!(
                "  | {:13.2} {:5.1} {:8.1} {agreement:10.1}",
                least(&|judged| judged.fit),
                least(&|judged| judged.step),
                least(&|judged| judged.pattern)
            );
        }
    }
}
