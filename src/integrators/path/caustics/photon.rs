//! A photon: a place where focused light landed, and the directions it comes from around there.
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

/// See the drawing above. All vectors are in the world.
#[derive(Debug, Clone, Copy)]
pub(super) struct Photon {
    pub position: DVec3,
    /// Unit direction the light came from: w.
    pub towards: DVec3,
    /// J: the change of w is `turn[0] (along[0] . offset) + turn[1] (along[1] . offset)`.
    pub along: [DVec3; 2],
    pub turn: [DVec3; 2],
    /// Unit vectors at right angles to w: the axes of the light's image.
    pub axes: [DVec3; 2],
    /// Half axes of the image as tangents of angles.
    pub half: [f64; 2],
    /// How fast the image leaves the direction that is foreseen: tangent of the angle per squared distance from y.
    pub drift: f64,
}

/// What a photon foresees at a place.
#[derive(Clone, Copy)]
pub(super) struct Forecast {
    towards: DVec3,
    axes: [DVec3; 2],
    half: [f64; 2],
    /// Weight among the photons around, not normalised.
    pub weight: f64,
}

impl Photon {
    /// Where the light's image is seen from a place nearby.
    #[inline]
    pub fn forecast(&self, point: DVec3) -> Forecast {
        let offset = point - self.position;
        let squared_distance = offset.length_squared();
        let turned = self.turn[0] * self.along[0].dot(offset) + self.turn[1] * self.along[1].dot(offset);
        // A direction foreseen far away is no forecast.
        let turned = if turned.length_squared() < WIDEST * WIDEST { turned } else { DVec3::ZERO };
        let blur = self.drift * squared_distance;
        let half = self.half.map(|half| (half + blur).clamp(NARROWEST, WIDEST));
        let towards = (self.towards + turned).normalize();
        // The axes, turned along with w as far as they must be.
        let first = (self.axes[0] - towards * self.axes[0].dot(towards)).normalize();
        Forecast { towards, axes: [first, towards.cross(first)], half, weight: 1.0 / (half[0] * half[1]) }
    }
}

impl Forecast {
    /// A direction by two uniform numbers. The density falls with the fourth power of the distance from the middle, in units
    /// of the half axes: wide tails for what the forecast missed.
    #[inline]
    pub fn draw(&self, [radial, angular]: [f64; 2]) -> DVec3 {
        let radius = (radial / (1.0 - radial)).sqrt();
        let (sine, cosine) = sin_cos_turns(angular);
        let offset = self.axes[0] * (radius * cosine * self.half[0]) + self.axes[1] * (radius * sine * self.half[1]);
        (self.towards + offset).normalize()
    }

    /// Density by solid angle of [`Forecast::draw`].
    #[inline]
    pub fn density(&self, direction: DVec3) -> f64 {
        let cosine = direction.dot(self.towards);
        if cosine <= 0.0 {
            return 0.0;
        }
        // On the plane at distance 1 along w; a solid angle is cos^3 of an area there.
        let x = direction.dot(self.axes[0]) / (cosine * self.half[0]);
        let y = direction.dot(self.axes[1]) / (cosine * self.half[1]);
        let tail = 1.0 + x * x + y * y;
        1.0 / (std::f64::consts::PI * self.half[0] * self.half[1] * tail * tail * cosine * cosine * cosine)
    }

    /// How far a direction is from the middle, as the tangent of the angle.
    pub fn distance(&self, direction: DVec3) -> f64 {
        let cosine = direction.dot(self.towards).max(1e-9);
        (direction / cosine - self.towards).length()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn drawn_directions_have_their_density() {
        let photon = Photon {
            position: DVec3::ZERO,
            towards: DVec3::new(0.3, 0.2, 0.9).normalize(),
            along: [DVec3::X, DVec3::Y],
            turn: [DVec3::new(0.1, 0.0, 0.02), DVec3::new(0.0, -0.2, 0.0)],
            axes: [DVec3::X, DVec3::Y],
            half: [0.02, 0.1],
            drift: 0.5,
        };
        let forecast = photon.forecast(DVec3::new(0.1, -0.1, 0.0));
        // Importance sampling of a constant over the hemisphere around w: E[1 / density] = 2 pi.
        let count = 400;
        let mut sum = 0.0;
        for index in 0..count * count {
            let place = [
                (f64::from(index % count) + 0.5) / f64::from(count),
                (f64::from(index / count) + 0.5) / f64::from(count),
            ];
            let direction = forecast.draw(place);
            assert!((direction.length() - 1.0).abs() < 1e-12);
            // A bump of known integral: pi times the widths over the plane, seen under cos^3.
            sum += f64::from(forecast.distance(direction) < 0.2) / forecast.density(direction);
        }
        let cone = std::f64::consts::TAU * (1.0 - 1.0 / (1.0_f64 + 0.04).sqrt());
        let mean = sum / f64::from(count * count);
        assert!((mean / cone - 1.0).abs() < 0.01, "{mean} {cone}");
    }
}
