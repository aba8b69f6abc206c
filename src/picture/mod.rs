//! Pictures: the float raster, texels as files hold them, textures, and every file format.
//!
//! Only this module touches the image codecs.

mod decode;
mod exr_environment;
mod raster;
mod texels;

pub use decode::{decode, read, read_header};
pub use exr_environment::{EnvironmentLayout, environment_layout};
pub use raster::Raster;
pub use texels::{Format, Header, Picture, Texels};
