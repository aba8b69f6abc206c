//! Tags of a TIFF file that its decoder ignores.

/// The order of bits in a byte (tag 266): 1 from the highest on, 2 from the lowest; `None` if the file does not say it.
pub fn fill_order(encoded: &[u8]) -> Option<u16> {
    const FILL_ORDER: u16 = 266;
    let little = encoded.starts_with(b"II");
    let two = |at: usize| {
        let bytes = *encoded.get(at..)?.first_chunk()?;
        Some(if little { u16::from_le_bytes(bytes) } else { u16::from_be_bytes(bytes) })
    };
    let four = |at: usize| {
        let bytes = *encoded.get(at..)?.first_chunk()?;
        Some(if little { u32::from_le_bytes(bytes) } else { u32::from_be_bytes(bytes) } as usize)
    };
    // The first directory: a count, and twelve bytes an entry. BigTIFF has eight and twenty.
    let (start, first, size, value) = match two(2)? {
        43 => (four(if little { 8 } else { 12 })?, 8, 20, 12),
        _ => (four(4)?, 2, 12, 8),
    };
    let entries = usize::from(two(if first == 8 && !little { start + 6 } else { start })?);
    let entry = (0..entries).map(|entry| start + first + size * entry).find(|&at| two(at) == Some(FILL_ORDER))?;
    two(entry + value)
}
