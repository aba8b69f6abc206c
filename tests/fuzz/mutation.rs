//! Random changes of files, the same ones for the same name.

/// A source of changed inputs.
pub struct Mutation(u64);

/// Numbers at which programs go wrong, as bytes and as text.
const BYTES: [u8; 6] = [0, 1, 0x7F, 0x80, 0xFE, 0xFF];
const WORDS: [&str; 8] = ["-1", "0", "65536", "4294967295", "-9223372036854775808", "1e308", "nan", "\u{feff}"];

impl Mutation {
    pub fn new(name: &str) -> Self {
        Self(
            name.bytes()
                .fold(0x9E37_79B9_7F4A_7C15, |state, byte| (state ^ u64::from(byte)).wrapping_mul(0x100_0000_01B3)),
        )
    }

    /// xorshift64 (Marsaglia, 2003).
    fn below(&mut self, limit: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % limit.max(1) as u64) as usize
    }

    /// One of the seeds with one to four changes.
    pub fn changed(&mut self, seeds: &[Vec<u8>]) -> Vec<u8> {
        let mut bytes = seeds[self.below(seeds.len())].clone();
        for _ in 0..=self.below(4) {
            self.change(&mut bytes);
        }
        bytes
    }

    fn change(&mut self, bytes: &mut Vec<u8>) {
        let at = self.below(bytes.len());
        let length = 1 + self.below(16).min(bytes.len() - at);
        let end = (at + length).min(bytes.len());
        match self.below(7) {
            0 => bytes[at..end].fill(BYTES[self.below(BYTES.len())]),
            1 => bytes.iter_mut().skip(at).take(1).for_each(|byte| *byte ^= 1 << (at % 8)),
            2 => bytes.truncate(at),
            3 => drop(bytes.drain(at..end)),
            4 => {
                let copy = bytes[at..end].to_vec();
                let to = self.below(bytes.len());
                bytes.splice(to..to, copy);
            }
            5 => {
                let word = WORDS[self.below(WORDS.len())];
                bytes.splice(at..end, word.bytes());
            }
            _ => {
                let random: Vec<u8> = (at..end).map(|_| self.below(256) as u8).collect();
                bytes.splice(at..end, random);
            }
        }
        if bytes.is_empty() {
            bytes.push(0);
        }
    }
}
