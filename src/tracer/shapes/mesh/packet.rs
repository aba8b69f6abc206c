//! Four triangles tested at once.

use glam::Vec4;

use super::triangle::ShearedRay;
use crate::bvh::{HierarchyRay, LEAF_CAPACITY};
use crate::math::Vec3;

/// The triangles of a leaf.
#[derive(Debug, Clone)]
#[repr(C, align(32))]
pub(super) struct Packet {
    /// `[corner][axis]`, of all four triangles each.
    corners: [[Vec4; 3]; 3],
    /// Their numbers in the mesh; [`Packet::NONE`] for empty places.
    pub(super) triangles: [u32; LEAF_CAPACITY],
}

impl Packet {
    /// Number of the triangle in an empty place.
    pub(super) const NONE: u32 = u32::MAX;

    /// Packs up to four triangles.
    pub(super) fn new(members: &[(u32, [Vec3; 3])]) -> Self {
        let mut packet = Self { corners: [[Vec4::ZERO; 3]; 3], triangles: [Self::NONE; LEAF_CAPACITY] };
        for place in 0..LEAF_CAPACITY {
            // An empty place repeats a triangle, so that no special value slows the arithmetic down.
            let (number, corners) = members[place.min(members.len() - 1)];
            if place < members.len() {
                packet.triangles[place] = number;
            }
            for (corner, position) in corners.iter().enumerate() {
                for axis in 0..3 {
                    packet.corners[corner][axis][place] = position[axis];
                }
            }
        }
        packet
    }

    /// The corners of one triangle, exactly.
    #[inline]
    pub(super) fn triangle(&self, place: usize) -> [[f64; 3]; 3] {
        self.corners.map(|corner| corner.map(|axis| f64::from(axis.as_ref()[place])))
    }
}

/// A ray that sorts out, in single precision, triangles it certainly misses. What passes is tested exactly.
pub(super) struct PacketRay {
    origin: [Vec4; 3],
    shear: [Vec4; 2],
    axes: [usize; 3],
    error: Vec4,
}

impl PacketRay {
    #[inline]
    pub(super) fn new(ray: &HierarchyRay, sheared: &ShearedRay) -> Self {
        Self {
            origin: sheared.axes.map(|axis| Vec4::splat(ray.origin[axis])),
            shear: [Vec4::splat(sheared.shear[0] as f32), Vec4::splat(sheared.shear[1] as f32)],
            axes: sheared.axes,
            error: Vec4::splat(ray.error),
        }
    }

    /// A bit for each triangle that the ray may hit.
    ///
    /// The sheared coordinates are off by at most `error` (see [`HierarchyRay`]), so an edge function, say
    /// `cx by - cy bx`, is off by at most `error (|bx| + |by| + |cx| + |cy| + 2 error)` and the rounding of its own three operations, for
    /// which `error`, at least 16 roundoffs of the largest coordinate, has room. Twice the sum over all three corners is on the safe side.
    #[inline]
    pub(super) fn candidates(&self, packet: &Packet) -> u32 {
        let [(ax, ay), (bx, by), (cx, cy)] = std::array::from_fn(|corner| self.shear(&packet.corners[corner]));
        let u = cx * by - cy * bx;
        let v = ax * cy - ay * cx;
        let w = bx * ay - by * ax;
        let size = ax.abs() + ay.abs() + bx.abs() + by.abs() + cx.abs() + cy.abs();
        let margin = (self.error + self.error) * (size + self.error);
        let outside = u.min(v).min(w).cmplt(-margin).bitmask() & u.max(v).max(w).cmpgt(margin).bitmask();
        !outside & 0xF
    }

    #[inline]
    fn shear(&self, corner: &[Vec4; 3]) -> (Vec4, Vec4) {
        let z = corner[self.axes[2]] - self.origin[2];
        let x = corner[self.axes[0]] - self.origin[0];
        let y = corner[self.axes[1]] - self.origin[1];
        (x - self.shear[0] * z, y - self.shear[1] * z)
    }
}
