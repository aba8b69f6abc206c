//! A right-handed frame around a normal.

use super::DVec3;

/// Three unit vectors at right angles, `tangent x bitangent = normal`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    /// The x axis.
    pub tangent: DVec3,
    /// The y axis.
    pub bitangent: DVec3,
    /// The z axis.
    pub normal: DVec3,
}

impl Frame {
    /// A frame around a unit normal, without a branch and without a loss of digits anywhere (Duff et al., Building an
    /// Orthonormal Basis, Revisited, JCGT 2017).
    #[inline]
    pub fn around(normal: DVec3) -> Self {
        let sign = 1.0_f64.copysign(normal.z);
        let a = -1.0 / (sign + normal.z);
        let b = normal.x * normal.y * a;
        Self {
            tangent: DVec3::new(1.0 + sign * normal.x * normal.x * a, sign * b, -sign * normal.x),
            bitangent: DVec3::new(b, sign + normal.y * normal.y * a, -normal.y),
            normal,
        }
    }

    /// A world vector in the frame: z along the normal.
    #[inline]
    pub fn to_local(&self, vector: DVec3) -> DVec3 {
        DVec3::new(vector.dot(self.tangent), vector.dot(self.bitangent), vector.dot(self.normal))
    }

    /// A vector of the frame in the world.
    #[inline]
    pub fn to_world(&self, vector: DVec3) -> DVec3 {
        self.tangent * vector.x + self.bitangent * vector.y + self.normal * vector.z
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_are_right_handed_and_orthonormal_for_every_normal() {
        let mut normals = vec![DVec3::Z, DVec3::NEG_Z, DVec3::X, DVec3::NEG_Y, DVec3::new(1e-9, 0.0, -1.0)];
        normals.extend(
            (0..500).map(|k| DVec3::new(f64::from(k % 7) - 3.1, f64::from(k % 11) - 5.2, f64::from(k % 13) - 6.3)),
        );
        for normal in normals.into_iter().map(DVec3::normalize) {
            let frame = Frame::around(normal);
            assert!((frame.tangent.cross(frame.bitangent) - normal).length() < 1e-14, "{normal}");
            assert!((frame.tangent.length() - 1.0).abs() < 1e-14 && frame.tangent.dot(normal).abs() < 1e-15);
            let vector = DVec3::new(0.3, -0.5, 0.7);
            assert!((frame.to_world(frame.to_local(vector)) - vector).length() < 1e-14);
        }
    }
}
