//! Sums over the sphere.

use skycube::math::DVec3;
use skycube::stress::Random;

/// A place on the cube around the origin: number of the face +x -x +y -y +z -z, and the two other coordinates in
/// `[0, 1]`, in the order x y z.
pub fn place_on_cube(direction: DVec3) -> (usize, [f64; 2]) {
    let size = direction.abs();
    let axis = if size.x >= size.y && size.x >= size.z { 0 } else { 1 + usize::from(size.z > size.y) };
    let point = direction / size[axis];
    let others = [(axis + 1) % 3, (axis + 2) % 3];
    let (low, high) = (others[0].min(others[1]), others[0].max(others[1]));
    (2 * axis + usize::from(direction[axis] < 0.0), [(point[low] + 1.0) / 2.0, (point[high] + 1.0) / 2.0])
}

/// The point of the cube at a place; its largest component is 1.
pub fn point_on_cube(face: usize, place: [f64; 2]) -> DVec3 {
    let axis = face / 2;
    let mut point = DVec3::ZERO;
    point[axis] = if face.is_multiple_of(2) { 1.0 } else { -1.0 };
    let mut coordinates = place.into_iter();
    for other in (0..3).filter(|&other| other != axis) {
        point[other] = 2.0 * coordinates.next().unwrap() - 1.0;
    }
    point
}

/// Number of the bin of a direction, each face of the cube having `side` by `side` bins.
pub fn cube_bin(direction: DVec3, side: usize) -> usize {
    let (face, place) = place_on_cube(direction);
    let [column, row] = place.map(|coordinate| ((coordinate * side as f64) as usize).min(side - 1));
    (face * side + row) * side + column
}

/// The integral of a function of the unit direction over each bin, by `steps` by `steps` midpoints on the plane.
pub fn cube_integrals(side: usize, steps: usize, mut function: impl FnMut(DVec3) -> f64) -> Vec<f64> {
    let mut integrals = vec![0.0; 6 * side * side];
    let count = side * steps;
    let area = 4.0 / (count * count) as f64;
    for face in 0..6 {
        for row in 0..count {
            for column in 0..count {
                let place = [column, row].map(|step| (step as f64 + 0.5) / count as f64);
                let point = point_on_cube(face, place);
                let bin = (face * side + row / steps) * side + column / steps;
                integrals[bin] += function(point.normalize()) * area / point.length().powi(3);
            }
        }
    }
    integrals
}

/// A stratified place of `[0, 1)^2`: number `index` of `side * side`.
pub fn stratified(index: usize, side: usize, random: &mut Random) -> [f64; 2] {
    [(index % side) as f64 + random.unit(), (index / side) as f64 + random.unit()].map(|place| place / side as f64)
}

/// Mean and its standard error.
pub fn mean_and_error(values: &[f64]) -> (f64, f64) {
    let count = values.len() as f64;
    let mean = values.iter().sum::<f64>() / count;
    let variance = values.iter().map(|value| (value - mean).powi(2)).sum::<f64>() / (count - 1.0);
    (mean, (variance / count).sqrt())
}
