//! The check of one map, from its pictures to the verdict.

use super::borders::border::{Borders, read_borders};
use super::borders::edge::EdgeBorders;
use super::borders::pair_cost::PairCosts;
use super::notes::{self, Note};
use super::outlier::{self, Outlier};
use super::seam::{self, Seam};
use super::search::arrangement::{Arrangement, Problem};
use super::search::convention::mirrored_faces;
use super::search::convention::{self, Convention, Hints};
use super::sky::Sky;
use super::solve::{Search, Solution, Unsettled, corrected};
use super::story::Story;
use super::thresholds::verdict::{TELLING_FACES, UNDECIDABLE_SEAMS, UNRELATED};
use crate::envmap::source::Skybox;
use crate::envmap::{CubeFilter, CubeMap, Face, LazyImage, Lookup, Orientation, Preset, SignedAxis};
use crate::error::Result;
use crate::parallel;
use crate::picture::{Format, Picture};

/// What a map, or one seam of it, is found to be.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Verdict {
    /// No other orientation is decisively better, and the pixels would tell.
    Fits,
    /// Another orientation fits decisively better, or a face does not belong.
    Broken,
    /// The pixels cannot tell.
    Undecidable,
}

impl Verdict {
    pub fn name(self) -> &'static str {
        match self {
            Self::Fits => "fits",
            Self::Broken => "broken",
            Self::Undecidable => "undecidable",
        }
    }
}

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
    pub names: Names,
    /// What the report calls the lookup.
    pub lookup_name: String,
}

/// An image as the report lists it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ImageFacts {
    /// The name of the image.
    pub face: Face,
    pub file: String,
    pub width: usize,
    pub height: usize,
    pub format: Format,
    pub alpha: bool,
}

impl ImageFacts {
    /// The six images of a skybox.
    pub fn of_skybox(skybox: &Skybox) -> Vec<Self> {
        let facts = |face: Face| {
            let image = skybox.image(face);
            let header = image.header();
            Self {
                face,
                file: image.name().to_owned(),
                width: header.width,
                height: header.height,
                format: header.format,
                alpha: header.alpha,
            }
        };
        Face::ALL.map(facts).to_vec()
    }
}

/// The report on one map.
#[derive(Debug, Clone)]
pub struct Check {
    pub images: Vec<ImageFacts>,
    pub lookup: Lookup,
    pub lookup_name: String,
    pub verdict: Verdict,
    /// The twelve seams as they are.
    pub seams: Vec<Seam>,
    pub fix: Fix,
    /// Faces whose image belongs to no place in this map.
    pub outliers: Vec<Outlier>,
    /// The faces that the given lookup shows mirrored in a right-handed world.
    pub mirrored: Vec<Face>,
    pub notes: Vec<Note>,
}

/// What to change.
#[derive(Debug, Clone, PartialEq)]
pub struct Fix {
    pub faces: [FaceFix; 6],
    /// Faces that change.
    pub changes: usize,
    /// What happened to the files.
    pub story: Story,
    /// Other stories that are as short and close the seams as well.
    pub also: Vec<Story>,
    /// The standard errors by which the next essentially different orientation is worse; 0 if none is.
    pub margin: f64,
    pub seams_after: Vec<Seam>,
    /// Fixes that are equally good, this one among them.
    pub equivalents: usize,
}

/// What to change at one face.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FaceFix {
    pub face: Face,
    /// The image that the face shall read.
    pub image: Face,
    /// (u', v') as functions of the (u, v) that the given lookup computes.
    pub orientation: Orientation,
    /// True if the pixels decide this orientation: every other one is decisively worse.
    pub decided: bool,
}

impl FaceFix {
    /// True if the face keeps its image and its orientation.
    pub fn is_unchanged(&self, given: &Lookup) -> bool {
        self.image == given.row(self.face).image && self.orientation == Orientation::IDENTITY
    }
}

impl Check {
    /// What no change repairs: faces that do not belong or have the wrong size.
    pub fn unrepaired(&self) -> Vec<&Note> {
        let unrepaired =
            |note: &&Note| matches!(note, Note::Outlier { .. } | Note::NotSquare { .. } | Note::Sizes { .. });
        self.notes.iter().filter(unrepaired).collect()
    }

    /// True if all six images are square and of one size: no graphics library takes others as a cube map.
    pub fn has_equal_squares(&self) -> bool {
        let size = self.images[0].width;
        self.images.iter().all(|image| (image.width, image.height) == (size, size))
    }
}

impl Fix {
    /// The known order that these files follow, if the story names one.
    pub fn convention(&self) -> Option<Convention> {
        self.story.order
    }

    /// The corrected lookup.
    pub fn lookup(&self, given: &Lookup) -> Lookup {
        corrected(given, &self.arrangement())
    }

    fn arrangement(&self) -> Arrangement {
        let index =
            |orientation: Orientation| Orientation::ALL.iter().position(|&known| known == orientation).unwrap_or(0);
        Arrangement {
            images: self.faces.map(|face| face.image),
            orientations: self.faces.map(|face| index(face.orientation)),
        }
    }
}

/// Decodes all six images at once. The first one that cannot be decoded is the error.
pub fn load(skybox: &Skybox, lookup: Lookup) -> Result<CubeMap> {
    let decoded: Result<Vec<Picture>> = parallel::map(&skybox.images, |image| image.decode()).into_iter().collect();
    let images: Vec<LazyImage> = decoded?.into_iter().map(LazyImage::ready).collect();
    Ok(CubeMap::new(images.try_into().expect("there are six images"), lookup, CubeFilter::Nearest))
}

/// Checks a map under its lookup.
pub fn check(map: &CubeMap, images: Vec<ImageFacts>, options: &CheckOptions) -> Result<Check> {
    let lookup = *map.lookup();
    let borders = read_borders(map)?;
    let problem = Problem { borders: EdgeBorders::new(&lookup), costs: PairCosts::new(&borders) };
    let names = options.names;
    let world_up = options.world_up.unwrap_or_else(|| Preset::usual_up_of(&options.lookup_name));
    let hints = Hints::of_files(images.iter().map(|image| image.file.as_str()), names == Names::AnyOrder);
    let orders = convention::orders(&lookup, world_up, hints);
    let sky = Sky::of(map, &borders)?;
    let (images_of, problem_of) = (&borders, &problem);
    let search = Search {
        map,
        images: images_of,
        problem: problem_of,
        lookup: &lookup,
        names,
        world_up,
        orders: &orders,
        sky: &sky,
    };
    let solution = search.solve()?;

    let given = Arrangement::given(Face::ALL.map(|face| lookup.row(face).image));
    let found = solution.arrangement;
    let outliers: Vec<Outlier> = solution.outlier.into_iter().collect();
    let outlying: Vec<Face> = outliers.iter().map(|outlier| outlier.face).collect();
    let seams = |arrangement: &Arrangement| seam::seams(&problem, &borders, arrangement, &found, &outlying);
    let fix = fix_of(&solution, &given, seams(&found));
    let mut check = Check {
        images,
        lookup,
        lookup_name: options.lookup_name.clone(),
        verdict: Verdict::Undecidable,
        seams: seams(&given),
        fix,
        outliers,
        mirrored: mirrored_faces(&lookup),
        notes: Vec::new(),
    };
    check.verdict = verdict(&problem, &borders, &solution, &check, &given);
    let sky = sky.image(&check.fix.lookup(&lookup));
    check.notes = notes::collect(&check, &borders, options, sky);
    Ok(check)
}

fn fix_of(solution: &Solution, given: &Arrangement, seams_after: Vec<Seam>) -> Fix {
    let found = &solution.arrangement;
    let faces = Face::ALL.map(|face| FaceFix {
        face,
        image: found.images[face.index()],
        orientation: found.orientation(face),
        decided: solution.is_decided(face),
    });
    let changed = |face: &Face| {
        let face = face.index();
        (found.images[face], found.orientations[face]) != (given.images[face], given.orientations[face])
    };
    Fix {
        faces,
        changes: Face::ALL.iter().filter(|face| changed(face)).count(),
        story: solution.story.clone(),
        also: solution.also.clone(),
        margin: solution.margin,
        seams_after,
        equivalents: solution.equivalents,
    }
}

/// Broken if the fix changes anything, a face does not belong, seams gape or no graphics library takes these sizes; else
/// the map fits if the pixels of at least half of the faces tell most orientations from the one found, what is found looks
/// like a map at all, and no face gapes.
fn verdict(problem: &Problem, borders: &Borders, solution: &Solution, check: &Check, given: &Arrangement) -> Verdict {
    let found = &solution.arrangement;
    let torn = solution.unsettled == Some(Unsettled::Torn);
    if found != given || solution.outlier.is_some() || torn || !check.has_equal_squares() {
        return Verdict::Broken;
    }
    let related = problem.mean_fit(found) < UNRELATED;
    let gapes = |&face: &Face| outlier::gapes(problem, borders, found, face);
    let undecidable = check.seams.iter().filter(|seam| seam.verdict == Verdict::Undecidable).count();
    let tells = related
        && solution.telling_faces() >= TELLING_FACES
        && undecidable < UNDECIDABLE_SEAMS
        && !Face::ALL.iter().any(gapes);
    if tells && solution.unsettled.is_none() { Verdict::Fits } else { Verdict::Undecidable }
}
