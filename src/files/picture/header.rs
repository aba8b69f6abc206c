//! The header of a picture, read before any pixel is decoded.

use super::{Format, jpeg_extent};
use crate::error::{Error, Result};
use crate::memory::{Claim, claim_memory};

/// The most memory the texels of one picture may take. It holds a 16384 by 8192 panorama in floats and stops a damaged
/// or hostile header before it exhausts the machine.
pub(super) const MEMORY_LIMIT: u64 = 2 << 30;

/// Size and kind of a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
pub struct Header {
    /// Columns of pixels.
    pub width: usize,
    /// Rows of pixels.
    pub height: usize,
    /// The format that the first bytes of the file name; its extension does not count.
    pub format: Format,
    /// Bits per channel in the file (1 to 32).
    pub bit_depth: u8,
    /// True if the file has an alpha channel. Its colours are read as they stand; the alpha is not applied.
    pub alpha: bool,
}

impl Header {
    /// Claims the memory for decoding the picture: its samples as they are decoded, beside them as they are kept where they have to be
    /// converted, and the coefficients of all blocks of a progressive JPEG picture.
    pub(super) fn claim(&self, encoded: &[u8]) -> Result<Claim> {
        let texel = match self.format {
            Format::Jpeg if jpeg_extent::is_progressive(encoded) => 3 + 3 * size_of::<i16>(),
            Format::Hdr | Format::Exr | Format::Pfm => 2 * 3 * size_of::<f32>(),
            _ if self.bit_depth > 8 => 4 * size_of::<u16>() + 3 * size_of::<f32>(),
            _ if self.alpha => 4 + 3,
            _ => 3,
        };
        let bytes = self.width as u64 * self.height as u64 * texel as u64;
        claim_memory(bytes, format_args!("the picture ({} x {})", self.width, self.height))
    }
}

/// An error if a picture of this size is empty or would take more memory than is sensible.
pub(super) fn check_size(width: usize, height: usize, bytes_per_texel: usize) -> Result<()> {
    if width == 0 || height == 0 {
        return Err(Error::new(format!("the picture is empty ({width} x {height})")));
    }
    let bytes = (width as u128) * (height as u128) * (bytes_per_texel as u128);
    if bytes <= u128::from(MEMORY_LIMIT) {
        return Ok(());
    }
    Err(Error::new(format!("the picture claims to be {width} x {height} and would take {} GiB of memory", bytes >> 30))
        .expected(format!("at most {} GiB", MEMORY_LIMIT >> 30))
        .help("scale the picture down, or download it again if it should be smaller"))
}

/// The error for a picture whose data do not decode.
pub(super) fn damaged(format: Format, detail: impl std::fmt::Display) -> Error {
    Error::new(format!("this {} picture cannot be decoded: {detail}", format.name()))
        .help("the file is damaged, incomplete or of an unsupported kind; download it again or save it again as PNG")
        .of_damage()
}
