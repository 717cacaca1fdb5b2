//! `steps FOLDER`: measures what the steps of the exact intersection cost, and how often each of them decides.

use std::cell::RefCell;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;

use bench::families::{FAMILIES, PROPERTIES};
use clap::Parser;
use cpu::internals::exact::{self, error_bound::Decision};
use cpu::internals::geometry::{cylinder::CylinderPart, cylinder::CylinderRecord, sphere::SphereRecord};
use cpu::internals::input::scene::{Cylinder, Shape, Sphere};
use cpu::internals::sampling::uniform::Uniform;
use cpu::reference::intersect::{Exact, Intersect};
use cpu::{Aos, Config, Layout, Ray, Scatter, Scene, Vec3};
use output::{Options as OutputOptions, Output};
use stability::case::Case;
use stability::oracle::{Big, big, big3, dot, minus, to_f64};
use stability::random::Random;
use stability::record::Record;
use stability::regimes::{CYLINDERS, EXTREMES, LIMITS, SPHERES};

/// Writes two tables: `step-times.csv` has the time of an intersection by its difficulty, for each step that decides
/// it, and `step-shares.csv` the share of intersections that each step decides, in pictures of scenes. Prints the
/// dearest intersection of each step among rays that are hard in all known ways.
///
/// The difficulty of a ray is the condition number of its discriminant `D`: the size of the terms of `D` over `|D|`.
#[derive(Parser)]
#[command(
    name = "steps",
    term_width = 120,
    after_help = "\
Example:
  cargo run --release -p bench --bin steps docs/accuracy ../shared/reference
  cargo run --release -p lab --example charts docs/accuracy      draws the tables"
)]
struct Options {
    /// The folder of the tables
    folder: PathBuf,
    /// The folder of the course's cases
    cases: Option<PathBuf>,
}

/// A function that says whether a step is certain of a ray.
type Decides = fn(&Record, &Ray) -> bool;

/// The steps, in their order: the name of each, and whether it is certain of a ray. The last step always is.
const STEPS: &[(&str, Decides)] = &[
    ("plain", |record, ray| record.filtered(ray) != Decision::Uncertain),
    ("compensated", |record, ray| match record {
        Record::Sphere(sphere) => exact::sphere_compensated::compensated(sphere, ray) != Decision::Uncertain,
        Record::Cylinder(cylinder, axis) => exact::cylinder::compensated(cylinder, axis, ray) != Decision::Uncertain,
    }),
    ("dyadic", |_, _| true),
];

/// Returns the index of the step that decides about a ray.
fn step_of(record: &Record, ray: &Ray) -> usize {
    STEPS.iter().position(|(_, decides)| decides(record, ray)).expect("the last step decides")
}

fn main() -> ExitCode {
    bench::main(|Options { folder, cases }: &Options| {
        write(&folder.join("step-times.csv"), &times())?;
        write(&folder.join("step-shares.csv"), &shares(cases.as_deref())?)?;
        dearest();
        Ok(true)
    })
}

fn write(path: &Path, text: &str) -> Result<(), String> {
    let written = Output::open(path, OutputOptions::default());
    written.and_then(|file| file.fill(|file| file.write_all(text.as_bytes()))).map_err(|error| error.to_string())
}

/// Returns the nanoseconds of one intersection in a pass over the cases, of at least nine passes the shortest.
fn nanoseconds(cases: &[Case], passes: usize) -> f64 {
    let cases: Vec<_> = cases.iter().map(Case::of::<f64>).collect();
    let mut least = f64::INFINITY;
    for _ in 0..passes {
        let start = Instant::now();
        for (record, ray) in std::hint::black_box(&cases) {
            std::hint::black_box(record.exact(ray));
        }
        least = least.min(start.elapsed().as_secs_f64());
    }
    least * 1e9 / cases.len() as f64
}

/// Returns the table of times by difficulty. The rays pass the rim of a sphere or of a cylinder's side. The time is 0
/// if a step decides too few rays of a difficulty.
fn times() -> String {
    const LEAST_RAYS: usize = 32;
    let mut table = "object,step,difficulty,rays,nanoseconds\n".to_owned();
    for is_sphere in [true, false] {
        let mut groups = vec![vec![Vec::new(); 20]; STEPS.len()];
        let mut random = Random::new(7);
        for _ in 0..60_000 {
            let case = beside_the_rim(&mut random, is_sphere);
            let ((record, ray), decade) = (case.of(), condition(&case).log10() as usize);
            groups[step_of(&record, &ray)][decade.min(19)].push(case);
        }
        for ((step, _), decades) in STEPS.iter().zip(&groups) {
            for (decade, cases) in decades.iter().enumerate() {
                let (object, rays) = (if is_sphere { "sphere" } else { "cylinder" }, cases.len().min(2048));
                let time = if rays < LEAST_RAYS { 0.0 } else { nanoseconds(&cases[..rays], 25) };
                let _ = writeln!(table, "{object},{step},1e{decade},{rays},{time:.1}");
            }
        }
    }
    table
}

fn beside_the_rim(random: &mut Random, is_sphere: bool) -> Case {
    let (center, axis) = (random.cube(2.0), random.unit());
    let (aside, off) = (random.perpendicular(axis), 1.0 + random.sign() * random.decades(-17.0, 0.0));
    let forward = axis.cross(aside) + axis * random.uniform(-0.2, 0.2);
    let origin = center + aside * off - forward * 10.0;
    if is_sphere {
        return Case::sphere(center, 1.0, origin, forward);
    }
    Case::cylinder(Cylinder { center, radius: 1.0, axis: axis * 6.0 }, origin, forward)
}

/// Returns the condition number of the discriminant, with a numerator and a denominator that are computed exactly.
fn condition(case: &Case) -> f64 {
    let (origin, direction, center) = (big3(case.ray.origin), big3(case.ray.direction), big3(case.center()));
    let to_center = minus(&center, &origin);
    let (a, h, q) = (dot(&direction, &direction), dot(&direction, &to_center), dot(&to_center, &to_center));
    let (radius, axis) = match case.shape {
        Shape::Sphere(Sphere { radius, .. }) => (radius, Vec3::ZERO),
        Shape::Cylinder(Cylinder { radius, axis, .. }) => (radius, axis),
    };
    let (squared, axis) = (big(radius) * big(radius), big3(axis));
    // Across the axis, all terms are multiplied by the square of the axis, which is 1 for a sphere.
    let (slope, along) = (dot(&direction, &axis), dot(&to_center, &axis));
    let length = if slope == Big::ZERO { big(1.0) } else { dot(&axis, &axis) };
    let size = &a * (&q + &squared) * &length * &length;
    let [a, h, c] =
        [a * &length - &slope * &slope, h * &length - &slope * &along, (q - squared) * &length - &along * &along];
    let discriminant = to_f64(&(&h * &h - a * c)).abs();
    to_f64(&size) / discriminant.max(f64::MIN_POSITIVE)
}

thread_local! {
    static DECIDED: RefCell<Vec<u64>> = RefCell::new(vec![0; STEPS.len()]);
}

/// The exact intersections, which also count the step that decides in [`DECIDED`].
enum Counted {}

impl Intersect for Counted {
    fn sphere(record: &SphereRecord, ray: &Ray) -> Option<f64> {
        DECIDED.with_borrow_mut(|decided| decided[step_of(&Record::Sphere(*record), ray)] += 1);
        Exact::sphere(record, ray)
    }

    fn cylinder(record: &CylinderRecord, axis: &Vec3, ray: &Ray) -> Option<(f64, CylinderPart)> {
        DECIDED.with_borrow_mut(|decided| decided[step_of(&Record::Cylinder(*record, *axis), ray)] += 1);
        Exact::cylinder(record, axis, ray)
    }
}

/// Returns the table of shares. A picture is rendered by the definition, which intersects each ray with every object.
fn shares(cases: Option<&Path>) -> Result<String, String> {
    let mut table = "scene,step,share\n".to_owned();
    let mut add = |name: &str| {
        let counts = DECIDED.replace(vec![0; STEPS.len()]);
        for ((step, _), count) in STEPS.iter().zip(&counts) {
            let _ = writeln!(table, "{name},{step},{:.3e}", *count as f64 / counts.iter().sum::<u64>().max(1) as f64);
        }
    };
    let render = |config: &Config, scene: &Scene| -> Result<(), cpu::Error> {
        let image: Result<<Aos as Layout>::Image, _> =
            cpu::reference::render_with::<_, Counted>(config, scene, Scatter::Statement);
        image.map(|_| ())
    };
    // The first case has no object.
    for number in 2..=cases.map_or(1, |_| 4) {
        let file = |kind: &str| cases.expect("there are cases").join(format!("{kind}{number}.txt"));
        let small = |config: Config| Config { image_width: 160, samples_per_pixel: 4, ..config };
        let files = Config::read(&file("config")).and_then(|config| Ok((small(config), Scene::read(&file("scene"))?)));
        files.and_then(|(config, scene)| render(&config, &scene)).map_err(|error| error.to_string())?;
        add(&format!("case {number}"));
    }
    for family in FAMILIES {
        let mut draws = Uniform::new(1);
        for _ in 0..12 {
            let scene = (family.scene)([(); PROPERTIES].map(|()| draws.canonical()));
            let config = Config::parse(scene.config(24, 1).as_bytes());
            let files = config.and_then(|config| Ok((config, Scene::parse(scene.scene.as_bytes())?)));
            files.and_then(|(config, scene)| render(&config, &scene)).map_err(|error| error.to_string())?;
        }
        add(family.name);
    }
    Ok(table)
}

/// Prints the dearest intersection of each step, and the case that it is.
fn dearest() {
    const CASES: usize = 3000;
    for is_sphere in [true, false] {
        let mut worst = vec![(0.0, "", 0); STEPS.len()];
        for regime in SPHERES.iter().chain(&CYLINDERS).chain(&EXTREMES).chain(&LIMITS) {
            for (number, case) in regime.cases(1, CASES).into_iter().enumerate() {
                if matches!(case.shape, Shape::Sphere(_)) == is_sphere {
                    let (record, ray) = case.of();
                    let worst = &mut worst[step_of(&record, &ray)];
                    // A first measurement is often too large by chance, and never too small.
                    if nanoseconds(&[case; 16], 2) > worst.0 {
                        let time = nanoseconds(&[case; 16], 25);
                        if time > worst.0 {
                            *worst = (time, regime.name, number);
                        }
                    }
                }
            }
        }
        for ((step, _), (time, regime, number)) in STEPS.iter().zip(worst) {
            let object = if is_sphere { "sphere" } else { "cylinder" };
            println!("{object}, {step}: at most {time:.0} ns, case {number} of the regime \"{regime}\"");
        }
    }
}
