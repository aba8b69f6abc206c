//! A photon: a hit of focused light, and the directions of that light nearby.
//!
//! ```text
//!            glass                   A photon at y saw the light in the direction w. At a place x nearby the light is
//!           /  |  \                  seen at about w + J (x - y), and its image there has the half axes a_1, a_2: both
//!          /   |   \                 from how rays beside the photon's own went (photon differentials: Schjoth, Frisvad,
//!       w / w'/     \                Erleben and Sporring, Photon Differentials, 2007).
//!     ---y--x--------
//! ```

use crate::math::DVec3;
use crate::math::functions::sin_cos_turns;

/// Widest half axis of the image of a light, as the tangent of its angle: wider ones are not known well enough.
const WIDEST: f64 = 0.3;
/// Narrowest half axis: the last digits of positions and directions must not matter.
const NARROWEST: f64 = 1e-6;

/// See the drawing above. Directions are told by where they pierce the plane at distance 1 along w, whose axes are `axes`;
/// vectors are in the world.
#[derive(Debug, Clone, Copy)]
pub(super) struct Photon {
    pub position: DVec3,
    /// Unit direction the light came from: w.
    pub towards: DVec3,
    /// Unit vectors at right angles to w: the axes of the light's image.
    pub axes: [DVec3; 2],
    /// J: a step along `along[k]` moves the image by `jacobian[k]` on the plane.
    pub along: [DVec3; 2],
    pub jacobian: [[f64; 2]; 2],
    /// Half axes of the image on the plane.
    pub half: [f64; 2],
    /// Number of the specular chain of the light, and the share of it that took it.
    pub chain: u32,
    pub share: f64,
    /// How fast the image leaves its predicted place: distance on the plane per squared distance from y.
    pub drift: f64,
}

/// The prediction of a photon at a point: the centre and the half axes of the image on its plane.
#[derive(Clone, Copy, Default)]
pub(super) struct Forecast {
    middle: [f64; 2],
    half: [f64; 2],
    /// Weight among the photons around, not normalised: sharp forecasts first.
    pub weight: f64,
}

impl Photon {
    /// Where the light's image is seen from a place nearby.
    #[inline]
    pub fn forecast(&self, point: DVec3) -> Forecast {
        let offset = point - self.position;
        let steps = self.along.map(|along| along.dot(offset));
        let middle = [0, 1].map(|axis| self.jacobian[0][axis] * steps[0] + self.jacobian[1][axis] * steps[1]);
        // A direction predicted far away is not a prediction.
        let near = middle[0] * middle[0] + middle[1] * middle[1] < WIDEST * WIDEST;
        let blur = self.drift * offset.length_squared();
        let half = self.half.map(|half| (half + blur).clamp(NARROWEST, WIDEST));
        Forecast { middle: if near { middle } else { [0.0; 2] }, half, weight: 1.0 / (half[0] * half[1]) }
    }

    /// A direction by a forecast and two uniform numbers. The density falls with the fourth power of the distance from the
    /// middle, in units of the half axes: wide tails for what the forecast missed.
    #[inline]
    pub fn draw(&self, forecast: &Forecast, [radial, angular]: [f64; 2]) -> DVec3 {
        let radius = (radial / (1.0 - radial)).sqrt();
        let (sine, cosine) = sin_cos_turns(angular);
        let x = forecast.middle[0] + radius * cosine * forecast.half[0];
        let y = forecast.middle[1] + radius * sine * forecast.half[1];
        (self.towards + self.axes[0] * x + self.axes[1] * y).normalize()
    }

    /// Density by solid angle of [`Photon::draw`].
    #[inline]
    pub fn density(&self, forecast: &Forecast, direction: DVec3) -> f64 {
        let cosine = direction.dot(self.towards);
        if cosine <= 0.0 {
            return 0.0;
        }
        // On the plane; a solid angle is cos^3 of an area there.
        let inverse = 1.0 / cosine;
        let x = (direction.dot(self.axes[0]) * inverse - forecast.middle[0]) / forecast.half[0];
        let y = (direction.dot(self.axes[1]) * inverse - forecast.middle[1]) / forecast.half[1];
        let tail = 1.0 + x * x + y * y;
        std::f64::consts::FRAC_1_PI * forecast.weight * inverse * inverse * inverse / (tail * tail)
    }

    /// How far a direction is from the middle of the forecast, on the plane.
    pub fn miss(&self, forecast: &Forecast, direction: DVec3) -> f64 {
        let cosine = direction.dot(self.towards).max(1e-9);
        let x = direction.dot(self.axes[0]) / cosine - forecast.middle[0];
        let y = direction.dot(self.axes[1]) / cosine - forecast.middle[1];
        (x * x + y * y).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Frame;

    #[test]
    fn drawn_directions_have_their_density() {
        let towards = DVec3::new(0.3, 0.2, 0.9).normalize();
        let frame = Frame::around(towards);
        let photon = Photon {
            position: DVec3::ZERO,
            towards,
            axes: [frame.tangent, frame.bitangent],
            along: [DVec3::X, DVec3::Y],
            jacobian: [[0.1, 0.02], [0.0, -0.2]],
            half: [0.02, 0.1],
            chain: 0,
            share: 1.0,
            drift: 0.5,
        };
        let forecast = photon.forecast(DVec3::new(0.1, -0.1, 0.0));
        // The solid angle of a disc on the plane, by sampling: E[1 / density, inside] = its cos^3-weighted area.
        let count = 600;
        let place = |index: u32| (f64::from(index) + 0.5) / f64::from(count);
        let mut sum = 0.0;
        for index in 0..count * count {
            let direction = photon.draw(&forecast, [place(index % count), place(index / count)]);
            assert!((direction.length() - 1.0).abs() < 1e-12);
            let inside = direction.dot(towards) > 1.0 / (1.0_f64 + 0.04).sqrt();
            sum += f64::from(inside) / photon.density(&forecast, direction);
        }
        let cone = std::f64::consts::TAU * (1.0 - 1.0 / (1.0_f64 + 0.04).sqrt());
        let mean = sum / f64::from(count * count);
        assert!((mean / cone - 1.0).abs() < 0.01, "{mean} {cone}");
    }
}
