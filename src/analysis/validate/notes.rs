//! Collecting the notes about a map beside the verdict.

use super::borders::border::Borders;
use super::borders::edge::{Border, Edge, Side};
use super::findings::Check;
use super::note::Note;
use super::options::CheckOptions;
use super::seam::Seam;
use super::search::convention::mirrored_faces;
use super::thresholds::seam::{EXPOSED, ROUGH};
use super::verdict::Verdict;
use crate::envmap::{Face, Preset};

/// All remarks in the order of the report.
pub fn collect(
    check: &Check,
    borders: &Borders,
    options: &CheckOptions,
    sky: Option<Face>,
    doubtful: &[Face],
) -> Vec<Note> {
    let mut notes = Vec::new();
    for outlier in &check.outliers {
        let image = check.fix.faces[outlier.face.index()].image;
        let file = check.images[image.index()].file.clone();
        notes.push(Note::Outlier { face: outlier.face, file, reason: outlier.reason });
    }
    sizes(check, &mut notes);
    pictures(check, borders, &mut notes);
    notes.extend(exposures(check, borders));
    let undecided: Vec<Face> = check.fix.faces.iter().filter(|fix| !fix.decided).map(|fix| fix.face).collect();
    if !undecided.is_empty() {
        notes.push(Note::Undecided { faces: undecided });
    }
    if !doubtful.is_empty() && check.verdict == Verdict::Undecidable {
        notes.push(Note::Doubtful { faces: doubtful.to_vec() });
    }
    rough(check, &mut notes);
    let after = mirrored_faces(&check.fix.lookup(&check.lookup));
    if !check.mirrored.is_empty() || !after.is_empty() {
        notes.push(Note::Mirrored { faces: check.mirrored.clone(), after, changes: check.fix.changes > 0 });
    }
    if options.world_up.is_none() && check.fix.changes > 0 {
        let lookup = options.lookup_name.clone();
        notes.push(Note::AssumedUp { up: Preset::usual_up_of(&lookup), lookup });
    }
    if let (Some(up), Some(sky)) = (options.world_up, sky) {
        let top = Face::on_axis(usize::from(up.axis), !up.negative);
        let there = check.fix.faces[top.index()].image == sky;
        notes.push(Note::Sky { sky, up, there, after_the_fix: check.fix.changes > 0 });
    }
    notes
}

/// Images whose mean along their borders differs from that of all neighbours after the fix in one direction.
fn exposures(check: &Check, borders: &Borders) -> Vec<Note> {
    let mean = |image: Face, side: Side| {
        let row = borders[image.index()].row(side, 0);
        row.iter().flatten().map(|&channel| f64::from(channel)).sum::<f64>() / (3 * row.len()) as f64
    };
    let lookup = check.fix.lookup(&check.lookup);
    let mut notes = Vec::new();
    for face in Face::ALL.into_iter().filter(|&face| check.outliers.iter().all(|outlier| outlier.face != face)) {
        let offset = |edge: &Edge| {
            let other = if edge.first == face { edge.second } else { edge.first };
            let side = |of: Face, towards: Face| Border::of_face(lookup.row(of), of, towards).side;
            mean(lookup.row(face).image, side(face, other)) - mean(lookup.row(other).image, side(other, face))
        };
        let offsets: Vec<f64> = Edge::ALL.iter().filter(|edge| edge.touches(face)).map(offset).collect();
        let least = offsets.iter().fold(f64::INFINITY, |least, offset| least.min(offset.abs()));
        let alike = offsets.iter().all(|&offset| offset > 0.0) || offsets.iter().all(|&offset| offset < 0.0);
        if alike && least > EXPOSED {
            notes.push(Note::Exposure { image: lookup.row(face).image, codes: offsets.iter().sum::<f64>() / 4.0 });
        }
    }
    notes
}

/// Sizes that no cube map may have.
fn sizes(check: &Check, notes: &mut Vec<Note>) {
    let unsquare: Vec<Face> =
        check.images.iter().filter(|facts| facts.width != facts.height).map(|facts| facts.face).collect();
    if !unsquare.is_empty() {
        notes.push(Note::NotSquare { images: unsquare });
        return;
    }
    let sizes = check.images.iter().map(|facts| facts.width);
    let (smallest, largest) = (sizes.clone().min().unwrap_or(0), sizes.max().unwrap_or(0));
    if smallest != largest {
        notes.push(Note::Sizes { smallest, largest });
    }
}

/// What single pictures are like.
fn pictures(check: &Check, borders: &Borders, notes: &mut Vec<Note>) {
    let framed: Vec<Face> = Face::ALL.into_iter().filter(|image| borders[image.index()].framed).collect();
    if !framed.is_empty() {
        notes.push(Note::Framed { images: framed });
    }
    let outlier = |image: Face| check.outliers.iter().any(|one| check.fix.faces[one.face.index()].image == image);
    let flat = |image: Face| borders[image.index()].is_flat() && !outlier(image);
    let flat: Vec<Face> = Face::ALL.into_iter().filter(|&image| flat(image)).collect();
    // Flat pictures look alike, which is said once.
    let same = |one: Face, other: Face| borders[one.index()].holds_the_same(&borders[other.index()]);
    let identical = groups(same).into_iter().filter(|group| !group.iter().all(|image| flat.contains(image)));
    notes.extend(identical.map(|images| Note::Identical { images }));
    if !flat.is_empty() {
        notes.push(Note::Flat { images: flat });
    }
    let alpha: Vec<Face> = check.images.iter().filter(|facts| facts.alpha).map(|facts| facts.face).collect();
    if !alpha.is_empty() {
        notes.push(Note::Alpha { images: alpha });
    }
}

/// The images that are the same as the first of their group, in groups of two and more.
fn groups(same: impl Fn(Face, Face) -> bool) -> Vec<Vec<Face>> {
    let mut groups: Vec<Vec<Face>> = Vec::new();
    for image in Face::ALL {
        match groups.iter_mut().find(|group| same(group[0], image)) {
            Some(group) => group.push(image),
            None => groups.push(vec![image]),
        }
    }
    groups.retain(|group| group.len() > 1);
    groups
}

/// Seams that are rough although the map fits, or would once it is fixed; and those that a fix leaves open.
fn rough(check: &Check, notes: &mut Vec<Note>) {
    if !check.outliers.is_empty() || check.verdict == Verdict::Undecidable {
        return;
    }
    let after_the_fix = check.fix.changes > 0;
    let rough = || check.fix.seams_after.iter().filter(|seam| seam.score > ROUGH);
    let open = |seam: &&Seam| seam.verdict == Verdict::Undecidable;
    let partly = check.verdict == Verdict::Broken && rough().any(|seam| open(&seam));
    let steps: Vec<f64> = rough().filter(|seam| !partly || open(seam)).map(|seam| seam.step).collect();
    if steps.is_empty() {
        return;
    }
    let (seams, step) = (steps.len(), steps.iter().sum::<f64>() / steps.len() as f64);
    notes.push(if partly {
        Note::Open { seams, step, after_the_fix }
    } else {
        Note::Rough { seams, step, after_the_fix }
    });
}
