//! The shapes of a scene that stand under a hierarchy of boxes.

use crate::bvh::{FloatBox, Hierarchy, TextbookHierarchy, Visit};
use crate::math::{Bounds, Ray};
use crate::shapes::{Hit, Primitive};

/// Shapes under a hierarchy, by their numbers in the scene.
#[derive(Debug)]
pub(super) struct BoxedShapes {
    hierarchy: AnyHierarchy,
    /// Shape numbers in the order of the hierarchy's boxes.
    shapes: Vec<u32>,
}

/// Both find the same.
#[derive(Debug)]
enum AnyHierarchy {
    Fast(Hierarchy),
    Textbook(TextbookHierarchy),
}

impl BoxedShapes {
    /// Builds the fast hierarchy, or that of lesson 10, over shapes with bounds; there is at least one.
    pub fn build(shapes: Vec<u32>, boxes: &[Bounds], textbook: bool) -> Self {
        let hierarchy = if textbook {
            AnyHierarchy::Textbook(TextbookHierarchy::build(boxes))
        } else {
            let boxes: Vec<FloatBox> = boxes.iter().map(FloatBox::containing).collect();
            AnyHierarchy::Fast(Hierarchy::build(&boxes))
        };
        Self { hierarchy, shapes }
    }

    /// The nearest hit of these shapes if it is nearer than a hit known.
    #[inline]
    pub fn nearer(&self, primitives: &[Primitive], ray: &Ray, mut nearest: Hit) -> Hit {
        let hierarchy = match &self.hierarchy {
            AnyHierarchy::Fast(hierarchy) => hierarchy,
            AnyHierarchy::Textbook(hierarchy) => return self.nearer_by_textbook(hierarchy, primitives, ray, nearest),
        };
        let Some(walk) = hierarchy.ray(ray.origin, ray.direction) else { return nearest };
        hierarchy.traverse(
            &walk,
            nearest.t,
            |_| {},
            |leaf| {
                for &index in hierarchy.leaf(leaf) {
                    let shape = self.shapes[index as usize];
                    nearest = primitives[shape as usize].nearer(ray, shape, nearest);
                }
                Visit::Closer(nearest.t)
            },
        );
        nearest
    }

    // Never in line: that would cost the fast hierarchy 1.5 % (the marbles of lesson 10).
    #[inline(never)]
    fn nearer_by_textbook(
        &self,
        hierarchy: &TextbookHierarchy,
        primitives: &[Primitive],
        ray: &Ray,
        mut nearest: Hit,
    ) -> Hit {
        hierarchy.intersect(ray.origin, ray.direction, nearest.t, |index| {
            let shape = self.shapes[index as usize];
            nearest = primitives[shape as usize].nearer(ray, shape, nearest);
            nearest.t
        });
        nearest
    }

    /// True if `stops` holds for the number of a shape whose box the ray meets within `limit`.
    #[inline]
    pub fn any(&self, ray: &Ray, limit: f64, stops: impl Fn(u32) -> bool) -> bool {
        let stops = |index: u32| stops(self.shapes[index as usize]);
        let hierarchy = match &self.hierarchy {
            AnyHierarchy::Fast(hierarchy) => hierarchy,
            AnyHierarchy::Textbook(hierarchy) => return hierarchy.occluded(ray.origin, ray.direction, limit, stops),
        };
        let Some(walk) = hierarchy.ray(ray.origin, ray.direction) else { return false };
        let mut found = false;
        hierarchy.traverse(
            &walk,
            limit,
            |_| {},
            |leaf| {
                found = hierarchy.leaf(leaf).iter().any(|&index| stops(index));
                if found { Visit::Stop } else { Visit::Continue }
            },
        );
        found
    }
}
