//! The spread of a beam along its chain: what a photon stores besides position and direction.

use super::chain::{Chain, ChainTracer, PhotonHit};
use super::emission::Beam;
use super::photon::Photon;
use crate::math::{DVec3, Frame};

/// How far from the middle ray those beside it hit, by length of their steps.
pub(super) struct Spread {
    /// Change of place and of direction by moving along the disc; `None` if they met other events.
    moved: Option<[(DVec3, DVec3); 2]>,
    /// The same by turning.
    turned: Option<[(DVec3, DVec3); 2]>,
    /// Of the source.
    width: f64,
}

impl Spread {
    /// Follows the rays beside the middle one through its events.
    pub fn of(tracer: &ChainTracer, beam: &Beam, chain: &Chain) -> Self {
        let change = |ray, step: f64| {
            let other = tracer.follow(ray, &chain.events)?;
            let hit = &chain.hit;
            Some(((other.position - hit.position) / step, (other.towards - hit.towards) / step))
        };
        let both = |[one, other]: [_; 2], step| Some([change(one, step)?, change(other, step)?]);
        let (moved, turned) = (both(beam.moved, beam.steps[0]), both(beam.turned, beam.steps[1]));
        Self { moved, turned, width: beam.width }
    }

    /// The photon, with the number of its chain.
    pub fn photon(&self, chain: &Chain, number: u32) -> Photon {
        let PhotonHit { position, normal, towards } = chain.hit;
        let Frame { tangent, bitangent, .. } = Frame::around(normal);
        let along = [tangent, bitangent];
        let view = Frame::around(towards);
        let unknown = Photon {
            position,
            towards,
            axes: [view.tangent, view.bitangent],
            along,
            jacobian: [[0.0; 2]; 2],
            half: [self.width; 2],
            chain: number,
            share: chain.share,
            drift: 0.0,
        };
        let Some(jacobian) = self.jacobian_along(along) else { return unknown };
        let (axes, half) = match self.turned {
            // Seen from the same place: what turning the source does, less what the move does that brings the ray back.
            Some(turned) => {
                let seen = |(place, direction): (DVec3, DVec3)| {
                    (direction - jacobian[0] * tangent.dot(place) - jacobian[1] * bitangent.dot(place)) * self.width
                };
                ellipse_axes(turned.map(seen), towards)
            }
            None => (unknown.axes, unknown.half),
        };
        let on_plane = |vector: DVec3| axes.map(|axis| axis.dot(vector));
        Photon { axes, jacobian: jacobian.map(on_plane), half, ..unknown }
    }

    /// J = W Y^-1: the change of direction for a step along either axis of the surface, from the changes of place Y and of
    /// direction W by moving the start of the ray. `None` where neighbours met other events or all hit in one line.
    fn jacobian_along(&self, [tangent, bitangent]: [DVec3; 2]) -> Option<[DVec3; 2]> {
        let [one, other] = self.moved?;
        let flat = |offset: DVec3| [tangent.dot(offset), bitangent.dot(offset)];
        let ([a, c], [b, d]) = (flat(one.0), flat(other.0));
        let determinant = a * d - b * c;
        let spread = determinant.abs() > 1e-6 * (a * a + b * b + c * c + d * d);
        spread.then(|| [(one.1 * d - other.1 * c) / determinant, (other.1 * a - one.1 * b) / determinant])
    }
}

/// The axes of the ellipse that two vectors (at right angles to `normal`, more or less) make of the unit circle, and their
/// lengths: the singular value decomposition of two columns (Golub and Van Loan, Matrix Computations, section 8.6).
fn ellipse_axes([one, other]: [DVec3; 2], normal: DVec3) -> ([DVec3; 2], [f64; 2]) {
    // Turn the circle so that the images of its axes are at right angles.
    let (difference, product) = (one.length_squared() - other.length_squared(), 2.0 * one.dot(other));
    let angle = 0.5 * crate::math::functions::arctan2(product, difference);
    let (sine, cosine) = (crate::math::functions::sin(angle), crate::math::functions::cos(angle));
    let (long, short) = (one * cosine + other * sine, other * cosine - one * sine);
    let fallback = Frame::around(normal);
    let first = (long - normal * long.dot(normal)).try_normalize().unwrap_or(fallback.tangent);
    ([first, normal.cross(first)], [long.length(), short.length()])
}
