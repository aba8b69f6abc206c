//! A shape placed in the world.

mod intersection;
mod surface;

use std::sync::Arc;

use super::flat::{Height, Outline};
use super::mesh::Mesh;
use crate::math::{DVec2, DVec3, SurfaceId, Transform, Vec3};

/// A shape with its place and material.
#[derive(Debug, Clone)]
pub struct Primitive {
    /// The shape in object space.
    pub geometry: Geometry,
    /// From object space to the world.
    pub transform: Transform,
    /// One material, or one for each group of a mesh.
    pub material: MaterialChoice,
    /// False if light passes the shape as if it were not there.
    pub casts_shadow: bool,
    /// False if nothing needs the texture coordinates: they then stay 0.
    pub textured: bool,
    kernel: Kernel,
}

/// The form of a shape in its own space.
#[derive(Debug, Clone)]
pub enum Geometry {
    /// Radius 1 around the origin.
    Sphere,
    /// In the plane z = 0, normal +z.
    Flat(Outline),
    /// The cube `[-1, 1]^3`.
    Cuboid,
    /// Shared by all its instances.
    Mesh(Arc<Mesh>),
}

impl Geometry {
    /// The name of the shape in scenes.
    pub fn name(&self) -> &'static str {
        match self {
            Geometry::Sphere => "sphere",
            Geometry::Flat(Outline::Plane) => "plane",
            Geometry::Flat(Outline::Disc) => "disc",
            Geometry::Flat(Outline::Rectangle) => "rectangle",
            Geometry::Cuboid => "box",
            Geometry::Mesh(_) => "mesh",
        }
    }
}

/// What is computed for a ray, with what is derived from the transform once.
#[derive(Debug, Clone)]
enum Kernel {
    /// A sphere that the transform leaves round.
    RoundSphere {
        centre: DVec3,
        radius: f64,
        inverse_radius: f64,
    },
    /// A sphere that the transform makes an ellipsoid.
    Ellipsoid,
    /// `normal` is of unit length, in the world.
    Flat {
        outline: Outline,
        height: Height,
        normal: DVec3,
    },
    Cuboid,
    Mesh(Arc<Mesh>),
}

/// Which material a shape has.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum MaterialChoice {
    /// One for the whole shape: its number in the scene.
    Whole(u32),
    /// One for each group of a mesh.
    PerGroup(Arc<[u32]>),
}

/// Where a ray meets a shape.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hit {
    /// Distance along the ray.
    pub t: f64,
    /// Which shape, and which triangle of a mesh.
    pub id: SurfaceId,
    /// Weights of the three vertices of a triangle; 0 for other shapes.
    pub barycentric: [f64; 3],
}

/// The surface at a hit, in the world.
#[derive(Debug, Clone, Copy)]
pub struct Surface {
    /// The point itself.
    pub position: DVec3,
    /// Unit normal of the true surface, pointing to its front (outside).
    pub normal: DVec3,
    /// Unit normal to shade with: interpolated over smooth meshes, otherwise the true one.
    pub shading_normal: DVec3,
    /// Where the colours of its material are looked up.
    pub texture: TexturePoint,
    /// Number of the material in the scene.
    pub material: u32,
    /// Which shape, and which triangle of a mesh.
    pub id: SurfaceId,
}

/// Where on a surface a colour is looked up.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct TexturePoint {
    /// v grows upwards, 0 at the bottom of a picture.
    pub coordinates: DVec2,
    /// Linear RGB between the vertices of a mesh; black where they have no colours.
    pub vertex_colour: Vec3,
}

impl Primitive {
    /// A shape in its place.
    pub fn new(geometry: Geometry, transform: Transform, material: MaterialChoice, casts_shadow: bool) -> Self {
        let kernel = match &geometry {
            Geometry::Flat(outline) => Kernel::Flat {
                outline: *outline,
                height: Height::of(&transform.to_object),
                normal: transform.normal_to_world(DVec3::Z),
            },
            Geometry::Sphere => transform.uniform_scale().map_or(Kernel::Ellipsoid, |radius| Kernel::RoundSphere {
                centre: transform.to_world.translation,
                radius,
                inverse_radius: 1.0 / radius,
            }),
            Geometry::Cuboid => Kernel::Cuboid,
            Geometry::Mesh(mesh) => Kernel::Mesh(Arc::clone(mesh)),
        };
        Self { geometry, transform, material, casts_shadow, textured: true, kernel }
    }

    /// True for flat shapes and round spheres, which cost a ray less than a box around them would.
    pub fn is_simple(&self) -> bool {
        matches!(self.kernel, Kernel::Flat { .. } | Kernel::RoundSphere { .. })
    }

    /// True for meshes of triangles.
    pub fn is_mesh(&self) -> bool {
        matches!(self.kernel, Kernel::Mesh(_))
    }

    /// Centre and radius in the world, if this is a sphere that its transform leaves round.
    pub fn as_sphere(&self) -> Option<(DVec3, f64)> {
        match self.kernel {
            Kernel::RoundSphere { centre, radius, .. } => Some((centre, radius)),
            _ => None,
        }
    }
}

impl MaterialChoice {
    /// The scene's numbers of all its materials.
    pub fn numbers(&self) -> &[u32] {
        match self {
            MaterialChoice::Whole(material) => std::slice::from_ref(material),
            MaterialChoice::PerGroup(materials) => materials,
        }
    }

    /// The scene's number of the material of a group.
    fn of_group(&self, group: u32) -> u32 {
        match self {
            MaterialChoice::Whole(material) => *material,
            MaterialChoice::PerGroup(materials) => materials[group as usize],
        }
    }
}
