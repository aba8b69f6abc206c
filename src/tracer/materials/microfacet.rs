//! The rough surface as many small mirrors: the GGX distribution of their normals.
//!
//! Trowbridge and Reitz, Average Irregularity Representation of a Rough Surface for Ray Reflection, 1975; Walter et al.,
//! Microfacet Models for Refraction through Rough Surfaces, 2007; Heitz, Understanding the Masking-Shadowing Function in
//! Microfacet-Based BRDFs, JCGT 2014. Everything is written so that it neither cancels nor divides by zero for any
//! roughness from 1e-4 to 1 and any cosine more than 0.
//!
//! Smith's function for GGX is `Lambda(mu) = (s / mu - 1) / 2` with `s(mu) = sqrt(mu^2 + alpha^2 (1 - mu^2))`. From it
//! follow, without tangents, masking `G1 = 1 / (1 + Lambda) = 2 mu / (mu + s)` and height-correlated masking and
//! shadowing `G2 = 1 / (1 + Lambda_o + Lambda_i) = 2 mu_o mu_i / (mu_o s_i + mu_i s_o)`.

use std::f64::consts::PI;

use crate::math::DVec3;
use crate::math::functions::sin_cos_turns;

/// GGX microfacets. Cosines are those with the mean normal +z, more than 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Microfacets {
    alpha: f64,
}

impl Microfacets {
    /// `alpha` is the roughness of Walter et al., from 1e-4 to 1.
    pub fn new(alpha: f64) -> Self {
        Self { alpha }
    }

    pub fn alpha(&self) -> f64 {
        self.alpha
    }

    /// Density of microfacets with the unit normal `normal`, per solid angle: `D(m)`, for which `D cos` integrates to 1.
    #[inline]
    pub fn distribution(&self, normal: DVec3) -> f64 {
        if normal.z <= 0.0 {
            return 0.0;
        }
        let square = self.alpha * self.alpha;
        let spread = normal.x * normal.x + normal.y * normal.y + square * (normal.z * normal.z);
        square / (PI * spread * spread)
    }

    /// `s` in the formulas above.
    #[inline]
    fn root(&self, cosine: f64) -> f64 {
        let square = cosine * cosine;
        (square + self.alpha * self.alpha * (1.0 - square).max(0.0)).sqrt()
    }

    /// `G2 / (4 mu_o mu_i)`.
    #[inline]
    pub fn visibility(&self, one: f64, other: f64) -> f64 {
        0.5 / (one * self.root(other) + other * self.root(one))
    }

    /// `G1(mu) / mu`: what turns `D(m) (v.m)` into the density of the normals that are visible from `v`.
    #[inline]
    pub fn visible_scale(&self, cosine: f64) -> f64 {
        2.0 / (cosine + self.root(cosine))
    }

    /// Share of what leaves visible microfacets towards `light` that is not shadowed on the way out: `G2 / G1(mu_o)`.
    #[inline]
    pub fn unshadowed(&self, view: f64, light: f64) -> f64 {
        let (view_root, light_root) = (self.root(view), self.root(light));
        light * (view + view_root) / (view * light_root + light * view_root)
    }

    /// `1 - G2 / G1(mu_o)` without cancellation.
    #[inline]
    pub fn shadowed(&self, view: f64, light: f64) -> f64 {
        let (view_root, light_root) = (self.root(view), self.root(light));
        let difference = self.alpha * self.alpha * (1.0 - light * light).max(0.0) / (light_root + light);
        view * difference / (view * light_root + light * view_root)
    }

    /// A microfacet normal out of those visible from `view`, with the density `G1 D(m) (v.m) / mu_o`
    /// (Dupuy and Benyoub, Sampling Visible GGX Normals with Spherical Caps, HPG 2023).
    #[inline]
    pub fn visible_normal(&self, view: DVec3, place: [f64; 2]) -> DVec3 {
        let stretched = self.stretched(view);
        let (sine, cosine) = sin_cos_turns(place[1]);
        let depth = place[0] * (1.0 + stretched.z);
        let height = 1.0 - depth;
        let radius = (depth * (1.0 + height)).max(0.0).sqrt();
        self.shrunk(stretched + DVec3::new(radius * cosine, radius * sine, height))
    }

    /// A view in the space where the microfacets are those of a hemisphere.
    #[inline]
    pub fn stretched(&self, view: DVec3) -> DVec3 {
        DVec3::new(self.alpha * view.x, self.alpha * view.y, view.z).normalize()
    }

    /// The unit normal of a microfacet from that of the hemisphere, which need not have length 1.
    #[inline]
    pub fn shrunk(&self, normal: DVec3) -> DVec3 {
        let normal = DVec3::new(self.alpha * normal.x, self.alpha * normal.y, normal.z.max(0.0));
        let length_squared = normal.length_squared();
        if length_squared > 0.0 { normal / length_squared.sqrt() } else { DVec3::Z }
    }
}
