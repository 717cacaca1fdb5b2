//! Seeded mutations of inputs. They are like those of a fuzzer, but coverage does not guide them, and they are the same
//! on every machine.

/// A generator of random numbers (splitmix64).
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    /// Returns the generator with this seed.
    #[must_use]
    pub const fn new(seed: u64) -> Self {
        Self(seed)
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut mixed = self.0;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    /// Returns a random byte.
    pub fn byte(&mut self) -> u8 {
        (self.next() >> 56) as u8
    }

    /// Returns a random number below `count`, which must not be 0.
    pub fn below(&mut self, count: usize) -> usize {
        (self.next() % count as u64) as usize
    }
}

/// Returns `input` with one to four changes. A change removes, doubles or replaces some bytes. The new bytes are
/// random, part of one of the `others`, or one of the `tokens`.
#[must_use]
pub fn mutate(random: &mut Random, input: &[u8], others: &[Vec<u8>], tokens: &[Vec<u8>]) -> Vec<u8> {
    let mut bytes = input.to_vec();
    for _ in 0..=random.below(4) {
        let start = random.below(bytes.len() + 1);
        let end = start + random.below((bytes.len() - start).min(16) + 1);
        let new = match random.below(6) {
            0 => Vec::new(),
            1 => vec![random.byte()],
            2 => bytes[start..end].repeat(2),
            3 => {
                let other = &others[random.below(others.len())];
                let from = random.below(other.len() + 1);
                other[from..from + random.below((other.len() - from).min(64) + 1)].to_vec()
            }
            4 => {
                let mut changed = bytes[start..end].to_vec();
                for byte in &mut changed {
                    *byte ^= 1 << random.below(8);
                }
                changed
            }
            _ => tokens[random.below(tokens.len())].clone(),
        };
        bytes.splice(start..end, new);
    }
    bytes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_seed_gives_the_same_mutations_and_they_differ() {
        let (others, tokens) = (vec![b"other".to_vec()], vec![b"token".to_vec()]);
        let all = |seed| -> Vec<Vec<u8>> {
            let mut random = Random::new(seed);
            (0..50).map(|_| mutate(&mut random, b"some input", &others, &tokens)).collect()
        };
        assert_eq!(all(1), all(1));
        let mut distinct = all(1);
        distinct.sort();
        distinct.dedup();
        assert!(distinct.len() > 40, "{} of 50", distinct.len());
    }
}
