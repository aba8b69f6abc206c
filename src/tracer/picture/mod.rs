//! Pictures: the float raster, texels as files hold them, textures, and every file format.
//!
//! Only this module touches the image codecs.

mod atomic_file;
mod bilinear;
mod decode;
mod display;
mod encode;
mod foreign;
mod format;
mod jpeg_extent;
mod lay;
mod openexr;
mod output_format;
mod pixel_codecs;
mod png;
mod raster;
mod remark;
mod resize;
mod texels;
mod texture;

pub use atomic_file::{check_folder_target, check_target, write_atomically, write_if_absent, write_together};
pub use bilinear::Footprint;
pub use decode::{decode, read, read_file_header, read_header};
pub use display::{display_bytes, without_opacity};
pub use encode::{Extras, SideLayer, WriteOptions, encode, write, write_with};
pub use format::Format;
pub use openexr::{EnvironmentLayout, exr_environment};
pub use output_format::OutputFormat;
pub use png::{PngDepth, Samples, encode_png, write_png};
pub use raster::Raster;
pub use texels::{Header, Picture, Texels};
pub use texture::{Filter, Texture, Wrap};

#[cfg(test)]
mod tests;
