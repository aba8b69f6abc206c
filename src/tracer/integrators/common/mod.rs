//! What several integrators need: the surface as a ray sees it, the glasses around a ray, the light sources, and an
//! observer.

pub mod enclosing;
pub mod first_hit;
pub mod lights;
pub mod media;
pub mod observer;
pub mod task;
pub mod vertex;
pub mod view;
