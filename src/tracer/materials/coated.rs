//! A diffuse base under a dielectric coat: plastic, varnish, glazed tiles.
//!
//! The coat reflects the share S(mu) at once. The rest reaches the base and leaves it in the distribution that
//! conserves energy and reciprocity: `(1 - S(mu_o)) (1 - S(mu_i)) / (pi (1 - S_avg))` (Kelemen and Szirmay-Kalos, A
//! Microfacet Based Coupled Specular-Matte BRDF Model, 2001). The coat reflects light of the base back inside
//! repeatedly, which makes the colour c darker and more saturated: `c (1 - F) / (1 - c F)`, with F the average
//! reflectance of the coat from inside (Saunderson 1942).

use super::directional_table::DirectionalTable;
use super::fresnel::boundary;
use super::microfacet::Microfacets;
use super::quadrature::integral;
use super::scattering_sample::{Evaluation, ScatteringSample};
use super::visible_average::Facet;
use super::{cosine_density, cosine_direction};
use crate::colour::luminance;
use crate::math::{DVec3, Vec3};

/// A coat with what its scattering function needs, computed once.
#[derive(Debug, Clone, PartialEq)]
pub struct Coat {
    /// Index of refraction outside over that of the coat.
    relative_index: f64,
    /// Average reflectance from inside.
    inner_reflectance: f32,
    /// `1 / (1 - S_avg)`.
    base_scale: f64,
    /// The microfacets and S; a smooth coat's S is Fresnel's reflectance.
    roughness: Option<(Microfacets, DirectionalTable)>,
}

/// The scattering function of a coat over a base.
#[derive(Debug, Clone, Copy)]
pub struct Coated<'a> {
    coat: &'a Coat,
    /// The base's colour with the reflections from inside.
    base: Vec3,
}

impl Coat {
    /// `index` is at least 1; `roughness` is the alpha of GGX, or 0 for a smooth coat.
    pub fn new(index: f64, roughness: f64) -> Self {
        let relative_index = 1.0 / index;
        let outer = integral(|mu| 2.0 * mu * boundary(mu, relative_index).reflectance);
        let roughness = (roughness > 0.0).then(|| {
            let microfacets = Microfacets::new(roughness);
            let reflected = |view, normal| reflected_at_once(&microfacets, relative_index, view, normal);
            (microfacets, DirectionalTable::over_visible_normals(&microfacets, None, reflected))
        });
        let average = roughness.as_ref().map_or(outer, |(_, reflected)| reflected.average());
        // The same light passes in both directions: n^2 (1 - F_inside) = 1 - F_outside.
        let inner_reflectance = (1.0 - (1.0 - outer) * relative_index * relative_index) as f32;
        Self { relative_index, inner_reflectance, base_scale: 1.0 / (1.0 - average), roughness }
    }

    /// True if its reflections are sharp.
    pub fn is_smooth(&self) -> bool {
        self.roughness.is_none()
    }

    /// The coat over a base of a colour.
    #[inline]
    pub(super) fn over(&self, colour: Vec3) -> Coated<'_> {
        let inside = self.inner_reflectance;
        Coated { coat: self, base: colour * (1.0 - inside) / (Vec3::ONE - colour * inside) }
    }

    /// S: the share of light reflected by the coat at once.
    #[inline]
    fn reflected(&self, cosine: f64) -> f64 {
        match &self.roughness {
            Some((_, reflected)) => reflected.at(cosine),
            None => boundary(cosine, self.relative_index).reflectance,
        }
    }
}

/// Share of light that a visible microfacet reflects past all others.
#[inline]
fn reflected_at_once(microfacets: &Microfacets, relative_index: f64, view: DVec3, normal: DVec3) -> Facet {
    let cosine = view.dot(normal);
    let light = 2.0 * cosine * normal.z - view.z;
    let reflectance = boundary(cosine, relative_index).reflectance;
    let value = if light > 0.0 { reflectance * microfacets.unshadowed(view.z, light) } else { 0.0 };
    Facet { value, kinks: [light, 1.0, 1.0] }
}

#[cfg(test)]
impl Coat {
    /// The table's error at a cosine.
    pub(super) fn table_error(&self, cosine: f64) -> f64 {
        let Some((microfacets, table)) = &self.roughness else { return 0.0 };
        let exact = super::visible_average::average_over_visible(microfacets, cosine, 1e-9, |view, normal| {
            reflected_at_once(microfacets, self.relative_index, view, normal)
        });
        table.at(cosine) - exact
    }
}

impl Coated<'_> {
    /// Probability of sampling the coat: its share of what leaves towards the view.
    #[inline]
    fn coat_share(&self, reflected: f64) -> f64 {
        let base = (1.0 - reflected) * f64::from(luminance(self.base));
        if reflected > 0.0 { reflected / (reflected + base) } else { 0.0 }
    }

    /// Share of all light that leaves again, over all directions.
    pub(super) fn albedo(&self) -> Vec3 {
        let reflected = (1.0 - 1.0 / self.coat.base_scale) as f32;
        Vec3::splat(reflected) + self.base * (1.0 - reflected)
    }

    #[inline]
    pub(super) fn evaluate(&self, view: DVec3, light: DVec3) -> Evaluation {
        if light.z <= 0.0 {
            return Evaluation::NONE;
        }
        let reflected = self.coat.reflected(view.z);
        let share = self.coat_share(reflected);
        let diffuse = cosine_density(light.z);
        let passing = (1.0 - reflected) * (1.0 - self.coat.reflected(light.z)) * self.coat.base_scale;
        let base = self.base * (passing * diffuse) as f32;
        let Some((microfacets, _)) = &self.coat.roughness else {
            return Evaluation { value: base, density: (1.0 - share) * diffuse };
        };
        let normal = (view + light).normalize();
        let distribution = microfacets.distribution(normal);
        let reflectance = boundary(view.dot(normal), self.coat.relative_index).reflectance;
        let coat = reflectance * distribution * microfacets.visibility(view.z, light.z) * light.z;
        let coat_density = 0.25 * distribution * microfacets.visible_scale(view.z);
        Evaluation { value: base + coat as f32, density: (1.0 - share) * diffuse + share * coat_density }
    }

    #[inline]
    pub(super) fn sample(&self, view: DVec3, place: [f64; 2], choice: f64) -> Option<ScatteringSample> {
        let reflected = self.coat.reflected(view.z);
        let share = self.coat_share(reflected);
        let direction = if choice >= share {
            cosine_direction(place)
        } else if let Some((microfacets, _)) = &self.coat.roughness {
            let normal = microfacets.visible_normal(view, place);
            normal * (2.0 * view.dot(normal)) - view
        } else {
            let weight = Vec3::splat((reflected / share) as f32);
            return Some(ScatteringSample::reflected_specularly(view, weight, share));
        };
        let Evaluation { value, density } = self.evaluate(view, direction);
        let weight = value / density as f32;
        (density > 0.0).then_some(ScatteringSample { direction, weight, density, specular: false, transmitted: false })
    }
}
