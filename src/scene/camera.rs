//! The table `[camera]`.

use super::document::Table;
use crate::camera::Camera;
use crate::error::Result;
use crate::math::DVec3;

/// The largest picture side in pixels.
pub const MAXIMUM_SIDE: u32 = 65_536;

/// The camera and its samples a pixel.
pub(super) fn read(mut table: Table) -> Result<(Camera, u32)> {
    let position = table.required("position")?.vector()?;
    let target = table.required("target")?.vector()?;
    let up = table.optional("up").map_or(Ok(DVec3::Z), |up| up.vector())?;
    let field_of_view = match table.optional("field_of_view") {
        Some(angle) => angle.number_where("degrees, from 0.001 to 179.999", |a| (0.001..=179.999).contains(&a))?,
        None => 45.0,
    };
    let size = match table.optional("size") {
        Some(size) => {
            let sides = size.list()?;
            let [width, height] = sides.as_slice() else {
                return Err(size.error(format!("found a list of {}", sides.len())).expected("[width, height]"));
            };
            [width.integer(1..=MAXIMUM_SIDE)? as usize, height.integer(1..=MAXIMUM_SIDE)? as usize]
        }
        None => [640, 480],
    };
    let samples = table.optional("samples").map_or(Ok(1), |samples| samples.integer(1..=1 << 24))?;
    let camera = Camera::look_at(position, target, up, field_of_view, size).ok_or_else(|| {
        table
            .error("the camera's orientation is undefined")
            .expected("a target away from the position, and an up that is not along the view")
    })?;
    table.finish()?;
    Ok((camera, samples))
}
