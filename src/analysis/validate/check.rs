//! The check of one map, from its pictures to the verdict.

use super::borders::border::{Borders, read_borders};
use super::borders::edge::EdgeBorders;
use super::borders::pair_cost::PairCosts;
use super::copies::Copies;
use super::findings::{Check, FaceFix, Fix, ImageFacts};
use super::notes;
use super::options::{CheckOptions, Names};
use super::outlier::{self, Outlier};
use super::seam::{self, Seam};
use super::search::arrangement::{Arrangement, Problem};
use super::search::convention::{self, Hints, mirrored_faces};
use super::sky::Sky;
use super::solve::{Search, Solution, Unsettled};
use super::thresholds::seam::ROUGH;
use super::thresholds::verdict::{ROUGH_SEAMS, TELLING_FACES, UNDECIDABLE_SEAMS, UNRELATED};
use super::verdict::Verdict;
use crate::envmap::source::Skybox;
use crate::envmap::{CubeFilter, CubeMap, Face, LazyImage, Lookup, Preset, VOrigin};
use crate::error::Result;
use crate::parallel;
use crate::picture::Picture;

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
    let copies = Copies::of(map, &borders)?;
    let (images_of, problem_of) = (&borders, &problem);
    let search = Search {
        map,
        copies: &copies,
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
    let fix = fix_of(&solution, &given, lookup.v_origin(), seams(&found));
    let mut check = Check {
        lookup_name: options.lookup_name.clone(),
        lookup,
        images,
        verdict: Verdict::Undecidable,
        seams: seams(&given),
        fix,
        outliers,
        mirrored: mirrored_faces(&lookup),
        notes: Vec::new(),
    };
    check.verdict = verdict(&problem, &borders, &solution, &check, &given);
    let sky = sky.image(&check.fix.lookup(&lookup));
    check.notes = notes::collect(&check, &borders, options, sky, &solution.doubtful);
    Ok(check)
}

fn fix_of(solution: &Solution, given: &Arrangement, v_origin: VOrigin, seams_after: Vec<Seam>) -> Fix {
    let found = &solution.arrangement;
    let faces = Face::ALL.map(|face| FaceFix {
        face,
        image: found.images[face.index()],
        orientation: found.orientation(face),
        image_operation: found.orientation(face).image_operation(v_origin),
        decided: solution.is_decided(face),
    });
    let changed = |face: &Face| {
        let face = face.index();
        (found.images[face], found.orientations[face]) != (given.images[face], given.orientations[face])
    };
    Fix {
        faces,
        story: solution.story.clone(),
        also: solution.also.clone(),
        changes: Face::ALL.iter().filter(|face| changed(face)).count(),
        convention: solution.story.order,
        margin: solution.margin,
        seams_after,
        equivalents: solution.equivalents,
    }
}

/// Broken if the fix changes anything, a face does not belong, seams gape or no graphics library takes these sizes; else
/// the map fits if the pixels of at least half of the faces tell most orientations from the one found, what is found looks
/// like a map at all, and no face gapes. A face that stands out is a fault, however much the others tell.
fn verdict(problem: &Problem, borders: &Borders, solution: &Solution, check: &Check, given: &Arrangement) -> Verdict {
    let found = &solution.arrangement;
    let torn = solution.unsettled == Some(Unsettled::Torn);
    if found != given || solution.outlier.is_some() || torn || !check.has_equal_squares() {
        return Verdict::Broken;
    }
    let related = problem.mean_fit(found) < UNRELATED;
    let stands_out = |&face: &Face| outlier::stands_out(problem, borders, found, face);
    let gapes = |&face: &Face| outlier::gapes(problem, borders, found, face);
    let undecidable = check.seams.iter().filter(|seam| seam.verdict == Verdict::Undecidable).count();
    // What neither continues nor tells any orientation for certain may be anything.
    let rough = check.seams.iter().filter(|seam| seam.score > ROUGH).count();
    let is_vague = rough >= ROUGH_SEAMS && !check.fix.faces.iter().any(|face| face.decided);
    let tells = related
        && !is_vague
        && solution.telling_faces() >= TELLING_FACES
        && undecidable < UNDECIDABLE_SEAMS
        && !Face::ALL.iter().any(gapes);
    match tells && solution.unsettled.is_none() {
        _ if Face::ALL.iter().any(stands_out) => Verdict::Broken,
        true => Verdict::Fits,
        false => Verdict::Undecidable,
    }
}
