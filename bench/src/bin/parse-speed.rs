//! `parse-speed [LINES]`: prints the time to read one line of a generated scene. It is the shortest of five
//! measurements. The scene has a million lines by default.

use std::hint::black_box;
use std::process::ExitCode;
use std::time::Instant;

use generator::{self, Options};

const USAGE: &str = "\
parse-speed [LINES]
Prints what a line of a generated scene costs to read, best of five; a million lines without LINES.

Example:
  cargo run --release -p bench --bin parse-speed 100000";

fn main() -> ExitCode {
    let objects = match std::env::args().nth(1).as_deref() {
        None => 1_000_000,
        Some("--help") => {
            println!("{USAGE}");
            return ExitCode::SUCCESS;
        }
        Some(text) => match text.parse() {
            Ok(lines) => lines,
            Err(_) => {
                eprintln!("Error: LINES must be a whole number, not [{text}]; see --help");
                return ExitCode::from(2);
            }
        },
    };
    let text = generator::write::scene(&generator::scene(&Options { objects, ..Options::default() }));
    let lines = text.lines().count();
    let best = (0..5)
        .map(|_| {
            let start = Instant::now();
            let scene = cpu::internals::input::scene::Scene::parse(black_box(text.as_bytes()))
                .expect("generated scenes are valid");
            assert_eq!(scene.objects.len(), objects);
            start.elapsed()
        })
        .min()
        .expect("five runs");
    let nanoseconds = best.as_nanos() as f64 / lines as f64;
    println!("{lines} lines, {} bytes: {:.3} s, {nanoseconds:.0} ns a line", text.len(), best.as_secs_f64());
    ExitCode::SUCCESS
}
