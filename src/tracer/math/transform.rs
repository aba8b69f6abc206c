//! Placing a shape in the world: scale, rotate, translate.

use super::functions::sin_cos_degrees;
use super::{DAffine3, DMat3, DVec3};

/// An invertible affine map from a shape's own space to the world, with its inverse.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Transform {
    /// From object to world space.
    pub to_world: DAffine3,
    /// From world to object space: its inverse.
    pub to_object: DAffine3,
}

impl Transform {
    /// The map that changes nothing.
    pub const IDENTITY: Self = Self { to_world: DAffine3::IDENTITY, to_object: DAffine3::IDENTITY };

    /// Scales along the shape's axes, then rotates about x, y and z in this order (degrees, right-handed), then
    /// translates. `None` if a scale is zero or a number is not finite: the transform then has no inverse.
    pub fn from_parts(translate: DVec3, rotate_degrees: DVec3, scale: DVec3) -> Option<Self> {
        let linear = rotation_z(rotate_degrees.z)
            * rotation_y(rotate_degrees.y)
            * rotation_x(rotate_degrees.x)
            * DMat3::from_diagonal(scale);
        Self::from_affine(DAffine3::from_mat3_translation(linear, translate))
    }

    /// A transform from the map to the world; `None` if it has no inverse.
    pub fn from_affine(to_world: DAffine3) -> Option<Self> {
        let to_object = to_world.inverse();
        (to_world.is_finite() && to_object.is_finite()).then_some(Self { to_world, to_object })
    }

    /// A normal of the shape's own space, carried to the world by the transposed inverse and made unit length.
    ///
    /// Normals are planes, not arrows: they stay perpendicular to the surface under any scale
    /// (Pharr, Jakob, Humphreys: Physically Based Rendering, 4th ed., section 3.10.3).
    pub fn normal_to_world(&self, normal: DVec3) -> DVec3 {
        (self.to_object.matrix3.transpose() * normal).normalize()
    }

    /// The factor of the lengths, if it is the same in all directions to the last digits; then spheres stay round.
    pub fn uniform_scale(&self) -> Option<f64> {
        let DMat3 { x_axis, y_axis, z_axis } = self.to_world.matrix3;
        let scale = x_axis.length();
        let close = |number: f64, wanted: f64| (number - wanted).abs() <= 4.0 * f64::EPSILON * scale * scale;
        let same_lengths = [y_axis, z_axis].iter().all(|axis| close(axis.length_squared(), scale * scale));
        let right_angles =
            [x_axis.dot(y_axis), y_axis.dot(z_axis), z_axis.dot(x_axis)].iter().all(|&dot| close(dot, 0.0));
        (same_lengths && right_angles).then_some(scale)
    }

    /// True if the map mirrors: a right-handed frame becomes left-handed.
    pub fn mirrors(&self) -> bool {
        self.to_world.matrix3.determinant() < 0.0
    }
}

fn rotation_x(degrees: f64) -> DMat3 {
    let (s, c) = sin_cos_degrees(degrees);
    DMat3::from_cols(DVec3::X, DVec3::new(0.0, c, s), DVec3::new(0.0, -s, c))
}

fn rotation_y(degrees: f64) -> DMat3 {
    let (s, c) = sin_cos_degrees(degrees);
    DMat3::from_cols(DVec3::new(c, 0.0, -s), DVec3::Y, DVec3::new(s, 0.0, c))
}

fn rotation_z(degrees: f64) -> DMat3 {
    let (s, c) = sin_cos_degrees(degrees);
    DMat3::from_cols(DVec3::new(c, s, 0.0), DVec3::new(-s, c, 0.0), DVec3::Z)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quarter_turns_map_axes_onto_axes_exactly() {
        let turn = |degrees| Transform::from_parts(DVec3::ZERO, degrees, DVec3::ONE).unwrap().to_world;
        assert_eq!(turn(DVec3::new(90.0, 0.0, 0.0)).transform_vector3(DVec3::Y), DVec3::Z);
        assert_eq!(turn(DVec3::new(0.0, 90.0, 0.0)).transform_vector3(DVec3::Z), DVec3::X);
        assert_eq!(turn(DVec3::new(0.0, 0.0, 90.0)).transform_vector3(DVec3::X), DVec3::Y);
    }

    #[test]
    fn normals_stay_perpendicular_under_uneven_scale() {
        let transform =
            Transform::from_parts(DVec3::new(1.0, 2.0, 3.0), DVec3::new(20.0, 30.0, 40.0), DVec3::new(1.0, 5.0, -0.2))
                .unwrap();
        let normal = DVec3::new(1.0, 1.0, 1.0).normalize();
        let tangent = DVec3::new(1.0, -1.0, 0.0);
        let world_tangent = transform.to_world.transform_vector3(tangent);
        assert!(transform.normal_to_world(normal).dot(world_tangent).abs() < 1e-12);
        assert!(transform.mirrors());
    }

    #[test]
    fn a_flat_scale_has_no_inverse() {
        assert!(Transform::from_parts(DVec3::ZERO, DVec3::ZERO, DVec3::new(1.0, 0.0, 1.0)).is_none());
    }
}
