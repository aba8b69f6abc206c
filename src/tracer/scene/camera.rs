//! The table `[camera]`.

use skycube_files::document::Table;

use crate::camera::{Camera, Lens};
use crate::error::Result;
use crate::math::DVec3;
use crate::sampling::Sampling;

/// The largest picture side in pixels.
pub const MAXIMUM_SIDE: u32 = 65_536;

/// The camera, its samples per pixel, and how they are chosen.
pub(super) fn read(mut table: Table) -> Result<(Camera, u32, Sampling)> {
    let (camera, samples) = (read_camera(&mut table)?, read_samples(&mut table)?);
    let sampling = read_sampling(&mut table)?;
    table.finish()?;
    Ok((camera, samples, sampling))
}

fn read_samples(table: &mut Table) -> Result<u32> {
    table.optional("samples").map_or(Ok(1), |samples| samples.integer(1..=1 << 24))
}

fn read_sampling(table: &mut Table) -> Result<Sampling> {
    let mut sampling = Sampling::default();
    if let Some(sampler) = table.optional("sampler") {
        sampling.sampler = sampler.choice()?;
    }
    if let Some(filter) = table.optional("filter") {
        sampling.filter = filter.choice()?;
    }
    if let Some(seed) = table.optional("seed") {
        sampling.seed = seed.integer(0..=u32::MAX)?;
    }
    Ok(sampling)
}

/// A lens if `aperture`, its diameter, is there and not 0; the plane in focus goes through the target unless `focus` says
/// otherwise.
fn read_lens(table: &mut Table, to_target: f64) -> Result<Option<Lens>> {
    let Some(aperture) = table.optional("aperture") else {
        return match table.optional("focus") {
            Some(focus) => {
                Err(focus.error("a pinhole has no focus distance").help("add camera.aperture, the lens's diameter"))
            }
            None => Ok(None),
        };
    };
    let diameter = aperture.number_where("the diameter of the lens, from 0 to 1e6", |a| (0.0..=1e6).contains(&a))?;
    let focus = match table.optional("focus") {
        Some(value) => value.number_where("a distance from 1e-6 to 1e12", |focus| (1e-6..=1e12).contains(&focus))?,
        None => to_target,
    };
    Ok((diameter > 0.0).then_some(Lens { radius: diameter / 2.0, focus }))
}

fn read_camera(table: &mut Table) -> Result<Camera> {
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
                return Err(size.error(format!("found a list of length {}", sides.len())).expected("[width, height]"));
            };
            [width.integer(1..=MAXIMUM_SIDE)? as usize, height.integer(1..=MAXIMUM_SIDE)? as usize]
        }
        None => [640, 480],
    };
    let lens = read_lens(table, (target - position).length())?;
    let camera = Camera::look_at(position, target, up, field_of_view, size).ok_or_else(|| {
        table
            .error("the camera's orientation is undefined")
            .expected("a target away from the position, and an up that is not parallel to the view")
    })?;
    Ok(camera.with_lens(lens))
}
