//! The reflectance of a smooth metal.

use super::quadrature::integral;
use crate::math::Vec3;

/// Reflectance of a metal against the angle, by channel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum MetalReflectance {
    /// Fresnel's equations for the complex index of refraction `index + i extinction`.
    Measured {
        /// Real part by channel (R, G, B).
        index: Vec3,
        /// Imaginary part by channel.
        extinction: Vec3,
    },
    /// Schlick's approximation from the reflectance at normal incidence (An Inexpensive BRDF Model for
    /// Physically-based Rendering, 1994). A reflectance of 1 reflects everything at every angle.
    Schlick {
        /// Reflectance at normal incidence by channel, in `[0, 1]`.
        normal: Vec3,
    },
}

/// Metals by name: complex indices at 630, 532 and 465 nm (the primaries of a display, roughly), linear between the
/// tabulated wavelengths around them.
///
/// Gold, silver, copper: Johnson and Christy, Optical Constants of the Noble Metals, Phys. Rev. B 6, 4370 (1972). Iron,
/// chromium: the same, Optical Constants of Transition Metals, Phys. Rev. B 9, 5056 (1974). Aluminium: Rakic, Appl. Opt.
/// 34, 4755 (1995). Tables from refractiveindex.info (public domain).
pub const METALS: [(&str, MetalReflectance); 6] = [
    ("gold", measured([0.1884, 0.5439, 1.3319], [3.4034, 2.2309, 1.8693])),
    ("silver", measured([0.0569, 0.0540, 0.0469], [4.2543, 3.4290, 2.8028])),
    ("copper", measured([0.2753, 1.1159, 1.2469], [3.3726, 2.5956, 2.4562])),
    ("aluminium", measured([1.4303, 0.9388, 0.6860], [7.5081, 6.4195, 5.6351])),
    ("iron", measured([2.8924, 2.8954, 2.6460], [3.0655, 2.9179, 2.8050])),
    ("chromium", measured([3.1452, 3.0343, 2.4560], [3.3124, 3.3300, 3.2100])),
];

const fn measured(index: [f32; 3], extinction: [f32; 3]) -> MetalReflectance {
    MetalReflectance::Measured { index: Vec3::from_array(index), extinction: Vec3::from_array(extinction) }
}

impl MetalReflectance {
    /// Reflectance for unpolarised light, in `[0, 1]`.
    #[inline]
    pub fn at(&self, cosine: f32) -> Vec3 {
        let cosine = cosine.clamp(0.0, 1.0);
        match *self {
            Self::Measured { index, extinction } => fresnel(cosine, index, extinction),
            Self::Schlick { normal } => {
                let missing = 1.0 - cosine;
                let square = missing * missing;
                normal + (Vec3::ONE - normal) * (square * square * missing)
            }
        }
    }

    /// Average over all directions, each weighted by its cosine.
    pub fn average(&self) -> Vec3 {
        let channel = |channel: usize| integral(|mu| 2.0 * mu * f64::from(self.at(mu as f32)[channel])) as f32;
        Vec3::new(channel(0), channel(1), channel(2)).min(Vec3::ONE)
    }
}

/// Fresnel's equations for a conductor (Born and Wolf, Principles of Optics, section 14.2; in this form Lagarde, Memo on
/// Fresnel Equations, 2013; Pharr, Jakob, Humphreys: Physically Based Rendering, 4th ed., 9.3.6).
#[inline]
fn fresnel(cosine: f32, index: Vec3, extinction: Vec3) -> Vec3 {
    let cos_squared = cosine * cosine;
    let sin_squared = 1.0 - cos_squared;
    // a + ib is the square root of (n + ik)^2 - sin^2. The larger of both first, so that nothing cancels.
    let real = index * index - extinction * extinction - sin_squared;
    let half_imaginary = index * extinction;
    let modulus = (real * real + 4.0 * half_imaginary * half_imaginary).sqrt();
    let larger = (0.5 * (modulus + real.abs())).sqrt();
    let smaller = half_imaginary / larger.max(Vec3::splat(f32::MIN_POSITIVE));
    let a = Vec3::select(real.cmpge(Vec3::ZERO), larger, smaller);
    let sum = modulus + cos_squared;
    let mixed = 2.0 * cosine * a;
    let perpendicular = (sum - mixed) / (sum + mixed);
    let sum = cos_squared * modulus + sin_squared * sin_squared;
    let mixed = mixed * sin_squared;
    let parallel = perpendicular * ((sum - mixed) / (sum + mixed));
    let reflectance = 0.5 * (perpendicular + parallel);
    // 0/0 is left for grazing light and an index of exactly 1, and for normal light, an index of 0 and no extinction.
    reflectance.map(|channel| if channel.is_nan() { 1.0 } else { channel.clamp(0.0, 1.0) })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::materials::fresnel::boundary;

    #[test]
    fn without_extinction_it_is_a_dielectric() {
        for index in [0.5, 1.0, 1.000_001, 1.5, 4.0] {
            for step in 1..=20 {
                let cosine = step as f32 / 20.0;
                let found = fresnel(cosine, Vec3::splat(index), Vec3::ZERO).x;
                let exact = boundary(f64::from(cosine), 1.0 / f64::from(index)).reflectance;
                assert!((f64::from(found) - exact).abs() < 2e-6, "{index} {cosine}: {found} {exact}");
            }
        }
    }

    #[test]
    fn agrees_with_complex_arithmetic() {
        // r_s = (cos - w) / (cos + w), r_p = (m^2 cos - w) / (m^2 cos + w), w^2 = m^2 - sin^2, m = n + ik.
        type Complex = (f64, f64);
        let multiply = |a: Complex, b: Complex| (a.0 * b.0 - a.1 * b.1, a.0 * b.1 + a.1 * b.0);
        let squared_ratio = |a: Complex, w: Complex| {
            ((a.0 - w.0).powi(2) + (a.1 - w.1).powi(2)) / ((a.0 + w.0).powi(2) + (a.1 + w.1).powi(2))
        };
        for (name, metal) in METALS {
            let MetalReflectance::Measured { index, extinction } = metal else { unreachable!() };
            for step in 0..=20 {
                let cosine = f64::from(step) / 20.0;
                let m = (f64::from(index.y), f64::from(extinction.y));
                let square = multiply(m, m);
                let inside = (square.0 - 1.0 + cosine * cosine, square.1);
                let (length, angle) = (inside.0.hypot(inside.1).sqrt(), inside.1.atan2(inside.0) / 2.0);
                let w = (length * angle.cos(), length * angle.sin());
                let expected =
                    0.5 * (squared_ratio((cosine, 0.0), w) + squared_ratio((square.0 * cosine, square.1 * cosine), w));
                let found = f64::from(metal.at(cosine as f32).y);
                assert!((found - expected).abs() < 1e-5, "{name} {cosine}: {found} {expected}");
            }
        }
    }

    #[test]
    fn gold_is_yellow_and_silver_is_bright() {
        let gold = METALS[0].1.at(1.0);
        assert!(gold.x > 0.9 && gold.x > gold.y && gold.y > 0.6 && gold.z < 0.5, "{gold}");
        assert!(METALS[1].1.at(1.0).min_element() > 0.95);
    }

    #[test]
    fn average_of_schlick_in_closed_form() {
        // The integral of 2 mu (1 - mu)^5 is 1/21.
        let average = MetalReflectance::Schlick { normal: Vec3::splat(0.2) }.average();
        assert!((average - Vec3::splat(0.2 + 0.8 / 21.0)).abs().max_element() < 1e-6, "{average}");
    }
}
