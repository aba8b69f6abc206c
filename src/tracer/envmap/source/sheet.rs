//! One picture that holds all six faces.

use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use super::super::orientation::ImageOperation;
use super::cross::{self, Grid};
use super::layout::{Cell, EnvironmentPicture, Layout};
use super::picture_file::{read_file, read_header};
use crate::envmap::Face;
use crate::error::{Error, Result};
use crate::picture::{self, Header, Picture, Texels};

/// A picture that holds six faces as a cross or strip. It is decoded when the first face is asked for, once.
#[derive(Debug)]
pub(super) struct Sheet {
    path: PathBuf,
    header: Header,
    layout: Layout,
    cells: [Cell; 6],
    picture: OnceLock<Result<Picture>>,
}

impl Sheet {
    /// The file of the picture.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Reads the header and finds the layout from it; the pixels of a cross show where its faces lie.
    pub fn open(path: &Path) -> Result<Self> {
        let (header, head) = read_header(|limit| read_file(path, limit), path)?;
        let attribute = picture::exr_environment(&head);
        let recognised = EnvironmentPicture::recognise(header.width, header.height, attribute);
        let layout = match recognised.map_err(|error| error.in_file(path))? {
            EnvironmentPicture::Cube(layout) => layout,
            EnvironmentPicture::Equirectangular => return Err(equirectangular(path, header)),
        };
        let mut sheet =
            Self { path: path.to_path_buf(), header, layout, cells: layout.cells(), picture: OnceLock::new() };
        if layout.is_cross() || layout == Layout::WideSheet || layout == Layout::TallSheet {
            sheet.refuse_equi_angular()?;
            let (columns, rows) = layout.grid();
            let grid = Grid { picture: sheet.picture()?, columns, rows };
            let cells = if layout.is_cross() { cross::cells(&grid, layout) } else { cross::sheet_cells(&grid, layout) };
            sheet.cells = cells.map_err(|error| error.in_file(path))?;
        }
        Ok(sheet)
    }

    /// An error for an equi-angular cube map, which only its file name reveals.
    fn refuse_equi_angular(&self) -> Result<()> {
        let name = self.name().to_ascii_lowercase();
        if name.split(|letter: char| !letter.is_ascii_alphabetic()).all(|word| word != "eac") {
            return Ok(());
        }
        Err(Error::new(
            "an equi-angular cube map (EAC), according to its name: its faces are stretched towards their \
                        borders",
        )
        .in_file(&self.path)
        .expected("six faces of a 90° camera"))
    }

    fn picture(&self) -> Result<&Picture> {
        self.picture.get_or_init(|| self.decode()).as_ref().map_err(Error::clone)
    }

    /// The name of the file.
    pub fn name(&self) -> String {
        self.path.file_name().unwrap_or(self.path.as_os_str()).to_string_lossy().into_owned()
    }

    pub fn layout(&self) -> Layout {
        self.layout
    }

    pub fn cell(&self, face: Face) -> Cell {
        self.cells[face.index()]
    }

    /// The header of every face: that of the file, with the size of a cell.
    pub fn cell_header(&self) -> Header {
        let (columns, rows) = self.layout.grid();
        Header { width: self.header.width / columns, height: self.header.height / rows, ..self.header }
    }

    /// The pixels of a cell, turned upright.
    pub fn cut(&self, cell: Cell) -> Result<Picture> {
        let picture = self.picture()?;
        let Header { width, height, .. } = self.cell_header();
        // Column and row in the sheet of the pixel at `x` and `y` of the face.
        let place = |x: usize, y: usize| {
            let (x, y) = if cell.turn == ImageOperation::None { (x, y) } else { cell.turn.source(x, y, width) };
            (cell.row * height + y) * picture.width() + cell.column * width + x
        };
        let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y))).map(|(x, y)| place(x, y));
        let texels = match picture.texels() {
            Texels::Srgb8(bytes) => {
                Texels::Srgb8(places.flat_map(|at| [0, 1, 2].map(|channel| bytes[3 * at + channel])).collect())
            }
            Texels::Linear(colours) => Texels::Linear(places.map(|at| colours[at]).collect()),
        };
        Ok(Picture::new(Header { width, height, ..picture.header() }, texels))
    }

    fn decode(&self) -> Result<Picture> {
        let picture = picture::read(&self.path)?;
        if (picture.width(), picture.height()) == (self.header.width, self.header.height) {
            return Ok(picture);
        }
        Err(Error::new("its pixel data differ in size from its header").in_file(&self.path))
    }
}

fn equirectangular(path: &Path, header: Header) -> Error {
    Error::new(format!("{} x {} pixels: an equirectangular picture, not six faces", header.width, header.height))
        .in_file(path)
        .expected("six faces: a folder, a zip, a cross or strip, or an OpenEXR file with `envmap = cube`")
        .help("a scene can use it as an equirectangular environment")
}
