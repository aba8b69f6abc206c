//! The camera: a pinhole, or a thin lens with depth of field.
//!
//! ```text
//!             up            right = forward x up
//!              |   forward
//!              |  /         image plane at distance 1: the picture's height is 2 tan(field_of_view / 2),
//!              | /          pixel (0, 0) is the top left one
//!   position   o----- right
//! ```
//!
//! Through a lens, all rays of a point in the picture meet in the plane of focus; nearer and farther points are spread
//! over a disc (Cook, Porter and Carpenter, Distributed Ray Tracing, 1984):
//!
//! ```text
//!     lens |\                       a point in focus at the depth `focus`: one place in the picture
//!          |   \_
//!   radius o-------*----------      a ray from any point of the lens goes through the same point in focus
//!          |   _/   focus
//!          |/
//! ```

use crate::math::functions::{cos, sin};
use crate::math::{DVec3, Ray};
use crate::sampling::warp::concentric_disc;

/// A camera that sees a rectangle of a plane through a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Camera {
    position: DVec3,
    /// From the middle of the image plane to the middle of its right border.
    right: DVec3,
    /// From the middle of the image plane to the middle of its top border.
    top: DVec3,
    forward: DVec3,
    width: usize,
    height: usize,
    lens: Option<Lens>,
}

/// A thin lens.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lens {
    /// Radius of the opening, in the scene's unit, more than 0.
    pub radius: f64,
    /// Distance along the view of the plane that is in focus, more than 0.
    pub focus: f64,
}

impl Camera {
    /// A camera at `position` that looks at `target` with `up` upwards in the picture; vertical field of view in
    /// degrees, picture size in pixels. `None` if target and up leave the orientation open (the target at the
    /// position, up along the view, or anything not finite).
    pub fn look_at(
        position: DVec3,
        target: DVec3,
        up: DVec3,
        field_of_view_degrees: f64,
        [width, height]: [usize; 2],
    ) -> Option<Self> {
        let forward = (target - position).try_normalize()?;
        let right = forward.cross(up.try_normalize()?);
        // Less than a thousandth of a degree between up and the view does not define a right.
        if right.length() < 1e-5 {
            return None;
        }
        let right = right.normalize();
        let half_angle = field_of_view_degrees.to_radians() / 2.0;
        // Exact for 90 degrees, whose views tile the cube.
        let half_height = if field_of_view_degrees == 90.0 { 1.0 } else { sin(half_angle) / cos(half_angle) };
        let half_width = half_height * width as f64 / height as f64;
        Some(Self {
            position,
            right: right * half_width,
            top: right.cross(forward) * half_height,
            forward,
            width,
            height,
            lens: None,
        })
    }

    /// The same view through a lens, or a pinhole for `None`.
    pub fn with_lens(self, lens: Option<Lens>) -> Self {
        Self { lens, ..self }
    }

    /// The lens; `None` for a pinhole.
    pub fn lens(&self) -> Option<Lens> {
        self.lens
    }

    /// The same view in another picture size. The vertical field of view stays.
    pub fn resized(self, [width, height]: [usize; 2]) -> Self {
        let half_height = self.top.length();
        let right = self.right.normalize() * (half_height * width as f64 / height as f64);
        Self { right, width, height, ..self }
    }

    /// Width and height in pixels.
    pub fn size(&self) -> [usize; 2] {
        [self.width, self.height]
    }

    /// In the world: the centre of the lens.
    pub fn position(&self) -> DVec3 {
        self.position
    }

    /// The ray through a place of the picture in pixels: `(0, 0)` is the top left corner, `(0.5, 0.5)` the middle of
    /// the first pixel.
    #[inline]
    pub fn ray(&self, x: f64, y: f64) -> Ray {
        Ray::new(self.position, self.towards(x, y).normalize())
    }

    /// Origin and direction of the ray through a place of the picture and a place of the lens, both numbers uniform in
    /// `[0, 1)`; a pinhole has one place only. The direction is of any length.
    #[inline]
    pub fn sight(&self, x: f64, y: f64, lens_place: [f64; 2]) -> (DVec3, DVec3) {
        let towards = self.towards(x, y);
        let Some(lens) = self.lens else { return (self.position, towards) };
        let offset = self.place_on_lens(lens, lens_place);
        (self.position + offset, towards * lens.focus - offset)
    }

    /// A place of the lens, relative to its middle.
    #[inline(never)]
    fn place_on_lens(&self, lens: Lens, place: [f64; 2]) -> DVec3 {
        let point = concentric_disc(place) * lens.radius;
        self.right.normalize() * point.x + self.top.normalize() * point.y
    }

    /// The view through a place of the picture, of length 1 along the forward direction.
    #[inline(always)]
    fn towards(&self, x: f64, y: f64) -> DVec3 {
        let across = 2.0 * x / self.width as f64 - 1.0;
        let upwards = 1.0 - 2.0 * y / self.height as f64;
        self.forward + self.right * across + self.top * upwards
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corners_of_a_90_degree_view_are_corners_of_the_cube() {
        let camera = Camera::look_at(DVec3::ZERO, DVec3::X, DVec3::Z, 90.0, [8, 8]).unwrap();
        let corner = |x, y| camera.ray(x, y).direction * 3.0_f64.sqrt();
        assert!((corner(0.0, 0.0) - DVec3::new(1.0, 1.0, 1.0)).length() < 1e-14, "top left: +y is left of +x in z up");
        assert!((corner(8.0, 8.0) - DVec3::new(1.0, -1.0, -1.0)).length() < 1e-14);
    }

    #[test]
    fn rays_through_a_lens_meet_in_the_plane_in_focus() {
        let lens = Lens { radius: 0.5, focus: 3.0 };
        let pinhole = Camera::look_at(DVec3::new(1.0, 2.0, 3.0), DVec3::X, DVec3::Z, 60.0, [8, 6]).unwrap();
        let camera = pinhole.with_lens(Some(lens));
        let forward = (DVec3::X - camera.position()).normalize();
        let in_focus =
            |ray: Ray| ray.at((3.0 - (ray.origin - camera.position()).dot(forward)) / ray.direction.dot(forward));
        let expected = in_focus(pinhole.ray(1.25, 4.5));
        for place in [[0.0, 0.0], [0.1, 0.9], [0.5, 0.5], [0.99, 0.3]] {
            let (origin, towards) = camera.sight(1.25, 4.5, place);
            let ray = Ray::new(origin, towards.normalize());
            assert!((in_focus(ray) - expected).length() < 1e-12);
            assert!((ray.origin - camera.position()).length() <= 0.5 + 1e-12);
            assert!((ray.origin - camera.position()).dot(forward).abs() < 1e-12);
        }
    }

    #[test]
    fn an_undefined_orientation_is_none() {
        let look = |target, up| Camera::look_at(DVec3::ZERO, target, up, 45.0, [4, 3]);
        assert!(look(DVec3::ZERO, DVec3::Z).is_none());
        assert!(look(DVec3::Z, DVec3::Z).is_none());
        assert!(look(DVec3::X, DVec3::ZERO).is_none());
    }
}
