//! The nested glasses around a ray, and their transmittance.

use crate::math::Side;
use crate::math::functions::exponential_f64;

/// A glass: the shape that encloses it and the material it is made of, by their numbers in the scene.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Medium {
    /// Number of the shape.
    pub shape: u32,
    /// Number of the material.
    pub material: u32,
}

/// Glasses whose inside the ray is in, innermost last. Holds [`MediumStack::CAPACITY`] entries without allocating;
/// deeper nesting is not entered: the outermost entries are kept.
// Of 64 bytes, which are copied in whole pieces.
#[repr(align(16))]
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct MediumStack {
    media: [Medium; Self::CAPACITY],
    depth: u8,
}

impl MediumStack {
    /// How many glasses may be nested in one another.
    pub const CAPACITY: usize = 7;

    /// The innermost glass; `None` in free space.
    #[inline]
    pub fn innermost(&self) -> Option<Medium> {
        self.depth.checked_sub(1).map(|last| self.media[usize::from(last)])
    }

    /// True if the ray is inside of the shape.
    #[inline]
    pub fn contains(&self, shape: u32) -> bool {
        self.media[..usize::from(self.depth)].iter().any(|entered| entered.shape == shape)
    }

    /// True if the ray is inside of several glasses at once.
    #[inline]
    pub fn is_nested(&self) -> bool {
        self.depth > 1
    }

    /// The glasses whose shape satisfies `keep`.
    pub fn retaining(&self, keep: impl Fn(u32) -> bool) -> Self {
        let entered = &self.media[..usize::from(self.depth)];
        entered.iter().copied().filter(|medium| keep(medium.shape)).collect()
    }

    /// Enters a glass. One that the ray is inside of already stays where it is: its surface was met twice, as happens where
    /// it coincides with another.
    #[inline]
    pub fn enter(&mut self, medium: Medium) {
        if self.takes(medium.shape) {
            self.media[usize::from(self.depth)] = medium;
            self.depth += 1;
        }
    }

    /// True if entering the shape would change the stack.
    #[inline]
    fn takes(&self, shape: u32) -> bool {
        usize::from(self.depth) < Self::CAPACITY && !self.contains(shape)
    }

    /// Leaves a shape, which need not be the innermost one: overlapping glasses are left in any order. A shape that was
    /// never entered changes nothing.
    #[inline]
    pub fn leave(&mut self, shape: u32) {
        let depth = usize::from(self.depth);
        if let Some(place) = self.media[..depth].iter().rposition(|entered| entered.shape == shape) {
            self.media.copy_within(place + 1..depth, place);
            self.depth -= 1;
            // Equal stacks are equal throughout.
            self.media[usize::from(self.depth)] = Medium::default();
        }
    }

    /// The glass a ray came through to a side of the surface of `met`. A glass whose inside is met without having been
    /// entered (its surface coincides with another's, where rounding decides what is met first) is what the ray came
    /// through.
    #[inline]
    pub fn before(&self, met: Medium, side: Side) -> Option<Medium> {
        let unknown = side == Side::Back && !self.contains(met.shape);
        if unknown { Some(met) } else { self.innermost() }
    }

    /// Passes the surface of `met` from a side.
    #[inline]
    pub fn pass(&mut self, met: Medium, side: Side) {
        match side {
            Side::Front => self.enter(met),
            Side::Back => self.leave(met.shape),
        }
    }

    /// The innermost glass beyond the surface of `met`, for light that passes it from a side: what [`pass`](Self::pass) would
    /// leave innermost.
    #[inline]
    pub fn innermost_beyond(&self, met: Medium, side: Side) -> Option<Medium> {
        match (side, self.innermost()) {
            (Side::Front, _) if self.takes(met.shape) => Some(met),
            (Side::Back, Some(innermost)) if innermost.shape == met.shape => {
                self.depth.checked_sub(2).map(|below| self.media[usize::from(below)])
            }
            (_, innermost) => innermost,
        }
    }
}

impl FromIterator<Medium> for MediumStack {
    /// Glasses entered one after the other, outermost first.
    fn from_iter<I: IntoIterator<Item = Medium>>(media: I) -> Self {
        let mut stack = Self::default();
        media.into_iter().for_each(|medium| stack.enter(medium));
        stack
    }
}

/// Share of light that is left after a distance (0 to infinity): `e^(-coefficient * distance)`, Beer and Lambert's law; no
/// absorption is none over any distance.
///
/// In `f64`, as rounding the exponent x to `f32` would make x ulp of the result uncertain; to half an ulp so.
#[inline]
pub fn beer_lambert(coefficient: f32, distance: f64) -> f32 {
    if coefficient == 0.0 { 1.0 } else { exponential_f64(-f64::from(coefficient) * distance) as f32 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shapes_are_left_in_any_order() {
        let glass = |shape| Medium { shape, material: 10 + shape };
        let of = |shapes: &[u32]| shapes.iter().map(|&shape| glass(shape)).collect::<MediumStack>();
        let without = |shapes: &[u32]| {
            let mut stack = of(&[1, 2, 3]);
            shapes.iter().for_each(|&shape| stack.leave(shape));
            stack
        };
        let stack = of(&[1, 2, 3]);
        assert_eq!(without(&[2]), of(&[1, 3]));
        assert_eq!(without(&[3]), of(&[1, 2]));
        assert_eq!(without(&[7]), stack);
        assert_eq!(without(&[1, 2, 3]), MediumStack::default());
        assert_eq!(of(&[1, 2, 3, 2]), stack, "entered twice");
        assert_eq!(stack.retaining(|shape| shape != 2), of(&[1, 3]));
        assert!(stack.is_nested() && !of(&[2]).is_nested());
    }

    #[test]
    fn what_is_innermost_beyond_is_what_passing_leaves() {
        let glass = |shape| Medium { shape, material: 10 + shape };
        // From free space to more glasses than fit.
        for depth in 0..=MediumStack::CAPACITY as u32 + 1 {
            let stack: MediumStack = (0..depth).map(glass).collect();
            for (shape, side) in (0..depth + 2).flat_map(|shape| [(shape, Side::Front), (shape, Side::Back)]) {
                let mut passed = stack;
                passed.pass(glass(shape), side);
                assert_eq!(stack.innermost_beyond(glass(shape), side), passed.innermost(), "{depth} {shape} {side:?}");
            }
        }
    }
}
