//! The six axis shots: pictures of a 90 degree camera at the origin, one along each axis.
//!
//! ```text
//!   world up    sides look up   along the up axis, up =   along the other end, up =
//!     +z             +z              -y  (along +z)             +y  (along -z)
//!     +y             +y              +z  (along +y)             -z  (along -y)
//!     +x             +x              +z  (along +x)             -z  (along -x)
//!     -z             -z              -y  (along -z)             +y  (along +z)
//!     -y, -x         the same        +z  (along -y, -x)         -z  (along +y, +x)
//! ```
//!
//! One rule makes the table: every world has a front (+y where z is the vertical axis, else -z, as
//! [`Equirectangular`](crate::envmap::Equirectangular) has it). A camera that looks to the front and tilts back to look
//! upwards has the front behind its head, up = -front; tilted down it has up = +front.

use crate::camera::Camera;
use crate::envmap::{Environment, Face, SignedAxis};
use crate::math::DVec3;
use crate::scene::Scene;

/// How the camera of one axis shot looks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct AxisShot {
    /// The axis the camera looks along, by the name of the face it sees. The file of the shot is named after it.
    pub direction: Face,
    /// The axis that points upwards in the picture.
    pub up: SignedAxis,
}

impl AxisShot {
    /// The shot along `direction` in a world whose vertical axis is `world_up`.
    pub fn new(direction: Face, world_up: SignedAxis) -> Self {
        let forward = direction.signed_axis();
        let up = match forward {
            _ if forward == world_up => -front(world_up),
            _ if forward == -world_up => front(world_up),
            _ => world_up,
        };
        Self { direction, up }
    }

    /// All six in the order of [`Face::ALL`].
    pub fn all(world_up: SignedAxis) -> [Self; 6] {
        Face::ALL.map(|direction| Self::new(direction, world_up))
    }

    /// The axis that points to the right in the picture: forward x up.
    pub fn right(self) -> SignedAxis {
        self.direction.signed_axis().cross(self.up).expect("up is at a right angle to the view")
    }

    /// The camera: at the origin, 90 degrees wide and high, `size` pixels each way.
    pub fn camera(self, size: usize) -> Camera {
        let [target, up] = [self.direction.normal(), self.up.direction()].map(|axis| axis.as_dvec3());
        Camera::look_at(DVec3::ZERO, target, up, 90.0, [size, size]).expect("up is at a right angle to the view")
    }

    /// A scene of nothing but an environment, seen by this camera.
    pub fn scene(self, environment: Environment, size: usize) -> Scene {
        Scene::of_environment(environment, self.camera(size))
    }
}

/// The horizontal axis that a world looks to at the start.
pub fn front(world_up: SignedAxis) -> SignedAxis {
    if world_up.axis == 2 { SignedAxis::POS_Y } else { SignedAxis::NEG_Z }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ups(world_up: &str) -> String {
        AxisShot::all(world_up.parse().unwrap()).map(|shot| shot.up.to_string()).join(" ")
    }

    /// Along +x -x +y -y +z -z; the first two lines are those of `conventions.md`.
    #[test]
    fn the_table_at_the_top() {
        assert_eq!(ups("+z"), "+z +z +z +z -y +y");
        assert_eq!(ups("+y"), "+y +y +z -z +y +y");
        assert_eq!(ups("+x"), "+z -z +x +x +x +x");
        assert_eq!(ups("-z"), "-z -z -z -z +y -y");
        assert_eq!(ups("-y"), "-y -y -z +z -y -y");
        assert_eq!(ups("-x"), "-z +z -x -x -x -x");
    }

    #[test]
    fn the_camera_is_the_table() {
        for world_up in Face::ALL.map(Face::signed_axis) {
            for shot in AxisShot::all(world_up) {
                // The middle of the right border looks along forward + right, that of the top along forward + up.
                let camera = shot.camera(2);
                let towards = |x, y| camera.ray(x, y).direction * 2.0_f64.sqrt() - shot.direction.normal().as_dvec3();
                assert!((towards(2.0, 1.0) - shot.right().direction().as_dvec3()).length() < 1e-15);
                assert!((towards(1.0, 0.0) - shot.up.direction().as_dvec3()).length() < 1e-15);
            }
        }
    }
}
