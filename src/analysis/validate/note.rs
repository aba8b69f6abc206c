//! A note about a map beside the verdict, and its sentence.

use std::fmt;

use super::outlier::Reason;
use crate::envmap::{Face, SignedAxis};

/// A remark in the report. [`Note::Outlier`], [`Note::NotSquare`] and [`Note::Sizes`] say why a map is broken.
#[derive(Debug, Clone, PartialEq)]
pub enum Note {
    /// A picture that does not belong to this map.
    Outlier {
        /// The face that shows it after the fix.
        face: Face,
        /// The name of its file.
        file: String,
        /// Why it does not belong.
        reason: Reason,
    },
    /// A 1-pixel frame, left out of the measure.
    Framed {
        /// The images with the frame, in the order of [`Face::ALL`].
        images: Vec<Face>,
    },
    /// Square images of different sizes.
    Sizes {
        /// The smallest side in texels.
        smallest: usize,
        /// The largest side in texels.
        largest: usize,
    },
    /// Images whose width and height differ.
    NotSquare {
        /// In the order of [`Face::ALL`].
        images: Vec<Face>,
    },
    /// An alpha channel, which is ignored.
    Alpha {
        /// In the order of [`Face::ALL`].
        images: Vec<Face>,
    },
    /// An image that is brighter or darker than all its neighbours.
    Exposure {
        /// The image.
        image: Face,
        /// By how many of 255 codes, on average; negative if darker.
        codes: f64,
    },
    /// Images with the same texels along all borders.
    Identical {
        /// In the order of [`Face::ALL`].
        images: Vec<Face>,
    },
    /// One flat colour along all borders, about that in which the neighbours end: nobody can say how the image lies.
    Flat {
        /// The flat images, in the order of [`Face::ALL`].
        images: Vec<Face>,
    },
    /// The pixels do not determine every orientation.
    Undecided {
        /// The faces that may have another orientation.
        faces: Vec<Face>,
    },
    /// Faces that would fit better otherwise, but not decisively.
    Doubtful {
        /// The faces that the best arrangement changes.
        faces: Vec<Face>,
    },
    /// Rough seams of a geometry that fits, as it is or after the fix.
    Rough {
        /// How many of the twelve.
        seams: usize,
        /// Mean step across them, of 255 codes.
        step: f64,
        /// True if they are rough after the fix, false if nothing changes.
        after_the_fix: bool,
    },
    /// Seams of a broken map that no certain change closes.
    Open {
        /// How many of the twelve.
        seams: usize,
        /// Mean step across them, of 255 codes.
        step: f64,
        /// True if a fix leaves them open, false if nothing changes.
        after_the_fix: bool,
    },
    /// The names do not say which face an image is.
    Unnamed {
        /// True if they are numbers.
        numbered: bool,
    },
    /// Faces that a right-handed world sees mirrored.
    Mirrored {
        /// Under the given lookup.
        faces: Vec<Face>,
        /// After the fix.
        after: Vec<Face>,
        /// True if the fix changes a face.
        changes: bool,
    },
    /// The axis that the fix puts above was taken from the lookup.
    AssumedUp {
        /// The usual up axis of the lookup.
        up: SignedAxis,
        /// The name of the lookup.
        lookup: String,
    },
    /// Which image seems to be the sky, by its brightness and detail.
    Sky {
        /// The image.
        sky: Face,
        /// The up axis that the user named.
        up: SignedAxis,
        /// True if the face at `up` reads the image, after the fix if there is one.
        there: bool,
        /// True if the fix changes a face.
        after_the_fix: bool,
    },
}

/// What a sentence calls images and faces.
pub struct PictureNames {
    /// Of each image, in the order of [`Face::ALL`].
    pub images: [String; 6],
    /// Of what each face shows after the fix.
    pub faces: [String; 6],
}

impl PictureNames {
    /// `posx` ... `negz`.
    fn of_faces() -> Self {
        let names = Face::ALL.map(|face| face.name().to_owned());
        Self { images: names.clone(), faces: names }
    }
}

/// `posx.jpg, negx.jpg and posy.jpg`.
pub fn joined(parts: &[String]) -> String {
    match parts {
        [] => String::new(),
        [one] => one.clone(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}

/// The names of pictures, or `all six pictures`.
pub fn listed(names: &[String]) -> String {
    if names.len() == 6 { "all six pictures".to_owned() } else { joined(names) }
}

/// The word for one, or for several.
fn either<T>(faces: &[Face], one: T, several: T) -> T {
    if faces.len() == 1 { one } else { several }
}

/// As its sentence.
impl serde::Serialize for Note {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl fmt::Display for Note {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.sentence(&PictureNames::of_faces()))
    }
}

impl Note {
    /// True if it names a picture that no change of the lookup repairs.
    pub fn is_beyond_repair(&self) -> bool {
        matches!(self, Self::Outlier { .. } | Self::NotSquare { .. } | Self::Sizes { .. })
    }

    /// The note as a sentence, without its full stop.
    pub fn sentence(&self, names: &PictureNames) -> String {
        let of = |names: &[String; 6], faces: &[Face]| {
            listed(&faces.iter().map(|face| names[face.index()].clone()).collect::<Vec<_>>())
        };
        let (images, faces) = (|images: &[Face]| of(&names.images, images), |faces: &[Face]| of(&names.faces, faces));
        match self {
            Self::Outlier { face, file, reason } => {
                format!("{} ({file}) does not belong here: {}", face.name(), why_outlier(*reason, names))
            }
            Self::Framed { images: framed } => {
                let have = either(framed, "has", "have");
                format!("{} {have} a frame one texel wide; the texels inside it were compared", images(framed))
            }
            Self::Sizes { smallest, largest } => format!(
                "the images differ in size, from {smallest} to {largest} texels: no graphics library takes this as a cube map"
            ),
            Self::NotSquare { images: unsquare } => {
                let are = either(unsquare, "is", "are");
                format!("{} {are} not square: no graphics library takes this as a cube map", images(unsquare))
            }
            Self::Alpha { images: transparent } => format!("alpha channel in {}: ignored", images(transparent)),
            Self::Exposure { image, codes } => exposed(&names.images[image.index()], *codes),
            Self::Identical { images: identical } => {
                format!("{} are the same along all their borders", images(identical))
            }
            Self::Flat { images: flat } => {
                let (are, they) = either(flat, ("is", "it looks"), ("are each", "they look"));
                format!("{} {are} one flat colour along the borders: {they} the same in any orientation", images(flat))
            }
            Self::Undecided { faces: undecided } => {
                format!("undecided: the pixels do not determine the orientation of {}", faces(undecided))
            }
            Self::Doubtful { faces: doubtful } => format!(
                "{} would fit better with another orientation or picture, but the pixels do not decide",
                faces(doubtful)
            ),
            Self::Rough { seams, step, after_the_fix } => rough_seams(*seams, *step, *after_the_fix),
            Self::Open { seams, step, after_the_fix } => {
                let when = if *after_the_fix { " after the fix too" } else { "" };
                let stay = if *seams == 1 { "stays" } else { "stay" };
                format!(
                    "{seams} of 12 seams {stay} open{when} (mean step {step:.1} of 255): the pixels do not show how \
                     to close them"
                )
            }
            Self::Unnamed { numbered } => {
                let what = if *numbered { "numbers" } else { "names" };
                format!(
                    "the {what} of the files do not identify the faces: assigned to +X -X +Y -Y +Z -Z in this order, \
                     then sorted by their pixels"
                )
            }
            Self::Mirrored { faces, after, changes } => mirrored(faces, after, *changes && faces != after),
            Self::AssumedUp { up, lookup } => {
                format!("assumed a world with {up} up, for the lookup {lookup}; --world-up changes this")
            }
            Self::Sky { sky, up, there, after_the_fix } => {
                sky_place(&names.images[sky.index()], *up, *there, *after_the_fix)
            }
        }
    }
}

/// What is said of a map as it is, or as the fix makes it.
fn when(after_the_fix: bool) -> &'static str {
    if after_the_fix { " after the fix" } else { "" }
}

/// That seams are rough, and why they may be.
fn rough_seams(seams: usize, step: f64, after_the_fix: bool) -> String {
    let are = if seams == 1 { "is" } else { "are" };
    let when = when(after_the_fix);
    format!(
        "{seams} of 12 seams {are} rough{when} (mean step {step:.1} of 255), but the geometry fits: {ROUGH_REASONS}"
    )
}

/// Why the seams of a right map may be rough.
const ROUGH_REASONS: &str = "the faces were exposed, framed or compressed separately, the ground is coarse, or an \
                             edge of the scene lies along the seam";

/// Why a picture does not belong to the map.
pub fn why_outlier(reason: Reason, names: &PictureNames) -> String {
    match reason {
        Reason::Flat => "it is one flat colour that its four neighbours do not continue".to_owned(),
        Reason::CopyOf(other) => format!("it holds the same picture as {}", names.images[other.index()]),
        Reason::AnotherScene => {
            "its borders fit no neighbour in any orientation: the picture shows another scene".to_owned()
        }
    }
}

fn exposed(name: &str, codes: f64) -> String {
    let how = if codes > 0.0 { "brighter" } else { "darker" };
    let codes = codes.abs();
    format!("{name} is {how} than all its neighbours, by {codes:.1} of 255 on average: another exposure")
}

/// Faces of a lookup, whatever files they read.
fn face_names(faces: &[Face]) -> String {
    match faces {
        [] => "no face".to_owned(),
        faces if faces.len() == 6 => "all six faces".to_owned(),
        faces => faces.iter().map(|face| face.name()).collect::<Vec<_>>().join(", "),
    }
}

/// Which faces are mirrored now and, if that changes, after the fix.
fn mirrored(now: &[Face], after: &[Face], changes: bool) -> String {
    let now = face_names(now);
    if !changes {
        return format!("a right-handed world sees {now} mirrored; this follows from the table alone");
    }
    let after = face_names(after);
    format!(
        "a right-handed world sees {now} mirrored now, and {after} after the fix if the pictures are unflipped \
         photographs (if they were flipped, the handedness stays: seams cannot tell); this follows from the table \
         alone"
    )
}

fn sky_place(sky: &str, up: SignedAxis, there: bool, after_the_fix: bool) -> String {
    let when = when(after_the_fix);
    if there {
        return format!("the sky seems to be {sky}: at the declared up axis {up}{when}");
    }
    format!("the sky seems to be {sky}, not at the declared up axis {up}{when} (a hint from brightness and detail)")
}
