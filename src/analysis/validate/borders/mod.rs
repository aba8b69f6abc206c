//! The borders of the six images, and the cost of one as the continuation of another.

pub mod agreement;
pub mod border;
pub mod display;
pub mod edge;
pub mod pair_cost;
pub mod signal;
