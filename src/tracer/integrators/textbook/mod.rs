//! The integrators as a lecture shows them, one file each: what they compute is what every faster code is tested against,
//! and what `skycube trace` watches.

pub mod normals;
pub mod path;
pub mod phong;
pub mod whitted;
