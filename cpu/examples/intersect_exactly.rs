//! Intersects a large sphere with rays that nearly touch it, so that the plain formula decides by its rounding errors.
//!
//! `cargo run -p cpu --example intersect_exactly`

use std::process::ExitCode;

use cpu::intersect::{SphereRecord, sphere};
use cpu::{Ray, Vec3};

const USAGE: &str = "\
intersect_exactly
Prints, for rays that nearly touch a sphere, what the plain formula and the exact intersection answer.

Example:
  cargo run -p cpu --example intersect_exactly";

fn main() -> ExitCode {
    match std::env::args_os().nth(1) {
        None => {}
        Some(argument) if argument == "--help" => {
            println!("{USAGE}");
            return ExitCode::SUCCESS;
        }
        Some(argument) => {
            eprintln!("Error: {argument:?} is not an option; see --help");
            return ExitCode::from(2);
        }
    }
    // The ray runs parallel to the z axis, at a distance from the centre of almost exactly the radius.
    let radius = 1e8_f64;
    let target = SphereRecord::new(Vec3::new(0.0, 0.0, 1e8), radius);
    println!("{:24}{:28}exact", "distance - radius", "plain formula");
    for steps in [-2_i32, -1, 0, 1, 2] {
        let mut x = radius;
        for _ in 0..steps.abs() {
            x = if steps < 0 { x.next_down() } else { x.next_up() };
        }
        let ray = Ray { origin: Vec3::new(x, 0.0, 0.0), direction: Vec3::new(0.0, 0.0, 1.0) };
        // `None` is a miss. Lambda is the distance along the ray in lengths of its direction.
        let plain = target.intersect(&ray);
        let exact = sphere(&target, &ray);
        println!("{:<24e}{:28}{}", x - radius, text(plain), text(exact));
    }
    ExitCode::SUCCESS
}

fn text(lambda: Option<f64>) -> String {
    lambda.map_or("misses".to_owned(), |lambda| format!("hits at {lambda}"))
}
