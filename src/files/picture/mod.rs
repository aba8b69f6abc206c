//! Every file format of pictures, in terms of samples.
//!
//! Only this module touches the image codecs.

mod decode;
mod encoders;
mod foreign;
mod format;
mod header;
mod jpeg_extent;
mod openexr;
mod output_format;
mod pixel_loops;
mod png;
mod remark;
mod still;

pub use decode::{Decoded, Samples, decode, read, read_file_header, read_header};
pub use encoders::{encode_hdr, encode_jpeg};
pub use format::Format;
pub use header::Header;
pub use openexr::{EnvironmentLayout, encode as encode_openexr, exr_environment};
pub use output_format::OutputFormat;
pub use pixel_loops::{PixelLoops, SampleKind, Stretch};
pub use png::{PngDepth, PngSamples, encode_png, write_png};
pub use remark::with_remark;
