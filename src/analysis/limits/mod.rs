//! The limits of what the program promises: `stress` measures that they are kept, `render` warns of scenes outside.

mod limit;
mod scene;

pub use limit::{
    COORDINATE, FACE_SIZE, INDEX, LIGHT_AREA, LIMITS, Limit, NESTING, RADIUS, REMOTENESS, ROUGHNESS, Range, SCALE,
    VERTEX_REMOTENESS,
};
pub use scene::outside_limits;
