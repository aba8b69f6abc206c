//! Ways of focused light: which mirrors and glasses it meets, one after the other, and which it passes.

/// One meeting with glass or a mirror.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Turn {
    pub shape: u32,
    pub transmitted: bool,
}

/// The turns of a way in one number; ways with the same turns have the same.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct WayCode(u64);

impl WayCode {
    /// Of no turns.
    pub const START: Self = Self(0);

    /// The way with another turn, after it seen from the camera.
    ///
    /// The shape's number and the kind of turn are mixed into 64 bits (the finaliser of SplitMix64), so that the codes of
    /// two ways of a scene are the same with a probability of 2^-64.
    #[inline]
    pub fn then(self, turn: Turn) -> Self {
        let mut bits =
            (self.0 ^ (u64::from(turn.shape) << 1 | u64::from(turn.transmitted))).wrapping_add(0x9e37_79b9_7f4a_7c15);
        bits = (bits ^ bits >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ bits >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        Self(bits ^ bits >> 31)
    }

    /// The code of a sequence of turns, from the camera's side.
    pub fn of<'t>(turns: impl IntoIterator<Item = &'t Turn>) -> Self {
        turns.into_iter().fold(Self::START, |code, &turn| code.then(turn))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_tell_order_shape_and_kind() {
        let turn = |shape, transmitted| Turn { shape, transmitted };
        let ways: Vec<Vec<Turn>> = vec![
            vec![],
            vec![turn(0, false)],
            vec![turn(0, true)],
            vec![turn(1, false)],
            vec![turn(0, false), turn(1, true)],
            vec![turn(1, true), turn(0, false)],
            vec![turn(0, false), turn(0, false)],
        ];
        for (index, way) in ways.iter().enumerate() {
            assert!(ways[..index].iter().all(|other| WayCode::of(other) != WayCode::of(way)), "{way:?}");
        }
        assert_eq!(WayCode::of(&ways[4]), WayCode::of(&ways[1]).then(turn(1, true)));
    }
}
