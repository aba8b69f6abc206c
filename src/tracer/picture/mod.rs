//! Pictures: the float raster, texels as files hold them, textures, and rasters as files.

mod bilinear;
mod decode;
mod display;
mod encode;
mod jpeg_data;
mod pixel_loops;
mod raster;
mod rearranged;
mod resize;
mod texels;
mod texture;

pub use bilinear::{Footprint, neighbours};
pub use decode::{decode, read, read_file_header, read_header};
pub use display::{display_bytes, without_opacity};
pub use encode::{Extras, SideLayer, WriteOptions, encode, encode_with, write, write_with};
pub use raster::Raster;
pub use texels::{Picture, Texels};
pub use texture::{Filter, Texture, Wrap};

pub use skycube_files::picture::{
    EnvironmentLayout, Format, Header, OutputFormat, PngDepth, PngSamples as Samples, encode_jpeg, encode_png,
    exr_environment, write_png,
};
pub use skycube_files::{
    archive::archive_of, between_writes, check_folder_target, check_target, folder_of, is_standard_stream, make_folder,
    read_plain_file, write_atomically, write_if_absent, write_together,
};

#[cfg(test)]
mod tests;
