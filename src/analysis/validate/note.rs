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
        /// The image with the frame.
        image: Face,
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
    /// Two images with the same texels along all borders.
    Identical {
        /// In the order of [`Face::ALL`].
        images: [Face; 2],
    },
    /// One flat colour along all borders, about that in which its neighbours end: nobody can say how it lies.
    Flat {
        /// The flat image.
        image: Face,
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

fn names(faces: &[Face]) -> String {
    match faces {
        [] => "no face".to_owned(),
        faces if faces.len() == 6 => "all six faces".to_owned(),
        faces => faces.iter().map(|face| face.name()).collect::<Vec<_>>().join(", "),
    }
}

/// As its sentence.
impl serde::Serialize for Note {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl fmt::Display for Note {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Outlier { face, file, reason } => {
                write!(formatter, "{} ({file}) does not belong here: {}", face.name(), why_outlier(*reason))
            }
            Self::Framed { image } => {
                write!(formatter, "{} has a frame one texel wide; the texels inside it were compared", image.name())
            }
            Self::Sizes { smallest, largest } => write!(
                formatter,
                "the images differ in size, from {smallest} to {largest} texels: no graphics library takes this as a cube map"
            ),
            Self::NotSquare { images } => {
                let are = if images.len() == 1 { "is" } else { "are" };
                write!(formatter, "{} {are} not square: no graphics library takes this as a cube map", names(images))
            }
            Self::Alpha { images } => write!(formatter, "alpha channel in {}: ignored", names(images)),
            Self::Exposure { image, codes } => formatter.write_str(&exposed(*image, *codes)),
            Self::Identical { images: [one, other] } => {
                write!(formatter, "{} and {} are the same along all their borders", one.name(), other.name())
            }
            Self::Flat { image } => {
                let name = image.name();
                write!(formatter, "{name} is one flat colour along its borders: it looks the same in any orientation")
            }
            Self::Undecided { faces } => {
                write!(formatter, "undecided: the pixels do not determine the orientation of {}", names(faces))
            }
            Self::Doubtful { faces } => write!(
                formatter,
                "{} would fit better with another orientation or picture, but the pixels do not decide",
                names(faces)
            ),
            Self::Rough { seams, step, after_the_fix } => {
                formatter.write_str(&rough_seams(*seams, *step, *after_the_fix))
            }
            Self::Open { seams, step, after_the_fix } => {
                let when = if *after_the_fix { " after the fix too" } else { "" };
                let stay = if *seams == 1 { "stays" } else { "stay" };
                write!(
                    formatter,
                    "{seams} of 12 seams {stay} open{when} (mean step {step:.1} of 255): the pixels do not show how \
                     to close them"
                )
            }
            Self::Unnamed { numbered } => {
                let names = if *numbered { "numbers" } else { "names" };
                write!(
                    formatter,
                    "the {names} of the files do not identify the faces: assigned to +X -X +Y -Y +Z -Z in this order, \
                     then sorted by their pixels"
                )
            }
            Self::Mirrored { faces, after, changes } => {
                formatter.write_str(&mirrored(faces, after, *changes && faces != after))
            }
            Self::AssumedUp { up, lookup } => {
                write!(formatter, "assumed a world with {up} up, for the lookup {lookup}; --world-up changes this")
            }
            Self::Sky { sky, up, there, after_the_fix } => {
                formatter.write_str(&sky_place(*sky, *up, *there, *after_the_fix))
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

fn why_outlier(reason: Reason) -> String {
    match reason {
        Reason::Flat => "it is one flat colour that its four neighbours do not continue".to_owned(),
        Reason::CopyOf(other) => format!("it holds the same picture as {}", other.name()),
        Reason::AnotherScene => {
            "its borders fit no neighbour in any orientation: the picture shows another scene".to_owned()
        }
    }
}

fn exposed(image: Face, codes: f64) -> String {
    let how = if codes > 0.0 { "brighter" } else { "darker" };
    let (name, codes) = (image.name(), codes.abs());
    format!("{name} is {how} than all its neighbours, by {codes:.1} of 255 on average: another exposure")
}

/// Which faces are mirrored now and, if that changes, after the fix.
fn mirrored(now: &[Face], after: &[Face], changes: bool) -> String {
    let now = names(now);
    if !changes {
        return format!("a right-handed world sees {now} mirrored; this follows from the table alone");
    }
    let after = names(after);
    format!(
        "a right-handed world sees {now} mirrored now, and {after} after the fix if the pictures are unflipped \
         photographs (if they were flipped, the handedness stays: seams cannot tell); this follows from the table \
         alone"
    )
}

fn sky_place(sky: Face, up: SignedAxis, there: bool, after_the_fix: bool) -> String {
    let sky = sky.name();
    let when = when(after_the_fix);
    if there {
        return format!("the sky seems to be {sky}: at the declared up axis {up}{when}");
    }
    format!("the sky seems to be {sky}, not at the declared up axis {up}{when} (a hint from brightness and detail)")
}
