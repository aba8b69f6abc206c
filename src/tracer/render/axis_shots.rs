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
//! [`Equirectangular`](crate::envmap::Equirectangular) has it; [`World::front`]). A camera that looks to the front and tilts back to look
//! upwards has the front behind its head, up = -front; tilted down it has up = +front.

use crate::camera::Camera;
use crate::envmap::{Environment, Face, Handedness, SignedAxis, World};
use crate::math::DVec3;
use crate::picture::Raster;
use crate::scene::Scene;

/// How the camera of one axis shot looks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct AxisShot {
    /// The axis the camera looks along, by the name of the face it sees. The file of the shot is named after it.
    pub direction: Face,
    /// The axis that points upwards in the picture.
    pub up: SignedAxis,
    /// That of the world.
    pub handedness: Handedness,
}

impl AxisShot {
    /// The shot along `direction` in a world, or in a right-handed one of which the vertical axis is given.
    pub fn new(direction: Face, world: impl Into<World>) -> Self {
        let (forward, world) = (direction.signed_axis(), world.into());
        let up = match forward {
            _ if forward == world.up => -world.front(),
            _ if forward == -world.up => world.front(),
            _ => world.up,
        };
        Self { direction, up, handedness: world.handedness }
    }

    /// All six in the order of [`Face::ALL`].
    pub fn all(world: impl Into<World>) -> [Self; 6] {
        let world = world.into();
        Face::ALL.map(|direction| Self::new(direction, world))
    }

    /// The axis that points to the right in the picture: forward x up; in a left-handed world the opposite one.
    pub fn right(self) -> SignedAxis {
        let right = self.direction.signed_axis().cross(self.up).expect("up is at a right angle to the view");
        if self.handedness == Handedness::Left { -right } else { right }
    }

    /// What its viewer sees where the camera took `raster`: in a left-handed world the mirror image.
    pub fn as_seen(self, raster: Raster) -> Raster {
        match self.handedness {
            Handedness::Right => raster,
            Handedness::Left => {
                Raster::from_function(raster.width(), raster.height(), |x, y| raster.pixel(raster.width() - 1 - x, y))
            }
        }
    }

    /// The tracer's right-handed camera: at the origin, 90 degrees wide and high, `size` pixels each way.
    pub fn camera(self, size: usize) -> Camera {
        let [target, up] = [self.direction.normal(), self.up.direction()].map(|axis| axis.as_dvec3());
        Camera::look_at(DVec3::ZERO, target, up, 90.0, [size, size]).expect("up is at a right angle to the view")
    }

    /// A scene of nothing but an environment, seen by this camera.
    pub fn scene(self, environment: Environment, size: usize) -> Scene {
        Scene::of_environment(environment, self.camera(size))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ups(world_up: &str) -> String {
        AxisShot::all(world_up.parse::<SignedAxis>().unwrap()).map(|shot| shot.up.to_string()).join(" ")
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

    /// As Direct3D and Unity have it (forward +z, right +x), and Unreal (forward +x, right +y).
    #[test]
    fn left_handed_worlds_have_their_right_on_the_other_side() {
        for (up, front, right) in [("+y", "+z", "+x"), ("+z", "+x", "+y")] {
            let world = World { up: up.parse().unwrap(), handedness: Handedness::Left };
            assert_eq!(world.front().to_string(), front);
            assert_eq!(AxisShot::new(world.front().face(), world).right().to_string(), right);
        }
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
