//! Grading of shots that a tracer made which shares nothing with ours: its camera and its `get_texel` stand below, written
//! by hand. Whatever is wrong with them must be named, or called undecided; never something else.

mod common;
#[path = "grade/readings.rs"]
mod readings;

use std::path::{Path, PathBuf};
use std::process::Command;

use skycube::envmap::source::Skybox;
use skycube::envmap::{Face, Preset, SignedAxis};
use skycube::grade::{Alternative, CameraFault, Cause, FaceGrade, Grade, GradeVerdict, Grader, Misfit, ShotFrame};
use skycube::picture::{Format, Header, Picture, Texels};
use skycube::render::AxisShot;
use skycube::stress::Random;
use skycube::validate::load;

type Vector = [f64; 3];

/// Six photographs as bytes, in the order +X -X +Y -Y +Z -Z.
struct Photographs {
    name: String,
    side: usize,
    bytes: Vec<Vec<u8>>,
    grader: Grader,
}

/// The tracer under test, with its faults.
#[derive(Clone)]
struct Student {
    /// Which image each face reads, and which of eight things its code does to u and v.
    faces: [(usize, usize); 6],
    /// Done to the place on the screen, and the axes it takes for x, y, z with their signs.
    screen: usize,
    axes: [(usize, f64); 3],
    field_of_view: f64,
    /// Factor and summand of u and v before the texel is looked up: 1, 0 for a right one.
    range: (f64, f64),
    /// What its textures show outside of 0 to 1.
    beyond: Beyond,
    /// False if it takes the components of the unit direction as they are.
    divides: bool,
    size: usize,
    bilinear: bool,
    /// Power on the way in, factor, power on the way out.
    tone: (f64, f64, f64),
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Beyond {
    Border,
    Repeated,
    Black,
}

/// The eight things code may do to a pair of coordinates, as one would write them.
const FORMULAS: [(&str, &str); 8] =
    [("u", "v"), ("1-u", "v"), ("u", "1-v"), ("1-u", "1-v"), ("v", "u"), ("1-v", "u"), ("v", "1-u"), ("1-v", "1-u")];

/// The value of a formula.
fn value(formula: &str, u: f64, v: f64) -> f64 {
    match formula {
        "u" => u,
        "1-u" => 1.0 - u,
        "v" => v,
        "1-v" => 1.0 - v,
        _ => panic!("{formula}"),
    }
}

const RIGHT: Student = Student {
    faces: [(0, 0), (1, 0), (2, 0), (3, 0), (4, 0), (5, 0)],
    screen: 0,
    axes: [(0, 1.0), (1, 1.0), (2, 1.0)],
    field_of_view: 90.0,
    range: (1.0, 0.0),
    beyond: Beyond::Border,
    divides: true,
    size: 128,
    bilinear: false,
    tone: (1.0, 1.0, 1.0),
};

/// The camera of the exercise: forward and up, z up.
const CAMERAS: [(Vector, Vector); 6] = [
    ([1.0, 0.0, 0.0], [0.0, 0.0, 1.0]),
    ([-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]),
    ([0.0, 1.0, 0.0], [0.0, 0.0, 1.0]),
    ([0.0, -1.0, 0.0], [0.0, 0.0, 1.0]),
    ([0.0, 0.0, 1.0], [0.0, -1.0, 0.0]),
    ([0.0, 0.0, -1.0], [0.0, 1.0, 0.0]),
];

fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The exercise solved, by hand: the face of a direction and its u and v, v = 0 at the bottom.
fn right_lookup([x, y, z]: Vector) -> (usize, f64, f64) {
    let (ax, ay, az) = (x.abs(), y.abs(), z.abs());
    let half = |quotient: f64| (quotient + 1.0) / 2.0;
    if ax >= ay && ax >= az {
        if x > 0.0 { (0, half(-y / ax), half(z / ax)) } else { (1, half(y / ax), half(z / ax)) }
    } else if ay >= az {
        if y > 0.0 { (2, half(x / ay), half(z / ay)) } else { (3, half(-x / ay), half(z / ay)) }
    } else if z > 0.0 {
        (4, half(x / az), half(-y / az))
    } else {
        (5, half(x / az), half(y / az))
    }
}

impl Student {
    /// A picture along an axis, as the bytes of a file.
    fn shot(&self, photographs: &Photographs, axis: usize) -> Picture {
        let (forward, up) = CAMERAS[axis];
        let right = cross(forward, up);
        let reach = (self.field_of_view.to_radians() / 2.0).tan();
        let mut bytes = Vec::with_capacity(3 * self.size * self.size);
        let light: [f64; 256] = std::array::from_fn(|code| (code as f64 / 255.0).powf(self.tone.0));
        for (row, column) in (0..self.size).flat_map(|row| (0..self.size).map(move |column| (row, column))) {
            let place = |index: usize| (index as f64 + 0.5) / self.size as f64;
            let (first, second) = FORMULAS[self.screen];
            let (s, t) = (place(column), 1.0 - place(row));
            let (s, t) = (value(first, s, t), value(second, s, t));
            let (a, b) = ((2.0 * s - 1.0) * reach, (2.0 * t - 1.0) * reach);
            let seen: Vector = std::array::from_fn(|k| forward[k] + a * right[k] + b * up[k]);
            let mut direction = [0.0; 3];
            for (component, (axis, sign)) in seen.into_iter().zip(self.axes) {
                direction[axis] += sign * component;
            }
            bytes.extend(self.get_texel(photographs, &light, direction));
        }
        let header = Header { width: self.size, height: self.size, format: Format::Png, bit_depth: 8, alpha: false };
        Picture::new(header, Texels::Srgb8(bytes))
    }

    fn get_texel(&self, photographs: &Photographs, light: &[f64; 256], direction: Vector) -> [u8; 3] {
        let (face, u, v) = right_lookup(direction);
        let largest = direction.iter().fold(0.0_f64, |largest, component| largest.max(component.abs()));
        let length = direction.iter().map(|component| component * component).sum::<f64>().sqrt();
        let shortened = |place: f64| if self.divides { place } else { (place - 0.5) * largest / length + 0.5 };
        let (u, v) = (shortened(u), shortened(v));
        let (image, orientation) = self.faces[face];
        let (first, second) = FORMULAS[orientation];
        let (u, v) = (value(first, u, v), value(second, u, v));
        let (factor, summand) = self.range;
        let (x, y) = ((factor * u + summand), 1.0 - (factor * v + summand));
        let side = photographs.side as f64;
        let (x, y) = (x * side, y * side);
        let texel = |x: f64, y: f64, channel: usize| {
            let outside = [x, y].iter().any(|place| !(-0.5..=side).contains(place));
            if self.beyond == Beyond::Black && outside {
                return 0.0;
            }
            let index = |place: f64| match self.beyond {
                Beyond::Repeated => place.floor().rem_euclid(side) as usize,
                _ => place.floor().clamp(0.0, side - 1.0) as usize,
            };
            light[usize::from(photographs.bytes[image][3 * (index(y) * photographs.side + index(x)) + channel])]
        };
        std::array::from_fn(|channel| {
            let light = if self.bilinear {
                let (x, y) = (x - 0.5, y - 0.5);
                let (across, down) = (x - x.floor(), y - y.floor());
                let row = |y: f64| texel(x, y, channel) * (1.0 - across) + texel(x + 1.0, y, channel) * across;
                row(y) * (1.0 - down) + row(y + 1.0) * down
            } else {
                texel(x, y, channel)
            };
            ((light * self.tone.1).min(1.0).powf(1.0 / self.tone.2) * 255.0).round() as u8
        })
    }

    fn shots(&self, photographs: &Photographs) -> [Picture; 6] {
        std::array::from_fn(|axis| self.shot(photographs, axis))
    }

    fn grade(&self, photographs: &Photographs) -> Grade {
        photographs.grader.grade(&self.shots(photographs))
    }

    /// Another way to take and write pictures for every number.
    fn varied(mut self, number: usize) -> Self {
        const SIZES: [usize; 4] = [64, 128, 256, 100];
        const TONES: [(f64, f64, f64); 8] = [
            (1.0, 1.0, 1.0),
            (2.2, 0.5, 2.2),
            (2.2, 2.0, 2.2),
            (2.2, 1.0, 1.0),
            (1.0, 0.5, 1.0),
            (1.0, 1.0, 2.2),
            (1.0, 2.0, 1.0),
            (2.2, 0.5, 1.0),
        ];
        self.size = match number {
            36 => 512,
            44 => 1024,
            _ => SIZES[number % 4],
        };
        self.tone = TONES[number / 2 % 8];
        self.bilinear = number / 3 % 2 == 1;
        self
    }
}

/// A map of the repository or of the shared folder; 8-bit codes of its files.
fn photographs(path: &Path) -> Photographs {
    judged_by(path, Preset::Course)
}

/// The same, graded as code that should have another lookup.
fn judged_by(path: &Path, lookup: Preset) -> Photographs {
    let skybox = Skybox::open(path).unwrap();
    let map = load(&skybox, lookup.lookup()).unwrap();
    let bytes = Face::ALL.map(|face| match map.picture(face).unwrap().texels() {
        Texels::Srgb8(bytes) => bytes.clone(),
        Texels::Linear(_) => panic!("8 bits are expected"),
    });
    let name = path.file_stem().unwrap().display().to_string();
    let frames = AxisShot::all(SignedAxis::POS_Z).map(|shot| ShotFrame {
        face: shot.direction,
        right: shot.right(),
        up: shot.up,
    });
    let grader = Grader::new(&map, frames).unwrap();
    Photographs { name, side: map.picture(Face::PosX).unwrap().width(), bytes: bytes.into(), grader }
}

/// The numbers of the cases to try: every seventh, unless all are asked for. Seven has no factor in common with the six
/// faces, the eight orientations and the tones that the numbers stand for.
fn cases(count: usize) -> impl Iterator<Item = usize> {
    (0..count).step_by(if common::thorough() { 1 } else { 7 })
}

/// Every orientation of a single face; unless all are asked for, eight of the 48 cases, in which each orientation, each face,
/// each size up to 512 and each tone occurs.
fn single_faces() -> impl Iterator<Item = (usize, Student)> {
    let numbers: Vec<usize> =
        if common::thorough() { (0..48).collect() } else { (0..8).map(|orientation| 9 * orientation % 48).collect() };
    numbers.into_iter().map(|number| {
        let mut student = RIGHT.varied(number);
        student.faces[number / 8].1 = number % 8;
        (number, student)
    })
}

fn maps() -> Vec<Photographs> {
    let own = Path::new(env!("CARGO_MANIFEST_DIR")).join("envmaps");
    let mut paths = vec![own.join("compass"), own.join("courtyard")];
    if common::thorough() {
        paths.extend(common::shared_map("Meadow.zip"));
        paths.extend(common::shared_map("clouds-dusk"));
    }
    paths.iter().map(|path: &PathBuf| photographs(path)).collect()
}

/// One map with detail everywhere, unless all are asked for: other angles and code that does not divide are searched for at
/// length.
fn costly_maps() -> Vec<Photographs> {
    if common::thorough() { maps() } else { maps().split_off(1) }
}

/// What came of a kind of cases.
#[derive(Default)]
struct Row {
    cases: usize,
    decided: usize,
    undecided: usize,
}

impl Row {
    /// Every decided face must be what the student's code does, and its repair applied must give the right lookup; what is
    /// undecided must leave the truth open.
    fn check(&mut self, student: &Student, photographs: &Photographs, grade: &Grade) {
        self.cases += 1;
        for face in &grade.faces {
            let (image, orientation) = student.faces[face.face.index()];
            let told =
                format!("{}: face {:?} of {:?}: {:?}", photographs.name, face.face, student.faces, face.possible);
            let told = format!("{told} {} {} {:?}", student.size, student.bilinear, student.tone);
            assert!(face.misfit.is_none(), "{told}: {:?}", face.misfit);
            let is_true = |placement: &skycube::grade::Placement| {
                placement.image.index() == image && placement.orientation.formulas() == FORMULAS[orientation]
            };
            assert!(face.possible.iter().any(is_true), "{told}");
            if !face.is_decided() {
                self.undecided += 1;
                continue;
            }
            self.decided += 1;
            let (first, second) = face.repair().unwrap().formulas();
            for (u, v) in [(0.1, 0.3), (0.7, 0.2)] {
                let (code_u, code_v) = (value(FORMULAS[orientation].0, u, v), value(FORMULAS[orientation].1, u, v));
                let repaired = (value(first, code_u, code_v), value(second, code_u, code_v));
                assert!((repaired.0 - u).abs() + (repaired.1 - v).abs() < 1e-12, "{told}");
            }
            assert_eq!(face.expected, face.face, "{told}");
        }
    }

    fn print(&self, kind: &str, map: &str) {
        let Self { cases, decided, undecided } = self;
        println!("{kind:<28} {map:<12} {cases:>5} {decided:>8} {undecided:>10}   all {decided} repairs right");
    }
}

#[test]
fn every_orientation_of_a_single_face_is_named() {
    for photographs in costly_maps() {
        let mut row = Row::default();
        for (number, student) in single_faces() {
            let grade = student.grade(&photographs);
            row.check(&student, &photographs, &grade);
            let verdict = grade.verdict();
            assert!(!matches!(verdict, GradeVerdict::Camera | GradeVerdict::CameraAndLookup), "{verdict:?}");
            assert!(!grade.undivided, "{}: case {number} divides", photographs.name);
        }
        row.print("one face, every orientation", &photographs.name);
    }
}

#[test]
fn six_random_orientations_are_named() {
    let mut random = Random(6);
    for photographs in maps() {
        let mut row = Row::default();
        for number in cases(24) {
            let mut student = RIGHT.varied(number);
            student.faces.iter_mut().for_each(|face| face.1 = random.below(8));
            row.check(&student, &photographs, &student.grade(&photographs));
        }
        row.print("six random orientations", &photographs.name);
    }
}

#[test]
fn exchanged_images_are_named() {
    let mut random = Random(7);
    for photographs in maps() {
        let mut row = Row::default();
        let pairs = (0..6).flat_map(|one| (0..one).map(move |other| (one, other)));
        for (number, (one, other)) in pairs.enumerate().step_by(if common::thorough() { 1 } else { 7 }) {
            let mut student = RIGHT.varied(number);
            (student.faces[one].0, student.faces[other].0) = (other, one);
            student.faces[random.below(6)].1 = random.below(8);
            let grade = student.grade(&photographs);
            row.check(&student, &photographs, &grade);
            assert!(grade.verdict() != GradeVerdict::Right);
        }
        row.print("two images exchanged", &photographs.name);
    }
}

#[test]
fn a_wrong_camera_is_told_from_a_wrong_lookup() {
    for photographs in costly_maps() {
        let decided = RIGHT.grade(&photographs).faces.iter().all(FaceGrade::is_decided);
        let mut row = Row::default();
        for (screen, formulas) in FORMULAS.into_iter().enumerate().skip(1) {
            let student = Student { screen, ..RIGHT.varied(screen) };
            let grade = student.grade(&photographs);
            if !decided {
                continue;
            }
            assert_eq!(grade.verdict(), GradeVerdict::Camera, "{} {screen} {grade:?}", photographs.name);
            assert_eq!(grade.camera.orientation.formulas(), formulas, "{}", photographs.name);
            assert!(matches!(grade.alternatives[..], [Alternative::Lookup(_)]));
            row.check(&student, &photographs, &grade);
        }
        row.print("pictures in other orientations", &photographs.name);
        let mut row = Row::default();
        let mixed = [
            [(0, 1.0), (2, 1.0), (1, -1.0)],
            [(1, 1.0), (2, 1.0), (0, 1.0)],
            [(1, 1.0), (0, -1.0), (2, 1.0)],
            [(0, -1.0), (1, -1.0), (2, 1.0)],
            [(0, 1.0), (2, 1.0), (1, 1.0)],
        ];
        for (number, axes) in mixed.into_iter().enumerate() {
            let student = Student { axes, ..RIGHT.varied(number) };
            let grade = student.grade(&photographs);
            if !decided {
                continue;
            }
            assert_eq!(grade.verdict(), GradeVerdict::Camera, "{} {axes:?} {grade:?}", photographs.name);
            row.check(&student, &photographs, &grade);
        }
        row.print("axes mixed up", &photographs.name);
    }
}

#[test]
fn a_wrong_field_of_view_is_measured() {
    for photographs in costly_maps() {
        let mut row = Row::default();
        for (number, angle) in [45.0, 60.0, 75.0, 84.0, 90.0, 97.0, 110.0, 125.0].into_iter().enumerate() {
            let mut student = RIGHT.varied(number + 1);
            student.field_of_view = angle;
            student.faces[number % 6].1 = number % 3;
            let grade = student.grade(&photographs);
            let seen = grade.field_of_view.unwrap_or(90.0);
            println!("{:<12} {angle:>4}° seen as {seen:.1}°", photographs.name);
            assert!((seen - angle).abs() < 2.0, "{}: {angle}° seen as {seen}°", photographs.name);
            row.check(&student, &photographs, &grade);
        }
        row.print("other fields of view", &photographs.name);
    }
}

#[test]
fn a_missing_division_is_named() {
    for photographs in costly_maps() {
        let mut row = Row::default();
        for (number, divided) in single_faces() {
            let student = Student { divides: false, ..divided };
            let grade = student.grade(&photographs);
            assert!(grade.undivided, "{}: case {number}, {:?}", photographs.name, grade.field_of_view);
            assert_eq!((grade.verdict(), grade.field_of_view), (GradeVerdict::Lookup, None));
            row.check(&student, &photographs, &grade);
            // By a mirrored camera, in the smallest and the largest of these shots.
            if number % 4 == 0 {
                let mirrored = Student { screen: 1, ..student }.grade(&photographs);
                assert!(
                    mirrored.undivided || mirrored.verdict() != GradeVerdict::Right,
                    "{}: case {number}",
                    photographs.name
                );
            }
        }
        row.print("undivided", &photographs.name);
    }
}

/// u and v from -1 to 1, and what shows of it.
#[test]
fn a_texture_read_out_of_range_fits_no_orientation() {
    let photographs = &maps()[1];
    let names =
        [(Beyond::Border, Misfit::Smeared), (Beyond::Repeated, Misfit::Repeated), (Beyond::Black, Misfit::PartlyBlack)];
    for (beyond, name) in names {
        let grade = Student { range: (2.0, -1.0), beyond, ..RIGHT }.grade(photographs);
        let misfits: Vec<Option<Misfit>> = grade.faces.iter().map(|face| face.misfit).collect();
        println!("{beyond:?}: {misfits:?}");
        assert_ne!(grade.verdict(), GradeVerdict::Right);
        assert!(misfits.contains(&Some(name)), "{beyond:?}: {misfits:?}");
        assert!(misfits.iter().flatten().all(|misfit| *misfit == name), "{beyond:?}: {misfits:?}");
    }
    let black = Student { tone: (1.0, 0.0, 1.0), ..RIGHT }.grade(photographs);
    assert_eq!(black.verdict(), GradeVerdict::OutOfRange);
    assert!(black.faces.iter().all(|face| face.misfit == Some(Misfit::Black)));
}

#[test]
fn usual_slips_are_named() {
    let lookup = Preset::Course.lookup();
    let named = |grade: &Grade| grade.causes(&lookup, SignedAxis::POS_Z);
    for photographs in costly_maps() {
        let of = |student: &Student| named(&student.grade(&photographs));
        let all = |orientation: usize| Student { faces: RIGHT.faces.map(|(image, _)| (image, orientation)), ..RIGHT };
        assert_eq!(of(&RIGHT), [], "{}", photographs.name);
        assert_eq!(of(&all(1)), [Cause::UFromTheOtherEnd], "{}", photographs.name);
        assert_eq!(of(&all(2)), [Cause::VFromTheOtherEnd], "{}", photographs.name);
        let mut unsigned = RIGHT;
        for face in [1, 3, 5] {
            unsigned.faces[face].1 = 3;
        }
        assert_eq!(of(&unsigned), [Cause::AbsForgotten], "{}", photographs.name);
        for (faces, orientation) in [([0, 1], 1), ([2, 3], 1), ([4, 5], 2)] {
            let mut exchanged = RIGHT;
            for (face, other) in [(faces[0], faces[1]), (faces[1], faces[0])] {
                exchanged.faces[face] = (other, orientation);
            }
            assert_eq!(
                of(&exchanged),
                [Cause::CasesExchanged(faces.map(|face| Face::ALL[face]))],
                "{}",
                photographs.name
            );
        }
        for beyond in [Beyond::Border, Beyond::Repeated, Beyond::Black] {
            let unhalved = Student { range: (2.0, -0.5), beyond, ..RIGHT };
            assert_eq!(of(&unhalved), [Cause::NotHalved], "{} {beyond:?}", photographs.name);
            let neither = Student { divides: false, ..unhalved }.grade(&photographs);
            let found = (neither.undivided, named(&neither));
            assert_eq!(found, (true, vec![Cause::NotHalved]), "{} {beyond:?}", photographs.name);
        }
        let mut shots = RIGHT.shots(&photographs);
        for axis in [4, 5] {
            shots[axis] = Student { tone: (1.0, 0.0, 1.0), ..RIGHT }.shot(&photographs, axis);
        }
        assert_eq!(named(&photographs.grader.grade(&shots)), [Cause::UpAlongTheView], "{}", photographs.name);
    }
}

#[test]
fn the_lookup_of_the_code_is_read_from_its_shots() {
    let lookup = Preset::Course.lookup();
    let photographs = &maps()[0];
    let mut student = RIGHT;
    (student.faces[3], student.faces[0]) = ((3, 1), (1, 0));
    let code = student.grade(photographs).lookup_of_code(&lookup);
    let [right, own] = [lookup, code].map(|table| table.row(Face::NegY));
    assert_eq!((own.image, own.u, own.v), (right.image, -right.u, right.v));
    assert_eq!(code.row(Face::PosX).image, Face::NegX);
    assert_eq!(code.row(Face::PosZ), lookup.row(Face::PosZ));
}

#[test]
fn small_shots_do_not_make_the_camera_wrong() {
    for photographs in costly_maps() {
        for size in [16, 20, 32, 48] {
            let grade = Student { size, ..RIGHT }.grade(&photographs);
            assert_eq!(grade.field_of_view, None, "{} at {size}", photographs.name);
            assert!(grade.camera == CameraFault::NONE && !grade.undivided, "{} at {size}", photographs.name);
        }
    }
}

/// The whole command: files, text, JSON, exit codes.
#[test]
fn the_command_names_the_repair() {
    let photographs = &maps()[0];
    let folder = tempfile::tempdir().unwrap();
    let mut student = RIGHT;
    student.faces[3].1 = 1;
    let run = |student: &Student, more: &[&str]| {
        for (face, shot) in Face::ALL.into_iter().zip(student.shots(photographs)) {
            let path = folder.path().join(face.name()).with_extension("png");
            skycube::picture::write(&shot.to_raster(), &path, &skycube::picture::WriteOptions::default()).unwrap();
        }
        let map = Path::new(env!("CARGO_MANIFEST_DIR")).join("envmaps/compass");
        let mut command = Command::new(env!("CARGO_BIN_EXE_skycube"));
        command.arg("grade").arg(folder.path()).arg("--map").arg(map).args(["--lookup", "course"]).args(more);
        let output = command.output().unwrap();
        (output.status.code(), String::from_utf8(output.stdout).unwrap(), String::from_utf8(output.stderr).unwrap())
    };
    let (code, text, error) = run(&student, &[]);
    println!("{text}{error}");
    assert_eq!(code, Some(1));
    assert!(text.contains("    case NEG_Y: u = 1 - u\n"), "{text}");
    let (_, json, _) = run(&student, &["--json"]);
    let json = common::json_report(&json);
    assert_eq!(json["verdict"], "lookup");
    let face = &json["faces"][3];
    assert_eq!((&face["face"], &face["image"]), (&"negy".into(), &"negy".into()));
    assert_eq!((&face["u"], &face["v"], &face["decided"]), (&"1-u".into(), &"v".into(), &true.into()));
    let (code, text, _) = run(&RIGHT, &[]);
    println!("{text}");
    assert_eq!(code, Some(0));
    assert_eq!(run(&Student { field_of_view: 60.0, ..RIGHT }, &[]).0, Some(1));
    std::fs::remove_file(folder.path().join("negz.png")).unwrap();
    let map = Path::new(env!("CARGO_MANIFEST_DIR")).join("envmaps/compass");
    let output = Command::new(env!("CARGO_BIN_EXE_skycube"))
        .args([Path::new("grade"), folder.path(), Path::new("--map"), &map])
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(2));
    let error = String::from_utf8(output.stderr).unwrap();
    assert!(error.contains("the shot negz is missing"), "{error}");
}
