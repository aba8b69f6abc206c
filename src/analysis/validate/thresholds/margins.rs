//! The margins of the thresholds on all maps at hand: how far right maps reach, and what maps with a fault have.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use super::super::borders::border::{Borders, mean_step, read_borders};
use super::super::borders::edge::{Edge, EdgeBorders, Side};
use super::super::borders::pair_cost::PairCosts;
use super::super::copies::Copies;
use super::super::outlier::{self, Judged};
use super::super::seam::measure;
use super::super::search::arrangement::{Arrangement, Comparison, Problem};
use super::super::search::branch_and_bound::{Freedom, cheapest};
use super::story::{
    ANNOUNCED, DIAGONAL, EXCHANGE, EXCHANGE_OF_FREE_NAMES, EXCHANGE_OF_OPPOSITES, FLIP, LIKE_AN_EXCHANGE, MIRRORED,
    NUMBERED, OTHER_TABLE, SIDEWAYS, TURN,
};
use super::{copies, evidence, frame, outlier as outliers, seam, verdict};
use crate::envmap::source::Skybox;
use crate::envmap::{CubeMap, Face, Lookup, Preset};
use crate::validate::load;

/// A map, and the arrangement in which it is known to be right.
struct Subject {
    name: String,
    map: CubeMap,
    borders: Borders,
    problem: Problem,
    right: Arrangement,
}

/// Every map at hand.
fn subjects() -> Vec<Subject> {
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
    let subject = |path: PathBuf| {
        let map = load(&Skybox::open(&path).ok()?, Preset::Opengl.lookup()).ok()?;
        let borders = read_borders(&map).ok()?;
        let problem = problem(&borders, map.lookup());
        let name = path.file_name()?.to_string_lossy().into_owned();
        Some(Subject { right: known(&name), name, map, borders, problem })
    };
    paths.into_iter().filter_map(subject).collect()
}

/// How a map must be arranged to be right, as those say who made it.
fn known(name: &str) -> Arrangement {
    use Face::{NegX, NegY, NegZ, PosX, PosY, PosZ};
    match name {
        "city-upside-down" => Arrangement { images: Face::ALL, orientations: [2; 6] },
        "clouds-dusk" | "miramar-quake" => Arrangement::given([PosZ, NegZ, PosY, NegY, PosX, NegX]),
        name if name.ends_with(".exr") => Arrangement::given([PosX, NegX, PosY, NegY, NegZ, PosZ]),
        _ => Arrangement::given(Face::ALL),
    }
}

fn problem(borders: &Borders, lookup: &Lookup) -> Problem {
    Problem { borders: EdgeBorders::new(lookup), costs: PairCosts::new(borders) }
}

/// Values on either side of each threshold, and which maps have them.
#[derive(Default)]
struct Table(BTreeMap<String, [Vec<(f64, String)>; 2]>);

impl Table {
    fn right(&mut self, threshold: &str, value: f64, name: &str) {
        self.0.entry(threshold.to_owned()).or_default()[0].push((value, name.to_owned()));
    }

    fn faulty(&mut self, threshold: &str, value: f64, name: &str) {
        self.0.entry(threshold.to_owned()).or_default()[1].push((value, name.to_owned()));
    }

    /// The line of a threshold that a fault exceeds (or, if `below`, falls short of): the nearest values on both sides.
    fn print(&self, name: &str, threshold: f64, below: bool) {
        let [right, faulty] = &self.0.get(name).cloned().unwrap_or_default();
        let by_value = |a: &&(f64, String), b: &&(f64, String)| a.0.total_cmp(&b.0);
        let least = |values: &[(f64, String)]| values.iter().min_by(by_value).cloned();
        let most = |values: &[(f64, String)]| values.iter().max_by(by_value).cloned();
        let (right, faulty) = if below { (least(right), most(faulty)) } else { (most(right), least(faulty)) };
        let shown = |value: Option<(f64, String)>| {
            value.map_or_else(|| "-".to_owned(), |(value, name)| format!("{value:.2} ({name})"))
        };
        println!("{name:24} {threshold:8.2}  {:38}  {}", shown(right), shown(faulty));
    }
}

/// Changed by a turned or flipped face.
fn turned(right: &Arrangement) -> impl Iterator<Item = Arrangement> + '_ {
    Face::ALL.into_iter().flat_map(move |face| {
        (1..8).map(move |turn| right.with_orientation(face, (right.orientations[face.index()] + turn) % 8))
    })
}

/// What is compared where one arrangement is right and the other is not.
fn compared(table: &mut Table, subject: &Subject) {
    let Subject { name, problem, right, .. } = subject;
    let mut add = |is_right: bool, comparison: &Comparison| {
        let mut add = |threshold: &str, value: f64| match is_right {
            true => table.right(threshold, value, name),
            false => table.faulty(threshold, value, name),
        };
        add("STANDARD_ERRORS", comparison.standard_errors());
        add("IMPROVEMENT", comparison.improvement());
        add("TOGETHER", comparison.likelihood());
        add("NOTICEABLE", comparison.likelihood());
        add("NOTICEABLE_IMPROVEMENT", comparison.improvement());
        if comparison.improvement() >= evidence::NEARLY_ALL {
            add("FEW_STANDARD_ERRORS", comparison.standard_errors());
        }
        if comparison.standard_errors() >= evidence::FEW_STANDARD_ERRORS {
            add("NEARLY_ALL", comparison.improvement());
        }
        if is_right || comparison.is_decisive_by_patterns() {
            add("SOME_AGREEMENT", comparison.agreement);
            add("SOME_STANDARD_ERRORS", comparison.standard_errors());
            add("SOME_IMPROVEMENT", comparison.improvement());
        }
        let (gain, count, loss) = comparison.strong();
        add("STRONG_GAIN", gain);
        add("STRONG_COUNT", count as f64);
        add("STRONG_LOSS", loss);
    };
    // What the search prefers to the right one, if it does.
    let found = cheapest(problem, &Arrangement::given(Face::ALL), Freedom::ANY_ORDER);
    for changed in turned(right).chain([found]) {
        // The right one may lose to another only by chance; a decided one must win clearly.
        let (lost, won) = (problem.compare(&changed, right), problem.compare(right, &changed));
        if lost.standard_errors() > 0.0 {
            add(true, &lost);
        } else if won.is_decisive() {
            add(false, &won);
        }
    }
}

/// Faces as they are, and faces of another map, of one colour, in grey.
fn judged(table: &mut Table, subject: &Subject, other: &Subject) {
    let Subject { name, borders, problem: own, right, map, .. } = subject;
    let replaced = |image: Face, change: &dyn Fn(&mut Borders)| {
        let mut changed = borders.clone();
        change(&mut changed);
        let (problem, face) = (problem(&changed, map.lookup()), right.face_of(image).unwrap_or(image));
        let seams = (0..12).filter(|&edge| Edge::ALL[edge].touches(face));
        let least = seams.map(|edge| problem.fit(right, edge)).fold(f64::INFINITY, f64::min);
        (outlier::judge(&problem, &changed, right, face), least)
    };
    let ratio = |judged: &Judged| judged.step / judged.others_step.max(0.1);
    for image in Face::ALL.into_iter().filter(|&image| !borders[image.index()].is_flat()) {
        let face = right.face_of(image).unwrap_or(image);
        let here = outlier::judge(own, borders, right, face);
        let (foreign, least) = replaced(image, &|all| all[image.index()] = other.borders[image.index()].clone());
        let colour = |all: &mut Borders, grey: bool| {
            let all = &mut all[image.index()];
            let mean = {
                let row = all.row(Side::Left, 0);
                [0, 1, 2].map(|channel| row.iter().map(|texel| texel[channel]).sum::<f32>() / row.len() as f32)
            };
            let rows = all
                .sides
                .iter_mut()
                .flat_map(|side| side.outer.iter_mut().chain(&mut side.deep).chain(side.blocks.iter_mut().flatten()));
            for texel in rows.flatten() {
                *texel = if grey { [texel.iter().sum::<f32>() / 3.0; 3] } else { mean };
            }
        };
        let (flat, _) = replaced(image, &|all| colour(all, false));
        let (grey, _) = replaced(image, &|all| colour(all, true));
        for threshold in ["OUTLIER", "OUTLIER_GLARING", "OUTLIER_FLAT", "OUTLIER_COPY"] {
            table.right(threshold, here.fit, name);
        }
        table.right("OUTLIER_GLARING", grey.fit, &format!("{name}, grey"));
        table.faulty("UNDECIDED", least, name);
        table.faulty("OUTLIER", foreign.fit, name);
        table.faulty("OUTLIER_GLARING", foreign.fit, name);
        table.faulty("OUTLIER_FLAT", flat.fit, name);
        table.right("OUTLIER_STEP", here.step, name);
        table.faulty("OUTLIER_STEP", foreign.step, name);
        table.right("STEP_RATIO", ratio(&here), name);
        table.faulty("STEP_RATIO", ratio(&foreign), name);
        table.right("VISIBLE", here.score, name);
        table.faulty("VISIBLE", foreign.score, name);
        table.right("ANOTHER_PATTERN", here.pattern, name);
        table.faulty("ANOTHER_PATTERN", foreign.pattern, name);
        table.right("KINDRED", grey.agreement, &format!("{name}, grey"));
        table.faulty("KINDRED", foreign.agreement, name);
        table.right("FAMILIAR", here.others_fit, name);
    }
}

/// Images that show the same, and images that do not.
fn copied(table: &mut Table, subject: &Subject) {
    let Subject { name, map, borders, right, problem: own } = subject;
    for face in Face::ALL {
        let opposite = (-face.signed_axis()).face();
        let [image, original] = [face, opposite].map(|face| right.images[face.index()].index());
        let mut changed = borders.clone();
        changed[image] = borders[original].clone();
        let with_copy = problem(&changed, map.lookup());
        let (gaping, closing) = outlier::copy_steps(&with_copy, &changed, right, face, opposite);
        if !borders[original].is_flat() {
            table.faulty("COPY_STEP", gaping, name);
            if gaping >= outliers::COPY_STEP {
                table.faulty("COPY_RATIO", gaping / closing.max(0.1), name);
                table.faulty("OUTLIER_COPY", outlier::judge(&with_copy, &changed, right, face).fit, name);
            }
        }
        let (gaping, closing) = outlier::copy_steps(own, borders, right, face, opposite);
        table.right("COPY_STEP", gaping, name);
        table.right("COPY_RATIO", gaping / closing.max(0.1), name);
    }
    let details = Copies::details(map, borders).expect("the map was read");
    for (one, other) in (0..6).flat_map(|one| (one + 1..6).map(move |other| (one, other))) {
        table.right("SAME_DETAIL", details[one].correlation(&details[other]), name);
    }
    // Noise of 8 codes on every texel is 2 on a cell of 16 samples.
    for detail in &details {
        if detail.strength() >= copies::LEAST_DETAIL {
            table.faulty("SAME_DETAIL", detail.correlation(&detail.with_noise(2.0)), name);
        }
        table.right("LEAST_DETAIL", detail.strength(), name);
    }
}

/// Seams of the right arrangement and of those with a turned face; verdicts.
fn seams(table: &mut Table, subject: &Subject) {
    let Subject { name, borders, problem, right, .. } = subject;
    let fits = |arrangement: &Arrangement| (0..12).map(|edge| problem.fit(arrangement, edge)).collect::<Vec<f64>>();
    let open = fits(right).iter().filter(|&&fit| fit > seam::UNDECIDED).count();
    table.right("UNDECIDABLE_SEAMS", open as f64, name);
    table.right("UNRELATED", problem.mean_fit(right), name);
    if !turned(right).any(|changed| problem.compare(right, &changed).is_decisive()) {
        let rough = (0..12).filter(|&edge| measure(problem, borders, right, edge).score > seam::ROUGH);
        table.right("ROUGH_SEAMS", rough.count() as f64, name);
    }
    for edge in 0..12 {
        table.right("UNDECIDED", problem.fit(right, edge), name);
        table.right("ROUGH", measure(problem, borders, right, edge).score, name);
    }
    for axis in 0..3 {
        let [one, other] = [2 * axis, 2 * axis + 1];
        let mut exchanged = *right;
        exchanged.images.swap(one, other);
        exchanged.orientations.swap(one, other);
        let differ: Vec<usize> =
            (0..12).filter(|&edge| problem.ends(right, edge) != problem.ends(&exchanged, edge)).collect();
        let step = |arrangement: &Arrangement| {
            let steps = differ.iter().map(|&edge| measure(problem, borders, arrangement, edge).step);
            steps.sum::<f64>() / differ.len().max(1) as f64
        };
        if problem.compare(right, &exchanged).is_decisive() {
            table.right("TORN_STEP", step(right), name);
            table.faulty("TORN_STEP", step(&exchanged), name);
            table.faulty("REPAIRED", step(right) / step(&exchanged), name);
            table.right("REPAIRED", step(&exchanged) / step(right), name);
        }
    }
}

/// Frames: how abruptly the outermost row steps, beside the next one.
fn frames(table: &mut Table, subject: &Subject) {
    let Subject { name, borders, .. } = subject;
    for image in borders.iter().filter(|image| !image.framed) {
        // How abruptly the outermost rows step after a change, at the side where they do so least.
        let abruptness = |(factor, codes): (f64, f64), change: fn(&mut [f32; 3])| {
            let steps = image.sides.iter().map(|side| {
                let [first, second, third, _] = &side.outer;
                let mut first = first.clone();
                first.iter_mut().for_each(change);
                mean_step(&first, second) / (mean_step(second, third) + codes / factor)
            });
            steps.fold(f64::INFINITY, f64::min)
        };
        table.right("PLAIN", abruptness(frame::PLAIN, |_| ()), name);
        table.faulty("PLAIN", abruptness(frame::PLAIN, |texel| *texel = [0.0; 3]), name);
        table.right("DARKER", abruptness(frame::DARKER, |_| ()), name);
        table.faulty("DARKER", abruptness(frame::DARKER, |texel| *texel = texel.map(|code| 0.25 * code)), name);
    }
}

#[test]
#[ignore = "prints the margins of all maps at hand"]
fn margins() {
    let subjects = subjects();
    let mut table = Table::default();
    for (index, subject) in subjects.iter().enumerate() {
        compared(&mut table, subject);
        judged(&mut table, subject, &subjects[(index + 1) % subjects.len()]);
        copied(&mut table, subject);
        seams(&mut table, subject);
        frames(&mut table, subject);
        // Six pictures that have nothing to do with each other.
        let mut unrelated = subject.borders.clone();
        for image in 0..6 {
            unrelated[image] = subjects[(index + image) % subjects.len()].borders[image].clone();
        }
        let mixed = problem(&unrelated, subject.map.lookup());
        let best = cheapest(&mixed, &Arrangement::given(Face::ALL), Freedom::ANY_ORDER);
        table.faulty("UNRELATED", mixed.mean_fit(&best), &subject.name);
        let open = (0..12).filter(|&edge| mixed.fit(&best, edge) > seam::UNDECIDED).count();
        table.faulty("UNDECIDABLE_SEAMS", open as f64, &subject.name);
        let others_fit = |face| outlier::judge(&mixed, &unrelated, &best, face).others_fit;
        table.faulty("FAMILIAR", Face::ALL.map(others_fit).into_iter().fold(f64::INFINITY, f64::min), &subject.name);
    }
    println!("{} maps", subjects.len());
    println!("{:24} {:>8}  {:38}  faulty ones have", "threshold", "value", "right maps reach");
    for (name, value) in [
        ("STANDARD_ERRORS", evidence::STANDARD_ERRORS),
        ("IMPROVEMENT", evidence::IMPROVEMENT),
        ("FEW_STANDARD_ERRORS", evidence::FEW_STANDARD_ERRORS),
        ("NEARLY_ALL", evidence::NEARLY_ALL),
        ("STRONG_GAIN", evidence::STRONG_GAIN),
        ("STRONG_COUNT", evidence::STRONG_COUNT as f64),
        ("TOGETHER", evidence::TOGETHER),
        ("SOME_AGREEMENT", evidence::SOME_AGREEMENT),
        ("SOME_STANDARD_ERRORS", evidence::SOME_STANDARD_ERRORS),
        ("SOME_IMPROVEMENT", evidence::SOME_IMPROVEMENT),
        ("NOTICEABLE", evidence::NOTICEABLE),
        ("NOTICEABLE_IMPROVEMENT", evidence::NOTICEABLE_IMPROVEMENT),
        ("OUTLIER", outliers::OUTLIER),
        ("OUTLIER_GLARING", outliers::OUTLIER_GLARING),
        ("OUTLIER_FLAT", outliers::OUTLIER_FLAT),
        ("OUTLIER_COPY", outliers::OUTLIER_COPY),
        ("OUTLIER_STEP", outliers::OUTLIER_STEP),
        ("STEP_RATIO", outliers::STEP_RATIO),
        ("VISIBLE", outliers::VISIBLE),
        ("ANOTHER_PATTERN", outliers::ANOTHER_PATTERN),
        ("FAMILIAR", outliers::FAMILIAR),
        ("COPY_STEP", outliers::COPY_STEP),
        ("COPY_RATIO", outliers::COPY_RATIO),
        ("SAME_DETAIL", copies::SAME_DETAIL),
        ("UNDECIDED", seam::UNDECIDED),
        ("ROUGH", seam::ROUGH),
        ("UNRELATED", verdict::UNRELATED),
        ("UNDECIDABLE_SEAMS", verdict::UNDECIDABLE_SEAMS as f64),
        ("ROUGH_SEAMS", verdict::ROUGH_SEAMS as f64),
        ("TORN_STEP", verdict::TORN_STEP),
        ("PLAIN", frame::PLAIN.0),
        ("DARKER", frame::DARKER.0),
    ] {
        table.print(name, value, false);
    }
    println!("lower where there is a fault");
    table.print("STRONG_LOSS", evidence::STRONG_LOSS, true);
    table.print("KINDRED", outliers::KINDRED, true);
    table.print("REPAIRED", verdict::REPAIRED, true);
    table.print("LEAST_DETAIL", copies::LEAST_DETAIL, true);
}

#[test]
fn the_costs_keep_their_order() {
    // Files in each other's place before files that were edited, turned ones before flipped ones, the usual before the rare.
    let rising = [
        0,
        EXCHANGE_OF_FREE_NAMES,
        NUMBERED,
        ANNOUNCED,
        OTHER_TABLE,
        EXCHANGE_OF_OPPOSITES,
        SIDEWAYS,
        EXCHANGE,
        TURN,
        MIRRORED,
        FLIP,
        DIAGONAL,
    ];
    assert!(rising.is_sorted_by(|a, b| a < b), "{rising:?}");
    // Where an order and an exchange explain a map equally well, the pictures decide; all six flipped is one order.
    assert_eq!(LIKE_AN_EXCHANGE, EXCHANGE_OF_OPPOSITES);
    let cheaper = [
        (LIKE_AN_EXCHANGE, FLIP),
        (MIRRORED, 2 * FLIP),
        (MIRRORED, 2 * EXCHANGE_OF_OPPOSITES),
        // Free names never cost as much as a turn, however many change.
        (5 * EXCHANGE_OF_FREE_NAMES, TURN),
    ];
    assert!(cheaper.iter().all(|(one, other)| one < other), "{cheaper:?}");
}
