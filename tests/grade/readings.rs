//! Shots that have more than one explanation, or none: plain maps, a wrong camera together with a wrong lookup, presets.

use super::*;
use skycube::math::Vec3;
use skycube::picture::{Raster, WriteOptions};
use skycube::report::GradeReport;

/// The light of an sRGB code.
fn decoded(code: f32) -> f32 {
    if code <= 0.04045 { code / 12.92 } else { ((code + 0.055) / 1.055).powf(2.4) }
}

/// The folder of a map whose faces have these colours.
fn plain_map(folder: &Path, colours: [[u8; 3]; 6]) {
    for (face, colour) in Face::ALL.into_iter().zip(colours) {
        let light = Vec3::from_array(colour.map(|code| decoded(f32::from(code) / 255.0)));
        let path = folder.join(face.name()).with_extension("png");
        skycube::picture::write(&Raster::filled(64, 64, light), &path, &WriteOptions::default()).unwrap();
    }
}

#[test]
fn plain_faces_say_nothing_of_the_camera() {
    let six = [[200, 60, 30], [30, 90, 200], [120, 120, 20], [60, 160, 90], [90, 140, 220], [110, 80, 50]];
    for colours in [[six[0]; 6], [six[3]; 6], [[120; 3]; 6], six] {
        let folder = tempfile::tempdir().unwrap();
        plain_map(folder.path(), colours);
        let photographs = photographs(folder.path());
        for student in [Student { size: 64, ..RIGHT }, Student { size: 256, ..RIGHT }] {
            let grade = student.grade(&photographs);
            assert_eq!(grade.verdict(), GradeVerdict::Undecided, "{colours:?}: {:?}", grade.field_of_view);
        }
    }
}

fn courtyard(lookup: Preset) -> Photographs {
    judged_by(&Path::new(env!("CARGO_MANIFEST_DIR")).join("envmaps/courtyard"), lookup)
}

/// The exercise's formulas, by what they do to u and v of the right ones.
const EXERCISE: [(usize, usize); 6] = [(0, 1), (1, 0), (2, 0), (3, 1), (4, 2), (5, 0)];
/// The right ones for a map with y up.
const HUMUS: [(usize, usize); 6] = [(0, 0), (1, 0), (4, 0), (5, 0), (2, 0), (3, 0)];

/// Wrong faces under the camera that the grade names or else mentions, if it has a fault.
fn left_by_a_camera(grade: &Grade) -> Option<usize> {
    let wrong = |faces: &[FaceGrade; 6]| faces.iter().filter(|face| face.is_wrong()).count();
    if grade.camera != CameraFault::NONE {
        return Some(wrong(&grade.faces));
    }
    grade.alternatives.iter().find_map(|alternative| match alternative {
        Alternative::Camera(_) => Some(0),
        Alternative::Both(_, faces) => Some(wrong(faces)),
        _ => None,
    })
}

#[test]
fn a_wrong_camera_is_blamed_though_one_face_is_wrong_too() {
    let photographs = courtyard(Preset::Course);
    let mut row = Row::default();
    for (screen, face, orientation) in [(1, 0, 1), (1, 3, 1), (2, 3, 2), (3, 0, 3), (1, 3, 2), (4, 1, 3)] {
        let mut student = Student { screen, ..RIGHT };
        student.faces[face].1 = orientation;
        let grade = student.grade(&photographs);
        assert_eq!(grade.verdict(), GradeVerdict::CameraAndLookup, "{screen} {face} {orientation}");
        assert_eq!(grade.camera.orientation.formulas(), FORMULAS[screen]);
        row.check(&student, &photographs, &grade);
    }
}

#[test]
fn a_camera_that_explains_as_much_as_a_lookup_is_mentioned() {
    let photographs = courtyard(Preset::Course);
    let mut random = Random(9);
    let mut cases = 0;
    for number in (0..12).cycle() {
        let mut student = Student { screen: random.below(4), size: 64, ..RIGHT };
        for _ in 0..number / 3 {
            student.faces[random.below(6)].1 = random.below(4);
        }
        let own = student.faces.iter().filter(|face| face.1 != 0).count();
        // Orientations without a swap undo themselves: a face is right if its own fault is the camera's.
        let seen = student.faces.iter().filter(|face| face.1 != student.screen).count();
        // Otherwise the lookup explains more than the camera.
        if student.screen != 0 && own <= seen && own < 6 {
            let left = left_by_a_camera(&student.grade(&photographs));
            assert!(left.is_some_and(|left| left <= own), "{:?} {}: {left:?}", student.faces, student.screen);
            cases += 1;
        }
        if cases == 8 {
            break;
        }
    }
}

fn report(grade: &Grade) -> String {
    let (lookup, table) = ("humus-z-up", Preset::HumusZUp.lookup());
    let world_up = SignedAxis::POS_Z;
    GradeReport { grade, map: "courtyard", lookup, lookup_given: true, table, world_up }.to_string()
}

#[test]
fn a_preset_seen_by_a_wrong_camera_is_named() {
    let photographs = courtyard(Preset::HumusZUp);
    for screen in [1, 2, 3] {
        let grade = Student { faces: EXERCISE, screen, ..RIGHT }.grade(&photographs);
        let preset = grade.preset.as_ref().unwrap();
        assert_eq!(
            (&preset.presets[..], preset.camera.orientation.formulas()),
            (&[Preset::Exercise][..], FORMULAS[screen])
        );
        let named = grade.alternatives.iter().any(|alternative| {
            matches!(alternative, Alternative::Both(camera, faces)
                if *camera == preset.camera && faces.iter().filter(|face| face.is_wrong()).count() == 5)
        });
        assert!(named, "{screen}: {:?}", grade.alternatives);
        let text = report(&grade);
        assert!(
            text.contains("a wrong camera and a wrong lookup together would make the same pictures with"),
            "{text}"
        );
        assert!(text.contains("; then case ") && text.contains("; and your code contains exactly the preset exercise"));
        assert!(text.contains("a camera is blamed if it leaves at most one face wrong"), "{text}");
    }
    // A mirrored camera would leave as many faces wrong, but it is no simpler.
    let grade = Student { faces: EXERCISE, ..RIGHT }.grade(&photographs);
    let text = report(&grade);
    assert!(text.contains("with as many wrong faces (5), but more changes in them: all six are mirrored"), "{text}");
    assert!(text.contains("\n  your code contains exactly the preset exercise"), "{text}");
    assert_eq!(grade.verdict(), GradeVerdict::Lookup);
    assert_eq!(grade.preset.unwrap().camera, CameraFault::NONE);
    assert_eq!(Student { faces: HUMUS, ..RIGHT }.grade(&photographs).preset, None);
}

/// What `grade` says of the shots of a lookup.
fn graded(shown: &[&str], arguments: &[&str]) -> String {
    let folder = tempfile::tempdir().unwrap();
    let map = Path::new(env!("CARGO_MANIFEST_DIR")).join("envmaps/courtyard");
    let run = |command: &str, path: &Path, more: &[&str]| {
        let mut skycube = Command::new(env!("CARGO_BIN_EXE_skycube"));
        let output = skycube.arg(command).arg(path).args(more).current_dir(folder.path()).output().unwrap();
        String::from_utf8(output.stdout).unwrap()
    };
    run("shots", &map, &[shown, &["--size", "128", "-o", "mine"]].concat());
    run("grade", Path::new("mine"), &[&["--map", map.to_str().unwrap()], arguments].concat())
}

#[test]
fn a_preset_in_the_code_is_named() {
    let opengl = ["--lookup", "opengl", "--world-up", "+z"];
    let text = graded(&opengl, &["--lookup", "humus-z-up"]);
    println!("{text}");
    assert!(text.contains("your code contains exactly the preset opengl"), "{text}");
    assert!(text.contains("use --lookup opengl --world-up +z if you meant that one"), "{text}");
    assert!(!text.contains("the camera is wrong, the lookup is right"), "{text}");
    assert!(!text.contains("--lookup was not given"), "{text}");
    let json = graded(&opengl, &["--lookup", "humus-z-up", "--json"]);
    let json = common::json_report(&json);
    assert_eq!(json["preset"], serde_json::json!({ "names": ["opengl"], "camera": "none" }));

    let text = graded(&["--lookup", "humus-z-up"], &[]);
    println!("{text}");
    assert!(text.contains("the lookup course (world up +z), the default because --lookup was not given"), "{text}");
    assert!(text.contains("your code contains exactly the preset humus-z-up"), "{text}");
    assert!(text.contains("use --lookup humus-z-up if you meant that one"), "{text}");
    let right = graded(&["--lookup", "humus-z-up"], &["--lookup", "humus-z-up"]);
    assert!(!right.contains("preset"), "{right}");
}
