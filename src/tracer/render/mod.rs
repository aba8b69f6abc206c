//! From a scene to a picture: rows on all cores, the same bytes for any number of them.

mod axis_shots;
mod bake;
mod film;
mod layers;
mod map_view;
mod pixel_sample;
mod progress;
mod progressive;
mod ray_source;
mod renderer;
mod rendering;
mod watcher;

pub use axis_shots::AxisShot;
pub use bake::bake_face;
pub use film::{FilmRow, Keeps};
pub use layers::Layers;
pub use pixel_sample::PixelSample;
pub use progress::{Progress, Silent};
pub use progressive::{Budget, render_progressively};
pub use renderer::{Renderer, render};
pub use rendering::Rendering;
