//! Polygons as triangles.

use earcut::Earcut;

use crate::math::DVec3;

/// Cuts polygons into triangles; keeps its memory between them.
pub(super) struct Triangulation {
    ears: Earcut<f64>,
    triangles: Vec<u32>,
}

impl Triangulation {
    pub(super) fn new() -> Self {
        Self { ears: Earcut::new(), triangles: Vec::new() }
    }

    /// The triangles of a polygon, three numbers of corners each, turned as the polygon is.
    ///
    /// ```text
    ///     fan from corner 0         a concave polygon: the fan leaves it    ... its ears do not
    ///       3-------2                 2                                      2
    ///       |    /  |                 |\   .  1                              |\      1
    ///       |  /    |                 | \ . /                                | \    /
    ///       4/      |                 |  3                                   |  3 /
    ///       0-------1                 0                                      0
    /// ```
    ///
    /// The fan, if none of its triangles is turned over; or else by cutting off ears (Meisters, Polygons Have Ears, 1975).
    /// Exporters write a hole by a cut from the border to the hole and back.
    pub(super) fn triangles(&mut self, corners: &[DVec3]) -> impl Iterator<Item = [u32; 3]> + '_ {
        self.triangles.clear();
        let normal = normal(corners);
        if !fan(corners.len()).all(|triangle| is_turned_like(normal, triangle, corners)) {
            self.cut_ears(corners, normal);
        }
        if self.triangles.is_empty() {
            self.triangles.extend(fan(corners.len()).flatten());
        }
        self.triangles.as_chunks().0.iter().copied()
    }

    fn cut_ears(&mut self, corners: &[DVec3], normal: DVec3) {
        // Seen along the axis that the normal is nearest to, nothing overlaps that does not in its own plane.
        let size = normal.abs();
        let [first, second] = match () {
            () if size.x >= size.y && size.x >= size.z => [1, 2],
            () if size.y >= size.z => [2, 0],
            () => [0, 1],
        };
        let flat = corners.iter().map(|corner| [corner[first], corner[second]]);
        self.ears.earcut(flat, &[], &mut self.triangles);
        for triangle in self.triangles.as_chunks_mut().0 {
            if !is_turned_like(normal, *triangle, corners) {
                triangle.swap(1, 2);
            }
        }
    }
}

fn fan(corners: usize) -> impl Iterator<Item = [u32; 3]> {
    (2..corners as u32).map(|last| [0, last - 1, last])
}

/// Twice the area times the unit normal (Newell's method): the sum over a fan, in which what lies outside cancels.
fn normal(corners: &[DVec3]) -> DVec3 {
    fan(corners.len()).map(|triangle| area_vector(triangle, corners)).sum()
}

fn area_vector(triangle: [u32; 3], corners: &[DVec3]) -> DVec3 {
    let [a, b, c] = triangle.map(|corner| corners[corner as usize]);
    (b - a).cross(c - a)
}

fn is_turned_like(normal: DVec3, triangle: [u32; 3], corners: &[DVec3]) -> bool {
    area_vector(triangle, corners).dot(normal) >= 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The area of a polygon's triangles, none of them turned over.
    fn area(corners: &[[f64; 2]], lift: fn([f64; 2]) -> DVec3) -> f64 {
        let corners: Vec<DVec3> = corners.iter().map(|&corner| lift(corner)).collect();
        let normal = normal(&corners);
        let mut triangulation = Triangulation::new();
        let area = |triangle| {
            assert!(is_turned_like(normal, triangle, &corners));
            area_vector(triangle, &corners).length() / 2.0
        };
        triangulation.triangles(&corners).map(area).sum()
    }

    /// In several planes, from every first corner, and in both directions.
    fn check(corners: &[[f64; 2]], expected: f64) {
        let planes: [fn([f64; 2]) -> DVec3; 4] = [
            |[x, y]| DVec3::new(x, y, 2.0),
            |[x, y]| DVec3::new(y, -1.0, x),
            |[x, y]| DVec3::new(3.0, x, y),
            |[x, y]| DVec3::new(0.6 * x, y, 0.8 * x),
        ];
        let mut turned = corners.to_vec();
        for _ in 0..corners.len() {
            turned.rotate_left(1);
            for plane in planes {
                let found = area(&turned, plane);
                assert!((found - expected).abs() < 1e-12 * expected, "{found} for {expected} of {turned:?}");
            }
        }
        turned.reverse();
        let found = area(&turned, planes[0]);
        assert!((found - expected).abs() < 1e-12 * expected, "reversed: {found} for {expected}");
    }

    #[test]
    fn polygons_keep_their_area() {
        check(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]], 1.0);
        // An arrow, an L and the letter U.
        check(&[[0.0, 0.0], [2.0, -1.0], [1.0, 0.0], [2.0, 1.0]], 1.0);
        check(&[[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]], 3.0);
        let u = [[0.0, 0.0], [3.0, 0.0], [3.0, 3.0], [2.0, 3.0], [2.0, 1.0], [1.0, 1.0], [1.0, 3.0], [0.0, 3.0]];
        check(&u, 7.0);
        // A square with a square hole, reached by a cut from one of its corners.
        let hole = [[1.0, 1.0], [1.0, 2.0], [2.0, 2.0], [2.0, 1.0], [1.0, 1.0], [0.0, 0.0]];
        check(&[&[[0.0, 0.0], [3.0, 0.0], [3.0, 3.0], [0.0, 3.0], [0.0, 0.0]], &hole[..]].concat()[..10], 8.0);
    }

    #[test]
    fn a_comb_of_many_teeth_takes_no_time() {
        let teeth = 5000;
        let tooth = |index: i32| [[f64::from(index) + 0.5, 1.0], [f64::from(index) + 1.0, 0.0]];
        let mut corners = vec![[f64::from(teeth), -1.0], [0.0, -1.0], [0.0, 0.0]];
        corners.extend((0..teeth).flat_map(tooth));
        corners.reverse();
        let found = area(&corners, |[x, y]| DVec3::new(x, y, 0.0));
        assert!((found - 1.5 * f64::from(teeth)).abs() < 1e-6, "{found}");
    }

    #[test]
    fn what_has_no_area_becomes_triangles_without() {
        assert_eq!(area(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [1.0, 0.0]], |[x, y]| DVec3::new(x, y, 0.0)), 0.0);
    }
}
