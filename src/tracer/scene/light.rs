//! The tables `[[lights]]`.

use skycube_files::document::{Table, Value};

use crate::error::Result;
use crate::lights::{Cone, Falloff, Light};
use crate::math::DVec3;
use crate::math::functions::cos;

/// Reads one light.
pub(super) fn read(mut table: Table) -> Result<Light> {
    #[derive(Clone, Copy, clap::ValueEnum)]
    enum Kind {
        Ambient,
        Directional,
        Point,
        Spot,
    }
    let kind: Kind = table.required("kind")?.choice()?;
    let light = match kind {
        Kind::Ambient => Light::Ambient { radiance: table.required("radiance")?.colour()? },
        Kind::Directional => Light::Directional {
            direction: direction(&table.required("direction")?)?,
            irradiance: table.required("irradiance")?.colour()?,
        },
        Kind::Point => Light::Point {
            position: table.required("position")?.vector()?,
            intensity: table.required("intensity")?.colour()?,
            falloff: falloff(&mut table)?,
        },
        Kind::Spot => read_spot(&mut table)?,
    };
    table.finish()?;
    Ok(light)
}

fn read_spot(table: &mut Table) -> Result<Light> {
    let position = table.required("position")?.vector()?;
    let target = table.required("target")?;
    let axis = (target.vector()? - position)
        .try_normalize()
        .ok_or_else(|| target.error("the target is at the light's position"))?;
    let degrees = |value: Value| value.number_where("degrees, more than 0 and at most 180", |a| a > 0.0 && a <= 180.0);
    let outer = degrees(table.required("angle")?)?;
    let inner = match table.optional("inner_angle") {
        Some(value) => value.number_where("degrees, at most the angle", |a| a >= 0.0 && a <= outer)?,
        None => 0.9 * outer,
    };
    let cone = Cone { axis, cos_inner: cos(inner.to_radians()), cos_outer: cos(outer.to_radians()) };
    Ok(Light::Spot { position, intensity: table.required("intensity")?.colour()?, falloff: falloff(table)?, cone })
}

fn direction(value: &Value) -> Result<DVec3> {
    value.vector()?.try_normalize().ok_or_else(|| value.error("a direction must not be zero"))
}

fn falloff(table: &mut Table) -> Result<Falloff> {
    table.optional("falloff").map_or(Ok(Falloff::default()), |value| value.choice())
}
