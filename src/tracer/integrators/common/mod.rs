//! What several integrators need: the surface as a ray sees it, the glasses a ray is inside of, the light sources, and
//! somebody who may watch.

pub mod enclosing;
pub mod first_hit;
pub mod lights;
pub mod media;
pub mod observer;
pub mod task;
pub mod vertex;
pub mod view;
