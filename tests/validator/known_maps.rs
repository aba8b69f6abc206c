//! What is known of maps must be found: those of the project always, real ones where they are.

use std::path::{Path, PathBuf};

use super::pictures;
use crate::common;
use skycube::envmap::source::Skybox;
use skycube::envmap::{CubeFilter, CubeMap, Face, LazyImage, Lookup, Orientation, Preset, SignedAxis};
use skycube::error::Error;
use skycube::picture::Picture;
use skycube::report::{CheckReport, CheckedMap, Look, MapCheck, Page, Totals, check_json, map_line, totals_line};
use skycube::validate::{Check, CheckOptions, Convention, ImageFacts, Level, Names, Note, Verdict, check, load};

fn options(lookup: Preset, world_up: Option<SignedAxis>) -> CheckOptions {
    CheckOptions { world_up, names: Names::Auto, lookup_name: lookup.name().to_owned() }
}

fn checked(path: &Path, lookup: Preset, world_up: Option<SignedAxis>) -> Check {
    let skybox = Skybox::open(path).unwrap();
    let map = load(&skybox, lookup.lookup()).unwrap();
    check(&map, ImageFacts::of_skybox(&skybox), &options(lookup, world_up)).unwrap()
}

fn compass() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("envmaps/compass")
}

/// The compass named for a z-up world, as `course` reads it.
fn compass_for_z_up() -> [Picture; 6] {
    let skybox = Skybox::open(&compass()).unwrap();
    let images = skybox.images.clone().map(|image| image.decode().unwrap());
    let read = Preset::HumusZUp.lookup();
    Face::ALL.map(|face| images[read.row(face).image.index()].clone())
}

fn check_pictures(pictures: [Picture; 6], lookup: Lookup, options: &CheckOptions) -> Check {
    let facts = Face::ALL.map(|face| {
        let header = pictures[face.index()].header();
        let file = format!("{}.png", face.name());
        ImageFacts {
            face,
            file,
            width: header.width,
            height: header.height,
            format: header.format,
            alpha: header.alpha,
        }
    });
    let map = CubeMap::new(pictures.map(LazyImage::ready), lookup, CubeFilter::Nearest);
    check(&map, facts.to_vec(), options).unwrap()
}

/// The changes as one line: `posx u = 1-u; posz reads negz`.
fn changes(check: &Check) -> String {
    let mut changes = Vec::new();
    for fix in check.fix.faces.iter().filter(|fix| !fix.is_unchanged(&check.lookup)) {
        let (u, v) = fix.orientation.formulas();
        let image = if fix.image == fix.face { String::new() } else { format!(" reads {}", fix.image.name()) };
        changes.push(format!("{}{image} ({u}, {v})", fix.face.name()));
    }
    changes.join("; ")
}

const EXERCISE_FIXES: &str = "posx (1-u, v); negy (1-u, v); posz (u, 1-v)";

#[test]
fn the_exercise_is_corrected_on_a_z_up_map() {
    for world_up in [None, Some(SignedAxis::POS_Z)] {
        let options = options(Preset::Exercise, world_up);
        let check = check_pictures(compass_for_z_up(), Preset::Exercise.lookup(), &options);
        assert_eq!((check.verdict, changes(&check).as_str()), (Verdict::Broken, EXERCISE_FIXES));
        assert_eq!(check.fix.convention, Some(Convention::Course));
        assert_eq!(check.fix.lookup(&check.lookup), Preset::Course.lookup());
    }
}

#[test]
fn the_exercise_is_corrected_on_a_download() {
    let own = compass().with_file_name("courtyard");
    for map in [Some(own), common::shared_map("Meadow.zip")].into_iter().flatten() {
        let check = checked(&map, Preset::Exercise, Some(SignedAxis::POS_Z));
        assert_eq!(check.fix.lookup(&check.lookup), Preset::HumusZUp.lookup());
        assert_eq!(check.fix.convention, Some(Convention::HumusZUp));
        let orientations = check.fix.faces.map(|fix| fix.orientation.formulas());
        let as_is = ("u", "v");
        assert_eq!(orientations, [("1-u", "v"), as_is, as_is, ("1-u", "v"), ("u", "1-v"), as_is]);
    }
}

#[test]
fn where_the_sky_lies_does_not_break_a_map_that_fits() {
    let courtyard = compass().with_file_name("courtyard");
    for up in [SignedAxis::POS_X, SignedAxis::POS_Y, SignedAxis::NEG_Z, SignedAxis::POS_Z] {
        let check = checked(&courtyard, Preset::Opengl, Some(up));
        assert_eq!((check.verdict, check.fix.changes), (Verdict::Fits, 0), "{up}");
        let notes: Vec<String> = check.notes.iter().map(ToString::to_string).collect();
        let (there, elsewhere) = (format!("at the declared up axis {up}"), ", not at the declared up axis");
        let said =
            notes.iter().any(|note| note.contains(&there) && note.contains(elsewhere) != (up == SignedAxis::POS_Y));
        assert!(said, "{up}: {notes:?}");
    }
}

#[test]
fn right_maps_fit() {
    let right = checked(&compass(), Preset::Opengl, None);
    assert_eq!((right.verdict, right.fix.changes), (Verdict::Fits, 0));
    let own = ["hall", "night", "seaside"].map(|name| compass().with_file_name(name));
    let real = ["meadow", "Meadow.zip", "studio-garden", "layouts/storm-cross.jpg", "layouts/ryfjallet-strip.png"];
    for map in own.into_iter().chain(real.into_iter().filter_map(common::shared_map)) {
        let check = checked(&map, Preset::Opengl, None);
        assert_eq!((check.verdict, check.fix.changes), (Verdict::Fits, 0), "{}", map.display());
        assert_eq!(check.mirrored, Face::ALL, "{}", map.display());
        let notes: Vec<String> = check.notes.iter().map(ToString::to_string).collect();
        assert!(
            notes.iter().any(|note| note.contains("a right-handed world sees all six faces mirrored")),
            "{notes:?}"
        );
    }
}

/// The courtyard as files in the orders of other programs, under their names.
#[test]
fn conventions_are_named() {
    use Convention::{BottomUp, OpenExr, Quake, Unity};
    let axes = Face::ALL.map(Face::name);
    let cells = axes.map(|face| format!("map.exr [{face} cell]"));
    let known = [
        (BottomUp, [0, 1, 2, 3, 4, 5], 2, axes),
        (Quake, [4, 5, 2, 3, 0, 1], 0, ["rt", "lf", "up", "dn", "ft", "bk"]),
        (Unity, [1, 0, 2, 3, 4, 5], 0, ["_RightTex", "_LeftTex", "_UpTex", "_DownTex", "_FrontTex", "_BackTex"]),
        (OpenExr, [0, 1, 2, 3, 5, 4], 0, cells.each_ref().map(String::as_str)),
    ];
    let courtyard = pictures::project_map("courtyard").stored(&pictures::Storage::png(256));
    for (convention, images, orientation, names) in known {
        let files = courtyard.damaged(&images, &[Orientation::ALL[orientation]; 6]);
        let check = files.check_named(Names::Auto, names);
        assert_eq!((check.verdict, check.fix.convention), (Verdict::Broken, Some(convention)), "{names:?}");
    }
}

#[test]
fn conventions_of_real_maps_are_named() {
    use Convention::{BottomUp, OpenExr, Quake};
    let known = [
        ("city-upside-down", BottomUp),
        ("miramar-quake", Quake),
        ("clouds-dusk", Quake),
        ("openexr/KernerEnvCube.exr", OpenExr),
        ("openexr/OrientationCube.exr", OpenExr),
    ];
    for (name, convention) in known {
        let Some(map) = common::shared_map(name) else { continue };
        let check = checked(&map, Preset::Opengl, None);
        assert_eq!((check.verdict, check.fix.convention), (Verdict::Broken, Some(convention)), "{name}");
    }
}

#[test]
fn a_flat_sky_and_flat_ground_are_undecided() {
    let seaside = Some((compass().with_file_name("seaside"), Face::PosY));
    let miramar = common::shared_map("miramar-quake").map(|map| (map, Face::NegY));
    for (map, flat) in [seaside, miramar].into_iter().flatten() {
        let check = checked(&map, Preset::Opengl, None);
        let undecided = check.fix.faces.iter().filter(|fix| !fix.decided);
        assert_eq!(undecided.map(|fix| fix.face).collect::<Vec<Face>>(), [flat], "{}", map.display());
        assert_eq!(check.fix.equivalents, 8, "{}", map.display());
    }
}

/// A page as it is in a file, and on terminals of 120, 80 and 60 columns; in colours, where an escape is written ␛, at 80.
fn looks(page: &Page) -> String {
    let shown = |width: Option<usize>, colour: bool| page.shown(Look { width, colour });
    let mut looks = format!("--- file\n{}", shown(None, false));
    for columns in [120, 80, 60] {
        let (plain, coloured) = (shown(Some(columns), false), shown(Some(columns), true));
        assert_eq!(anstream::adapter::strip_str(&coloured).to_string(), plain, "colours change nothing else");
        assert!(plain.lines().all(|line| line.chars().count() <= columns), "{columns} columns:\n{plain}");
        looks += &format!("--- {columns} columns\n{plain}");
    }
    looks + "--- 80 columns, in colours\n" + &shown(Some(80), true).replace('\u{1b}', "␛")
}

#[test]
fn the_report_on_a_right_map() {
    let check = checked(&compass(), Preset::Opengl, None);
    let report = CheckReport::new("compass".to_owned(), &check);
    assert_eq!(report.to_string().lines().count(), 3);
    insta::assert_snapshot!("compass_text", looks(&report.page(false)));
    let json = check_json(&[CheckedMap::new("compass", Ok(check))]);
    common::json_report(&json);
    insta::assert_snapshot!("compass_json", json);
}

#[test]
fn the_report_on_the_exercise() {
    let options = options(Preset::Exercise, None);
    let check = check_pictures(compass_for_z_up(), Preset::Exercise.lookup(), &options);
    let report = CheckReport::new("compass".to_owned(), &check);
    insta::assert_snapshot!("exercise_text", looks(&report.page(false)));
    insta::assert_snapshot!("exercise_verbose", looks(&report.page(true)));
    let json = check_json(&[CheckedMap::new("compass", Ok(check))]);
    common::json_report(&json);
    insta::assert_snapshot!("exercise_json", json);
}

/// The kinds, levels and files of what was found, remarks left out.
fn faults(check: &Check) -> Vec<(&'static str, Level, String)> {
    let found = check.findings().into_iter().filter(|finding| finding.level != Level::Note);
    found.map(|finding| (finding.kind, finding.level, finding.files.join(" "))).collect()
}

#[test]
fn findings_name_the_kind_the_level_and_the_files() {
    assert_eq!(faults(&swapped()), [("exchanged", Level::Error, "posx.png posz.png".to_owned())]);
    let turned = turned();
    assert_eq!(faults(&turned), [("edited", Level::Error, "posy.png".to_owned())]);
    assert_eq!(turned.findings()[0].sentence, "posy.png: turn 90° clockwise");
    let copied = faulty(|pictures| pictures[0] = pictures[4].clone());
    assert_eq!(faults(&copied), [("outlier", Level::Error, "posx.png".to_owned())]);
    let figures = serde_json::json!({ "face": "posx", "reason": "copy", "copy_of": "posz" });
    assert_eq!(copied.findings()[0].figures, figures);
    let fits = faulty(|_| ());
    assert_eq!((fits.verdict, faults(&fits)), (Verdict::Fits, vec![]));
    let flat = faulty(|pictures| *pictures = [(); 6].map(|()| pictures::computed(64, |_, _| [128.0; 3])));
    assert_eq!((flat.verdict, faults(&flat)[0].0), (Verdict::Undecidable, "undecidable"));
}

/// The compass with one fault.
fn faulty(fault: impl Fn(&mut [Picture; 6])) -> Check {
    let skybox = Skybox::open(&compass()).unwrap();
    let mut pictures = skybox.images.clone().map(|image| image.decode().unwrap());
    fault(&mut pictures);
    check_pictures(pictures, Preset::Opengl.lookup(), &options(Preset::Opengl, None))
}

#[test]
fn the_report_says_how_seams_are_judged_and_counts_in_good_grammar() {
    let check = checked(&compass().with_file_name("courtyard"), Preset::Exercise, Some(SignedAxis::POS_Z));
    let report = CheckReport::new("courtyard".to_owned(), &check).page(true).shown(Look::default());
    assert!(report.contains("score = step / max(detail, 0.5)"), "{report}");
    assert!(report.contains("verdict: not by the score, but by comparing orientations"), "{report}");
    let rough = check.fix.seams_after.iter().filter(|seam| seam.score > 3.0).count();
    assert_eq!(check.verdict, Verdict::Broken);
    assert!(rough > 0 && report.contains(&format!("{rough} of 12 seams")), "{report}");
    assert!(report.contains("rough after the fix"), "{report}");
    let one = Note::Rough { seams: 1, step: 4.0, after_the_fix: false }.to_string();
    assert!(one.starts_with("1 of 12 seams is rough (mean step"), "{one}");
    let mirrored = Note::Mirrored { faces: Vec::new(), after: vec![Face::PosY], changes: true }.to_string();
    assert!(mirrored.contains("sees no face mirrored now, and posy after the fix"), "{mirrored}");
    // Where images change places, seams leave open how the cube as a whole is turned and mirrored.
    let swapped = faulty(|images| images.swap(0, 2));
    let report = CheckReport::new("swapped".to_owned(), &swapped).page(true).shown(Look::default());
    let count = "equally good orientations: 48; the simplest one is shown, seams cannot tell them apart";
    assert!(report.contains(count) && report.contains("has 48 rotations and mirrorings"), "{report}");
}

fn looks_of(name: &str, check: &Check) -> String {
    looks(&CheckReport::new(name.to_owned(), check).page(false))
}

fn swapped() -> Check {
    faulty(|pictures| pictures.swap(0, 4))
}

fn turned() -> Check {
    faulty(|pictures| pictures[2] = pictures::oriented(&pictures[2], Orientation::ALL[4]))
}

/// A map of six pictures of one colour.
fn uniform() -> Check {
    faulty(|pictures| *pictures = Face::ALL.map(|_| pictures::computed(64, |_, _| [128.0; 3])))
}

#[test]
fn the_report_on_swapped_faces() {
    insta::assert_snapshot!("swapped_text", looks_of("swapped", &swapped()));
}

#[test]
fn the_report_on_a_turned_face() {
    insta::assert_snapshot!("turned_text", looks_of("turned", &turned()));
}

#[test]
fn the_report_on_pictures_stored_from_the_bottom_up() {
    let upside_down = Orientation::ALL[2];
    let courtyard = Skybox::open(&compass().with_file_name("courtyard")).unwrap();
    let stored = courtyard.images.clone().map(|image| pictures::oriented(&image.decode().unwrap(), upside_down));
    let check = check_pictures(stored, Preset::Opengl.lookup(), &options(Preset::Opengl, None));
    assert_eq!(check.fix.convention, Some(Convention::BottomUp));
    insta::assert_snapshot!("bottom_up_text", looks_of("bottom-up", &check));
}

#[test]
fn the_report_on_six_pictures_of_one_colour() {
    let check = uniform();
    assert_eq!(check.verdict, Verdict::Undecidable);
    let flat: Vec<&Note> = check.notes.iter().filter(|note| matches!(note, Note::Flat { .. })).collect();
    assert_eq!(flat, [&Note::Flat { images: Face::ALL.to_vec() }], "said once");
    assert!(!check.notes.iter().any(|note| matches!(note, Note::Identical { .. })), "{:?}", check.notes);
    insta::assert_snapshot!("uniform_text", looks_of("uniform", &check));
}

#[test]
fn the_report_on_a_grey_face() {
    let check = faulty(|pictures| pictures[3] = pictures::computed(pictures[3].width(), |_, _| [128.0; 3]));
    insta::assert_snapshot!("grey_text", looks_of("grey", &check));
}

#[test]
fn the_report_on_a_copied_face() {
    let check = faulty(|pictures| pictures[0] = pictures[4].clone());
    insta::assert_snapshot!("copied_text", looks_of("copied", &check));
}

#[test]
fn the_report_on_a_folder_of_maps() {
    let right = checked(&compass(), Preset::Opengl, None);
    let missing = Err(Error::new("no file in it has the name of a cube face"));
    let maps: Vec<MapCheck> = [("right", Ok(right)), ("swapped", Ok(swapped())), ("turned", Ok(turned()))]
        .into_iter()
        .chain([("uniform", Ok(uniform())), ("missing", missing)])
        .map(|(name, check)| (format!("Skyboxes/{name}"), check))
        .collect();
    let mut page = Page::default();
    maps.iter().for_each(|map| page.append(map_line(map)));
    page.append(totals_line(&Totals::of(&maps)));
    insta::assert_snapshot!("folder_text", looks(&page));
}

/// The step across an edge measured with directions alone: just inside either face, through `CubeMap::sample`.
fn sampled_step(map: &CubeMap, edge: skycube::validate::Edge, size: usize) -> f64 {
    let free = 3 - edge.first.axis() - edge.second.axis();
    let inside = 1.0 - 1.0 / size as f32;
    let mut sum = 0.0;
    for texel in 0..size {
        let along = 2.0 * (texel as f32 + 0.5) / size as f32 - 1.0;
        let colour = |face: Face, neighbour: Face| {
            let mut direction = face.normal() + inside * neighbour.normal();
            direction[free] = along;
            map.sample(direction).to_array().map(|value| (255.0 * skycube::colour::encode_srgb(value)).round())
        };
        let (one, other) = (colour(edge.first, edge.second), colour(edge.second, edge.first));
        sum += (0..3).map(|channel| f64::from((one[channel] - other[channel]).abs())).sum::<f64>() / 3.0;
    }
    sum / size as f64
}

#[test]
fn steps_are_those_that_directions_see_before_and_after_the_fix() {
    let skybox = Skybox::open(&compass()).unwrap();
    let size = skybox.image(Face::PosX).header().width;
    for lookup in [Preset::Exercise, Preset::HumusYUp, Preset::Opengl] {
        let map = load(&skybox, lookup.lookup()).unwrap();
        let check = check(&map, ImageFacts::of_skybox(&skybox), &options(lookup, None)).unwrap();
        let repaired = load(&skybox, check.fix.lookup(&check.lookup)).unwrap();
        for (map, seams) in [(&map, &check.seams), (&repaired, &check.fix.seams_after)] {
            assert_eq!(seams.len(), 12);
            for seam in seams {
                let seen = sampled_step(map, seam.edge, size);
                assert!(
                    (seen - seam.step).abs() < 1e-6,
                    "{} {}: {seen} {}",
                    lookup.name(),
                    seam.edge.name(),
                    seam.step
                );
            }
        }
        assert!(check.fix.seams_after.iter().all(|seam| seam.score < 3.0), "{}", lookup.name());
    }
}
