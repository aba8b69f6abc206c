//! The integrators as a lecture shows them, one file each: faster code is tested against them, and `skycube trace`
//! watches them.

pub mod normals;
pub mod path;
pub mod phong;
pub mod whitted;
