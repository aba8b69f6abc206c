//! The limits of the promised accuracy: `stress` measures it, `render` warns of scenes outside.

mod limit;
mod scene;

pub use limit::{
    COORDINATE, FACE_SIZE, INDEX, LIGHT_AREA, LIMITS, Limit, NESTING, RADIUS, REMOTENESS, ROUGHNESS, Range, SCALE,
    VERTEX_REMOTENESS,
};
pub use scene::outside_limits;
