//! `parse_speed [LINES]`: prints what a line of a generated scene costs to read, best of five, a million by default.

use std::hint::black_box;
use std::time::Instant;

use tests::generator::{self, Options};

fn main() {
    let objects = std::env::args().nth(1).map_or(1_000_000, |text| text.parse().expect("LINES is a number"));
    let text = tests::write::scene(&generator::scene(&Options { objects, ..Options::default() }));
    let lines = text.lines().count();
    let best = (0..5)
        .map(|_| {
            let start = Instant::now();
            let scene = cpu::Scene::parse(black_box(text.as_bytes())).expect("generated scenes are valid");
            assert_eq!(scene.objects.len(), objects);
            start.elapsed()
        })
        .min()
        .expect("five runs");
    let nanoseconds = best.as_nanos() as f64 / lines as f64;
    println!("{lines} lines, {} bytes: {:.3} s, {nanoseconds:.0} ns a line", text.len(), best.as_secs_f64());
}
