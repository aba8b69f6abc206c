//! Watertight intersection of a ray and a triangle.

use crate::math::DVec3;

/// Where a ray meets the plane of a triangle, inside it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TriangleHit {
    /// Ray parameter, in units of the direction's length; may be negative.
    pub t: f64,
    /// Weights of the three corners, none negative, sum 1 up to rounding.
    pub barycentric: [f64; 3],
}

/// A ray made ready for triangles: the frame in which it runs along the third axis.
///
/// Woop, Benthin, Wald: "Watertight Ray/Triangle Intersection", JCGT 2013. The corners are moved to the ray's origin
/// and sheared so that the ray becomes an axis. What is left is whether the point (0, 0) lies in a plane triangle:
///
/// ```text
///              C
///             / \           U: signed area of (0, C, B), and so on.
///            /   \          Inside: none of U, V, W has another sign than the others.
///           / 0   \
///          A-------B        Edge 0AB: W = Bx Ay - By Ax.
/// ```
///
/// A corner is sheared to the same point whichever triangle it is looked at for, and each `U` compares two products:
/// rounding is monotone, so the comparison is right or says "equal", which counts as inside. Two triangles on one
/// edge therefore never both say "outside": nothing leaks. Computed in `f64`, from the `f32` corners and the `f64`
/// ray, without rounding the input.
#[derive(Debug, Clone, Copy)]
pub struct ShearedRay {
    origin: [f64; 3],
    /// The axes in the order in which they are used; the last is the direction's largest.
    pub(super) axes: [usize; 3],
    /// Shear along the first two axes and scale along the third.
    pub(super) shear: [f64; 3],
}

impl ShearedRay {
    /// Prepares a ray with a direction that is not zero.
    #[inline]
    pub fn new(origin: DVec3, direction: DVec3) -> Self {
        let size = direction.abs();
        let major = if size.x >= size.y && size.x >= size.z { 0 } else { 1 + usize::from(size.z > size.y) };
        let axes = [[1, 2, 0], [2, 0, 1], [0, 1, 2]][major];
        let along = direction[major];
        let shear = [direction[axes[0]] / along, direction[axes[1]] / along, 1.0 / along];
        Self { origin: origin.to_array(), axes, shear }
    }

    /// Tests both sides of a triangle; `None` if the ray's line misses it or it is seen edge-on.
    #[inline]
    pub fn intersect(&self, corners: [[f64; 3]; 3]) -> Option<TriangleHit> {
        let [a, b, c] = corners.map(|corner| self.shear(corner));
        let u = c[0] * b[1] - c[1] * b[0];
        let v = a[0] * c[1] - a[1] * c[0];
        let w = b[0] * a[1] - b[1] * a[0];
        if (u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0) {
            return None;
        }
        let determinant = u + v + w;
        if determinant == 0.0 {
            return None;
        }
        let barycentric = [u / determinant, v / determinant, w / determinant];
        let t = barycentric[0] * a[2] + barycentric[1] * b[2] + barycentric[2] * c[2];
        Some(TriangleHit { t, barycentric })
    }

    #[inline]
    fn shear(&self, corner: [f64; 3]) -> [f64; 3] {
        let [x, y, z] = self.axes.map(|axis| corner[axis] - self.origin[axis]);
        [x - self.shear[0] * z, y - self.shear[1] * z, z * self.shear[2]]
    }
}
