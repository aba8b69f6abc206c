//! The directions in which shapes may stand in the way of the sky: cones around balls around them.

use std::f64::consts::TAU;

use super::super::view::View;
use crate::math::functions::sin_cos_turns;
use crate::math::{DVec3, Frame};
use crate::sampling::warp::among_weights;
use crate::scene::Plan;
use crate::shapes::{BoundingBall, Surface};

/// Share of the sky, weighted by the cosine, above which too much of its light would be taken first and taken back then.
/// Measured where balls touch a floor: 1 is noisier there, and shows single pixels less than black at 16 samples; with 0.3
/// the floor around is noisier.
const MOST_HIDDEN: f64 = 0.6;

/// The directions from one place that shapes may fill: cones, each with its probability.
pub(super) struct Obstacles {
    cones: [Cone; Plan::MOST_OBSTACLES],
    count: usize,
    /// Sum of the weights of all cones: about the share of the sky, weighted by the cosine, that they fill.
    weight: f64,
}

/// Directions around an axis.
#[derive(Debug, Clone, Copy)]
struct Cone {
    axis: DVec3,
    /// 1 - cosine of the half angle.
    spread: f64,
    weight: f64,
}

impl Obstacles {
    /// `None` from inside of a ball around a shape, which may then be in every direction, and where shapes fill most of the sky.
    #[inline]
    pub fn seen_from(balls: &[Option<BoundingBall>], surface: &Surface, view: &View) -> Option<Self> {
        let mut obstacles = Self {
            cones: [Cone { axis: DVec3::Z, spread: 0.0, weight: 0.0 }; Plan::MOST_OBSTACLES],
            count: 0,
            weight: 0.0,
        };
        for (shape, ball) in balls.iter().enumerate() {
            // A flat surface does not hide the sky from itself.
            if shape == surface.id.shape as usize {
                continue;
            }
            let cone = Cone::around(ball.as_ref()?, surface.position, view.normal)?;
            if cone.weight > 0.0 {
                obstacles.cones[obstacles.count] = cone;
                obstacles.count += 1;
                obstacles.weight += cone.weight;
            }
        }
        (obstacles.weight <= MOST_HIDDEN).then_some(obstacles)
    }

    /// True if nothing hides the sky.
    #[inline]
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// The share of the sky, weighted by the cosine, that shapes may fill: about right, too large where their cones overlap.
    #[inline]
    pub fn share(&self) -> f64 {
        self.weight
    }

    /// A direction to something that may hide the sky, and its density by solid angle. There must be some.
    #[inline]
    pub fn draw(&self, place: [f64; 2], choice: f64) -> (DVec3, f64) {
        let cones = &self.cones[..self.count];
        let (chosen, _) = among_weights(cones.len(), |cone| cones[cone].weight, choice * self.weight);
        let direction = cones[chosen].draw(place);
        // The cones may overlap: the density is that of all together.
        let density: f64 = cones
            .iter()
            .enumerate()
            .filter(|&(number, cone)| number == chosen || cone.contains(direction))
            .map(|(_, cone)| cone.weight / (TAU * cone.spread))
            .sum();
        (direction, density / self.weight)
    }
}

impl Cone {
    /// The cone that a ball fills over a surface; of weight 0 below its horizon. `None` from inside of the ball.
    ///
    /// The weight is the share of the sky, weighted by the cosine, of a ball wholly above the horizon, `sin^2 m cos`; and
    /// not less than a little for one that is cut by it.
    #[inline]
    fn around(ball: &BoundingBall, position: DVec3, normal: DVec3) -> Option<Self> {
        let offset = ball.centre - position;
        let square = offset.length_squared();
        let sine_square = ball.radius * ball.radius / square;
        // Not quite at the ball: rounding must not make a cone of more than half of all directions.
        if sine_square.is_nan() || sine_square > 1.0 - 1e-9 {
            return None;
        }
        let axis = offset / square.sqrt();
        let height = axis.dot(normal);
        let sine = sine_square.sqrt();
        let weight = if height <= -sine { 0.0 } else { sine_square * height.max(0.25 * sine) };
        // 1 - cos m without cancellation.
        let spread = sine_square / (1.0 + (1.0 - sine_square).sqrt());
        Some(Self { axis, spread, weight })
    }

    /// A direction uniform in the cone.
    #[inline]
    fn draw(&self, place: [f64; 2]) -> DVec3 {
        let offset = place[0] * self.spread;
        let radius = (offset * (2.0 - offset)).sqrt();
        let (sine, cosine) = sin_cos_turns(place[1]);
        Frame::around(self.axis).to_world(DVec3::new(radius * cosine, radius * sine, 1.0 - offset))
    }

    #[inline]
    fn contains(&self, direction: DVec3) -> bool {
        direction.dot(self.axis) >= 1.0 - self.spread
    }
}
