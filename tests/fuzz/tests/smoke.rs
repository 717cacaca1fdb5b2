//! Runs every fuzz target with the inputs that it begins with, and with thousands of mutations of them.
//!
//! The variable `RENDER_CASES` sets the number of mutations for each target. `RENDER_SEED` sets their seed.

use cpu::internals::sampling::uniform::Uniform;
use fuzz_oracles::{check, dictionary, inputs};
use test_support::mutate::{below, mutate};
use test_support::number_of;

/// A description of an input and the input. It prints both if it is dropped during a panic, so that the input can be
/// kept as a regression.
struct Tried<'a>(&'a str, &'a [u8]);

impl Drop for Tried<'_> {
    fn drop(&mut self) {
        if std::thread::panicking() {
            println!("{}: {}", self.0, self.1.escape_ascii());
        }
    }
}

fn smoke(target: &str, cases: u64) {
    let try_one = |what: &str, input: &[u8]| {
        let _shown = Tried(what, input);
        check(target, input);
    };
    let (kept, tokens) = (inputs(target), dictionary(target));
    assert!(kept.len() >= 5 && tokens.len() >= 10, "{} inputs and {} tokens", kept.len(), tokens.len());
    kept.iter().for_each(|input| try_one("an input that it begins with", input));
    let seed = number_of("RENDER_SEED").unwrap_or(1);
    let mut random = Uniform::new(seed);
    let cases = number_of("RENDER_CASES").unwrap_or(cases);
    assert!(cases > 0, "nothing would be tried");
    for case in 0..cases {
        let input = &kept[below(&mut random, kept.len())];
        let input = mutate(&mut random, input, &kept, &tokens);
        try_one(&format!("mutation {case} of seed {seed}"), &input);
    }
    println!("{cases} mutations of {} inputs", kept.len());
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
    smoke("render", 1_000);
}

#[test]
fn pictures_are_read_as_the_plain_reader_reads_them() {
    smoke("picture", 50_000);
}

#[test]
fn modules_of_shaders_are_taken_or_refused_with_a_place() {
    smoke("wgsl", 1_000);
}
