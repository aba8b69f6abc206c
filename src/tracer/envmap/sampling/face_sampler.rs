//! Cube maps: cells of the six faces, in the orientation of the lookup.

use super::brightness::BrightnessHistogram;
use super::cells::{Cell, CellAxis, CellTable};
use super::texel_angles::TexelAngles;
use super::texel_means::{Beyond, bilinear_means, texel_luminances, weighed_luminance};
use crate::envmap::{CubeFilter, CubeMap, Face, Lookup};
use crate::error::Result;
use crate::math::DVec3;
use crate::parallel;

/// Most cells along the side of a face. Larger pictures have several texels in a cell: cells half inside a sun make its
/// rim noisy. The relative variance of luminance / density for faces of 2048 texels and a sun of 0.5 degrees that gives
/// half of all light is 0.45, 0.14 and 0.05 with 512, 1024 and 2048 cells; the tables take 9, 38 and 151 MB.
pub(super) const CELLS_PER_SIDE: usize = 1024;

/// Draws directions in proportion to a cube map's luminance.
///
/// Within a cell places are uniform on the plane of the face, at distance 1 from the centre of the cube, where the area
/// of a face is 4. An area `dA` at (x, y) on it is seen under the solid angle `dA / (1 + x^2 + y^2)^(3/2)`.
#[derive(Debug)]
pub(super) struct FaceSampler {
    table: CellTable,
    frames: [FaceFrame; 6],
}

/// Where the picture of a face lies in space: `corner + right * across + down * along`, as the lookup says.
#[derive(Debug, Clone, Copy)]
struct FaceFrame {
    corner: DVec3,
    across: DVec3,
    along: DVec3,
}

impl FaceFrame {
    fn new(lookup: &Lookup, face: Face) -> Self {
        let corner = lookup.image_direction(face, 0.0, 0.0);
        let across = lookup.image_direction(face, 1.0, 0.0) - corner;
        let along = lookup.image_direction(face, 0.0, 1.0) - corner;
        Self { corner, across, along }
    }

    /// The place in the picture of a point of the face.
    #[inline]
    fn place(&self, point: DVec3) -> [f64; 2] {
        let offset = point - self.corner;
        [self.across, self.along].map(|axis| (offset.dot(axis) / axis.length_squared()).clamp(0.0, 1.0))
    }
}

impl FaceSampler {
    /// Reads all six faces, decoding what was not decoded yet.
    pub(super) fn new(map: &CubeMap, histogram: &mut BrightnessHistogram) -> Result<Self> {
        let row = |face: Face| map.lookup().row(face);
        // An error comes back below.
        parallel::for_each(Face::ALL, |face| drop(map.picture(row(face).image)));
        let mut table = CellTable::default();
        let mut angles: Option<TexelAngles> = None;
        for face in Face::ALL {
            let picture = map.picture(row(face).image)?;
            let (width, height) = (picture.width(), picture.height());
            let known = angles.take().filter(|angles| (angles.width, angles.height) == (width, height));
            let angles = angles.insert(known.unwrap_or_else(|| TexelAngles::new(width, height)));
            let (columns, rows) = (CellAxis::new(width, CELLS_PER_SIDE), CellAxis::new(height, CELLS_PER_SIDE));
            let cells = cells(&face_means(map, face)?, angles, columns, rows);
            cells.iter().for_each(|&cell| histogram.add(cell));
            table.push(columns, rows, &cells);
        }
        let frames = Face::ALL.map(|face| FaceFrame::new(map.lookup(), face));
        Ok(Self { table: table.finish(), frames })
    }

    /// Integral of the luminance over the sphere.
    pub(super) fn power(&self) -> f64 {
        self.table.power()
    }

    #[inline]
    pub(super) fn sample(&self, place: [f64; 2]) -> (DVec3, f64) {
        let cell = self.table.draw(place);
        let grid = self.table.grid(cell.grid);
        let (left, width) = grid.columns.extent(cell.column);
        let (top, height) = grid.rows.extent(cell.row);
        let frame = &self.frames[cell.grid];
        let point = frame.corner
            + frame.across * (left + width * cell.within[0])
            + frame.along * (top + height * cell.within[1]);
        let square = point.length_squared();
        let distance = square.sqrt();
        (point / distance, cell.probability / (4.0 * width * height) * square * distance)
    }

    #[inline]
    pub(super) fn density(&self, direction: DVec3) -> f64 {
        // The face that the lookup reads in this direction.
        let face = Lookup::face_towards(direction.as_vec3());
        let point = direction / direction[face.axis()].abs();
        let [right, down] = self.frames[face.index()].place(point);
        let grid = self.table.grid(face.index());
        let (column, row) = (grid.columns.cell_at(right), grid.rows.cell_at(down));
        let area = 4.0 * grid.columns.extent(column).1 * grid.rows.extent(row).1;
        let square = point.length_squared();
        self.table.probability(face.index(), column, row) / area * square * square.sqrt()
    }
}

/// Power and solid angle of the cells of a face.
fn cells(means: &[f32], angles: &TexelAngles, columns: CellAxis, rows: CellAxis) -> Vec<Cell> {
    let count = columns.count();
    let mut cells = vec![Cell::default(); count * rows.count()];
    parallel::for_each(cells.chunks_mut(count).enumerate(), |(row, cells)| {
        for texel_row in rows.texels_of(row) {
            for (column, cell) in cells.iter_mut().enumerate() {
                for texel in columns.texels_of(column) {
                    let solid_angle = angles.of(texel, texel_row);
                    cell.solid_angle += solid_angle;
                    cell.power += f64::from(means[texel_row * columns.texels + texel]) * solid_angle;
                }
            }
        }
    });
    cells
}

/// The mean luminance over each texel of the picture that a face reads, as the map's filter shows it there.
fn face_means(map: &CubeMap, face: Face) -> Result<Vec<f32>> {
    let picture = map.picture(map.lookup().row(face).image)?;
    let (width, height) = (picture.width(), picture.height());
    let values = texel_luminances(picture);
    if map.filter() == CubeFilter::Nearest {
        return Ok(values);
    }
    let mut means = bilinear_means(&values, width, Beyond::Border);
    if map.filter() == CubeFilter::Seamless {
        let inner_rows = 1..height.max(1) - 1;
        for row in 0..height {
            let step = if inner_rows.contains(&row) { (width - 1).max(1) } else { 1 };
            for column in (0..width).step_by(step) {
                means[row * width + column] = filtered_mean(map, face, [width, height], [column, row]);
            }
        }
    }
    Ok(means)
}

/// The mean over a texel at the border, from the filter itself: interpolation is linear in either coordinate over each
/// quarter of a texel, so the mean over the quarter is the value in its middle.
fn filtered_mean(map: &CubeMap, face: Face, size: [usize; 2], texel: [usize; 2]) -> f32 {
    let place = |axis: usize, offset: f64| (texel[axis] as f64 + offset) / size[axis] as f64;
    let quarters = [(0.25, 0.25), (0.75, 0.25), (0.25, 0.75), (0.75, 0.75)];
    let values = quarters.map(|(right, down)| {
        let direction = map.lookup().image_direction(face, place(0, right), place(1, down));
        weighed_luminance(map.sample(direction.as_vec3()))
    });
    values.iter().sum::<f32>() / 4.0
}
