//! What to do about a broken map, in the names of the user's files, and what happened to them.

use crate::envmap::{Face, ImageOperation, Lookup, Orientation, Preset};
use crate::validate::{Check, FaceFix, Note, Story, Verdict, exchange_reason, joined, listed, rings, why_outlier};

/// Something to do, and why.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Repair {
    /// `posx.jpg: turn 90° clockwise`.
    pub what: String,
    /// What happened, as a sentence; `None` if there is no more to say.
    pub why: Option<String>,
}

impl Repair {
    fn new(what: String) -> Self {
        Self { what, why: None }
    }
}

/// Everything to do, in an order in which it may be done: files are edited under the names that they have now, then exchanged.
pub fn repairs(check: &Check) -> Vec<Repair> {
    let mut repairs = Vec::new();
    if check.fix.changes > 0 {
        let order = check.fix.story.order;
        let preset = order.and_then(|order| order.preset());
        let reason = order.map(|order| order.reason().to_owned());
        if let Some(preset) = preset {
            repairs.push(Repair { what: format!("use --lookup {}", preset.name()), why: reason.clone() });
        }
        // What is left to do once that lookup is used.
        let base = preset.map_or(check.lookup, Preset::lookup);
        let fixed = check.fix.lookup(&check.lookup);
        let mut files = [edits(check, &base, &fixed), exchanges(check, &base, &fixed)].concat();
        if let (Some(last), None, Some(reason)) = (files.last_mut(), preset, reason) {
            last.why = Some(reason);
        }
        repairs.extend(files);
    }
    repairs.extend(check.unrepaired().into_iter().flat_map(|note| beyond_repair(note, check)));
    if repairs.is_empty() && check.verdict == Verdict::Broken {
        let what = "look at the pictures: something does not fit, but no change is certain".to_owned();
        repairs.push(Repair::new(what));
    }
    repairs
}

/// The files to turn and flip between two lookups, those with the same operation together.
fn edits(check: &Check, base: &Lookup, fixed: &Lookup) -> Vec<Repair> {
    let v_origin = fixed.v_origin();
    let mut edits: Vec<(ImageOperation, Vec<String>)> = Vec::new();
    for face in Face::ALL {
        let orientation = Orientation::between(base.row_counted_from(face, v_origin), fixed.row(face));
        let operation = orientation.image_operation(v_origin);
        let file = file(check, fixed.row(face).image).to_owned();
        match edits.iter_mut().find(|(known, _)| *known == operation) {
            _ if operation == ImageOperation::None => {}
            Some((_, files)) => files.push(file),
            None => edits.push((operation, vec![file])),
        }
    }
    edits.iter().map(|(operation, files)| Repair::new(format!("{}: {}", listed(files), operation.name()))).collect()
}

/// The files to exchange between two lookups.
fn exchanges(check: &Check, base: &Lookup, fixed: &Lookup) -> Vec<Repair> {
    let images = |lookup: &Lookup| Face::ALL.map(|face| lookup.row(face).image);
    let rings = rings(&images(base), &images(fixed));
    let repair =
        |ring: &Vec<Face>| Repair { what: exchange(ring, check), why: exchange_reason(ring).map(str::to_owned) };
    rings.iter().map(repair).collect()
}

/// `exchange posx.jpg and negx.jpg`; a longer ring names the place of each file.
fn exchange(ring: &[Face], check: &Check) -> String {
    if let [one, other] = ring {
        return format!("exchange {} and {}", file(check, *one), file(check, *other));
    }
    let next = ring.iter().cycle().skip(1);
    let moves: Vec<String> =
        ring.iter().zip(next).map(|(place, image)| format!("{} as {}", file(check, *image), place.name())).collect();
    format!("read {}", joined(&moves))
}

/// What to do about a picture that no lookup repairs.
fn beyond_repair(note: &Note, check: &Check) -> Vec<Repair> {
    match note {
        Note::Outlier { file, reason, .. } => vec![Repair {
            what: format!("{file}: replace this picture: it does not belong here"),
            why: Some(format!("{file}: {}", why_outlier(*reason, &check.file_names()))),
        }],
        Note::NotSquare { images } => vec![make_square(images, note, check)],
        Note::Sizes { .. } => vec![Repair { what: scale(check), why: Some(note.to_string()) }],
        _ => Vec::new(),
    }
}

fn make_square(images: &[Face], note: &Note, check: &Check) -> Repair {
    let size = |image: &Face| {
        let facts = &check.images[image.index()];
        format!("{} ({} x {} texels)", facts.file, facts.width, facts.height)
    };
    Repair {
        what: format!("{}: crop or scale to a square", joined(&images.iter().map(size).collect::<Vec<_>>())),
        why: Some(note.sentence(&check.file_names())),
    }
}

/// Which pictures to scale so that all have the size of most.
fn scale(check: &Check) -> String {
    let sizes = || check.images.iter().map(|facts| facts.width);
    let count = |size: usize| sizes().filter(|&other| other == size).count();
    let most = sizes().max_by_key(|&size| (count(size), size)).unwrap_or(0);
    let others = check.images.iter().filter(|facts| facts.width != most).map(|facts| facts.file.clone());
    format!("{}: scale to {most} x {most} texels, the size of the others", joined(&others.collect::<Vec<_>>()))
}

/// What to do about the picture that each face shows under the lookup, in few words: `turn 90° clockwise, belongs at +X`.
pub fn picture_repairs(check: &Check) -> [Option<String>; 6] {
    Face::ALL.map(|face| {
        let image = check.lookup.row(face).image;
        let fix = check.fix.faces.iter().find(|fix| fix.image == image)?;
        if check.outliers.iter().any(|outlier| outlier.face == fix.face) {
            return Some("does not belong here".to_owned());
        }
        let edit = (fix.orientation != Orientation::IDENTITY).then(|| fix.image_operation.name());
        let place = (fix.face != face).then(|| format!("belongs at {}", fix.face.signed_name().to_uppercase()));
        let words: Vec<String> = edit.into_iter().chain(place).collect();
        (!words.is_empty()).then(|| words.join(", "))
    })
}

/// Another story of the same length, in the names of the files.
pub fn retold(story: &Story, check: &Check) -> String {
    let order = story.order.map(|order| order.to_string());
    let exchanges = story.exchanged.iter().map(|ring| exchange(ring, check));
    let edited: Vec<String> = story.edited.iter().map(|face| check.file_names().faces[face.index()].clone()).collect();
    let edits = (!edited.is_empty()).then(|| format!("turn or flip {}", joined(&edited)));
    let parts: Vec<String> = order.into_iter().chain(exchanges).chain(edits).collect();
    if parts.is_empty() { "nothing to change".to_owned() } else { parts.join("; ") }
}

/// What to change in the code of the lookup instead: a line for each face, or one for all six.
pub fn code(check: &Check) -> Vec<String> {
    let changed: Vec<&FaceFix> = check.fix.faces.iter().filter(|fix| !fix.is_unchanged(&check.lookup)).collect();
    let lines: Vec<String> = changed.iter().map(|fix| statements(fix, check)).collect();
    if lines.len() == 6 && lines.iter().all(|line| *line == lines[0]) {
        return vec![format!("in every case: {}", lines[0])];
    }
    changed.iter().zip(lines).map(|(fix, line)| format!("case {}: {line}", fix.face.constant_name())).collect()
}

/// The image that the face reads, and the statements that change u, v to u', v', after those that compute u and v.
pub fn statements(fix: &FaceFix, check: &Check) -> String {
    let image = format!("image = {};", fix.image.constant_name());
    let reads_another = fix.image != check.lookup.row(fix.face).image;
    let Orientation { swaps, inverts_u, inverts_v } = fix.orientation;
    // After the swap u holds the old v, so the inversions read alike with and without it.
    let all =
        [(reads_another, image.as_str()), (swaps, "swap(u, v);"), (inverts_u, "u = 1 - u;"), (inverts_v, "v = 1 - v;")];
    all.into_iter().filter(|(needed, _)| *needed).map(|(_, text)| text).collect::<Vec<_>>().join(" ")
}

/// The name of the file of an image.
fn file(check: &Check, image: Face) -> &str {
    &check.images[image.index()].file
}
