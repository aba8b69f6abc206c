//! All shapes of a scene, and the search for those that a ray hits.

use super::boxed_shapes::BoxedShapes;
use super::stop_switch::StopSwitch;
use crate::materials::MediumStack;
use crate::math::{Bounds, DVec3, Ray, Side, SurfaceId};
use crate::shapes::{Hit, Primitive, SpherePack, Surface, ViewCones};

/// No shape has this number.
const NONE: u32 = u32::MAX;

/// The shapes of a scene. A few are tried one after the other; more get a hierarchy of boxes.
#[derive(Debug)]
pub struct Aggregate {
    primitives: Vec<Primitive>,
    /// Round spheres outside of the hierarchy, tried four at once.
    packs: Vec<SpherePack>,
    /// Other shapes outside of the hierarchy but meshes, tried one by one.
    listed: Vec<u32>,
    /// Meshes tried one by one.
    meshes: Vec<u32>,
    hierarchy: Option<BoxedShapes>,
    /// Asked by every ray but those to light sources, which are few for each of the others.
    pub stop: StopSwitch,
}

impl Aggregate {
    /// Up to this many flat shapes and round spheres are tried one by one. Below it a hierarchy over them costs more than it
    /// saves: 1.6 times for 8 spheres in a Whitted scene, 1.2 times in the room of lesson 08; at 24 flat shapes it pays.
    pub const MOST_SIMPLE: usize = 12;

    /// The same for boxes, ellipsoids and meshes: over two boxes a hierarchy saves a fifth.
    pub const MOST_OTHERS: usize = 1;

    /// Puts more than a few shapes under the fast hierarchy.
    pub fn new(primitives: Vec<Primitive>) -> Self {
        Self::with_hierarchy(primitives, false)
    }

    /// Puts more than a few shapes under the fast hierarchy, or under that of lesson 10, which finds the same.
    pub fn with_hierarchy(primitives: Vec<Primitive>, textbook: bool) -> Self {
        let bounds: Vec<_> = primitives.iter().map(Primitive::bounds).collect();
        let bounded = || primitives.iter().zip(&bounds).filter(|(_, bounds)| bounds.is_some());
        let simple = bounded().filter(|(primitive, _)| primitive.is_simple()).count();
        let many = [bounded().count() - simple > Self::MOST_OTHERS, simple > Self::MOST_SIMPLE];
        let is_boxed = |&shape: &u32| {
            bounds[shape as usize].is_some() && many[usize::from(primitives[shape as usize].is_simple())]
        };
        let (shapes, listed): (Vec<u32>, Vec<u32>) = (0..primitives.len() as u32).partition(is_boxed);
        let boxes: Vec<Bounds> = shapes.iter().filter_map(|&shape| bounds[shape as usize]).collect();
        let hierarchy = (!boxes.is_empty()).then(|| BoxedShapes::build(shapes, &boxes, textbook));
        Self { hierarchy, ..Self::listing(primitives, listed) }
    }

    /// Tries all shapes one after the other, round spheres four at once.
    pub fn without_hierarchy(primitives: Vec<Primitive>) -> Self {
        let all = (0..primitives.len() as u32).collect();
        Self::listing(primitives, all)
    }

    /// Tries the shapes of the given numbers one after the other, and no others.
    fn listing(primitives: Vec<Primitive>, numbers: Vec<u32>) -> Self {
        let sphere =
            |shape: u32| primitives[shape as usize].as_sphere().map(|(centre, radius)| (shape, centre, radius));
        let spheres = numbers.iter().filter_map(|&shape| sphere(shape)).collect::<Vec<_>>();
        let packs = spheres.chunks(SpherePack::MOST).map(SpherePack::new).collect();
        let is_mesh = |shape: &u32| primitives[*shape as usize].is_mesh();
        let (meshes, listed) = numbers.into_iter().filter(|&shape| sphere(shape).is_none()).partition(is_mesh);
        Self { packs, listed, meshes, primitives, hierarchy: None, stop: StopSwitch::default() }
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
    #[inline]
    pub fn intersect(&self, ray: &Ray) -> Option<Hit> {
        self.stop.check();
        self.nearest(ray)
    }

    // Apart, so that the question above does not take registers from the search.
    fn nearest(&self, ray: &Ray) -> Option<Hit> {
        let mut nearest = self.nearest_simple(ray, None);
        if self.has_others() {
            nearest = self.nearer_other(ray, nearest);
        }
        (nearest.id.shape != NONE).then_some(nearest)
    }

    /// The nearest hits of rays; of rays that all start at one point by the view cones from there, if there are any.
    #[inline]
    pub fn intersect_all<'r>(
        &self,
        cones: Option<&ViewCones>,
        rays: impl Iterator<Item = &'r Ray>,
        hits: &mut Vec<Option<Hit>>,
    ) {
        self.stop.check();
        hits.clear();
        let found = |nearest: Hit| (nearest.id.shape != NONE).then_some(nearest);
        if self.has_others() {
            hits.extend(rays.map(|ray| found(self.nearer_other(ray, self.nearest_simple(ray, cones)))));
        } else {
            hits.extend(rays.map(|ray| found(self.nearest_simple(ray, cones))));
        }
    }

    /// The round spheres as seen from a point, if that may save work.
    pub fn view_cones(&self, point: DVec3) -> Option<ViewCones> {
        let [pack] = self.packs.as_slice() else { return None };
        Some(ViewCones::new(pack, point))
    }

    /// The nearest hit of what is neither a mesh nor under the hierarchy; `cones` are those from the ray's origin.
    // Always in line: the hit is used field by field at once, and would otherwise go through memory.
    #[inline(always)]
    fn nearest_simple(&self, ray: &Ray, cones: Option<&ViewCones>) -> Hit {
        let (mut nearest, mut id) = (f64::INFINITY, SurfaceId { shape: NONE, part: 0 });
        if cones.is_none_or(|cones| cones.may_meet(ray.direction, 0.0)) {
            for pack in &self.packs {
                pack.hits(ray, |shape, t| {
                    if t < nearest {
                        nearest = t;
                        id = SurfaceId { shape, part: 0 };
                    }
                    false
                });
            }
        }
        for &shape in &self.listed {
            if let Some((t, part)) = self.primitives[shape as usize].intersect_mostly_flat(ray, shape, nearest) {
                nearest = t;
                id = SurfaceId { shape, part };
            }
        }
        Hit { t: nearest, id, barycentric: [0.0; 3] }
    }

    /// True if there are meshes, or shapes under a hierarchy.
    #[inline(always)]
    fn has_others(&self) -> bool {
        !self.meshes.is_empty() || self.hierarchy.is_some()
    }

    /// The nearest hit of those if it is nearer than a hit known.
    fn nearer_other(&self, ray: &Ray, mut nearest: Hit) -> Hit {
        for &shape in &self.meshes {
            nearest = self.primitives[shape as usize].nearer(ray, shape, nearest);
        }
        match &self.hierarchy {
            Some(boxed) => boxed.nearer(&self.primitives, ray, nearest),
            None => nearest,
        }
    }

    /// True if something that casts shadows is met within `limit`.
    #[inline]
    pub fn occluded(&self, ray: &Ray, limit: f64) -> bool {
        self.any_hit::<true>(ray, limit, None)
    }

    /// The same for a ray to a point at the distance `limit`, by the view cones from that point, if there are any.
    #[inline(always)]
    pub fn occluded_from(&self, cones: Option<&ViewCones>, ray: &Ray, limit: f64) -> bool {
        self.any_hit::<true>(ray, limit, cones)
    }

    /// True if anything is met within `limit`, even what casts no shadows.
    #[inline]
    pub fn blocked(&self, ray: &Ray, limit: f64) -> bool {
        self.any_hit::<false>(ray, limit, None)
    }

    #[inline(always)]
    fn any_hit<const SHADOWING: bool>(&self, ray: &Ray, limit: f64, cones: Option<&ViewCones>) -> bool {
        let in_the_way = |shape: u32, t: f64| t < limit && self.counts::<SHADOWING>(shape);
        let may_meet = cones.is_none_or(|cones| cones.may_meet(-ray.direction, limit));
        if may_meet && self.packs.iter().any(|pack| pack.hits(ray, in_the_way)) {
            return true;
        }
        let stops = |shape: u32| self.primitives[shape as usize].intersect_mostly_flat(ray, shape, limit).is_some();
        if self.listed.iter().any(|&shape| self.counts::<SHADOWING>(shape) && stops(shape)) {
            return true;
        }
        // A copy, so that the ray itself stays in registers.
        self.has_others() && self.any_other_hit::<SHADOWING>(*ray, limit)
    }

    #[inline(never)]
    fn any_other_hit<const SHADOWING: bool>(&self, ray: Ray, limit: f64) -> bool {
        let ray = &ray;
        if self.meshes.iter().any(|&shape| self.stops::<SHADOWING>(shape, ray, limit)) {
            return true;
        }
        let boxed = self.hierarchy.as_ref();
        boxed.is_some_and(|boxed| boxed.any(ray, limit, |shape| self.stops::<SHADOWING>(shape, ray, limit)))
    }

    /// True if the shape counts: for shadows, only what casts them.
    #[inline(always)]
    fn counts<const SHADOWING: bool>(&self, shape: u32) -> bool {
        !SHADOWING || self.primitives[shape as usize].casts_shadow
    }

    #[inline(always)]
    fn stops<const SHADOWING: bool>(&self, shape: u32, ray: &Ray, limit: f64) -> bool {
        self.counts::<SHADOWING>(shape) && self.primitives[shape as usize].occludes(ray, shape, limit)
    }

    /// Of glasses inside one another those whose inside the ray meets ahead.
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

    /// Passes the surface at a hit to `then`, which is compiled for each kind of shape.
    #[inline(always)]
    pub fn with_surface<R>(&self, ray: &Ray, hit: &Hit, then: impl FnOnce(Surface) -> R) -> R {
        self.primitives[hit.id.shape as usize].with_surface(ray, hit, then)
    }

    /// The surface at a hit.
    #[inline(always)]
    pub fn surface(&self, ray: &Ray, hit: &Hit) -> Surface {
        self.primitives[hit.id.shape as usize].surface(ray, hit)
    }
}
