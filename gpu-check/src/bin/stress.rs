//! `stress [RAYS [SEED [NAME CONFIG SCENE]...]]`: runs the whole stress test of the intersections, in Rust and in WGSL,
//! and writes `docs/accuracy/` and the tables of `docs/accuracy.md`.
//!
//! RAYS (100,000) is the number of rays a regime of spheres; cylinders get three fifths of it. Beside the pictures of
//! `tests/cases`, those named on the command line are rendered.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use cpu::output::{Options, Output};
use cpu::{Config, Scatter, Scene};
use gpu_check::Gpu;
use stability::methods::{self, CERTIFIED, PROJECTED};
use stability::observed::Counts;
use stability::regimes;
use stability::report::{self, Picture, Section};
use stability::run::{self, LargeSpheres};

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let rays: usize = arguments.first().map_or(Ok(100_000), |text| text.parse())?;
    let seed: u64 = arguments.get(1).map_or(Ok(1), |text| text.parse())?;
    let root = PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/.."));
    let folder = root.join("docs/accuracy");
    fs::create_dir_all(&folder)?;

    let gpu = Gpu::open()?;
    let device = gpu.to_string();
    println!("{device}");
    if !gpu.has_f64() {
        println!("it has no f64 in shaders: WGSL is held to exact arithmetic in f32 only");
    }
    let mut methods = methods::all();
    methods.extend(gpu_check::methods::all(gpu)?);

    let spheres = run::sections(&methods, &regimes::SPHERES, seed, rays)?;
    let cylinders = run::sections(&methods, &regimes::CYLINDERS, seed, rays * 3 / 5)?;
    print_costs(&spheres);
    print_costs(&cylinders);
    let kinds: [(&str, &[Section]); 2] = [("sphere", &spheres), ("cylinder", &cylinders)];
    put(&folder.join("table.csv"), &report::csv(&kinds))?;
    for (name, kind, sections) in [("sphere", "Spheres", &spheres), ("cylinder", "Cylinders", &cylinders)] {
        let wrong =
            run::plot(&format!("{kind}: wrong decisions (no mark: none)"), "share of rays", (-5, 0), sections, |row| {
                row.wrong as f64 / row.cases as f64
            });
        put(&folder.join(format!("{name}-wrong.svg")), &wrong.svg())?;
        let errors = run::plot(
            &format!("{kind}: largest relative error of lambda where the decision is right"),
            "relative error",
            (-17, 3),
            sections,
            |row| row.lambda_error[2],
        );
        put(&folder.join(format!("{name}-lambda.svg")), &errors.svg())?;
    }

    let large = LargeSpheres::new(&methods, seed, rays)?;
    put(&folder.join("large-spheres.svg"), &large.plot().svg())?;
    let pictures = pictures(&root, arguments.get(2..).unwrap_or_default())?;

    let mut command = format!("cargo run --release -p gpu-check --bin stress -- {rays} {seed}");
    for triple in arguments.get(2..).unwrap_or_default().chunks_exact(3) {
        command += &format!(" {} CONFIG SCENE", triple[0]);
    }
    let limits = format!(
        "Of {rays} rays that leave a sphere, up to which radius at most none, and at most one in a thousand, is \
         decided wrongly: projected f32 {:.0} and {:.0}, in WGSL {:.0} and {:.0}, certified f64 {:.0e} (the largest \
         tried) and the same.\n",
        large.limit(PROJECTED, 0.0),
        large.limit(PROJECTED, 1e-3),
        large.limit(gpu_check::methods::PROJECTED, 0.0),
        large.limit(gpu_check::methods::PROJECTED, 1e-3),
        large.limit(CERTIFIED, 0.0),
    );
    let today = String::from_utf8(Command::new("date").args(["-u", "+%F"]).output()?.stdout)?;
    let document = root.join("docs/accuracy.md");
    let mut text = fs::read_to_string(&document)?;
    for (mark, block) in [
        ("command", format!("`{command}`\n\nRun on {}, the seed is {seed}; WGSL ran on {device}.\n", today.trim())),
        ("spheres", report::markdown(&spheres)),
        ("cylinders", report::markdown(&cylinders)),
        ("costs", report::costs(&kinds)),
        ("large", limits),
        ("pictures", report::pictures(&pictures)),
    ] {
        text = replaced(&text, mark, &block)?;
    }
    put(&document, &text)?;

    for (kind, regimes, proven) in [
        ("spheres", &regimes::SPHERES[..], run::PROVEN_ERRORS[0]),
        ("cylinders", &regimes::CYLINDERS[..], run::PROVEN_ERRORS[1]),
    ] {
        let largest = run::climb(regimes, proven, seed, rays.div_ceil(1000), 1000)?;
        println!("{kind}: climbing reached an error of lambda of {largest:.2e}; {proven:.1e} is proven");
    }
    let textbook = [run::check(&spheres, [run::PROVEN_ERRORS[0]; 2])?, run::check(&cylinders, [1e-11, 1e-9])?];
    for row in [&spheres, &cylinders].into_iter().flat_map(|sections| run::parted_from_their_twins(sections)) {
        println!("{}, {}: not the figures of the same formulas in Rust", row.regime, row.method);
    }
    println!("certified: 0 wrong; textbook: {} spheres and {} cylinders wrong", textbook[0], textbook[1]);
    Ok(())
}

/// Replaces a file by one with this text.
fn put(path: &Path, text: &str) -> Result<(), cpu::Error> {
    Output::open(path, Options { sync: true })?.fill(|file| file.write_all(text.as_bytes()))
}

fn print_costs(sections: &[Section]) {
    for row in sections.iter().flat_map(|section| &section.rows) {
        println!("{:36} {:18} {:8.1} ns a test", row.regime, row.method, row.nanoseconds);
    }
}

/// The pictures of `tests/cases` and those asked for.
fn pictures(root: &Path, others: &[String]) -> Result<Vec<Picture>, Box<dyn Error>> {
    let mut pictures = Vec::new();
    let mut all = Picture { name: "tests/cases, all".into(), counts: Counts::default(), same_bytes: true };
    for entry in fs::read_dir(root.join("tests/cases"))? {
        let path = entry?.path();
        if path.is_dir() {
            let picture = render("", &path.join("config.txt"), &path.join("scene.txt"))?;
            all.counts = all.counts.with(&picture.counts);
            all.same_bytes &= picture.same_bytes;
        }
    }
    pictures.push(all);
    for triple in others.chunks_exact(3) {
        pictures.push(render(&triple[0], Path::new(&triple[1]), Path::new(&triple[2]))?);
    }
    Ok(pictures)
}

fn render(name: &str, config: &Path, scene: &Path) -> Result<Picture, cpu::Error> {
    run::picture(name, &Config::read(config)?, &Scene::read(scene)?, Scatter::Statement)
}

/// The text with what stands between a mark's two comments replaced.
fn replaced(text: &str, mark: &str, block: &str) -> Result<String, String> {
    let (begin, end) = (format!("<!-- begin: {mark} -->\n"), format!("<!-- end: {mark} -->"));
    let missing = || format!("docs/accuracy.md lacks the mark {mark}");
    let (before, rest) = text.split_once(&begin).ok_or_else(missing)?;
    let (_, after) = rest.split_once(&end).ok_or_else(missing)?;
    Ok(format!("{before}{begin}{block}{end}{after}"))
}
