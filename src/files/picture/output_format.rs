//! The output formats, chosen by the extension of the target.

use std::path::Path;

use super::{Format, Header};
use crate::error::{Error, Result};

/// A file format that is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, clap::ValueEnum)]
pub enum OutputFormat {
    /// Lossless, 8 or 16 bits a channel, sRGB-encoded.
    Png,
    /// Lossy, 8 bits a channel, sRGB-encoded.
    #[value(alias = "jpg")]
    Jpeg,
    /// Linear radiance as three mantissas of 8 bits and a shared exponent (RGBE).
    Hdr,
    /// Linear radiance in 32-bit floats, untouched.
    Exr,
}

impl OutputFormat {
    /// The usual extension of its files.
    pub fn extension(self) -> &'static str {
        match self {
            Self::Png => "png",
            Self::Jpeg => "jpg",
            Self::Hdr => "hdr",
            Self::Exr => "exr",
        }
    }

    /// The format that holds pictures of all these headers without loss: PNG for bytes and words, HDR for HDR, OpenEXR for
    /// other floats.
    pub fn lossless_for(headers: &[Header]) -> Self {
        let is_float =
            |header: &Header| matches!(header.format, Format::Hdr | Format::Exr | Format::Pfm) || header.bit_depth > 16;
        match headers {
            _ if !headers.iter().any(is_float) => Self::Png,
            _ if headers.iter().all(|header| header.format == Format::Hdr) => Self::Hdr,
            _ => Self::Exr,
        }
    }

    /// The format that the extension of `path` names, in any case.
    pub fn of_path(path: &Path) -> Result<Self> {
        let extension = path.extension().map(|extension| extension.to_string_lossy().to_ascii_lowercase());
        Ok(match extension.as_deref() {
            Some("png") => Self::Png,
            Some("jpg" | "jpeg") => Self::Jpeg,
            Some("hdr") => Self::Hdr,
            Some("exr") => Self::Exr,
            found => {
                let problem = match found {
                    Some(extension) => format!("cannot write a picture with the extension .{extension}"),
                    None => "the name has no extension that tells the picture format".to_owned(),
                };
                return Err(Error::new(problem).in_file(path).expected(".png, .jpg, .jpeg, .hdr or .exr"));
            }
        })
    }
}
