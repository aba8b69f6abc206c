//! Files that no decoder reads: the error says what they are, and what to do.

use crate::error::Error;

/// The formats that are read, as errors list them.
const READABLE: &str = "a JPEG, PNG, TGA, BMP, WebP, TIFF, HDR, OpenEXR or PPM picture";

/// The error for bytes in which no picture format was found.
pub fn not_a_picture(encoded: &[u8]) -> Error {
    let (what, help) = describe(encoded);
    Error::new(what).expected(READABLE).help(help)
}

/// What the bytes are, and the advice.
fn describe(encoded: &[u8]) -> (String, &'static str) {
    const DOWNLOAD_AGAIN: &str = "download it again";
    const WRITE_AGAIN: &str = "write it again if your own program did, otherwise download it again";
    const CONVERT: &str = "convert it to PNG with an image editor";
    let text = leading_text(encoded);
    let starts = |signature: &[u8]| encoded.starts_with(signature);
    let (what, help) = match () {
        () if encoded.is_empty() => ("the file is empty", WRITE_AGAIN),
        () if text.starts_with("version https://git-lfs") => (
            "this is a git-lfs pointer, not the picture itself",
            "run `git lfs pull` in the repository it came from, then copy the file again",
        ),
        () if text.starts_with("<!doctype html") || text.starts_with("<html") || text.starts_with("<head") => (
            "this is a web page (HTML), not a picture",
            "the link led to a page about the file; open it in a browser and download the picture itself",
        ),
        () if text.starts_with("<svg") || text.contains("<svg") => ("this is an SVG drawing", CONVERT),
        () if text.starts_with("<?xml") => ("this is an XML document, not a picture", "download the picture itself"),
        () if starts(b"PK\x03\x04") => ("this is a zip archive", "rename the archive so that its name ends in .zip"),
        () if starts(b"GIF8") => ("this is a GIF picture, an unsupported format", CONVERT),
        () if starts(b"DDS ") => ("this is a DirectDraw surface (DDS), an unsupported format", CONVERT),
        () if starts(b"8BPS") => ("this is a Photoshop document, an unsupported format", CONVERT),
        () if starts(b"\xABKTX") => ("this is a KTX texture, an unsupported format", CONVERT),
        () if encoded.get(4..8) == Some(b"ftyp") => ("this is a HEIF or AVIF picture, an unsupported format", CONVERT),
        () if starts(b"\x00\x00\x00\x0CjP  ") => ("this is a JPEG 2000 picture, an unsupported format", CONVERT),
        () if starts(b"%PDF") => ("this is a PDF document", "export its picture as PNG"),
        () if encoded.iter().all(|&byte| byte == 0) => ("the file contains only zero bytes", DOWNLOAD_AGAIN),
        () if is_text(encoded) => {
            ("this is a text file, not a picture", "name the picture itself, or download it again if it should be one")
        }
        () => ("unknown picture format", "check that the file is complete, or convert it to PNG with an image editor"),
    };
    (what.to_owned(), help)
}

/// The first characters in lower case, without a byte order mark and leading blanks.
fn leading_text(encoded: &[u8]) -> String {
    let start = String::from_utf8_lossy(&encoded[..encoded.len().min(512)]).to_ascii_lowercase();
    start.trim_start_matches('\u{feff}').trim_start().to_owned()
}

fn is_text(encoded: &[u8]) -> bool {
    encoded.iter().take(512).all(|&byte| byte >= 0x20 || matches!(byte, b'\t' | b'\n' | b'\r'))
}
