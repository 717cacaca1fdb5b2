//! Seeded mutations of inputs. They are like those of a fuzzer, but coverage does not guide them, and they are the same
//! on every machine.

use cpu::internals::sampling::uniform::Uniform;

/// Returns a random number below `count`, which must not be 0.
pub fn below(random: &mut Uniform, count: usize) -> usize {
    (random.canonical() * count as f64) as usize
}

/// Returns `input` with one to four changes. A change removes, doubles or replaces some bytes. The new bytes are
/// random, part of one of the `others`, or one of the `tokens`.
#[must_use]
pub fn mutate(random: &mut Uniform, input: &[u8], others: &[Vec<u8>], tokens: &[Vec<u8>]) -> Vec<u8> {
    let mut bytes = input.to_vec();
    for _ in 0..=below(random, 4) {
        let start = below(random, bytes.len() + 1);
        let end = start + below(random, (bytes.len() - start).min(16) + 1);
        let new = match below(random, 6) {
            0 => Vec::new(),
            1 => vec![below(random, 256) as u8],
            2 => bytes[start..end].repeat(2),
            3 => {
                let other = &others[below(random, others.len())];
                let from = below(random, other.len() + 1);
                other[from..from + below(random, (other.len() - from).min(64) + 1)].to_vec()
            }
            4 => bytes[start..end].iter().map(|byte| byte ^ (1 << below(random, 8))).collect(),
            _ => tokens[below(random, tokens.len())].clone(),
        };
        bytes.splice(start..end, new);
    }
    bytes
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn a_seed_gives_the_same_mutations_and_they_differ() {
        let (others, tokens) = (vec![b"other".to_vec()], vec![b"token".to_vec()]);
        let all = || -> BTreeSet<Vec<u8>> {
            let mut random = Uniform::new(1);
            (0..50).map(|_| mutate(&mut random, b"some input", &others, &tokens)).collect()
        };
        assert_eq!(all(), all());
        assert!(all().len() > 40, "{} of 50", all().len());
    }
}
