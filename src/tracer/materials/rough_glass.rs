//! The rough boundary of two dielectrics.
//!
//! Every microfacet reflects and refracts by Fresnel's equations (Walter et al., Microfacet Models for Refraction
//! through Rough Surfaces, 2007), with height-correlated masking for both as in pbrt (Pharr, Jakob, Humphreys:
//! Physically Based Rendering, 4th ed., 9.7). Further lobes, one on either side, restore the light that is lost between
//! microfacets (after Kulla and Conty 2017): seen from side a, with the lost share `C_a(mu)` and its average `A_a`,
//!
//! ```text
//!   reflected    (1 - k_ab) C_a(mu_o) C_a(mu_i) / (pi A_a)
//!   transmitted       k_ab  C_a(mu_o) C_b(mu_i) / (pi A_b)
//! ```
//!
//! so everything that arrives leaves. Reciprocity of basic radiance asks for `n_a^2 A_a k_ab = n_b^2 A_b k_ba`; the
//! larger of both is the average transmittance seen from the rarer side.

use std::f64::consts::FRAC_1_PI;

use super::directional_table::DirectionalTable;
use super::fresnel::boundary;
use super::microfacet::Microfacets;
use super::quadrature::integral;
use super::scattering_sample::{Evaluation, ScatteringSample};
use super::visible_average::Facet;
use crate::math::{DVec3, Vec3};

/// A rough surface of glass, with tables for every medium it is known to meet.
#[derive(Debug, Clone, PartialEq)]
pub struct RoughGlass {
    microfacets: Microfacets,
    /// In pairs: a boundary seen from one side, and from the other.
    sides: Vec<Side>,
}

/// What is lost at a boundary seen from one side.
#[derive(Debug, Clone, PartialEq)]
struct Side {
    /// Index of refraction on this side over that on the other.
    relative_index: f64,
    /// Share of light that a single scattering event loses: it leaves on neither side.
    lost: DirectionalTable,
    /// Share of the lost light that returns on the other side.
    transmitted: f64,
}

impl RoughGlass {
    /// The surface of a glass against vacuum; `roughness` is the alpha of GGX, more than 0.
    pub fn new(index: f64, roughness: f64) -> Self {
        let mut glass = Self::unprepared(roughness);
        glass.meet(index, 1.0);
        glass
    }

    /// A surface without tables; [`RoughGlass::meet`] adds them for each pair of media.
    pub fn unprepared(roughness: f64) -> Self {
        Self { microfacets: Microfacets::new(roughness), sides: Vec::new() }
    }

    /// Prepares the surface for another medium beyond it: glasses may be nested.
    pub fn meet(&mut self, index: f64, other: f64) {
        let ratios = [index / other, other / index];
        if index != other && self.sides.iter().all(|side| side.relative_index != ratios[0]) {
            self.sides.extend(pair(&self.microfacets, ratios));
        }
    }

    /// The roughness, alpha.
    pub fn roughness(&self) -> f64 {
        self.microfacets.alpha()
    }

    /// The boundary seen from a side. An index that was not prepared takes the lost share of the nearest one: energy is
    /// then kept only as far as the two agree. `None` if there is nothing to be prepared for.
    #[inline]
    pub(super) fn boundary(&self, relative_index: f64) -> Option<RoughBoundary<'_>> {
        let distance = |place: usize| (self.sides[place].relative_index / relative_index - 1.0).abs();
        let mut nearest = 0;
        for place in 1..self.sides.len() {
            if distance(place) < distance(nearest) {
                nearest = place;
            }
        }
        let (near, far) = (self.sides.get(nearest)?, self.sides.get(nearest ^ 1)?);
        Some(RoughBoundary { microfacets: self.microfacets, relative_index, near, far })
    }
}

/// The tables of a boundary from both sides.
fn pair(microfacets: &Microfacets, ratios: [f64; 2]) -> [Side; 2] {
    let lost = ratios.map(|ratio| {
        // About the critical angle refracted light grazes the surface, the more suddenly the smoother it is.
        let (critical, width) = ((1.0 - 1.0 / (ratio * ratio)).max(0.0).sqrt(), 3.0 * microfacets.alpha());
        let bump = (ratio > 1.0 && width < 0.1).then_some([critical - width, critical + width]);
        DirectionalTable::over_visible_normals(microfacets, bump, |view, normal| lost(microfacets, ratio, view, normal))
    });
    let rarer = ratios[0].min(ratios[1]);
    let transmittance = integral(|mu| 2.0 * mu * (1.0 - boundary(mu, rarer).reflectance));
    let averages = [lost[0].average(), lost[1].average()];
    let transmitted = |this: usize| {
        let (own, others) = (ratios[this] * ratios[this] * averages[this], averages[1 - this]);
        if others < own { transmittance * others / own } else { transmittance }
    };
    let shares = [transmitted(0), transmitted(1)];
    let [first, second] = lost;
    [
        Side { relative_index: ratios[0], lost: first, transmitted: shares[0] },
        Side { relative_index: ratios[1], lost: second, transmitted: shares[1] },
    ]
}

/// Share of light that a visible microfacet throws onto others, on both sides together.
#[inline]
fn lost(microfacets: &Microfacets, relative_index: f64, view: DVec3, normal: DVec3) -> Facet {
    let cosine = view.dot(normal);
    let reflected = 2.0 * cosine * normal.z - view.z;
    let shadowed = |light: f64| if light > 0.0 { microfacets.shadowed(view.z, light) } else { 1.0 };
    // The square of the refracted cosine; below 0 reflection is total.
    let r = relative_index;
    let square = cosine * cosine * r * r + (1.0 - r) * (1.0 + r);
    let depth = r * view.z - (r * cosine - square.max(0.0).sqrt()) * normal.z;
    let reflectance = boundary(cosine, r).reflectance;
    let value = reflectance * shadowed(reflected) + (1.0 - reflectance) * shadowed(depth);
    Facet { value, kinks: [reflected, depth, square] }
}

#[cfg(test)]
impl RoughGlass {
    /// The table's error on a side at a cosine.
    pub(super) fn table_error(&self, side: usize, cosine: f64) -> f64 {
        let Side { relative_index, lost: table, .. } = &self.sides[side];
        let exact = super::visible_average::average_over_visible(&self.microfacets, cosine, 1e-9, |view, normal| {
            lost(&self.microfacets, *relative_index, view, normal)
        });
        table.at(cosine) - exact
    }
}

/// The scattering function of a rough boundary, seen from one side.
#[derive(Debug, Clone, Copy)]
pub struct RoughBoundary<'a> {
    microfacets: Microfacets,
    relative_index: f64,
    near: &'a Side,
    far: &'a Side,
}

/// Value (with the cosine) and density.
struct Lobes {
    value: f64,
    density: f64,
}

impl RoughBoundary<'_> {
    #[inline]
    pub(super) fn evaluate(&self, view: DVec3, light: DVec3) -> Evaluation {
        let lobes = if light.z > 0.0 {
            self.reflected(view, light, (view + light).normalize())
        } else if light.z < 0.0 {
            // The refracted ray leaves against r view + light, on the side that this vector shows.
            let across = view * self.relative_index + light;
            let normal = across.normalize_or(DVec3::Z);
            self.transmitted(view, light, if normal.z < 0.0 { -normal } else { normal })
        } else {
            return Evaluation::NONE;
        };
        Evaluation { value: Vec3::splat(lobes.value as f32), density: lobes.density }
    }

    #[inline]
    pub(super) fn sample(&self, view: DVec3, place: [f64; 2], choice: f64) -> Option<ScatteringSample> {
        let lost = self.near.lost.at(view.z);
        if choice < lost {
            return self.sample_lost(view, place, choice / lost);
        }
        let choice = (choice - lost) / (1.0 - lost);
        let normal = self.microfacets.visible_normal(view, place);
        let cosine = view.dot(normal);
        let boundary = boundary(cosine, self.relative_index);
        match boundary.cos_transmitted {
            Some(cos_transmitted) if choice >= boundary.reflectance => {
                let r = self.relative_index;
                let direction = (normal * (r * cosine - cos_transmitted) - view * r).normalize();
                (direction.z < 0.0).then(|| sampled(direction, self.transmitted(view, direction, normal)))
            }
            _ => {
                let direction = normal * (2.0 * cosine) - view;
                (direction.z > 0.0).then(|| sampled(direction, self.reflected(view, direction, normal)))
            }
        }
    }

    /// Chooses one of the lobes that return the lost light.
    fn sample_lost(&self, view: DVec3, place: [f64; 2], choice: f64) -> Option<ScatteringSample> {
        let transmitted = choice < self.near.transmitted;
        let direction =
            if transmitted { -self.far.lost.lobe_direction(place) } else { self.near.lost.lobe_direction(place) };
        let Evaluation { value, density } = self.evaluate(view, direction);
        let weight = value / density as f32;
        (density > 0.0).then_some(ScatteringSample { direction, weight, density, specular: false, transmitted })
    }

    #[inline]
    fn reflected(&self, view: DVec3, light: DVec3, normal: DVec3) -> Lobes {
        let distribution = self.microfacets.distribution(normal);
        let reflectance = boundary(view.dot(normal), self.relative_index).reflectance;
        let value = reflectance * distribution * self.microfacets.visibility(view.z, light.z) * light.z;
        let density = 0.25 * reflectance * distribution * self.microfacets.visible_scale(view.z);
        self.with_lost(view.z, light.z, Lobes { value, density }, self.near, 1.0 - self.near.transmitted)
    }

    #[inline]
    fn transmitted(&self, view: DVec3, light: DVec3, normal: DVec3) -> Lobes {
        let depth = -light.z;
        let (before, behind) = (view.dot(normal), -light.dot(normal));
        let mut lobes = Lobes { value: 0.0, density: 0.0 };
        if before > 0.0 && behind > 0.0 {
            let across = self.relative_index * before - behind;
            let transmittance = 1.0 - boundary(before, self.relative_index).reflectance;
            // Density of the refracted direction over that of the normal (Walter et al., eq. 17).
            let spread = behind / (across * across);
            let arriving = self.microfacets.distribution(normal) * transmittance * before * spread;
            lobes.value = 4.0 * arriving * self.microfacets.visibility(view.z, depth) * depth;
            lobes.density = arriving * self.microfacets.visible_scale(view.z);
        }
        self.with_lost(view.z, depth, lobes, self.far, self.near.transmitted)
    }

    /// Adds the lobe on the light's side that returns a share of the lost light.
    #[inline]
    fn with_lost(&self, view: f64, light: f64, at_once: Lobes, side: &Side, share: f64) -> Lobes {
        let lost = self.near.lost.at(view);
        let (lost_to_light, level) = side.lost.at_with_lobe(light);
        let cosine = lost * share * light * FRAC_1_PI;
        Lobes {
            value: at_once.value + cosine * lost_to_light * side.lost.inverse_average(),
            density: (1.0 - lost) * at_once.density + cosine * level,
        }
    }
}

fn sampled(direction: DVec3, lobes: Lobes) -> ScatteringSample {
    let weight = Vec3::splat((lobes.value / lobes.density) as f32);
    ScatteringSample { direction, weight, density: lobes.density, specular: false, transmitted: direction.z < 0.0 }
}
