//! All file formats of pictures, in terms of samples.
//!
//! Only this module touches the image codecs.

mod colour_space;
mod decode;
mod decoded;
mod encoders;
mod format;
mod header;
mod jpeg_extent;
mod netpbm;
mod openexr;
mod orientation;
mod output_format;
mod palette;
mod pixel_loops;
mod png;
mod radiance_header;
mod remark;
mod still;
mod tiff_tags;
mod unsupported;

pub use colour_space::ColourSpace;
pub use decode::{decode, read, read_file_header, read_header};
pub use decoded::{Decoded, Samples};
pub use encoders::{encode_hdr, encode_jpeg};
pub use format::Format;
pub use header::Header;
pub use openexr::{EnvironmentLayout, encode as encode_openexr, exr_environment};
pub use output_format::OutputFormat;
pub use pixel_loops::{PixelLoops, SampleKind, Stretch};
pub use png::{PngDepth, PngSamples, encode_png, write_png};
pub use remark::with_remark;
