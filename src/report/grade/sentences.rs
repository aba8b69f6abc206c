//! The faults of cameras and lookups in plain sentences, for the report of `skycube grade`.

use crate::envmap::{Face, ImageOperation, Orientation, Preset, SignedAxis, VOrigin};
use crate::grade::{Alternative, CameraFault, Cause, FaceGrade, Misfit, PresetReading};

/// A slip in the code, and how to repair it.
pub(super) fn cause(cause: Cause, v_origin: VOrigin) -> String {
    match cause {
        Cause::VFromTheOtherEnd => {
            let (yours, right) = if v_origin == VOrigin::Bottom { ("top", "bottom") } else { ("bottom", "top") };
            format!(
                "v = 0 is the {yours} row in your get_texel and should be the {right} row: use 1 - v where you compute the row"
            )
        }
        Cause::UFromTheOtherEnd => {
            "u = 0 is the right column in your get_texel and should be the left one: use u where you use 1 - u"
                .to_owned()
        }
        Cause::AbsForgotten => {
            "abs() is missing: you divide by the component itself, which is negative on negx, negy and negz, so both \
             coordinates change their signs there"
                .to_owned()
        }
        Cause::NotHalved => "the coordinates are not halved: 0.5 + x / m in place of 0.5 + 0.5 * x / m".to_owned(),
        Cause::CasesExchanged([one, other]) => {
            format!("the cases {} and {} of the switch are exchanged", one.constant_name(), other.constant_name())
        }
        Cause::OneCoordinateTwice(face) => {
            format!(
                "case {}: u is used for v, or v for u: nothing changes along the rows or the columns of the shot",
                face.constant_name()
            )
        }
        Cause::UpAlongTheView => "the shots along the vertical axis are black: up is parallel to the view there, so \
                                  right = forward x up is zero; take the up vectors listed above"
            .to_owned(),
    }
}

/// What would be wrong had the camera of a shot another up vector.
pub(super) fn other_up(face: Face, taken: SignedAxis, ups: &[(SignedAxis, Orientation)]) -> String {
    let ups: Vec<String> = ups.iter().map(|&(up, orientation)| format!("{up}: {}", coordinates(orientation))).collect();
    format!("{} was judged with up = {taken}; if your up differs, its case needs: {}", face.name(), ups.join("; "))
}

/// The repair of code that does not divide.
pub(super) const DIVISION: &str =
    "tmp = 1 / |largest component|; u = (first * tmp + 1) / 2; v = (second * tmp + 1) / 2";

/// `case NEG_Y: u = 1 - u`, to stand after the code's own computation.
pub(super) fn repair(face: &FaceGrade) -> String {
    let mut parts = Vec::new();
    if let Some(placement) = face.placement().filter(|placement| placement.image != face.expected) {
        parts.push(format!("image = {} instead of {}", face.expected.constant_name(), placement.image.constant_name()));
    }
    let orientation = face.repair().unwrap_or(Orientation::IDENTITY);
    if orientation != Orientation::IDENTITY {
        parts.push(coordinates(orientation));
    }
    let open = if face.is_decided() { "" } else { "   (one of several that the pixels cannot tell apart)" };
    format!("case {}: {}{open}", face.face.constant_name(), parts.join("; "))
}

/// The new u and v as assignments.
fn coordinates(orientation: Orientation) -> String {
    let spaced = |formula: &str| formula.replace('-', " - ");
    let (u, v) = orientation.formulas();
    match (orientation.swaps, orientation.inverts_u, orientation.inverts_v) {
        (true, ..) => format!("(u, v) = ({}, {})", spaced(u), spaced(v)),
        (false, true, false) => "u = 1 - u".to_owned(),
        (false, false, true) => "v = 1 - v".to_owned(),
        _ => "u = 1 - u; v = 1 - v".to_owned(),
    }
}

/// What a wrong camera does, by the frame right = forward x up, top = right x forward.
pub(super) fn describe(camera: CameraFault) -> String {
    if camera.exchanges_axes() {
        let [x, y, z] = camera.axes;
        let turned = match camera.orientation {
            Orientation::IDENTITY => String::new(),
            _ => format!(", and every picture has another orientation ({})", camera.image_operation().name()),
        };
        return format!(
            "the axes are exchanged: your camera looks along {x} for +x, {y} for +y, {z} for +z{turned}; or the shots \
             are named after other axes"
        );
    }
    format!("all six are {}", placed_by(camera.image_operation()))
}

/// The wrong formulas that give every picture this orientation.
fn placed_by(operation: ImageOperation) -> &'static str {
    match operation {
        ImageOperation::None => "placed correctly",
        ImageOperation::FlipLeftRight => {
            "mirrored left-right: x of the pixel has the wrong sign (columns are counted from the right), or right \
             alone has it (negated after top = right x forward was computed, or right = up x forward where top is not \
             computed from right)"
        }
        ImageOperation::FlipTopBottom => {
            "upside down, mirrored top-bottom: rows are counted from the bottom, or top points down (top = forward x \
             right in place of right x forward)"
        }
        ImageOperation::Turn180 => {
            "turned by 180°: right = up x forward in place of forward x up (top = right x forward then changes its \
             sign, too), or x and y of the pixel both have the wrong sign, or the picture plane lies behind the eye"
        }
        ImageOperation::TurnClockwise => {
            "turned by 90° clockwise: rows and columns, or right and top, are exchanged, and one of the two has the \
             wrong sign"
        }
        ImageOperation::TurnCounterclockwise => {
            "turned by 90° counterclockwise: rows and columns, or right and top, are exchanged, and one of the two \
             has the wrong sign"
        }
        ImageOperation::Transpose => {
            "mirrored about the diagonal from the top left: rows and columns are exchanged, or right and top are, both \
             with the wrong sign"
        }
        ImageOperation::Transverse => {
            "mirrored about the diagonal from the top right: right and top are exchanged, or rows and columns are, \
             both counted from the wrong end"
        }
    }
}

fn names(faces: &[Face]) -> String {
    faces.iter().map(|face| face.name()).collect::<Vec<_>>().join(", ")
}

/// Another explanation of shots that were explained by these faces.
pub(super) fn other_explanation(alternative: &Alternative, grades: &[FaceGrade; 6]) -> String {
    match alternative {
        Alternative::Lookup(faces) => {
            format!(
                "a right camera and a wrong lookup would make the same pictures: {} (the camera is named because it \
                 explains more: {BLAMED})",
                repairs(faces)
            )
        }
        Alternative::Camera(camera) => format!(
            "a right lookup and a wrong camera would make the same pictures: {} (the lookup is named because it is \
             wrong at {} alone; {BLAMED})",
            describe(*camera),
            faces(grades.iter().filter(|face| face.is_wrong()).count())
        ),
        Alternative::Both(camera, others) => both(*camera, others, grades),
        Alternative::Rolled(shots) => format!(
            "a right lookup would make the same pictures with another up vector of the camera in {}: compare yours \
             with the output of `skycube shots`",
            names(shots)
        ),
        Alternative::Exchanged(pairs) => {
            let pair =
                |(shot, other): &(Face, Face)| format!("{} is the shot along {}", shot.name(), other.signed_name());
            let pairs: Vec<String> = pairs.iter().map(pair).collect();
            format!("a right lookup would make the same pictures if the files were named wrongly: {}", pairs.join(", "))
        }
    }
}

/// What decides between camera and lookup.
const BLAMED: &str = "a camera is blamed if it leaves at most one face wrong, and at least three fewer than a right \
                      camera";

/// A wrong camera and a wrong lookup together, where the lookup alone has all of `alone` wrong.
fn both(camera: CameraFault, grades: &[FaceGrade; 6], alone: &[FaceGrade; 6]) -> String {
    let [left, wrong] = [grades, alone].map(|faces| faces.iter().filter(|face| face.is_wrong()).count());
    let [more, fewer] = [grades, alone].map(|faces| faces.iter().map(FaceGrade::changes).sum::<usize>());
    let together = "a wrong camera and a wrong lookup together would make the same pictures";
    let camera = describe(camera);
    if left == wrong && more > fewer {
        return format!(
            "{together} with as many wrong faces ({left}), but more changes in them: {camera} (the lookup alone is \
             named because {BLAMED})"
        );
    }
    let count = if left == wrong { format!("as many wrong faces ({left})") } else { wrong_faces(left, wrong) };
    format!(
        "{together} with {count}: {camera}; then {} (the lookup alone is named because {BLAMED}; compare your camera \
         with the output of `skycube shots`)",
        repairs(grades)
    )
}

fn wrong_faces(left: usize, wrong: usize) -> String {
    format!("{left} wrong face{} in place of {wrong}", if left == 1 { "" } else { "s" })
}

pub(super) fn faces(count: usize) -> String {
    if count == 1 { "1 face".to_owned() } else { format!("{count} faces") }
}

fn repairs(faces: &[FaceGrade; 6]) -> String {
    faces.iter().filter(|face| face.is_wrong()).map(repair).collect::<Vec<_>>().join(", ")
}

/// The preset that the code contains, and how to judge by it; `blamed` is the camera of the verdict.
pub(super) fn preset(reading: &PresetReading, blamed: CameraFault, world_up: SignedAxis) -> String {
    let names = reading.presets.iter().map(|preset| preset.name()).collect::<Vec<_>>().join(" or ");
    let subject = match reading.camera {
        camera if camera == blamed => "your code contains".to_owned(),
        CameraFault::NONE => "or the camera is right, and your code contains".to_owned(),
        camera => format!("or {}; and your code contains", describe(camera)),
    };
    let exactly = format!("{subject} exactly the preset {names}, as far as the pixels show");
    match reading.presets[..] {
        [Preset::Exercise] => format!("{exactly}: the formula of the sheet for +X, repeated by analogy"),
        [preset, ..] => {
            let axis = if preset.usual_up() == world_up { String::new() } else { format!(" --world-up {world_up}") };
            format!("{exactly}: use --lookup {}{axis} if you meant that one", preset.name())
        }
        [] => exactly,
    }
}

/// What the pixels leave open.
pub(super) fn undecided(face: &FaceGrade) -> String {
    let mut images: Vec<Face> = face.possible.iter().map(|placement| placement.image).collect();
    images.sort();
    images.dedup();
    let orientations = face.possible.len();
    let what = match images[..] {
        [image] => format!("image {} in {orientations} orientations", image.name()),
        _ => format!("images {} in {orientations} orientations", names(&images)),
    };
    let right = if face.is_wrong() { "" } else { ", the right one among them" };
    format!("face {} is undecided: the pixels fit {what}{right}", face.face.signed_name())
}

pub(super) fn out_of_range(misfit: Misfit) -> &'static str {
    match misfit {
        Misfit::Black => "it is black: the face is never read, or outside its texture",
        Misfit::PartlyBlack => "a part of it is black: u or v leave the range from 0 to 1 there",
        Misfit::OneColour => "it is of one colour: u and v do not change, or are clamped everywhere",
        Misfit::Smeared => {
            "it is smeared into streaks: u or v leave the range from 0 to 1 and are clamped (is the division by the \
             largest component, or the step from -1..1 to 0..1, missing?)"
        }
        Misfit::OneCoordinate => {
            "nothing changes along its rows, or along its columns: u is used for v, or v for u, or one of the two is constant"
        }
        Misfit::Repeated => {
            "it repeats itself: u or v run from -1 to 1 and are wrapped (is the step from -1..1 to 0..1 missing?)"
        }
        Misfit::Unlike => "it resembles no image of this map: is it another map or position, or a rolled camera?",
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::DVec3;

    /// What a shot shows whose camera has these vectors, where `right` and `top` are those of a right one.
    fn operation([right, top]: [DVec3; 2], [wrong_right, wrong_top]: [DVec3; 2]) -> ImageOperation {
        let component = |axis: DVec3, s: f64, t: f64| (wrong_right * s + wrong_top * t).dot(axis);
        let leads = |orientation: &Orientation| {
            let (u, v) = orientation.apply(0.7, 0.8);
            let place = |axis| (component(axis, 0.4, 0.6) + 1.0) / 2.0;
            (f64::from(u) - place(right)).abs() + (f64::from(v) - place(top)).abs() < 1e-6
        };
        let orientation = Orientation::ALL.into_iter().find(leads).expect("the vectors are exchanged or turned round");
        CameraFault { orientation, ..CameraFault::NONE }.image_operation()
    }

    #[test]
    fn wrong_formulas_are_named_where_they_lead() {
        let (forward, up) = (DVec3::Y, DVec3::Z);
        let right = forward.cross(up);
        let top = right.cross(forward);
        let turned = up.cross(forward);
        for (wrong, words) in [
            ([turned, turned.cross(forward)], "turned by 180°: right = up x forward"),
            ([-right, top], "mirrored left-right: x of the pixel has the wrong sign"),
            ([-right, top], "negated after top = right x forward was computed"),
            ([turned, up], "right = up x forward where top is not computed from right"),
            ([right, forward.cross(right)], "upside down, mirrored top-bottom"),
            ([right, forward.cross(right)], "top = forward x right"),
            ([top, right], "mirrored about the diagonal from the top right: right and top are exchanged"),
            ([-top, -right], "mirrored about the diagonal from the top left: rows and columns"),
            ([-top, right], "right and top, are exchanged, and one of the two has the wrong sign"),
            ([top, -right], "right and top, are exchanged, and one of the two has the wrong sign"),
        ] {
            let sentence = placed_by(operation([right, top], wrong));
            assert!(sentence.contains(words), "{words}: {sentence}");
        }
    }
}
