//! Six faces in one picture: crosses, strips, and the cube of OpenEXR.

use super::super::orientation::ImageOperation;
use crate::envmap::Face;
use crate::error::{Error, Result};
use crate::picture::EnvironmentLayout;

/// How the six faces of a skybox are stored.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Layout {
    /// One file for each face.
    SixFiles,
    /// Four cells across and three down; the caps may stand over any of the four columns, the sides then begin there:
    ///
    /// ```text
    ///      +Y
    ///  -X  +Z  +X  -Z
    ///      -Y
    /// ```
    HorizontalCross,
    /// Three cells across and four down; the arms may stand in any of the four rows, and -Z is turned by 180 degrees, or not:
    ///
    /// ```text
    ///      +Y
    ///  -X  +Z  +X
    ///      -Y
    ///      -Z (upside down)
    /// ```
    VerticalCross,
    /// +X -X +Y -Y +Z -Z from left to right.
    HorizontalStrip,
    /// +X -X +Y -Y +Z -Z from top to bottom.
    VerticalStrip,
    /// An OpenEXR file with `envmap = cube`: +X -X +Y -Y +Z -Z from top to bottom. The faces are taken by these names and
    /// as they lie; that OpenEXR orients them otherwise than OpenGL is left to the lookup.
    OpenExrCube,
    /// Three cells across and two down, row by row +X -X +Y -Y +Z -Z.
    WideSheet,
    /// Two cells across and three down, row by row +X -X +Y -Y +Z -Z.
    TallSheet,
}

/// What one picture of the surroundings is, by its shape and the attribute of an OpenEXR file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EnvironmentPicture {
    /// Six faces of a cube.
    Cube(Layout),
    /// Longitude across, latitude down: twice as wide as high.
    Equirectangular,
}

/// Where a face lies in the picture that holds all six.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Cell {
    pub column: usize,
    pub row: usize,
    /// What turns the cell upright.
    pub turn: ImageOperation,
}

/// The layouts that the shape of a picture tells, with columns and rows.
const SHAPES: [(EnvironmentPicture, usize, usize, &str); 7] = [
    (EnvironmentPicture::Cube(Layout::HorizontalCross), 4, 3, "horizontal cross 4:3"),
    (EnvironmentPicture::Cube(Layout::VerticalCross), 3, 4, "vertical cross 3:4"),
    (EnvironmentPicture::Cube(Layout::HorizontalStrip), 6, 1, "horizontal strip 6:1"),
    (EnvironmentPicture::Cube(Layout::VerticalStrip), 1, 6, "vertical strip 1:6"),
    (EnvironmentPicture::Cube(Layout::WideSheet), 3, 2, "sheet 3:2"),
    (EnvironmentPicture::Cube(Layout::TallSheet), 2, 3, "sheet 2:3"),
    (EnvironmentPicture::Equirectangular, 2, 1, "equirectangular 2:1"),
];

impl EnvironmentPicture {
    /// Tells the layout of a picture of `width` by `height` pixels. The attribute of an OpenEXR file decides before
    /// the shape does. An error says which sizes would be right.
    pub fn recognise(width: usize, height: usize, attribute: Option<EnvironmentLayout>) -> Result<Self> {
        match attribute {
            Some(EnvironmentLayout::LatitudeLongitude) => Ok(Self::Equirectangular),
            Some(EnvironmentLayout::Cube) if height == 6 * width && width > 0 => Ok(Self::Cube(Layout::OpenExrCube)),
            Some(EnvironmentLayout::Cube) => {
                Err(Error::new(format!("{width} x {height} pixels, though its attribute says `envmap = cube`"))
                    .expected("six square faces from top to bottom: a height of six times the width"))
            }
            None => Self::by_shape(width, height),
        }
    }

    fn by_shape(width: usize, height: usize) -> Result<Self> {
        let exact =
            |&&(_, columns, rows, _): &&(Self, usize, usize, &str)| width > 0 && width * rows == height * columns;
        match SHAPES.iter().find(exact) {
            Some(&(picture, ..)) => Ok(picture),
            None => Err(unknown_shape(width, height)),
        }
    }
}

/// The error for a shape that is none of ours, with the right sizes of the shape that comes nearest.
fn unknown_shape(width: usize, height: usize) -> Error {
    let error = Error::new(format!("{width} x {height} pixels: these proportions match no layout of six faces"));
    // The larger quotient of the two aspect ratios, 1 where they agree.
    let distance = |columns: usize, rows: usize| {
        let quotient = (width * rows) as f64 / (height * columns) as f64;
        quotient.max(1.0 / quotient)
    };
    let nearest = SHAPES.iter().min_by(|a, b| distance(a.1, a.2).total_cmp(&distance(b.1, b.2)));
    let cubes = SHAPES.iter().filter(|(picture, ..)| matches!(picture, EnvironmentPicture::Cube(_)));
    let names = cubes.map(|(.., name)| *name).collect::<Vec<_>>().join(", ");
    let error = error.expected(format!("a cross, strip or sheet whose cells are exactly square ({names})"));
    match nearest {
        Some(&(_, columns, rows, name)) if distance(columns, rows) < 1.1 => {
            let cell = (width / columns).min(height / rows).max(1);
            let size = |cell: usize| format!("{} x {}", cell * columns, cell * rows);
            error.help(format!("if this is a {name}, {} or {} pixels would be right", size(cell), size(cell + 1)))
        }
        _ => error.help("six faces may also be six files in a folder or zip"),
    }
}

impl Layout {
    /// Columns and rows of cells.
    pub(super) fn grid(self) -> (usize, usize) {
        match self {
            Self::SixFiles => (1, 1),
            Self::HorizontalCross => (4, 3),
            Self::VerticalCross => (3, 4),
            Self::HorizontalStrip => (6, 1),
            Self::VerticalStrip | Self::OpenExrCube => (1, 6),
            Self::WideSheet => (3, 2),
            Self::TallSheet => (2, 3),
        }
    }

    /// True for layouts with several orders of cells: the place of a cell is not a name.
    pub fn has_free_order(self) -> bool {
        matches!(self, Self::HorizontalStrip | Self::VerticalStrip | Self::WideSheet | Self::TallSheet)
    }

    /// True if the pixels must tell where the faces lie.
    pub(super) fn is_cross(self) -> bool {
        matches!(self, Self::HorizontalCross | Self::VerticalCross)
    }

    /// The cells of the six faces, +X -X +Y -Y +Z -Z: row by row, and those of crosses as they are drawn above. The arms of a
    /// cross that is read may stand elsewhere, [`super::cross`] finds them.
    pub(super) fn cells(self) -> [Cell; 6] {
        let upright = |column, row| Cell { column, row, turn: ImageOperation::None };
        let (columns, _) = self.grid();
        match self {
            Self::HorizontalCross => [(2, 1), (0, 1), (1, 0), (1, 2), (1, 1), (3, 1)].map(|(x, y)| upright(x, y)),
            Self::VerticalCross => {
                let mut cells = [(2, 1), (0, 1), (1, 0), (1, 2), (1, 1), (1, 3)].map(|(x, y)| upright(x, y));
                cells[Face::NegZ.index()].turn = ImageOperation::Turn180;
                cells
            }
            _ => [0, 1, 2, 3, 4, 5].map(|index| upright(index % columns, index / columns)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn recognised(width: usize, height: usize) -> EnvironmentPicture {
        EnvironmentPicture::recognise(width, height, None).unwrap()
    }

    #[test]
    fn the_shape_tells_the_layout() {
        assert_eq!(recognised(1024, 768), EnvironmentPicture::Cube(Layout::HorizontalCross));
        assert_eq!(recognised(768, 1024), EnvironmentPicture::Cube(Layout::VerticalCross));
        assert_eq!(recognised(1536, 256), EnvironmentPicture::Cube(Layout::HorizontalStrip));
        assert_eq!(recognised(256, 1536), EnvironmentPicture::Cube(Layout::VerticalStrip));
        assert_eq!(recognised(768, 512), EnvironmentPicture::Cube(Layout::WideSheet));
        assert_eq!(recognised(512, 768), EnvironmentPicture::Cube(Layout::TallSheet));
        assert_eq!(recognised(1024, 512), EnvironmentPicture::Equirectangular);
    }

    #[test]
    fn the_attribute_decides_before_the_shape() {
        let recognise = |attribute| EnvironmentPicture::recognise(256, 1536, Some(attribute)).unwrap();
        assert_eq!(recognise(EnvironmentLayout::Cube), EnvironmentPicture::Cube(Layout::OpenExrCube));
        assert_eq!(recognise(EnvironmentLayout::LatitudeLongitude), EnvironmentPicture::Equirectangular);
    }

    #[test]
    fn other_shapes_are_refused_with_the_sizes_that_would_be_right() {
        let error = |width, height| EnvironmentPicture::recognise(width, height, None).unwrap_err();
        insta::assert_snapshot!(error(1025, 768), @r"
        1025 x 768 pixels: these proportions match no layout of six faces
          expected: a cross, strip or sheet whose cells are exactly square (horizontal cross 4:3, vertical cross 3:4, horizontal strip 6:1, vertical strip 1:6, sheet 3:2, sheet 2:3)
          help: if this is a horizontal cross 4:3, 1024 x 768 or 1028 x 771 pixels would be right
        ");
        insta::assert_snapshot!(error(512, 512), @r"
        512 x 512 pixels: these proportions match no layout of six faces
          expected: a cross, strip or sheet whose cells are exactly square (horizontal cross 4:3, vertical cross 3:4, horizontal strip 6:1, vertical strip 1:6, sheet 3:2, sheet 2:3)
          help: six faces may also be six files in a folder or zip
        ");
        let cube = EnvironmentPicture::recognise(512, 512, Some(EnvironmentLayout::Cube)).unwrap_err();
        insta::assert_snapshot!(cube, @r"
        512 x 512 pixels, though its attribute says `envmap = cube`
          expected: six square faces from top to bottom: a height of six times the width
        ");
    }
}
