use super::*;
use crate::math::Vec3;
use proptest::prelude::*;

proptest! {
    #[test]
    fn direction_is_the_inverse_of_locate(preset in 0..5_usize, face in 0..6_usize, u in 0.001..0.999_f32, v in 0.001..0.999_f32) {
        let lookup = Preset::ALL[preset].lookup();
        let point = FacePoint { face: Face::ALL[face], u, v };
        let back = lookup.locate(lookup.direction(point) * 3.0);
        prop_assert_eq!(back.face, point.face);
        prop_assert!((back.u - u).abs() < 1e-6 && (back.v - v).abs() < 1e-6);
    }

    #[test]
    fn every_direction_has_a_face_and_coordinates_in_range(x: f32, y: f32, z: f32) {
        let point = Preset::Course.lookup().locate(Vec3::new(x, y, z));
        prop_assert!((0.0..=1.0).contains(&point.u) && (0.0..=1.0).contains(&point.v));
    }
}

#[test]
fn ties_go_to_x_then_to_y() {
    let face = |x, y, z| Preset::Opengl.lookup().locate(Vec3::new(x, y, z)).face;
    assert_eq!(face(1.0, 1.0, 1.0), Face::PosX);
    assert_eq!(face(-1.0, 1.0, 1.0), Face::NegX);
    assert_eq!(face(0.5, -1.0, 1.0), Face::NegY);
    assert_eq!(face(0.5, 0.5, -1.0), Face::NegZ);
}
