//! Path signatures: the mirrors and glasses along a light path, and the events there.

/// One meeting with glass or a mirror.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SpecularEvent {
    pub shape: u32,
    pub transmitted: bool,
}

/// The events of a specular chain in one number; chains of the same events have the same.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Signature(u64);

impl Signature {
    /// Of no events.
    pub const START: Self = Self(0);

    /// The chain with another event, after it seen from the camera.
    ///
    /// The shape's number and the kind of event are mixed into 64 bits (the finaliser of SplitMix64), so that two
    /// chains of a scene have the same with a probability of 2^-64.
    #[inline]
    pub fn then(self, event: SpecularEvent) -> Self {
        let mut bits =
            (self.0 ^ (u64::from(event.shape) << 1 | u64::from(event.transmitted))).wrapping_add(0x9e37_79b9_7f4a_7c15);
        bits = (bits ^ bits >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ bits >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        Self(bits ^ bits >> 31)
    }

    /// The signature of a sequence of events, from the camera's side.
    pub fn of<'t>(events: impl IntoIterator<Item = &'t SpecularEvent>) -> Self {
        events.into_iter().fold(Self::START, |signature, &event| signature.then(event))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn signatures_tell_order_shape_and_kind() {
        let event = |shape, transmitted| SpecularEvent { shape, transmitted };
        let chains: Vec<Vec<SpecularEvent>> = vec![
            vec![],
            vec![event(0, false)],
            vec![event(0, true)],
            vec![event(1, false)],
            vec![event(0, false), event(1, true)],
            vec![event(1, true), event(0, false)],
            vec![event(0, false), event(0, false)],
        ];
        for (index, chain) in chains.iter().enumerate() {
            assert!(chains[..index].iter().all(|other| Signature::of(other) != Signature::of(chain)), "{chain:?}");
        }
        assert_eq!(Signature::of(&chains[4]), Signature::of(&chains[1]).then(event(1, true)));
    }
}
