//! What a check finds: facts, seams, verdict, fix and notes of one map.

use serde::{Serialize, Serializer};

use super::note::{Note, PictureNames};
use super::outlier::Outlier;
use super::seam::Seam;
use super::search::arrangement::Arrangement;
use super::search::convention::Convention;
use super::story::Story;
use super::verdict::Verdict;
use crate::digits::digits;
use crate::envmap::source::Skybox;
use crate::envmap::{Face, ImageOperation, Lookup, Orientation};
use crate::picture::Format;

/// An image as the report lists it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct ImageFacts {
    /// The name of the image.
    pub face: Face,
    /// The name of its file.
    pub file: String,
    /// Columns of texels.
    pub width: usize,
    /// Rows of texels.
    pub height: usize,
    /// The format of the file.
    pub format: Format,
    /// True if the file has an alpha channel, which is ignored.
    #[serde(skip)]
    pub alpha: bool,
}

impl ImageFacts {
    /// The six images of a skybox.
    pub fn of_skybox(skybox: &Skybox) -> Vec<Self> {
        let facts = |face: Face| {
            let image = skybox.image(face);
            let header = image.header();
            Self {
                face,
                file: image.name().to_owned(),
                width: header.width,
                height: header.height,
                format: header.format,
                alpha: header.alpha,
            }
        };
        Face::ALL.map(facts).to_vec()
    }
}

/// The report on one map.
#[derive(Debug, Clone, Serialize)]
pub struct Check {
    /// The name of the table: a preset or a file.
    #[serde(rename = "lookup")]
    pub lookup_name: String,
    /// The table that was checked.
    #[serde(skip)]
    pub lookup: Lookup,
    /// In the order of [`Face::ALL`].
    pub images: Vec<ImageFacts>,
    /// The worst of what was found.
    pub verdict: Verdict,
    /// The twelve seams as they are.
    pub seams: Vec<Seam>,
    /// The repair; it changes nothing if the map is right.
    pub fix: Fix,
    /// Faces whose image belongs to no place in this map.
    #[serde(skip)]
    pub outliers: Vec<Outlier>,
    /// The faces that the given lookup shows mirrored in a right-handed world.
    #[serde(rename = "handedness", serialize_with = "handedness")]
    pub mirrored: Vec<Face>,
    /// What the report says beside the verdict.
    pub notes: Vec<Note>,
}

/// What to change.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Fix {
    /// In the order of [`Face::ALL`].
    pub faces: [FaceFix; 6],
    /// What happened to the files.
    pub story: Story,
    /// Other stories that are as short and close the seams as well.
    pub also: Vec<Story>,
    /// Faces that change.
    pub changes: usize,
    /// The known order that these files follow, if the story names one.
    pub convention: Option<Convention>,
    /// The standard errors by which the next essentially different orientation is worse; 0 if none is.
    #[serde(serialize_with = "digits::<1, _>")]
    pub margin: f64,
    /// The twelve seams after the fix.
    pub seams_after: Vec<Seam>,
    /// Fixes that are equally good, this one among them.
    pub equivalents: usize,
}

/// What to change at one face.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct FaceFix {
    /// The face that reads the image.
    pub face: Face,
    /// The image that the face should read.
    pub image: Face,
    /// (u', v') as functions of the (u, v) that the given lookup computes.
    #[serde(flatten)]
    pub orientation: Orientation,
    /// The operation on the file that does the same.
    pub image_operation: ImageOperation,
    /// True if the pixels decide this orientation: every other one is decisively worse.
    pub decided: bool,
}

impl FaceFix {
    /// True if the face keeps its image and its orientation.
    pub fn is_unchanged(&self, given: &Lookup) -> bool {
        self.image == given.row(self.face).image && self.orientation == Orientation::IDENTITY
    }
}

impl Check {
    /// The names of the files, for sentences.
    pub fn file_names(&self) -> PictureNames {
        let file = |image: Face| self.images[image.index()].file.clone();
        PictureNames { images: Face::ALL.map(file), faces: self.fix.faces.map(|face| file(face.image)) }
    }

    /// What no change repairs: faces that do not belong or have the wrong size.
    pub fn unrepaired(&self) -> Vec<&Note> {
        self.notes.iter().filter(|note| note.is_beyond_repair()).collect()
    }

    /// True if all six images are square and of one size: no graphics library takes others as a cube map.
    pub fn has_equal_squares(&self) -> bool {
        let size = self.images[0].width;
        self.images.iter().all(|image| (image.width, image.height) == (size, size))
    }
}

/// The mirrored faces, in an object that has room for more.
fn handedness<S: Serializer>(mirrored: &[Face], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_map([("mirrored", mirrored)])
}

impl Fix {
    /// The corrected lookup.
    pub fn lookup(&self, given: &Lookup) -> Lookup {
        self.arrangement().corrected(given)
    }

    fn arrangement(&self) -> Arrangement {
        let index =
            |orientation: Orientation| Orientation::ALL.iter().position(|&known| known == orientation).unwrap_or(0);
        Arrangement {
            images: self.faces.map(|face| face.image),
            orientations: self.faces.map(|face| index(face.orientation)),
        }
    }
}
