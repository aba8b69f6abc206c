//! What an OpenEXR file says of itself as an environment map. STAND-IN: replaced when the picture formats are merged.

use std::io::Cursor;
use std::path::Path;

use exr::meta::MetaData;
use exr::meta::attribute::EnvironmentMap;

use crate::error::{Error, Result};

/// How an OpenEXR file lays out its environment map: the value of its `envmap` attribute.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EnvironmentLayout {
    /// Six square faces stacked +X -X +Y -Y +Z -Z from the top.
    Cube,
    /// Longitude across, latitude down: twice as wide as high.
    LatitudeLongitude,
}

/// The `envmap` attribute of an OpenEXR file, given at least all of its header. None if the attribute is absent, and
/// for files of all other formats.
pub fn environment_layout(encoded: &[u8], name: &Path) -> Result<Option<EnvironmentLayout>> {
    const MAGIC: [u8; 4] = [0x76, 0x2f, 0x31, 0x01];
    if !encoded.starts_with(&MAGIC) {
        return Ok(None);
    }
    let meta = MetaData::read_from_buffered(Cursor::new(encoded), false)
        .map_err(|error| Error::new(format!("cannot read the OpenEXR header: {error}")).in_file(name))?;
    let layout = meta.headers.first().and_then(|header| header.own_attributes.environment_map);
    Ok(layout.map(|layout| match layout {
        EnvironmentMap::Cube => EnvironmentLayout::Cube,
        EnvironmentMap::LatitudeLongitude => EnvironmentLayout::LatitudeLongitude,
    }))
}
