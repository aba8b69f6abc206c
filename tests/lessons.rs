//! The lessons as a student walks through them: every command is run in a copy of what a student gets, every expected
//! picture is compared with the one that the commands rendered, and both languages say the same.
//!
//! `UPDATE_LESSONS=1 cargo test --test lessons` renders the expected pictures anew, with the samples that `lesson.toml` asks
//! for: that takes many times as long. Look at them before you commit.

use std::ops::Range;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use skycube::colour::encode_srgb;
use skycube::compare::Comparison;
use skycube::lessons::{Lesson, Source};
use skycube::math::Vec3;
use skycube::picture::{self, Picture, Raster, Texels};
use skycube::report::draw_comparison;

/// The largest expected picture in bytes.
const LARGEST: u64 = 200_000;
/// All that a student gets, in bytes.
const LARGEST_TOGETHER: u64 = 4_000_000;

/// Scenes that differ in their noise only, or not at all.
const ALIKE: [[&str; 2]; 1] = [["marbles-with-hierarchy", "marbles-without-hierarchy"]];

/// The scene with rare bright paths, which one square may meet and another miss.
const SPARKS: &str = "sunlit-strategy-mis";

const HEADINGS: [&str; 8] = [
    "Goal",
    "The idea",
    "What to implement",
    "Where it stands in our source",
    "Commands",
    "The expected picture",
    "What goes wrong, and what it looks like",
    "Questions",
];
const CZECH_HEADINGS: [&str; 8] = [
    "Cíl",
    "Myšlenka",
    "Co naprogramovat",
    "Kde je to v našem kódu",
    "Příkazy",
    "Očekávaný obrázek",
    "Co se kazí a jak to vypadá",
    "Otázky",
];

fn project(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path)
}

/// The folders of the lessons, in order.
fn folders() -> Vec<PathBuf> {
    let entries = std::fs::read_dir(project("lessons")).unwrap().map(|entry| entry.unwrap().path());
    let mut folders: Vec<PathBuf> = entries.filter(|path| path.is_dir()).collect();
    folders.sort();
    folders
}

fn read(file: &Path) -> String {
    std::fs::read_to_string(file).unwrap_or_else(|error| panic!("{}: {error}", file.display()))
}

fn lesson(folder: &Path) -> Lesson {
    Lesson::read(Source::Folder(folder.to_path_buf())).unwrap_or_else(|error| panic!("{error}"))
}

/// Both texts, each with the headings it must have.
fn texts(folder: &Path) -> [(String, [&'static str; 8]); 2] {
    [(read(&folder.join("README.md")), HEADINGS), (read(&folder.join("README.cs.md")), CZECH_HEADINGS)]
}

/// The lines of the text's blocks for the shell.
fn shell_lines(text: &str) -> Vec<&str> {
    let blocks = text.split("```sh\n").skip(1).map(|rest| rest.split("```").next().unwrap());
    blocks.flat_map(str::lines).collect()
}

/// What stands between backquotes or in the brackets of a link, and begins and ends in a given way.
fn mentions<'a>(text: &'a str, starts: &str, ends: &[&str]) -> Vec<&'a str> {
    let words = text.split(['`', '(', ')', ' ', '\n']);
    words.filter(|word| word.starts_with(starts) && ends.iter().any(|end| word.ends_with(end))).collect()
}

/// The scenes among the files, without `.toml`.
fn scenes(lesson: &Lesson) -> Vec<&str> {
    lesson.files.iter().filter_map(|file| file.to_str().unwrap().strip_suffix(".toml")).collect()
}

/// The expected picture of a scene.
fn expected_name(scene: &str) -> String {
    format!("expected-{scene}.png")
}

#[test]
fn the_eleven_lessons_are_there_in_both_languages() {
    let folders = folders();
    assert_eq!(folders.len(), 11);
    for (index, folder) in folders.iter().enumerate() {
        let lesson = lesson(folder);
        assert_eq!(lesson.number as usize, index + 1);
        assert!(folder.file_name().unwrap().to_str().unwrap().starts_with(&format!("{:02}-", lesson.number)));
        let [english, czech] = texts(folder);
        assert!(english.0.starts_with(&format!("# {:02} {}\n", lesson.number, lesson.title.en)));
        assert!(czech.0.starts_with(&format!("# {:02} {}\n", lesson.number, lesson.title.cs)));
        for text in [&lesson.goal, &lesson.needs] {
            assert!(!text.en.is_empty() && !text.cs.is_empty() && text.en != text.cs);
        }
        for (text, expected) in [&english, &czech] {
            let headings: Vec<&str> = text.lines().filter_map(|line| line.strip_prefix("## ")).collect();
            assert_eq!(headings, *expected, "{}", folder.display());
        }
    }
}

#[test]
fn what_the_texts_name_exists() {
    for folder in folders() {
        let lesson = lesson(&folder);
        for file in &lesson.files {
            assert!(folder.join(file).is_file(), "{}: {} is listed and missing", folder.display(), file.display());
        }
        for (text, _) in &texts(&folder) {
            for source in mentions(text, "src/", &[".rs"]) {
                assert!(project(source).is_file(), "{}: {source} is missing", folder.display());
            }
            for shown in mentions(text, "expected-", &[".png", ".jpg"]) {
                assert!(lesson.files.iter().any(|file| file == Path::new(shown)), "{}: {shown}", folder.display());
            }
            for scene in scenes(&lesson) {
                let shown = text.contains(&format!("]({})", expected_name(scene)));
                assert!(shown, "{}: {scene} not shown", folder.display());
            }
        }
    }
}

#[test]
fn both_texts_and_the_list_hold_the_same_commands() {
    for folder in folders() {
        let lesson = lesson(&folder);
        for (text, _) in &texts(&folder) {
            assert_eq!(shell_lines(text), lesson.commands, "{}", folder.display());
        }
        for command in &lesson.commands {
            assert!(command.starts_with("skycube "), "{command}");
        }
    }
}

#[test]
fn a_student_gets_every_scene_and_picture() {
    for folder in folders() {
        let lesson = lesson(&folder);
        let names = std::fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
        for name in names.filter(|name| *name != "lesson.toml" && !name.starts_with("glass-and-mirror")) {
            let listed = lesson.files.iter().any(|file| file.starts_with(&name));
            assert!(listed, "{}: {name} is not listed", folder.display());
            if name.starts_with("expected-") {
                assert!(folder.join(&name).metadata().unwrap().len() <= LARGEST, "{name} is too large");
            }
        }
    }
}

#[test]
fn the_lessons_are_a_small_download() {
    let listed = |folder: &PathBuf| lesson(folder).files.into_iter().map(|file| folder.join(file)).collect::<Vec<_>>();
    let files = folders().iter().flat_map(listed).collect::<Vec<_>>();
    let together: u64 = files.iter().map(|file| file.metadata().unwrap().len()).sum();
    assert!(together <= LARGEST_TOGETHER, "{together}");
}

/// A lesson as a student has it: a copy of the listed files.
struct Walk {
    folder: PathBuf,
    lesson: Lesson,
    copy: tempfile::TempDir,
}

impl Walk {
    fn start(name: &str) -> Self {
        let folder = project("lessons").join(name);
        let lesson = lesson(&folder);
        let copy = tempfile::tempdir().unwrap();
        for file in &lesson.files {
            let target = copy.path().join(file);
            std::fs::create_dir_all(target.parent().unwrap()).unwrap();
            std::fs::copy(folder.join(file), target).unwrap();
        }
        Self { folder, lesson, copy }
    }

    fn run(&self, arguments: &[&str]) -> Output {
        Command::new(env!("CARGO_BIN_EXE_skycube")).args(arguments).current_dir(self.copy.path()).output().unwrap()
    }

    /// Runs all commands in their order.
    fn run_commands(&self) {
        for command in &self.lesson.commands {
            let arguments: Vec<&str> = command.split(' ').skip(1).collect();
            let output = self.run(&arguments);
            let expected = if finds_faults(&arguments) { 1 } else { 0 };
            let [said, complained] = [&output.stdout, &output.stderr].map(|bytes| String::from_utf8_lossy(bytes));
            assert_eq!(output.status.code(), Some(expected), "{command}\n{said}{complained}");
            let deliberate = self.asks_for_a_mistake(arguments[1..].first());
            assert_eq!(said.contains("wrong on purpose"), arguments[0] == "render" && deliberate, "{command}\n{said}");
        }
    }

    /// True for a scene with a mistake that the tracer must make on purpose.
    fn asks_for_a_mistake(&self, scene: Option<&&str>) -> bool {
        let Some(scene) = scene.filter(|name| name.ends_with(".toml")) else { return false };
        let text = read(&self.folder.join(scene));
        text.contains("\nmistake =") || text.contains("\nencode = \"linear\"")
    }

    /// Compares what the commands rendered with what was expected.
    fn compare_pictures(&self) {
        if std::env::var_os("UPDATE_LESSONS").is_some() {
            scenes(&self.lesson).into_iter().for_each(|scene| self.update(scene));
        }
        let differences: Vec<String> =
            scenes(&self.lesson).into_iter().filter_map(|scene| self.differs(scene)).collect();
        assert!(differences.is_empty(), "{}", differences.join("\n"));
    }

    /// Any other scene of the lesson must be told from the expected one: a bound that lets it pass lets mistakes pass.
    fn tell_apart(&self) {
        let scenes = scenes(&self.lesson);
        let alike = |one: &str, other: &str| ALIKE.iter().any(|pair| pair.contains(&one) && pair.contains(&other));
        for (&one, &other) in scenes.iter().flat_map(|one| scenes.iter().map(move |other| (one, other))) {
            let difference = Difference::of(&self.rendered(one), &self.expected(other));
            assert!(
                one == other || alike(one, other) || !difference.is_noise_of(other),
                "{one} passes as {other}: {difference:?}"
            );
        }
    }

    /// Renders the expected picture of a scene anew.
    fn update(&self, scene: &str) {
        let (scene_file, picture) = (format!("{scene}.toml"), format!("new-{scene}.png"));
        let samples = self.lesson.expected_samples.get(scene).map(|samples| format!("--samples={samples}"));
        let arguments = ["render", &scene_file, "-o", &picture].into_iter().chain(samples.as_deref());
        assert!(self.run(&arguments.collect::<Vec<_>>()).status.success(), "{scene}");
        std::fs::copy(self.copy.path().join(picture), self.folder.join(expected_name(scene))).unwrap();
    }

    /// How the picture of a scene differs from the expected one, if it does. A drawing of it is left in `target`.
    fn differs(&self, scene: &str) -> Option<String> {
        let (rendered, expected) = (self.rendered(scene), self.expected(scene));
        let difference = Difference::of(&rendered, &expected);
        let file = self.folder.join(expected_name(scene));
        let compared = self.run(&["compare", &format!("{scene}.png"), file.to_str().unwrap()]);
        if difference.is_noise_of(scene) && compared.status.code() == Some(0) {
            return None;
        }
        let drawn = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("lesson-{scene}-difference.png"));
        draw_comparison(&Comparison::of(&rendered, &expected)).write(&drawn).unwrap();
        let said = String::from_utf8_lossy(&compared.stdout).into_owned();
        Some(format!("{scene}: {difference:?}, see {}\n{said}", drawn.display()))
    }

    fn expected(&self, scene: &str) -> Picture {
        picture::read(&self.folder.join(expected_name(scene))).unwrap()
    }

    /// The picture of a scene as the commands rendered it.
    fn rendered(&self, scene: &str) -> Picture {
        picture::read(&self.copy.path().join(format!("{scene}.png"))).unwrap()
    }
}

/// True for commands that must say that something is wrong: pictures with a mistake in them, maps that do not fit.
fn finds_faults(arguments: &[&str]) -> bool {
    match arguments[0] {
        "compare" => !arguments[1].starts_with("marbles-without-hierarchy"),
        "check" => arguments[1] != "repaired",
        "grade" => true,
        _ => false,
    }
}

/// How far two pictures are apart in what noise leaves alone: linear light averaged over squares of some pixels, and
/// encoded again. In codes of 255; infinite for pictures of other sizes.
#[derive(Debug, Clone, Copy)]
struct Difference {
    /// Over all squares.
    mean: f64,
    /// Of the square that differs most, the mean of its channels.
    worst: f64,
}

impl Difference {
    /// Edge of a square in pixels.
    const SQUARE: usize = 10;

    fn of(mine: &Picture, expected: &Picture) -> Self {
        if (mine.width(), mine.height()) != (expected.width(), expected.height()) {
            return Self { mean: f64::INFINITY, worst: f64::INFINITY };
        }
        let (mine, expected) = (squares(&mine.to_raster()), squares(&expected.to_raster()));
        let differences =
            mine.iter().zip(&expected).map(|(mine, expected)| (*mine - *expected).abs().element_sum() / 3.0);
        let differences: Vec<f64> = differences.map(|difference| f64::from(difference * 255.0)).collect();
        let mean = differences.iter().sum::<f64>() / differences.len() as f64;
        Self { mean, worst: differences.into_iter().fold(0.0, f64::max) }
    }

    /// True if no more is left than the noise of the scene's own samples may leave. `tell_apart` holds these bounds to what
    /// they are for: no other scene of the lesson passes.
    fn is_noise_of(self, scene: &str) -> bool {
        let worst = if scene == SPARKS { 30.0 } else { 12.0 };
        self.mean <= 0.6 && self.worst <= worst
    }
}

/// The means of the squares of a raster, encoded, row by row.
fn squares(raster: &Raster) -> Vec<Vec3> {
    let places = |size: usize| {
        (0..size).step_by(Difference::SQUARE).map(move |start| start..size.min(start + Difference::SQUARE))
    };
    let rows = places(raster.height());
    let corners = rows.flat_map(|rows| places(raster.width()).map(move |columns| (columns, rows.clone())));
    let mean = |columns: Range<usize>, rows: Range<usize>| {
        let count = (columns.len() * rows.len()) as f32;
        let pixels = rows.flat_map(|y| columns.clone().map(move |x| (x, y)));
        pixels.map(|(x, y)| raster.pixel(x, y)).sum::<Vec3>() / count
    };
    corners.map(|(columns, rows)| mean(columns, rows).map(encode_srgb)).collect()
}

/// The codes of a picture of 8 bits.
fn codes(picture: &Picture) -> &[u8] {
    match picture.texels() {
        Texels::Srgb8(codes) => codes,
        other => panic!("a picture of 8 bits was expected, not {other:?}"),
    }
}

/// Mean absolute difference in codes of 255; infinite for pictures of other sizes.
fn mean_difference(mine: &Picture, expected: &Picture) -> f64 {
    if (mine.width(), mine.height()) != (expected.width(), expected.height()) {
        return f64::INFINITY;
    }
    let (mine, expected) = (codes(mine), codes(expected));
    let sum: u64 = mine.iter().zip(expected).map(|(&a, &b)| u64::from(a.abs_diff(b))).sum();
    sum as f64 / mine.len() as f64
}

/// Runs the commands of a lesson and compares its pictures.
fn walk_through(name: &str) -> Walk {
    let walk = Walk::start(name);
    walk.run_commands();
    walk.compare_pictures();
    walk.tell_apart();
    walk
}

#[test]
fn lesson_01_camera_rays() {
    walk_through("01-camera-rays");
}

#[test]
fn lesson_02_normals() {
    walk_through("02-normals");
}

#[test]
fn lesson_03_shadow_acne_darkens_here_and_there() {
    let walk = walk_through("03-phong-shadows");
    let (right, acne) = (walk.rendered("balls-with-shadows"), walk.rendered("balls-shadow-acne"));
    let pairs = || codes(&right).chunks(3).zip(codes(&acne).chunks(3));
    assert!(pairs().all(|(right, acne)| right.iter().zip(acne).all(|(right, acne)| acne <= right)));
    let darker = pairs().filter(|(right, acne)| right != acne).count();
    let share = darker as f64 / pairs().count() as f64;
    // The lit sides of the two balls and of the box cover about a seventh of the picture.
    assert!((0.05..0.2).contains(&share), "{share}");
}

#[test]
fn lesson_04_whitted() {
    walk_through("04-whitted");
}

#[test]
fn lesson_05_without_gamma_the_codes_are_the_light() {
    let walk = walk_through("05-textures-gamma");
    let (right, linear) = (walk.rendered("poster-right"), walk.rendered("poster-without-gamma"));
    for (&right, &linear) in codes(&right).iter().zip(codes(&linear)) {
        let encoded = f64::from(right) / 255.0;
        let light = if encoded <= 0.04045 { encoded / 12.92 } else { ((encoded + 0.055) / 1.055).powf(2.4) };
        // Half a code of the encoded picture is up to 1.14 codes of light, and the other is rounded to half a code.
        assert!((light * 255.0 - f64::from(linear)).abs() < 1.7, "{right} {linear}");
    }
}

#[test]
fn lesson_06_environment_map() {
    let walk = walk_through("06-environment-map");
    let report = walk.run(&["check", "broken", "--lookup", "humus-z-up", "--world-up", "+z"]).stdout;
    let report = String::from_utf8(report).unwrap();
    // The face -Z reads the image negy: the files change their names, whatever faces read them.
    let expected =
        ["posz.jpg: flip left-right", "posy.jpg: turn 90° counterclockwise", "exchange negx.jpg and negy.jpg"];
    assert_eq!(report.lines().take(3).collect::<Vec<_>>(), expected, "{report}");
    let whole = picture::read(&walk.copy.path().join("environment-with.png")).unwrap();
    let repaired = picture::read(&walk.copy.path().join("repaired.png")).unwrap();
    // 128 texels per face in place of 512, and JPEG: blurred, but the same world.
    assert!(mean_difference(&whole, &repaired) < 12.0, "{}", mean_difference(&whole, &repaired));
}

#[test]
fn lesson_07_antialiasing_depth_of_field() {
    walk_through("07-antialiasing-depth-of-field");
}

#[test]
fn lesson_08_path_tracing() {
    walk_through("08-path-tracing");
}

#[test]
fn lesson_09_a_metal_that_keeps_nothing_disappears() {
    let walk = walk_through("09-microfacets");
    let mean = |scene: &str| {
        let raster = walk.rendered(scene).to_raster();
        raster.pixels().iter().map(|colour| f64::from(colour.y)).sum::<f64>() / raster.pixels().len() as f64
    };
    // An environment of radiance 0.5, code 188 once rounded.
    let background = f64::from(skycube::colour::SRGB8_TO_LINEAR[188]);
    assert!((mean("furnace-metal") - background).abs() < 0.002, "{}", mean("furnace-metal"));
    assert!(mean("furnace-phong") < background - 0.03, "{}", mean("furnace-phong"));
}

#[test]
fn lesson_10_a_hierarchy_changes_no_pixel() {
    let walk = walk_through("10-hierarchies");
    let [with, without] = ["marbles-with-hierarchy", "marbles-without-hierarchy"].map(|scene| walk.rendered(scene));
    assert!(codes(&with) == codes(&without));
}

#[test]
fn lesson_11_photons_find_the_faint_light_in_the_shadow() {
    let walk = walk_through("11-light-through-glass");
    // A square of the ball's shadow behind the spot.
    let light = |picture: Picture| {
        let raster = picture.to_raster();
        let places = (70..74).flat_map(|y| (95..110).map(move |x| (x, y)));
        places.map(|(x, y)| f64::from(raster.pixel(x, y).y)).sum::<f64>() / 60.0
    };
    let expected = light(walk.expected("glass-ball-with-photons"));
    let with = light(walk.rendered("glass-ball-with-photons"));
    let without = light(walk.rendered("glass-ball-without-photons"));
    assert!((with / expected - 1.0).abs() < 0.2 && without < 0.5 * expected, "{with}, {without} of {expected}");
}
