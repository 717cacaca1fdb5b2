//! Compares the conversion of a generator's words to numbers with that of `cpu`.

use cpu::internals::sampling::uniform::canonical;
use gpu_check::Pipeline;
use gpu_check::pipeline::Content;
use rand_mt::Mt64;
use shaders::{Library, Precision};

use crate::common;

/// Returns words at which the conversion to f64 rounds up, down and to even, at every number of significant bits, and
/// words that round to 2^64.
fn edges() -> Vec<u64> {
    let mut words = vec![0, 1, u64::MAX, u64::MAX - 1023, u64::MAX - 1024, u64::MAX - 2048, 1 << 63, (1 << 53) + 1];
    for bits in 1..64 {
        let power = 1_u64 << bits;
        // Half of a unit in the last place of a number that begins with this bit.
        let half = (power >> 53).max(1);
        for word in [power, power + half, power + 3 * half, power - half, power + 2 * half] {
            words.extend([word - 1, word, word.wrapping_add(1)]);
        }
    }
    words
}

#[test]
fn words_become_the_numbers_of_the_programs() {
    let gpu = common::gpu();
    let composition = Library::standard().compose("kernels/draws", Precision::F64).expect("it exists");
    let pipeline = Pipeline::new(&gpu, &composition, &[]).unwrap_or_else(|error| panic!("{error}"));
    let mut generator = Mt64::new(5489);
    let mut words = edges();
    words.extend((0..1 << 18).map(|_| generator.next_u64()));
    // Random words with few significant bits, as the upper half alone or the lower half alone has them.
    words.extend((0..1 << 16).map(|shift| generator.next_u64() >> (shift % 64)));
    let (mut compared, mut rounded) = (0, 0);
    for (low, high) in [(-0.5, 0.5), (-1.0, 1.0), (-0.3, 0.3), (-1e300, 1e300), (-0.0, 0.0)] {
        let mut bytes = Vec::new();
        for word in &words {
            bytes.extend(bytemuck::cast_slice::<f64, u8>(&[low, high]));
            bytes.extend(bytemuck::cast_slice::<u32, u8>(&[*word as u32, (*word >> 32) as u32]));
        }
        let contents = [Content::Input(&bytes), Content::Output(8 * words.len() as u64)];
        let run = pipeline.run(&gpu, &contents, words.len() as u64).unwrap_or_else(|error| panic!("{error}"));
        let results = bytemuck::pod_collect_to_vec::<u8, f64>(&run.outputs.concat());
        for (word, result) in words.iter().zip(results) {
            let expected = canonical(*word) * (high - low) + low;
            assert_eq!(result.to_bits(), expected.to_bits(), "{word:#x} in [{low}, {high}): {result} and {expected}");
            compared += 1;
            rounded += usize::from(*word as f64 as u128 != u128::from(*word));
        }
    }
    println!("{compared} numbers compared, {rounded} of them rounded");
    assert!(compared > 1_000_000 && rounded > 500_000, "{compared}, {rounded}");
}
