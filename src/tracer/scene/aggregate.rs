//! All shapes of a scene, and the way to find those a ray meets.

use crate::bvh::{FloatBox, Hierarchy, Visit};
use crate::materials::MediumStack;
use crate::math::{Ray, Side, SurfaceId};
use crate::shapes::{Balls, Hit, Primitive, Surface};

/// No shape has this number.
const NONE: u32 = u32::MAX;

/// The shapes of a scene. A handful is tried one after the other; more get a hierarchy of boxes.
#[derive(Debug)]
pub struct Aggregate {
    primitives: Vec<Primitive>,
    /// Round spheres outside of a hierarchy, tried four at once.
    balls: Vec<Balls>,
    /// Shapes tried one by one: without a hierarchy all others, otherwise those without end.
    listed: Vec<u32>,
    hierarchy: Option<BoxedShapes>,
}

/// The shapes that have bounds, under a hierarchy.
#[derive(Debug)]
struct BoxedShapes {
    hierarchy: Hierarchy,
    /// Shape numbers in the order of the hierarchy's boxes.
    shapes: Vec<u32>,
}

impl Aggregate {
    /// Up to this many bounded shapes are tried one by one: below it the hierarchy costs more than it saves
    /// (measured by the benchmark `scenes`).
    pub const HANDFUL: usize = 4;

    /// Builds what the count of shapes asks for.
    pub fn new(primitives: Vec<Primitive>) -> Self {
        let numbers = || 0..primitives.len() as u32;
        let bounds: Vec<_> = primitives.iter().map(Primitive::bounds).collect();
        let bounded: Vec<u32> = numbers().filter(|&shape| bounds[shape as usize].is_some()).collect();
        if bounded.len() <= Self::HANDFUL {
            return Self::without_hierarchy(primitives);
        }
        let boxes: Vec<FloatBox> = bounded
            .iter()
            .filter_map(|&shape| bounds[shape as usize])
            .map(|bounds| FloatBox::containing(&bounds))
            .collect();
        let listed = numbers().filter(|&shape| bounds[shape as usize].is_none()).collect();
        let hierarchy = Some(BoxedShapes { hierarchy: Hierarchy::build(&boxes), shapes: bounded });
        Self { primitives, balls: Vec::new(), listed, hierarchy }
    }

    /// Tries all shapes one after the other, round spheres four at once.
    pub fn without_hierarchy(primitives: Vec<Primitive>) -> Self {
        let numbers = 0..primitives.len() as u32;
        let ball = |shape: u32| primitives[shape as usize].as_ball().map(|(centre, radius)| (shape, centre, radius));
        let balls = Balls::pack(&numbers.clone().filter_map(ball).collect::<Vec<_>>());
        let listed = numbers.filter(|&shape| ball(shape).is_none()).collect();
        Self { balls, listed, primitives, hierarchy: None }
    }

    /// All shapes, by their numbers.
    pub fn primitives(&self) -> &[Primitive] {
        &self.primitives
    }

    /// True if a hierarchy was built.
    pub fn has_hierarchy(&self) -> bool {
        self.hierarchy.is_some()
    }

    /// The nearest hit of the ray.
    // Always in line: the hit is used field by field at once, and would otherwise go through memory.
    #[inline(always)]
    pub fn intersect(&self, ray: &Ray) -> Option<Hit> {
        let mut nearest = Hit { t: f64::INFINITY, id: SurfaceId { shape: NONE, part: 0 }, barycentric: [0.0; 3] };
        for balls in &self.balls {
            balls.hits(ray, |shape, t| {
                if t < nearest.t {
                    nearest.t = t;
                    nearest.id = SurfaceId { shape, part: 0 };
                }
                false
            });
        }
        for &shape in &self.listed {
            self.primitives[shape as usize].find_nearer(ray, shape, &mut nearest);
        }
        if let Some(boxed) = &self.hierarchy {
            self.intersect_boxed(boxed, ray, &mut nearest);
        }
        (nearest.id.shape != NONE).then_some(nearest)
    }

    #[inline(never)]
    fn intersect_boxed(&self, boxed: &BoxedShapes, ray: &Ray, nearest: &mut Hit) {
        let Some(walk) = boxed.hierarchy.ray(ray.origin, ray.direction) else { return };
        boxed.hierarchy.traverse(
            &walk,
            nearest.t,
            |_| {},
            |leaf| {
                for &index in boxed.hierarchy.leaf(leaf) {
                    let shape = boxed.shapes[index as usize];
                    self.primitives[shape as usize].find_nearer(ray, shape, nearest);
                }
                Visit::Closer(nearest.t)
            },
        );
    }

    /// True if something that casts shadows is met within `limit`.
    #[inline]
    pub fn occluded(&self, ray: &Ray, limit: f64) -> bool {
        self.any_hit::<true>(ray, limit)
    }

    /// True if anything is met within `limit`, even what casts no shadows.
    #[inline]
    pub fn blocked(&self, ray: &Ray, limit: f64) -> bool {
        self.any_hit::<false>(ray, limit)
    }

    #[inline]
    fn any_hit<const SHADOWING: bool>(&self, ray: &Ray, limit: f64) -> bool {
        let counts = |shape: u32| !SHADOWING || self.primitives[shape as usize].casts_shadow;
        let in_the_way = |shape: u32, t: f64| t < limit && counts(shape);
        if self.balls.iter().any(|balls| balls.hits(ray, in_the_way)) {
            return true;
        }
        let occludes = |shape: u32| counts(shape) && self.primitives[shape as usize].occludes(ray, shape, limit);
        if self.listed.iter().any(|&shape| occludes(shape)) {
            return true;
        }
        let Some(boxed) = &self.hierarchy else { return false };
        let Some(walk) = boxed.hierarchy.ray(ray.origin, ray.direction) else { return false };
        let mut found = false;
        boxed.hierarchy.traverse(
            &walk,
            limit,
            |_| {},
            |leaf| {
                found = boxed.hierarchy.leaf(leaf).iter().any(|&index| occludes(boxed.shapes[index as usize]));
                if found { Visit::Stop } else { Visit::Continue }
            },
        );
        found
    }

    /// Of glasses inside of one another those whose inside the ray meets ahead.
    ///
    /// Where the surfaces of two glasses coincide, rounding may have the ray enter the second before it leaves the first,
    /// and start past the first one's surface, which is then never met:
    ///
    /// ```text
    ///       first      | second
    ///     -------------o====>          o lies a rounding error to the right of the first one's surface
    /// ```
    #[inline]
    pub fn settled(&self, media: &MediumStack, ray: &Ray) -> MediumStack {
        if media.is_nested() { media.retaining(|shape| self.is_inside(shape, ray)) } else { *media }
    }

    /// True if the ray meets the shape from inside.
    #[inline(never)]
    fn is_inside(&self, shape: u32, ray: &Ray) -> bool {
        let primitive = &self.primitives[shape as usize];
        let hit = primitive.intersect(ray, shape, f64::INFINITY);
        hit.is_some_and(|hit| Side::of(-ray.direction, primitive.surface(ray, &hit).normal) == Side::Back)
    }

    /// The surface at a hit.
    #[inline(always)]
    pub fn surface(&self, ray: &Ray, hit: &Hit) -> Surface {
        self.primitives[hit.id.shape as usize].surface(ray, hit)
    }
}
