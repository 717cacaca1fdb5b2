//! Runs every fuzz target with its seeds, with its regressions, and with thousands of mutations of both.
//!
//! The variable `RENDER_SMOKE_CASES` sets the number of mutations for each target. `RENDER_SMOKE_SEED` sets their seed.

use fuzz_oracles::mutate::{Random, mutate};
use fuzz_oracles::{TARGETS, dictionary, inputs};

/// The name of a target and an input. It prints the input if it is dropped during a panic, so that the input can be
/// kept as a regression.
struct Tried<'a>(&'a str, &'a [u8]);

impl Drop for Tried<'_> {
    fn drop(&mut self) {
        if std::thread::panicking() {
            println!("{}: {}", self.0, self.1.escape_ascii());
        }
    }
}

fn smoke(name: &str, cases: usize) {
    let (_, check) = TARGETS.into_iter().find(|(target, _)| *target == name).expect("it is a target");
    let mut kept = inputs("seeds", name);
    kept.extend(inputs("regressions", name));
    for (path, bytes) in &kept {
        let name = path.to_string_lossy();
        let _shown = Tried(&name, bytes);
        check(bytes);
    }
    let kept: Vec<_> = kept.into_iter().map(|(_, bytes)| bytes).collect();
    let tokens = dictionary(name);
    let seed = from_environment("RENDER_SMOKE_SEED").unwrap_or(1);
    let mut random = Random::new(seed as u64);
    let cases = from_environment("RENDER_SMOKE_CASES").unwrap_or(cases);
    let mut tried = 0;
    for case in 0..cases {
        let input = &kept[random.below(kept.len())];
        let input = mutate(&mut random, input, &kept, &tokens);
        let number = format!("mutation {case} of seed {seed}");
        let _shown = Tried(&number, &input);
        check(&input);
        tried += 1;
    }
    assert!(tried > 0, "nothing was tried");
    println!("{tried} mutations of {} inputs", kept.len());
}

fn from_environment(name: &str) -> Option<usize> {
    let text = std::env::var(name).ok()?;
    Some(text.parse().unwrap_or_else(|_| panic!("{name}={text} is not a number")))
}

#[test]
fn configurations_are_read_as_the_plain_parser_reads_them() {
    smoke("config", 200_000);
}

#[test]
fn scenes_are_read_as_the_plain_parser_reads_them() {
    smoke("scene", 200_000);
}

#[test]
fn tiny_scenes_are_rendered_as_the_reference_renders_them() {
    smoke("render", 5_000);
}

#[test]
fn pictures_are_read_as_the_plain_reader_reads_them() {
    smoke("picture", 50_000);
}

#[test]
fn modules_of_shaders_are_taken_or_refused_with_a_place() {
    smoke("wgsl", 1_000);
}
