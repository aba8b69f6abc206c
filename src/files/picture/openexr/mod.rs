//! OpenEXR files: half, float and uint channels under every compression the `exr` crate has.

mod channels;
mod read;
mod write;

pub use read::{EnvironmentLayout, decode, exr_environment, read_header};
pub use write::encode;
