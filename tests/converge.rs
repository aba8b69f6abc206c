//! The instrument against known laws of error, and the command as its user runs it.

mod common;

use std::path::Path;
use std::process::Output;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Duration;

use common::{json_report, skycube, text};
use serde_json::Value;
use skycube::converge::{
    Comparison, Configuration, Convergence, Curve, Protocol, Schedule, Step, Unwatched, Variation, Watch, Work,
    converge, variants,
};
use skycube::render::Progress;
use skycube::report::{ConvergeReport, ConvergedScene, Measure, converge_csv, draw_convergence};
use skycube::scene::Scene;

/// A rough ball on a floor under a lamp, small.
const LAMP: &str = r#"
camera = { position = [0, -6, 2], target = [0, 0, 0.7], field_of_view = 40, size = [40, 28] }
integrator = { kind = "path", depth = 4 }
environment = { kind = "gradient", zenith = [0.3, 0.4, 0.8], horizon = 0.6, nadir = 0.2 }
materials.floor = { kind = "lambert", colour = 0.6 }
materials.metal = { kind = "metal", reflectance = 0.8, roughness = 0.4 }
materials.lamp = { kind = "light", radiance = 12 }
shapes = [
    { kind = "rectangle", normal = [0, 0, 1], size = [20, 20], material = "floor" },
    { kind = "sphere", centre = [0, 0, 1], material = "metal" },
    { kind = "sphere", centre = [2, -1, 4], radius = 0.6, material = "lamp" },
]
"#;

/// A ball on a chequered floor, for the integrators of the lessons.
const CHECKERS: &str = r#"
camera = { position = [0, -6, 2], target = [0, 0, 0.7], field_of_view = 40, size = [40, 28] }
integrator = { kind = "KIND", depth = 4 }
environment = { kind = "constant", radiance = 0.5 }
materials.floor = { kind = "phong", diffuse = { checker = [0.8, 0.2], repeat = [30, 30] } }
materials.ball = { kind = "phong", diffuse = 0.3, specular = 0.4 }
lights = [{ kind = "point", position = [3, -4, 6], intensity = 60 }]
shapes = [
    { kind = "rectangle", normal = [0, 0, 1], size = [20, 20], material = "floor" },
    { kind = "sphere", centre = [0, 0, 1], material = "ball" },
]
"#;

fn scene(text: &str) -> Scene {
    Scene::from_text(text, Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/Cargo.toml")))
        .unwrap_or_else(|error| panic!("{error}"))
}

fn protocol(steps: &[u32], reference_samples: u32) -> Protocol<'static> {
    Protocol { schedule: Schedule::Samples(steps.to_vec()), seeds: 2, reference_samples, cache: None }
}

fn measured(text: &str, variations: &[&str], protocol: &Protocol) -> Convergence {
    let mut scene = scene(text);
    let variations: Vec<Variation> = variations.iter().map(|text| text.parse().unwrap()).collect();
    let variants = variants(&Configuration::of_scene(&scene), &variations).unwrap();
    converge(&mut scene, &variants, protocol, &Unwatched).unwrap()
}

fn last(curve: &Curve) -> Step {
    *curve.steps.last().unwrap()
}

#[test]
fn independent_samples_have_a_slope_of_minus_a_half_and_sobol_points_a_steeper_one() {
    let convergence = measured(LAMP, &["sampler=independent,sobol"], &protocol(&[4, 16, 64], 4096));
    let [independent, sobol] = convergence.curves.as_slice() else { panic!("two curves") };
    let slope = |curve: &Curve| curve.fit.against_samples.unwrap();
    assert!((slope(independent) + 0.5).abs() < 0.03, "{:?}", independent.fit);
    assert!(slope(sobol) < -0.55, "{:?}", sobol.fit);
    assert!(last(sobol).errors.rmse < 0.8 * last(independent).errors.rmse);
    for curve in &convergence.curves {
        assert!(!last(curve).bias.is_significant(), "{:?}", last(curve));
    }
    // The error that the reference states is that of its samples: Sobol points are still better at 4096 than at 64.
    let floor = convergence.references[0].errors.rmse;
    assert!(floor > 0.0 && floor < last(sobol).errors.rmse / 8.0, "{floor}");
}

#[test]
fn the_stated_error_of_a_reference_is_that_of_its_samples() {
    // A rendering of 64 independent samples is off by its own error and that of the reference; a reference of 64 Sobol
    // samples states the error that renderings of 64 Sobol samples have against a much better one.
    let good = measured(LAMP, &["sampler=sobol"], &protocol(&[32, 64], 4096));
    let poor = measured(LAMP, &["sampler=sobol"], &protocol(&[32], 64));
    // Two halves of 32, their mean: the variance of one rendering of 32 samples, halved.
    let expected = good.curves[0].steps[0].errors.rmse / 2.0_f64.sqrt();
    let stated = poor.references[0].errors.rmse;
    assert!((stated / expected - 1.0).abs() < 0.1, "{stated} {expected}");
}

#[test]
fn a_depth_limit_leaves_a_bias_that_does_not_shrink() {
    let convergence = measured(LAMP, &["depth=1,4"], &protocol(&[16, 64], 1024));
    let [shallow, deep] = convergence.curves.as_slice() else { panic!("two curves") };
    let [early, late] = shallow.steps.as_slice() else { panic!("two steps") };
    assert!(early.bias.is_significant() && late.bias.is_significant());
    assert!((late.bias.root() / early.bias.root() - 1.0).abs() < 0.05, "{early:?} {late:?}");
    assert!(late.errors.rmse > 0.9 * early.errors.rmse, "nearly all of it is bias");
    assert!(shallow.fit.against_samples.unwrap() > -0.1, "{:?}", shallow.fit);
    assert!(!last(deep).bias.is_significant() && last(deep).bias.limit() < 0.2 * late.bias.root(), "{:?}", last(deep));
    // Rays cut by the limit: the deeper rendering traces more.
    assert!(last(deep).rays > last(shallow).rays);
}

#[test]
fn whitted_and_phong_scenes_have_an_antialiasing_error() {
    for kind in ["whitted", "phong"] {
        let text = CHECKERS.replace("KIND", kind);
        let convergence = measured(&text, &["sampler=independent,sobol"], &protocol(&[4, 16, 64], 1024));
        let [independent, sobol] = convergence.curves.as_slice() else { panic!("two curves") };
        let slope = |curve: &Curve| curve.fit.against_samples.unwrap();
        assert!((slope(independent) + 0.5).abs() < 0.1, "{kind} {:?}", independent.fit);
        // Edges through a pixel: between n^-1/2 and n^-1.
        assert!(slope(sobol) < -0.6, "{kind} {:?}", sobol.fit);
    }
}

#[test]
fn every_filter_has_a_reference_of_its_own_and_approximations_share_one() {
    let filters = measured(LAMP, &["pixel-filter=box,tent"], &protocol(&[1], 16));
    assert_eq!(filters.curves.iter().map(|curve| curve.reference).collect::<Vec<_>>(), [0, 1]);
    let depths = measured(LAMP, &["depth=1,2", "sampler=sobol,independent"], &protocol(&[1], 16));
    assert_eq!((depths.references.len(), depths.curves.len()), (1, 4));
    assert_eq!(depths.references[0].configuration.depth, 2);
    assert_eq!(depths.curves[1].label, "depth=1, sampler=independent");
}

#[test]
fn the_numbers_do_not_depend_on_threads() {
    let numbers = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let convergence = pool.install(|| measured(LAMP, &["strategy=bsdf,mis"], &protocol(&[1, 4], 16)));
        let steps = convergence.curves.iter().flat_map(|curve| &curve.steps);
        let figures: Vec<_> = steps.map(|step| (step.samples, step.rays, step.errors, step.bias)).collect();
        (convergence.references, figures)
    };
    assert_eq!(numbers(1), numbers(3));
}

#[test]
fn a_time_budget_ends_in_time() {
    let limit = Duration::from_millis(400);
    let protocol = Protocol { schedule: Schedule::Time(limit), ..protocol(&[], 8) };
    let curve = &measured(LAMP, &[], &protocol).curves[0];
    let samples: Vec<u32> = curve.steps.iter().map(|step| step.samples).collect();
    assert!(samples.starts_with(&[1, 4]) && samples.windows(2).all(|pair| pair[0] < pair[1]), "{samples:?}");
    assert!(last(curve).seconds < 1.0, "{}", last(curve).seconds);
}

/// Says stop after so many samples of pixels.
struct Impatient(AtomicU64);

impl Progress for &'static Impatient {
    fn advance(&self, samples: u64, _rays: u64) {
        self.0.fetch_sub(samples.min(self.0.load(Ordering::Relaxed)), Ordering::Relaxed);
    }

    fn cancelled(&self) -> bool {
        self.0.load(Ordering::Relaxed) == 0
    }
}

impl Watch for &'static Impatient {
    type Phase = Self;

    fn begin(&self, _what: &str, _work: Work) -> Self {
        self
    }

    fn cancelled(&self) -> bool {
        Progress::cancelled(self)
    }
}

#[test]
fn a_stopped_experiment_keeps_the_steps_that_were_finished() {
    let run = |samples: u64| {
        let mut scene = scene(LAMP);
        let variants = variants(&Configuration::of_scene(&scene), &["depth=1,2".parse().unwrap()]).unwrap();
        let watch: &'static Impatient = Box::leak(Box::new(Impatient(AtomicU64::new(samples * 40 * 28))));
        converge(&mut scene, &variants, &protocol(&[1, 4, 16], 8), &watch)
    };
    // The reference takes 8 samples, the first two steps 2 and 6 more.
    let convergence = run(20).unwrap();
    assert!(convergence.stopped);
    assert_eq!(convergence.curves.len(), 1);
    assert_eq!(convergence.curves[0].steps.iter().map(|step| step.samples).collect::<Vec<_>>(), [1, 4]);
    assert!(run(9).unwrap_err().to_string().contains("nothing was written"));
    assert!(run(4).unwrap_err().to_string().contains("nothing was written"));
    assert!(!run(1000).unwrap().stopped);
}

fn report() -> ConvergeReport {
    let mut convergence = measured(LAMP, &["strategy=bsdf,mis"], &protocol(&[1, 4], 16));
    for (curve, pace) in convergence.curves.iter_mut().zip([1.0, 2.0]) {
        for step in &mut curve.steps {
            step.seconds = pace * f64::from(step.samples);
        }
        curve.fit.against_seconds = curve.fit.against_samples;
    }
    for reference in &mut convergence.references {
        // It depends on the files of the project.
        reference.key = "0123456789abcdef".to_owned();
    }
    let lamp = ConvergedScene { name: "lamp.toml".to_owned(), width: 40, height: 28, seeds: 2, convergence };
    ConvergeReport { scenes: vec![lamp], stopped: false }
}

#[test]
fn reports_are_stable() {
    let report = report();
    insta::assert_snapshot!("text", report);
    insta::assert_snapshot!("csv", converge_csv(&report));
    json_report(&report.to_json());
    insta::assert_snapshot!("json", report.to_json());
}

#[test]
fn every_line_of_the_plot_is_drawn_in_its_colour() {
    let report = report();
    for measure in [Measure::Rmse, Measure::RelativeMse, Measure::TrimmedRelativeMse, Measure::Flip] {
        let drawing = draw_convergence(&report, measure).to_drawing();
        let count = |colour: [u8; 3]| drawing.bytes().chunks_exact(3).filter(|pixel| **pixel == colour).count();
        // Two panels and the legend, lines at least two pixels thick.
        for colour in [[0, 114, 178], [213, 94, 0]] {
            assert!(count(colour) > 1500, "{measure:?} {colour:?} {}", count(colour));
        }
        assert!(drawing.width() == 1600 && count([255; 3]) > drawing.width() * drawing.height() / 2);
    }
    let svg = draw_convergence(&report, Measure::Rmse).to_svg();
    for text in ["strategy=bsdf", "strategy=mis", "error of the reference", "samples per pixel", "seconds", "lamp.toml"]
    {
        assert!(svg.contains(text), "{text}");
    }
    assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"));
}

#[test]
fn usual_comparisons_follow_the_scene() {
    let base = Configuration::of_scene(&scene(&LAMP.replace("depth = 4", "depth = 6")));
    let labels = |comparison: Comparison| -> Vec<String> {
        let variants = variants(&base, &[comparison.variation(&base)]).unwrap();
        variants.into_iter().map(|variant| variant.label).collect()
    };
    assert_eq!(labels(Comparison::Depths), ["depth=1", "depth=2", "depth=4", "depth=6"]);
    assert_eq!(labels(Comparison::Integrators), ["integrator=phong", "integrator=whitted", "integrator=path"]);
    assert_eq!(labels(Comparison::Strategies), ["strategy=bsdf", "strategy=light", "strategy=mis"]);
}

fn report_of(output: &Output) -> Value {
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    json_report(&text(&output.stdout))
}

#[test]
fn a_reference_is_taken_from_the_cache_until_the_scene_changes() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("lamp.toml"), LAMP).unwrap();
    let run = |more: &[&str]| {
        let arguments = ["converge", "lamp.toml", "--samples", "1,4", "--reference-samples", "8", "--json"];
        report_of(&skycube(folder.path(), &[&arguments, more].concat()))
    };
    let cached = |report: &Value| report["scenes"][0]["references"][0]["cached"].as_bool().unwrap();
    let rmse = |report: &Value| report["scenes"][0]["curves"][0]["steps"][1]["rmse"].as_f64().unwrap();
    let first = run(&[]);
    let second = run(&[]);
    assert!(!cached(&first) && cached(&second));
    assert_eq!(rmse(&first), rmse(&second), "the picture from the cache is the same");
    for name in ["converge.csv", "converge.json", "converge.png", "converge.svg", "references"] {
        assert!(folder.path().join("converge-lamp").join(name).exists(), "{name}");
    }
    // A setting of the renderings changes no reference; one of the picture does.
    assert!(cached(&run(&["--sampler", "independent"])));
    assert!(!cached(&run(&["--seed", "7"])) && !cached(&run(&["--depth", "3"])) && !cached(&run(&["--size", "20x14"])));
    // A damaged file is rendered anew.
    let references = folder.path().join("converge-lamp/references");
    let key = first["scenes"][0]["references"][0]["key"].as_str().unwrap();
    std::fs::write(references.join(format!("{key}-first-half.exr")), "no picture").unwrap();
    assert!(!cached(&run(&[])) && cached(&run(&[])));
    std::fs::write(folder.path().join("lamp.toml"), LAMP.replace("radiance = 12", "radiance = 13")).unwrap();
    assert!(!cached(&run(&[])));
}

#[test]
fn lookups_are_compared_where_there_is_a_cube_map() {
    // So narrow a view that a texel covers several pixels: that is where lookups differ.
    let courtyard = concat!(env!("CARGO_MANIFEST_DIR"), "/envmaps/courtyard");
    let narrow = format!(
        "camera = {{ position = [0, 0, 0], target = [3, 1, 0.3], field_of_view = 1, size = [48, 30] }}\n\
         environment = {{ kind = \"cube-map\", map = '{courtyard}', lookup = \"humus-z-up\" }}\n"
    );
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("narrow.toml"), narrow).unwrap();
    let arguments = ["converge", "narrow.toml", "--compare", "lookups", "--samples", "1,16", "--json"];
    let report = report_of(&skycube(folder.path(), &arguments));
    let curves = report["scenes"][0]["curves"].as_array().unwrap();
    assert_eq!(report["scenes"][0]["references"][0]["configuration"]["environment_filter"], "seamless");
    let bias = |index: usize| curves[index]["steps"][1]["bias_squared"].as_f64().unwrap();
    assert_eq!(curves[0]["label"], "environment-filter=nearest");
    assert!(curves[0]["steps"][1]["bias_is_significant"].as_bool().unwrap(), "nearest texels are another picture");
    assert!(bias(0) > 10.0 * bias(2).abs(), "{} {}", bias(0), bias(2));
}

#[test]
fn what_cannot_run_says_why_and_writes_nothing() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("lamp.toml"), LAMP).unwrap();
    std::fs::write(folder.path().join("whitted.toml"), LAMP.replace("\"path\"", "\"whitted\"")).unwrap();
    let cases: [(&[&str], &str); 11] = [
        (&["lamp.toml", "--samples", "4,1"], "ascending counts"),
        (&["lamp.toml", "--samples", "0"], "ascending counts"),
        (&["lamp.toml", "--samples", "4", "--time", "1s"], "cannot be used with"),
        (&["lamp.toml", "--time", "never"], "expected a time"),
        (&["lamp.toml", "--seeds", "1"], "2..=16"),
        (&["lamp.toml", "--vary", "colour=red"], "expected one of integrator, depth"),
        (&["lamp.toml", "--vary", "strategy=mis,mis"], "mis is given twice"),
        (&["lamp.toml", "--compare", "depths", "--vary", "depth=1,2"], "depth is varied twice"),
        (&["lamp.toml", "--compare", "lookups"], "not a cube map"),
        (&["whitted.toml", "--compare", "strategies"], "no scene uses the path tracer"),
        (&["missing.toml"], "missing.toml"),
    ];
    for (arguments, complaint) in cases {
        let output = skycube(folder.path(), &[&["converge"], arguments].concat());
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert!(text(&output.stderr).contains(complaint), "{arguments:?}: {}", text(&output.stderr));
    }
    let output = skycube(folder.path(), &["converge", "lamp.toml", "-o", "."]);
    assert!(text(&output.stderr).contains("nothing is written to it"), "{}", text(&output.stderr));
    let names = std::fs::read_dir(folder.path()).unwrap().map(|entry| entry.unwrap().file_name());
    assert_eq!(names.count(), 2, "nothing was written");
}
