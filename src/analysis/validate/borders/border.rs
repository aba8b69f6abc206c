//! Reads the borders of the six images, the only texels that decide seams and orientations.
//!
//! ```text
//!     side ->  0 1 2 3 4 ...            rows parallel to the side, counted inwards:
//!     0        . . . . . . . .          0 to 3        the outermost four: three are used, 1 to 3 inside a frame
//!     1        . . . . . . . .          h + 1, 2h + 1 deeper ones, for the slope towards the side
//!     2        . . . . . . . .          7, 8          of JPEG files: both sides of the first block boundary
//! ```

use super::super::thresholds::frame::{DARKER, MOST_TEXELS, PLAIN, SAME_COLOUR};
use super::display::{Display, is_radiance};
use super::edge::Side;
use crate::envmap::{CubeMap, Face, FaceLookup, FacePoint, Lookup};
use crate::error::Result;
use crate::math::Vec3;
use crate::parallel;
use crate::picture::{Format, Picture};

/// The side of a block of a JPEG file, each of which is compressed on its own.
const BLOCK: usize = 8;

/// Display colours along a side, one for each texel, by the growing coordinate.
pub type Row = Vec<[f32; 3]>;

/// The rows read beside one side of an image.
#[derive(Debug, Clone)]
pub struct BorderRows {
    /// The outermost four, the side itself first.
    pub outer: [Row; 4],
    /// Rows at the depths h + 1 and 2h + 1: h and 2h inside a frame.
    pub deep: [Row; 2],
    /// The rows on both sides of the first block boundary of a JPEG file: a seam lies between two blocks too.
    pub blocks: Option<[Row; 2]>,
}

/// The borders of one image.
#[derive(Debug, Clone)]
pub struct ImageBorders {
    /// In the order of [`Side::ALL`].
    pub sides: [BorderRows; 4],
    /// Texels along a side: the smaller of width and height.
    pub texels: usize,
    /// True if the outermost row is a frame around the picture.
    pub framed: bool,
    /// h, the distance of the two deep rows in texels.
    pub depth: usize,
    /// How the colours were encoded, the same for all six.
    pub display: Display,
}

/// The borders of the six images, by name.
pub type Borders = [ImageBorders; 6];

/// The encoding of all six.
pub fn display_of_map(borders: &Borders) -> Display {
    borders[0].display
}

impl ImageBorders {
    /// The row at this distance inside the side, without the frame if there is one: 0, 1 or 2.
    pub fn row(&self, side: Side, index: usize) -> &Row {
        &self.sides[side.index()].outer[index + usize::from(self.framed)]
    }

    /// True if all that was read is the same.
    pub fn holds_the_same(&self, other: &Self) -> bool {
        let same = |(one, other): (&BorderRows, &BorderRows)| one.outer == other.outer && one.deep == other.deep;
        self.sides.iter().zip(&other.sides).all(same)
    }

    /// True if no texel differs from the others in any row that was read, but for a frame: a frame that went unseen
    /// around a picture does not make it flat.
    pub fn is_flat(&self) -> bool {
        let colour = self.row(Side::Left, 0)[0];
        let rows = |side: &BorderRows| {
            let mut rows = side.outer.iter().skip(usize::from(self.framed)).chain(&side.deep);
            rows.all(|row| Self::within_frame(row, self.framed).iter().all(|&texel| texel == colour))
        };
        self.sides.iter().all(rows)
    }

    /// A row without its first and last texel if those belong to a frame.
    fn within_frame(row: &Row, framed: bool) -> &[[f32; 3]] {
        if framed && row.len() > 2 { &row[1..row.len() - 1] } else { row }
    }
}

/// Reads the borders of all six images, by the name of the image, through the one lookup.
pub fn read_borders(map: &CubeMap) -> Result<Borders> {
    let lookup = as_named(map.lookup());
    let mut pictures = Vec::new();
    for image in Face::ALL {
        pictures.push(map.picture(image)?);
    }
    let display = display_of(&lookup, &pictures);
    let read = |image: Face| read_image(&lookup, image, pictures[image.index()], display);
    let borders = parallel::map(Face::ALL, read);
    Ok(borders.try_into().expect("there are six images"))
}

/// The table by which every face reads the image of the same name. The texture coordinates of an image depend on
/// nothing but where v = 0 lies.
fn as_named(lookup: &Lookup) -> Lookup {
    let rows = Face::ALL.map(|face| FaceLookup { image: face, ..lookup.row(face) });
    lookup.with_rows(rows).expect("the axes are those of a valid table")
}

/// One encoding for all six: that of radiance if one of the files holds radiance.
fn display_of(lookup: &Lookup, pictures: &[&Picture]) -> Display {
    if pictures.iter().any(|picture| is_radiance(picture.header())) {
        let samples = Face::ALL.into_iter().flat_map(|image| {
            let picture = pictures[image.index()];
            let texels = picture.width().min(picture.height());
            Side::ALL.into_iter().flat_map(move |side| {
                (0..texels).map(move |index| sample(lookup, image, picture, side, texels, index, 0))
            })
        });
        return Display::of_radiance(samples);
    }
    let eight_bit = |picture: &&Picture| matches!(picture.texels(), crate::picture::Texels::Srgb8(_));
    if pictures.iter().all(eight_bit) { Display::EightBit } else { Display::Deep }
}

/// The colour at the centre of the texel `index` along a side and `depth` texels inside it.
#[inline]
fn sample(
    lookup: &Lookup,
    image: Face,
    picture: &Picture,
    side: Side,
    texels: usize,
    index: usize,
    depth: usize,
) -> Vec3 {
    let centre = |index: usize| (index as f32 + 0.5) / texels as f32;
    let (u, v) = side.place(centre(index), centre(depth));
    lookup.image_point(FacePoint { face: image, u, v }).nearest(picture)
}

fn read_image(lookup: &Lookup, image: Face, picture: &Picture, display: Display) -> ImageBorders {
    let texels = picture.width().min(picture.height());
    let depth = (texels / 32).max(1);
    let compressed = picture.header().format == Format::Jpeg;
    let row = |side: Side, depth: usize| -> Row {
        let depth = depth.min(texels - 1);
        (0..texels).map(|index| display.encode(sample(lookup, image, picture, side, texels, index, depth))).collect()
    };
    let sides = Side::ALL.map(|side| BorderRows {
        outer: [0, 1, 2, 3].map(|index| row(side, index)),
        deep: [depth, 2 * depth].map(|index| row(side, index + 1)),
        blocks: compressed.then(|| [BLOCK - 1, BLOCK].map(|index| row(side, index))),
    });
    let framed = is_framed(&sides);
    ImageBorders { sides, texels, framed, depth, display }
}

/// A frame: on all four sides the outermost row differs abruptly from the next one, and either it is one colour or
/// it is darker nearly everywhere.
fn is_framed(sides: &[BorderRows; 4]) -> bool {
    let colour = sides[0].outer[0][0];
    let near = |texel: &[f32; 3]| texel.iter().zip(&colour).all(|(one, other)| (one - other).abs() < SAME_COLOUR);
    let most = |rows: &BorderRows, count: usize| count as f64 > MOST_TEXELS * rows.outer[0].len() as f64;
    let plain = sides.iter().all(|rows| most(rows, rows.outer[0].iter().filter(|texel| near(texel)).count()));
    let darker = |rows: &BorderRows| {
        let [first, second, ..] = &rows.outer;
        most(rows, first.iter().zip(second).filter(|(one, other)| sum(one) < sum(other)).count())
    };
    let (factor, least) = if plain { PLAIN } else { DARKER };
    let abrupt = |rows: &BorderRows| {
        let [first, second, third, _] = &rows.outer;
        mean_step(first, second) > factor * mean_step(second, third) + least
    };
    sides.iter().all(abrupt) && (plain || sides.iter().all(darker))
}

fn sum(texel: &[f32; 3]) -> f32 {
    texel.iter().sum()
}

/// The mean absolute difference of two rows, over texels and channels.
pub fn mean_step(one: &Row, other: &Row) -> f64 {
    let difference = |(a, b): (&[f32; 3], &[f32; 3])| -> f64 {
        (0..3).map(|channel| f64::from((a[channel] - b[channel]).abs())).sum()
    };
    one.iter().zip(other).map(difference).sum::<f64>() / (3 * one.len().max(1)) as f64
}
