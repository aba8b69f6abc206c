//! The axis-aligned cube `[-1, 1]^3`; its six faces are numbered like those of a cube map, +x -x +y -y +z -z.

use crate::math::{DVec2, DVec3, Departure, Side};

/// Distance to the nearest hit in `(0, limit)` and the number of the face.
///
/// Each pair of parallel faces is a slab; inside the cube is inside all three (Kay and Kajiya, Ray Tracing Complex
/// Scenes, 1986). A ray that leaves a face outwards is done; inwards it can only meet the far side.
///
/// `error` is how far, in units of the direction's length, the origin may be from where it should be: an exit no farther
/// ahead, of a ray not known to be inside, is that of a ray that starts on a face and moves away from it.
#[inline]
pub(super) fn intersect(
    origin: DVec3,
    direction: DVec3,
    limit: f64,
    leaving: Option<Departure>,
    error: f64,
) -> Option<(f64, u32)> {
    if leaving.is_some_and(|departure| departure.side == Side::Front) {
        return None;
    }
    let (mut near, mut far) = ((f64::NEG_INFINITY, 0), (f64::INFINITY, 0));
    for axis in 0..3 {
        let (position, slope) = (origin[axis], direction[axis]);
        if slope == 0.0 {
            if position.abs() > 1.0 {
                return None;
            }
            continue;
        }
        // Entering by the face that looks against the ray, leaving by the opposite one.
        let entry_face = 2 * axis as u32 + u32::from(slope > 0.0);
        let entry = (-1.0_f64.copysign(slope) - position) / slope;
        let exit = (1.0_f64.copysign(slope) - position) / slope;
        near = if entry > near.0 { (entry, entry_face) } else { near };
        far = if exit < far.0 { (exit, entry_face ^ 1) } else { far };
    }
    let inside = leaving.is_some();
    if near.0 > far.0 && !inside {
        return None;
    }
    // The thickness of the box along the ray counts its own rounding.
    let starts_on_exit = near.0 <= 0.0 && far.0 <= error + (far.0 - near.0) * (1.0 / (1u64 << 50) as f64);
    if starts_on_exit && !inside {
        return None;
    }
    let hit = if near.0 > 0.0 && !inside { near } else { (if inside { far.0.max(0.0) } else { far.0 }, far.1) };
    ((hit.0 > 0.0 || inside) && hit.0 < limit).then_some(hit)
}

/// The point moved onto a face and into its square.
pub(super) fn onto_face(point: DVec3, face: u32) -> DVec3 {
    let mut point = point.clamp(DVec3::NEG_ONE, DVec3::ONE);
    let axis = face as usize / 2;
    point[axis] = normal(face)[axis];
    point
}

/// The outward normal of a face.
pub(super) fn normal(face: u32) -> DVec3 {
    let sign = if face.is_multiple_of(2) { 1.0 } else { -1.0 };
    DVec3::AXES[face as usize / 2] * sign
}

/// Each face fits the picture once: the two other coordinates, in the order x y z, mapped to `[0, 1]`.
pub(super) fn texture_coordinates(point: DVec3, face: u32) -> DVec2 {
    let place = match face / 2 {
        0 => DVec2::new(point.y, point.z),
        1 => DVec2::new(point.x, point.z),
        _ => DVec2::new(point.x, point.y),
    };
    (place + 1.0) / 2.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn enters_by_the_face_that_looks_at_the_ray() {
        let (t, face) = intersect(DVec3::new(-3.0, 0.2, 0.1), DVec3::X, f64::INFINITY, None, 0.0).unwrap();
        assert_eq!((t, normal(face)), (2.0, DVec3::NEG_X));
        let (t, face) = intersect(DVec3::ZERO, DVec3::NEG_Z, f64::INFINITY, None, 0.0).unwrap();
        assert_eq!((t, normal(face)), (1.0, DVec3::NEG_Z));
        assert!(intersect(DVec3::new(3.0, 0.0, 0.0), DVec3::X, f64::INFINITY, None, 0.0).is_none());
        assert!(intersect(DVec3::new(-3.0, 2.0, 0.0), DVec3::X, f64::INFINITY, None, 0.0).is_none());
    }
}
