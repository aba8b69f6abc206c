//! Which file format the bytes of a picture are in.

use std::path::Path;

use crate::choice::name_of;

/// The file formats that are read.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, serde::Serialize, clap::ValueEnum)]
#[serde(rename_all = "lowercase")]
#[value(rename_all = "UPPER")]
pub enum Format {
    /// JPEG: 8 bits, sRGB unless its ICC profile says otherwise.
    Jpeg,
    /// PNG: up to 16 bits.
    Png,
    /// Truevision TGA: 8 bits.
    Tga,
    /// Windows bitmap: 8 bits.
    Bmp,
    /// WebP: 8 bits, lossy or lossless.
    #[value(name = "WebP")]
    WebP,
    /// TIFF: integers or floats.
    Tiff,
    /// Radiance RGBE: linear light.
    Hdr,
    /// OpenEXR: linear light in halves or floats.
    #[value(name = "OpenEXR")]
    Exr,
    /// Netpbm with integers: grey or RGB, 8 or 16 bits.
    Ppm,
    /// Portable float map: linear light in floats.
    Pfm,
}

/// The first bytes that tell a format. TGA has none.
const SIGNATURES: [(&[u8], Format); 10] = [
    (b"\xFF\xD8\xFF", Format::Jpeg),
    (b"\x89PNG\r\n\x1A\n", Format::Png),
    (b"BM", Format::Bmp),
    (b"II*\0", Format::Tiff),
    (b"MM\0*", Format::Tiff),
    (b"II+\0", Format::Tiff),
    (b"MM\0+", Format::Tiff),
    (b"#?RADIANCE", Format::Hdr),
    (b"#?RGBE", Format::Hdr),
    (b"\x76\x2F\x31\x01", Format::Exr),
];

impl Format {
    /// The name of the format as it is printed.
    pub fn name(self) -> String {
        name_of(self)
    }

    /// The usual extension of its files.
    pub fn extension(self) -> &'static str {
        match self {
            Format::Jpeg => "jpg",
            Format::Png => "png",
            Format::Tga => "tga",
            Format::Bmp => "bmp",
            Format::WebP => "webp",
            Format::Tiff => "tif",
            Format::Hdr => "hdr",
            Format::Exr => "exr",
            Format::Ppm => "ppm",
            Format::Pfm => "pfm",
        }
    }

    /// The format a file name's extension promises, in any case. `None` if the extension is missing or not one of ours.
    pub fn of_extension(name: &Path) -> Option<Self> {
        let extension = name.extension()?.to_str()?.to_ascii_lowercase();
        Some(match extension.as_str() {
            "jpg" | "jpeg" | "jpe" | "jfif" => Format::Jpeg,
            "png" => Format::Png,
            "tga" | "vda" | "icb" | "vst" => Format::Tga,
            "bmp" | "dib" => Format::Bmp,
            "webp" => Format::WebP,
            "tif" | "tiff" => Format::Tiff,
            "hdr" | "rgbe" => Format::Hdr,
            "exr" => Format::Exr,
            "ppm" | "pgm" | "pbm" | "pnm" => Format::Ppm,
            "pfm" => Format::Pfm,
            _ => return None,
        })
    }

    /// The format the content shows. Only if the content shows none does the name count, and only for TGA, which has no
    /// signature. `None` if the bytes are not a supported picture.
    pub fn of_content(encoded: &[u8], name: &Path) -> Option<Self> {
        if let Some((_, format)) = SIGNATURES.iter().find(|(signature, _)| encoded.starts_with(signature)) {
            return Some(*format);
        }
        if encoded.starts_with(b"RIFF") && encoded.get(8..12) == Some(b"WEBP") {
            return Some(Format::WebP);
        }
        if is_netpbm(encoded) {
            return Some(if encoded[1].is_ascii_digit() { Format::Ppm } else { Format::Pfm });
        }
        let named_tga = Self::of_extension(name) == Some(Format::Tga);
        let header_fits = is_plausible_tga(encoded);
        (header_fits && (named_tga || is_signed_tga(encoded) || Self::of_extension(name).is_none()))
            .then_some(Format::Tga)
    }
}

/// True if the bytes begin like one of these files.
fn is_netpbm(encoded: &[u8]) -> bool {
    matches!(encoded, [b'P', b'1'..=b'6' | b'F' | b'f', blank, ..] if blank.is_ascii_whitespace())
}

/// True if the 18 bytes of a TGA header have values that the format allows (Truevision TGA 2.0, section C).
fn is_plausible_tga(encoded: &[u8]) -> bool {
    let Some(header) = encoded.first_chunk::<18>() else { return false };
    let width = u16::from_le_bytes([header[12], header[13]]);
    let height = u16::from_le_bytes([header[14], header[15]]);
    header[1] <= 1
        && matches!(header[2], 1 | 2 | 3 | 9 | 10 | 11)
        && matches!(header[16], 8 | 15 | 16 | 24 | 32)
        && width > 0
        && height > 0
}

/// True if the file ends with the footer of TGA 2.0.
fn is_signed_tga(encoded: &[u8]) -> bool {
    encoded.ends_with(b"TRUEVISION-XFILE.\0")
}
