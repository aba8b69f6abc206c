//! The report of `skycube shots`: the files, and the camera to copy.

use std::fmt;

use crate::envmap::SignedAxis;
use crate::render::AxisShot;

/// The axis shots of a map.
#[derive(Debug, Clone)]
pub struct ShotsReport {
    /// In the order of [`Face::ALL`](crate::envmap::Face::ALL).
    pub shots: [AxisShot; 6],
    /// The image each shot shows: `posz (Meadow.zip/posz.jpg)`.
    pub images: [String; 6],
    pub world_up: SignedAxis,
    pub lookup: String,
    /// Side of a shot in pixels.
    pub size: usize,
    /// Samples per pixel.
    pub samples: u32,
    /// Files written, the shots first.
    pub written: Vec<String>,
}

impl ShotsReport {
    /// The camera of all six in one line.
    pub fn camera(&self) -> String {
        let unit = if self.samples == 1 { "sample at the pixel's centre" } else { "samples per pixel" };
        format!(
            "camera at (0, 0, 0), 90° wide and high, {} x {} pixels, {} {unit}, right = {}; world up {}, lookup {}",
            self.size,
            self.size,
            self.samples,
            self.shots[0].handedness.right(),
            self.world_up,
            self.lookup
        )
    }
}

impl fmt::Display for ShotsReport {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        for file in &self.written {
            writeln!(formatter, "wrote {file}")?;
        }
        writeln!(formatter, "\n{}", self.camera())?;
        writeln!(formatter, "\nshot   forward       up            right         sees")?;
        for (shot, image) in self.shots.iter().zip(&self.images) {
            writeln!(
                formatter,
                "{}   {}  {}  {}  face {}, image {image}",
                shot.direction.name(),
                vector(shot.direction.signed_axis()),
                vector(shot.up),
                vector(shot.right()),
                shot.direction.signed_name()
            )?;
        }
        Ok(())
    }
}

/// `( 0, 0,-1)`.
fn vector(axis: SignedAxis) -> String {
    let [x, y, z] = axis.direction().to_array().map(|component| component as i32);
    format!("({x:>2}, {y:>2}, {z:>2})")
}
