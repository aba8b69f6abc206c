//! The borders of the six images, and what it costs to let one continue another.

pub mod agreement;
pub mod border;
pub mod display;
pub mod edge;
pub mod pair_cost;
pub mod signal;
