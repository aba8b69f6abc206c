//! Checks that six faces are square and of one size.

use crate::envmap::Face;
use crate::error::Error;

/// A face whose size does not suit a cube.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SizeFault {
    /// The face, by the name of its image.
    pub face: Face,
    /// Columns of texels.
    pub width: usize,
    /// Rows of texels.
    pub height: usize,
    /// What is wrong with the size.
    pub kind: SizeFaultKind,
}

/// What is wrong with the size of a face.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SizeFaultKind {
    /// Width and height differ.
    NotSquare,
    /// Square, but of another size than most faces; among equally many the faces first in order set the size.
    Differs {
        /// The side of most faces, in texels.
        from: usize,
    },
}

/// The faults of six sizes (width, height), in the order of the faces.
pub(super) fn size_faults(sizes: [(usize, usize); 6]) -> Vec<SizeFault> {
    let usual = usual_size(&sizes);
    let mut faults = Vec::new();
    for (face, (width, height)) in Face::ALL.into_iter().zip(sizes) {
        if width != height {
            faults.push(SizeFault { face, width, height, kind: SizeFaultKind::NotSquare });
        } else if let Some(from) = usual.filter(|&from| from != width) {
            faults.push(SizeFault { face, width, height, kind: SizeFaultKind::Differs { from } });
        }
    }
    faults
}

/// The edge length that most square faces have, of several the one that comes first. None if no face is square.
fn usual_size(sizes: &[(usize, usize); 6]) -> Option<usize> {
    let count = |size: usize| sizes.iter().filter(|&&other| other == (size, size)).count();
    let squares = sizes.iter().filter(|(width, height)| width == height).map(|&(width, _)| width);
    squares.reduce(|best, size| if count(size) > count(best) { size } else { best })
}

/// The error that names every faulty face with its file. None if there is no fault.
pub(super) fn size_error(faults: &[SizeFault], name: impl Fn(Face) -> String) -> Option<Error> {
    let line = |fault: &SizeFault| {
        let SizeFault { face, width, height, kind } = fault;
        let what = match kind {
            SizeFaultKind::NotSquare => "not square".to_owned(),
            SizeFaultKind::Differs { from } => format!("most faces are {from} x {from}"),
        };
        format!("\n  {}: {} is {width} x {height}: {what}", face.name(), name(*face))
    };
    let faces = if faults.len() == 1 { "1 face has" } else { &format!("{} faces have", faults.len()) };
    let lines: String = faults.iter().map(line).collect();
    (!faults.is_empty()).then(|| {
        Error::new(format!("{faces} the wrong size{lines}"))
            .expected("six square pictures of one size")
            .help("scale or crop these pictures, or take them from the original download again")
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn six_alike_have_no_fault() {
        assert_eq!(size_faults([(8, 8); 6]), []);
        assert!(size_error(&[], |_| String::new()).is_none());
    }

    #[test]
    fn the_size_of_most_faces_is_the_right_one() {
        let faults = size_faults([(4, 4), (8, 8), (8, 8), (8, 6), (8, 8), (4, 4)]);
        assert_eq!(faults.iter().map(|fault| fault.face).collect::<Vec<_>>(), [Face::PosX, Face::NegY, Face::NegZ]);
        assert_eq!(faults[0].kind, SizeFaultKind::Differs { from: 8 });
        assert_eq!(faults[1].kind, SizeFaultKind::NotSquare);
    }
}
