//! The report of `skycube probe`: the lookup step by step, as by hand.

use std::fmt;

use serde::ser::{Serialize, SerializeStruct, Serializer};

use super::json::to_json;
use crate::colour::ToneMap;
use crate::envmap::{CubeFilter, Face, Probe, ProbedTexel, SignedAxis, VOrigin};
use crate::math::Vec3;

/// A probe and the names of what it went through.
#[derive(Debug, Clone)]
pub struct ProbeReport<'a> {
    pub probe: &'a Probe,
    pub map: &'a str,
    pub lookup: &'a str,
    /// The file of each image, in the order of [`Face::ALL`].
    pub files: &'a [String; 6],
    /// The same after the fix, if there is something to fix.
    pub after_fix: Option<&'a Self>,
}

/// The report for machines.
impl Serialize for ProbeReport<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let probe = self.probe;
        let texels: Vec<_> = probe.texels.iter().map(|texel| self.json_texel(texel)).collect();
        let mut keys = serializer.serialize_struct("ProbeReport", 21)?;
        keys.serialize_field("map", self.map)?;
        keys.serialize_field("lookup", self.lookup)?;
        keys.serialize_field("direction", &probe.direction)?;
        keys.serialize_field("largest", &probe.largest)?;
        keys.serialize_field("tie", &(probe.largest_axes.len() > 1))?;
        keys.serialize_field("face", &probe.point.face)?;
        keys.serialize_field("inverse_largest", &(1.0 / probe.largest))?;
        keys.serialize_field("u_axis", &probe.row.u)?;
        keys.serialize_field("v_axis", &probe.row.v)?;
        keys.serialize_field("u", &probe.point.u)?;
        keys.serialize_field("v", &probe.point.v)?;
        keys.serialize_field("v_origin", &probe.v_origin)?;
        keys.serialize_field("image", &probe.row.image)?;
        keys.serialize_field("file", self.file(probe.row.image))?;
        keys.serialize_field("size", &probe.size)?;
        keys.serialize_field("position", &probe.position)?;
        keys.serialize_field("filter", &probe.filter)?;
        keys.serialize_field("texels", &texels)?;
        keys.serialize_field("linear", &probe.colour)?;
        keys.serialize_field("srgb8", &codes(probe.colour))?;
        keys.serialize_field("after_fix", &self.after_fix)?;
        keys.end()
    }
}

#[derive(serde::Serialize)]
struct JsonTexel<'a> {
    /// Null beyond a corner of the cube.
    image: Option<Face>,
    file: Option<&'a str>,
    column: Option<usize>,
    row: Option<usize>,
    weight: f32,
    linear: Vec3,
    srgb8: [u8; 3],
}

const AXES: [&str; 3] = ["x", "y", "z"];

impl ProbeReport<'_> {
    /// The report for machines, with that after the fix in it.
    pub fn to_json(&self) -> String {
        to_json("probe", self)
    }

    fn json_texel(&self, texel: &ProbedTexel) -> JsonTexel<'_> {
        JsonTexel {
            image: texel.place.map(|place| place.image),
            file: texel.place.map(|place| self.file(place.image)),
            column: texel.place.map(|place| place.column),
            row: texel.place.map(|place| place.row),
            weight: texel.weight,
            linear: texel.colour,
            srgb8: codes(texel.colour),
        }
    }

    fn file(&self, image: Face) -> &str {
        &self.files[image.index()]
    }

    /// `|y| = 1, so face -y`, and the rule where two are as large.
    fn largest(&self) -> String {
        let probe = self.probe;
        let names: Vec<String> = probe.largest_axes.iter().map(|&axis| format!("|{}|", AXES[axis])).collect();
        let rule = match names.len() {
            1 => "",
            _ => " (a tie: x wins over y, y over z)",
        };
        let largest = number(probe.largest);
        format!("{} = {largest}: face {}{rule}", names.join(" = "), probe.point.face.signed_name())
    }

    /// `(-x/|y| + 1) / 2 = (-0.3/1 + 1) / 2 = 0.35`.
    fn coordinate(&self, axis: SignedAxis, value: f32) -> String {
        let sign = if axis.negative { "-" } else { "" };
        let name = AXES[usize::from(axis.axis)];
        let largest = AXES[self.probe.point.face.axis()];
        let component = number(axis.component(self.probe.direction.to_array()));
        let (quotient, value) = (number(self.probe.largest), number(value));
        format!("({sign}{name}/|{largest}| + 1) / 2 = ({component}/{quotient} + 1) / 2 = {value}")
    }

    fn write_position(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let ([width, height], [x, y]) = (self.probe.size, self.probe.position);
        let (down, origin) = match self.probe.v_origin {
            VOrigin::Top => ("v", "top"),
            VOrigin::Bottom => ("(1 - v)", "bottom"),
        };
        writeln!(formatter, "texel position  x = u * {width} = {x} from the left")?;
        writeln!(formatter, "                y = {down} * {height} = {y} from the top, since v = 0 is the {origin} row")
    }

    fn write_texels(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let filter = match self.probe.filter {
            CubeFilter::Nearest => "nearest: the texel it falls into",
            CubeFilter::Bilinear => {
                "bilinear: the four texel centres around it (at half integers), clamped at the border"
            }
            CubeFilter::Seamless => "seamless: the four texel centres around it, across the border",
        };
        writeln!(formatter, "filter          {filter}")?;
        writeln!(formatter, "                image  column     row  weight      8-bit          linear")?;
        for texel in &self.probe.texels {
            let place = texel.place.map_or_else(
                || format!("{:<21}", "mean of the others"),
                |place| format!("{}   {:>6}  {:>6}", place.image.name(), place.column, place.row),
            );
            let weight = format!("{:.6}", texel.weight);
            writeln!(formatter, "                {place}  {weight:<10}  {}", colours(texel.colour))?;
        }
        Ok(())
    }
}

impl fmt::Display for ProbeReport<'_> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let probe = self.probe;
        let [x, y, z] = probe.direction.to_array().map(number);
        writeln!(formatter, "{} through the lookup {}", self.map, self.lookup)?;
        writeln!(formatter, "components      x = {x}, y = {y}, z = {z}")?;
        writeln!(formatter, "largest         {}", self.largest())?;
        let axis = AXES[probe.point.face.axis()];
        writeln!(formatter, "tmp             1/|{axis}| = {}", number(1.0 / probe.largest))?;
        writeln!(formatter, "u along {}      {}", probe.row.u, self.coordinate(probe.row.u, probe.point.u))?;
        writeln!(formatter, "v along {}      {}", probe.row.v, self.coordinate(probe.row.v, probe.point.v))?;
        let [width, height] = probe.size;
        let image = probe.row.image;
        writeln!(formatter, "image           {}: {}, {width} x {height} texels", image.name(), self.file(image))?;
        self.write_position(formatter)?;
        self.write_texels(formatter)?;
        writeln!(formatter, "colour          {}", colours(probe.colour))
    }
}

/// The shortest digits that give the same `f32`, with an exponent where there would be many zeros.
fn number(value: f32) -> String {
    let magnitude = value.abs();
    if magnitude == 0.0 || (1e-4..1e7).contains(&magnitude) { value.to_string() } else { format!("{value:e}") }
}

/// `( 12,  34,  56)  (0.003677, 0.015996, 0.039546)`.
fn colours(colour: Vec3) -> String {
    let [red, green, blue] = codes(colour);
    let Vec3 { x, y, z } = colour;
    format!("({red:>3}, {green:>3}, {blue:>3})  ({x:.6}, {y:.6}, {z:.6})")
}

/// The sRGB codes that a PNG would hold.
fn codes(colour: Vec3) -> [u8; 3] {
    ToneMap::Clamp.display(colour).to_array().map(|value| (value * 255.0).round() as u8)
}
