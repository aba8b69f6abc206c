//! Reflection and refraction at the smooth boundary of two dielectrics.
//!
//! ```text
//!        d \   n   / reflected        n: unit normal towards the side the ray comes from
//!           \  ^  /                   cos_i = -d.n, cos_t = cosine of the refracted ray against -n
//!      n_1   \ | /
//!     --------\|/--------             Snell: n_1 sin_i = n_2 sin_t
//!      n_2      \ refracted
//! ```

use crate::math::DVec3;

/// The direction of ideal reflection of `direction` at a surface with the given unit normal (either side).
#[inline]
pub fn reflect(direction: DVec3, normal: DVec3) -> DVec3 {
    direction - normal * (2.0 * direction.dot(normal))
}

/// Ideal reflection at +z of a unit vector that points away from the surface: the other leg of the V.
#[inline]
pub(super) fn mirrored(view: DVec3) -> DVec3 {
    DVec3::new(-view.x, -view.y, view.z)
}

/// What happens to unpolarised light at the boundary.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Boundary {
    /// Share of the power that is reflected, in `[0, 1]`; 1 under total reflection.
    pub reflectance: f64,
    /// Cosine of the refracted ray with the inverted normal; `None` under total reflection.
    pub cos_transmitted: Option<f64>,
}

/// Fresnel's equations for unpolarised light, exact.
///
/// `cos_incident` in `[0, 1]`, `relative_index` is n_1 / n_2: the side the light comes from over the other.
/// (Born and Wolf, Principles of Optics, section 1.5.2; Pharr, Jakob, Humphreys: Physically Based Rendering, 4th ed., 9.3.5.)
///
/// With r = n_1 / n_2 and `a = r cos_i`, `b = cos_t`, the amplitude (a - b) / (a + b) loses all digits for indices near 1.
/// It is taken as `(a^2 - b^2) / (a + b)^2`, whose numerator has the factor 1 - r in closed form for both polarisations:
///
/// ```text
///   cos_t^2 = cos_i^2 r^2 + (1 - r)(1 + r)
///   perpendicular  (r cos_i)^2 - cos_t^2 = -(1 - r)(1 + r)
///   parallel       (r cos_t)^2 - cos_i^2 =  (1 - r)(1 + r) (r^2 - cos_i^2 (1 + r^2))
/// ```
///
/// (Higham: Accuracy and Stability of Numerical Algorithms, section 1.8, on quadratics: the same rearrangement.)
#[inline]
pub fn boundary(cos_incident: f64, relative_index: f64) -> Boundary {
    let cos_incident = cos_incident.clamp(0.0, 1.0);
    let r = relative_index;
    if r == 1.0 {
        return Boundary { reflectance: 0.0, cos_transmitted: Some(cos_incident) };
    }
    let (contrast, square, r_square) = ((1.0 - r) * (1.0 + r), cos_incident * cos_incident, r * r);
    let cos_squared = square * r_square + contrast;
    if cos_squared <= 0.0 || cos_squared.is_nan() {
        return Boundary { reflectance: 1.0, cos_transmitted: None };
    }
    let cos_transmitted = cos_squared.sqrt();
    let amplitude = |difference: f64, sum: f64| difference / (sum * sum);
    let perpendicular = amplitude(contrast, r * cos_incident + cos_transmitted);
    let parallel = amplitude(contrast * (r_square - square * (1.0 + r_square)), r * cos_transmitted + cos_incident);
    let reflectance = (0.5 * (perpendicular * perpendicular + parallel * parallel)).min(1.0);
    Boundary { reflectance, cos_transmitted: Some(cos_transmitted) }
}

/// The refracted direction by Snell's law, of unit length; `normal` on the side the ray comes from. Only for boundaries that
/// [`boundary`] finds to transmit.
///
/// The part of the direction along the surface grows by n_1 / n_2, exactly; the depth follows from unit length. The cosine
/// of [`boundary`] would not do: near the normal a cosine does not tell the angle, and for n_1 / n_2 = 10^6 all light that
/// passes arrives there.
#[inline]
pub fn refract(direction: DVec3, normal: DVec3, relative_index: f64) -> DVec3 {
    let along = (direction - normal * direction.dot(normal)) * relative_index;
    let depth_squared = 1.0 - along.length_squared();
    // Rounding may have it just beyond the critical angle: then it runs along the surface.
    if depth_squared > 0.0 { along - normal * depth_squared.sqrt() } else { along.normalize() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Fresnel reflectance by the sine and tangent laws, an independent form of the same equations.
    fn by_sines_and_tangents(cos_incident: f64, relative_index: f64) -> f64 {
        let incident = cos_incident.acos();
        let transmitted = (relative_index * incident.sin()).asin();
        let (difference, sum) = (incident - transmitted, incident + transmitted);
        0.5 * ((difference.sin() / sum.sin()).powi(2) + (difference.tan() / sum.tan()).powi(2))
    }

    proptest! {
        #[test]
        fn agrees_with_the_sine_and_tangent_laws(cos_incident in 0.01..0.999_f64, index in 1.01..3.0_f64) {
            let inside_out = boundary(cos_incident, 1.0 / index);
            prop_assert!((inside_out.reflectance - by_sines_and_tangents(cos_incident, 1.0 / index)).abs() < 1e-9);
            let outwards = boundary(cos_incident, index);
            if outwards.cos_transmitted.is_some() && cos_incident.acos().sin() * index < 0.999 {
                prop_assert!((outwards.reflectance - by_sines_and_tangents(cos_incident, index)).abs() < 1e-9);
            }
        }

        #[test]
        fn refraction_obeys_snell(cos_incident in 0.0..1.0_f64, index in 1.0..3.0_f64) {
            let sine = (1.0 - cos_incident * cos_incident).sqrt();
            let direction = DVec3::new(sine, 0.0, -cos_incident);
            let refracted = refract(direction, DVec3::Z, 1.0 / index);
            let cos_transmitted = boundary(cos_incident, 1.0 / index).cos_transmitted.unwrap();
            prop_assert!((refracted.z + cos_transmitted).abs() < 1e-12);
            prop_assert!((refracted.x * index - sine).abs() < 1e-12);
            prop_assert!((refracted.length() - 1.0).abs() < 1e-14);
        }
    }

    #[test]
    fn closed_form_at_normal_incidence() {
        assert!((boundary(1.0, 1.0 / 1.5).reflectance - 0.04).abs() < 1e-15);
        assert_eq!(boundary(0.5, 1.0).reflectance, 0.0);
    }

    #[test]
    fn reflection_is_total_beyond_the_critical_angle() {
        let critical_cosine = (1.0_f64 - 1.0 / (1.5 * 1.5)).sqrt();
        assert_eq!(boundary(critical_cosine - 1e-9, 1.5).cos_transmitted, None);
        assert!(boundary(critical_cosine + 1e-9, 1.5).cos_transmitted.is_some());
    }
}
