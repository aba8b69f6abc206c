//! From a scene to a picture: rows on all cores, the same bytes whatever their number.

mod axis_shots;
mod film;
mod layers;
mod map_view;
mod progress;
mod progressive;
mod ray_source;
mod renderer;

pub use axis_shots::{AxisShot, front};
pub use film::{FilmRow, Keeps};
pub use layers::Layers;
pub use progress::{Progress, Silent};
pub use progressive::{Budget, render_progressively};
pub use renderer::{PixelSample, Renderer, Rendering, bake_face, render};
