//! From a scene to a picture: tiles on all cores, the same bytes whatever their number.

mod axis_shots;
mod film;
mod progress;

pub use axis_shots::{AxisShot, front};
pub use film::{Rendering, bake_face, render};
pub use progress::{Progress, Silent};
