//! The nested glasses a ray is inside of, and what they leave of light.

use crate::math::Side;
use crate::math::functions::exponential_f64;

/// A glass: the shape that encloses it and the material it is made of, by their numbers in the scene.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Medium {
    pub shape: u32,
    pub material: u32,
}

/// Glasses whose inside the ray is in, innermost last. Holds [`MediumStack::CAPACITY`] entries without allocating;
/// deeper nesting is not entered: the outermost entries are kept.
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

    /// The glasses for which `keep` says so of their shape.
    pub fn retaining(&self, keep: impl Fn(u32) -> bool) -> Self {
        let entered = self.media[..usize::from(self.depth)].iter();
        entered.filter(|medium| keep(medium.shape)).fold(Self::default(), |media, &medium| media.entering(medium))
    }

    /// The stack after entering a glass. One that the ray is inside of already stays where it is: its surface was met
    /// twice, as happens where it coincides with another.
    #[inline]
    pub fn entering(mut self, medium: Medium) -> Self {
        if usize::from(self.depth) < Self::CAPACITY && !self.contains(medium.shape) {
            self.media[usize::from(self.depth)] = medium;
            self.depth += 1;
        }
        self
    }

    /// The stack after leaving a shape, which need not be the innermost one: overlapping glasses are left in any
    /// order. A shape that was never entered changes nothing.
    #[inline]
    pub fn leaving(mut self, shape: u32) -> Self {
        let depth = usize::from(self.depth);
        if let Some(place) = self.media[..depth].iter().rposition(|entered| entered.shape == shape) {
            self.media.copy_within(place + 1..depth, place);
            self.depth -= 1;
            // Equal stacks are equal throughout.
            self.media[usize::from(self.depth)] = Medium::default();
        }
        self
    }

    /// The glass a ray came through to a side of the surface of `met`. A glass whose inside is met without having been
    /// entered (its surface coincides with another's, where rounding decides what is met first) is what the ray came
    /// through.
    #[inline]
    pub fn before(&self, met: Medium, side: Side) -> Option<Medium> {
        let unknown = side == Side::Back && !self.contains(met.shape);
        if unknown { Some(met) } else { self.innermost() }
    }

    /// The glasses beyond the surface of `met`, for light that passes it from a side.
    #[inline]
    pub fn beyond(self, met: Medium, side: Side) -> Self {
        match side {
            Side::Front => self.entering(met),
            Side::Back => self.leaving(met.shape),
        }
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
        let stack = MediumStack::default().entering(glass(1)).entering(glass(2)).entering(glass(3));
        assert_eq!(stack.leaving(2).innermost(), Some(glass(3)));
        assert_eq!(stack.leaving(3).innermost(), Some(glass(2)));
        assert_eq!(stack.leaving(7).innermost(), Some(glass(3)));
        assert_eq!(MediumStack::default().leaving(1).innermost(), None);
        assert_eq!(stack.leaving(1).leaving(2).leaving(3).innermost(), None);
        assert_eq!(stack.entering(glass(2)), stack);
        assert_eq!(stack.retaining(|shape| shape != 2), stack.leaving(2));
        assert!(stack.is_nested() && !stack.leaving(1).leaving(3).is_nested());
    }
}
