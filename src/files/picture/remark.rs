//! A remark inside a picture file, shown by programs among the file properties.

use super::OutputFormat;

/// Bytes before the first chunk of a PNG file that may follow its header: signature and `IHDR`.
const PNG_HEADER: usize = 8 + 25;

/// The encoded picture with a remark (ASCII) in it: a `tEXt` chunk in PNG, a comment segment in JPEG, a header line in HDR.
/// OpenEXR files are written with theirs.
pub fn with_remark(mut encoded: Vec<u8>, format: OutputFormat, remark: &str) -> Vec<u8> {
    let (place, bytes) = match format {
        OutputFormat::Png => (PNG_HEADER, png_text(remark)),
        OutputFormat::Jpeg => (2, jpeg_comment(remark)),
        OutputFormat::Hdr => match encoded.iter().position(|&byte| byte == b'\n') {
            Some(end) => (end + 1, format!("# {remark}\n").into_bytes()),
            None => return encoded,
        },
        OutputFormat::Exr => return encoded,
    };
    encoded.splice(place..place, bytes);
    encoded
}

/// A chunk of length, type, content and checksum (PNG specification, 11.3.3.2).
fn png_text(remark: &str) -> Vec<u8> {
    let mut body = b"tEXtComment\0".to_vec();
    body.extend_from_slice(remark.as_bytes());
    let checksum = crc32fast::hash(&body);
    let length = (body.len() - 4) as u32;
    [&length.to_be_bytes()[..], &body, &checksum.to_be_bytes()].concat()
}

/// A segment of marker, length with itself counted, and content (ITU-T T.81, B.2.4.5).
fn jpeg_comment(remark: &str) -> Vec<u8> {
    let remark = &remark.as_bytes()[..remark.len().min(60_000)];
    [&[0xff, 0xfe], &((remark.len() + 2) as u16).to_be_bytes()[..], remark].concat()
}
