//! What a TIFF file says and its decoder ignores.

/// The first directory of a file: a count, and twelve bytes an entry. BigTIFF has eight and twenty.
struct Directory<'a> {
    encoded: &'a [u8],
    little: bool,
    big: bool,
    start: usize,
}

impl<'a> Directory<'a> {
    fn of(encoded: &'a [u8]) -> Option<Self> {
        let mut directory = Self { encoded, little: encoded.starts_with(b"II"), big: false, start: 0 };
        directory.big = directory.two(2)? == 43;
        directory.start = match (directory.big, directory.little) {
            (false, _) => directory.four(4)?,
            (true, true) => directory.four(8)?,
            (true, false) => directory.four(12)?,
        };
        Some(directory)
    }

    fn two(&self, at: usize) -> Option<u16> {
        let bytes = *self.encoded.get(at..)?.first_chunk()?;
        Some(if self.little { u16::from_le_bytes(bytes) } else { u16::from_be_bytes(bytes) })
    }

    fn four(&self, at: usize) -> Option<usize> {
        let bytes = *self.encoded.get(at..)?.first_chunk()?;
        Some(if self.little { u32::from_le_bytes(bytes) } else { u32::from_be_bytes(bytes) } as usize)
    }

    /// Where the entries begin and end, and the bytes of each.
    fn entries(&self) -> Option<(usize, usize, usize)> {
        let (count, size) = if self.big { (8, 20) } else { (2, 12) };
        let last_two = if self.big && !self.little { 6 } else { 0 };
        let entries = usize::from(self.two(self.start + last_two)?);
        let first = self.start + count;
        Some((first, first + size * entries, size))
    }
}

/// The order of bits in a byte (tag 266): 1 from the highest on, 2 from the lowest; `None` if the file does not say it.
pub fn fill_order(encoded: &[u8]) -> Option<u16> {
    const FILL_ORDER: u16 = 266;
    let directory = Directory::of(encoded)?;
    let (first, end, size) = directory.entries()?;
    let entry = (first..end).step_by(size).find(|&at| directory.two(at) == Some(FILL_ORDER))?;
    directory.two(entry + if directory.big { 12 } else { 8 })
}

/// True if a tag says that it has more values than fit into the file: its decoder would make room for them.
pub fn claims_too_much(encoded: &[u8]) -> bool {
    let values = |directory: &Directory, at: usize| {
        let size = match directory.two(at + 2)? {
            1 | 2 | 6 | 7 => 1,
            3 | 8 => 2,
            4 | 9 | 11 | 13 => 4,
            _ => 8,
        };
        // The lower half of a number of 64 bits, unless the upper one is too much by itself.
        let (first, second) = (directory.four(at + 4)?, if directory.big { directory.four(at + 8)? } else { 0 });
        let (low, high) = if directory.big && !directory.little { (second, first) } else { (first, second) };
        Some(if high > 0 { usize::MAX } else { low.saturating_mul(size) })
    };
    let claims = |directory: Directory| {
        let (first, end, size) = directory.entries()?;
        Some((first..end).step_by(size).filter_map(|at| values(&directory, at)).any(|claimed| claimed > encoded.len()))
    };
    Directory::of(encoded).and_then(claims).unwrap_or(false)
}

/// What a user should know of a file with several pictures.
pub fn note(encoded: &[u8]) -> Option<String> {
    let directory = Directory::of(encoded)?;
    let (_, end, _) = directory.entries()?;
    let next = encoded.get(end..end + if directory.big { 8 } else { 4 })?;
    next.iter().any(|&byte| byte != 0).then(|| "it holds several pictures: only the first is read".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A directory of one entry, the order of bits, and the place of the next one.
    fn file(little: bool, big: bool, next: u64) -> Vec<u8> {
        let number = |value: u64, bytes: usize| {
            let little_endian = &value.to_le_bytes()[..bytes];
            if little { little_endian.to_vec() } else { little_endian.iter().rev().copied().collect() }
        };
        let order = if little { b"II" } else { b"MM" };
        let place = if big { 8 } else { 4 };
        let start = match big {
            false => [number(42, 2), number(8, 4), number(1, 2)].concat(),
            true => [number(43, 2), number(8, 2), number(0, 2), number(16, 8), number(1, 8)].concat(),
        };
        let entry = [number(266, 2), number(3, 2), number(1, place), number(2, 2), vec![0; place - 2]].concat();
        [order.to_vec(), start, entry, number(next, place)].concat()
    }

    #[test]
    fn tags_are_read_in_all_four_forms() {
        for (little, big) in [(true, false), (false, false), (true, true), (false, true)] {
            assert_eq!(fill_order(&file(little, big, 0)), Some(2), "{little} {big}");
            assert_eq!(note(&file(little, big, 0)), None);
            assert!(note(&file(little, big, 77)).is_some());
            assert!(!claims_too_much(&file(little, big, 0)));
            let mut huge = file(little, big, 0);
            let entry = if big { 24 } else { 10 };
            huge[entry + 5] = 0x7F;
            assert!(claims_too_much(&huge));
        }
        assert_eq!((fill_order(b"II*\0"), note(b"MM\0*\xFF\xFF\xFF\xFF")), (None, None));
    }
}
