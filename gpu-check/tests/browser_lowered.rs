//! Runs f64 by integers in headless Chromium, where WebGPU has no f64, and compares the results with Rust's f64.
//!
//! The variable `LOWERED_CASES` sets the number of cases of each operation. With `LOWERED_PICTURES=all` all pictures
//! are rendered, not only one. `tests/run --browser` installs Chromium. Without Chromium the test is shown as ignored.

use std::path::Path;
use std::process::ExitCode;
use std::sync::mpsc;
use std::time::Duration;

use cpu::{Scatter, Vec3, reference};
use gpu_check::difference::difference;
use gpu_check::features_of;
use gpu_check::lowered::{Tally, operands::draw, operations};
use gpu_check::scenes::{self, Case};
use gpu_check::web::chromium::{self, Browser};
use gpu_check::web::{Posted, Server, jobs::Jobs, lowered::add_operations};
use libtest_mimic::{Arguments, Failed, Trial};
use shaders::{Features, Library, lower::Arithmetic};
use test_support::folder::Folder;

/// Number of cases of each operation, unless `LOWERED_CASES` sets another.
const CASES: u64 = 1_000_000;
/// Number of random scenes among all pictures.
const RANDOM_SCENES: u64 = 60;
/// Limit on the number of pixels times objects of one picture; see [`Case::within`].
const TESTS: usize = 200_000;
/// Time limit for the next result of the page. SwiftShader compiles the shader of all pictures in many minutes.
const PATIENCE: Duration = Duration::from_secs(3000);

fn main() -> ExitCode {
    let chromium = chromium::find();
    let required = std::env::var_os("BROWSER_REQUIRED").is_some();
    let ignored = chromium.is_none() && !required;
    let name = "integers_give_the_bits_of_rusts_f64_in_a_browser";
    let trial = Trial::test(name, move || run(&chromium.ok_or("there is no Chromium")?));
    libtest_mimic::run(&Arguments::from_args(), vec![trial.with_ignored_flag(ignored)]).exit_code()
}

/// Returns the scenes that the browser renders, made small, and the features of their shader. By default this is one
/// scene, of spheres alone and one kind of material, because its shader is compiled in seconds.
fn pictures() -> Result<(Vec<Case>, Features), Failed> {
    if std::env::var("LOWERED_PICTURES").is_ok_and(|which| which == "all") {
        let cases = scenes::all(RANDOM_SCENES, TESTS)?;
        let deepest = cases.iter().map(|case| case.config.max_depth as u32).max().ok_or("there are no scenes")?;
        return Ok((cases, Features::all(deepest)));
    }
    let mut all = (0..400).map(scenes::random);
    let is_plain = |case: &Case| {
        features_of(&case.config, &case.scene).is_ok_and(|features| {
            let kinds = [features.has_matte, features.has_metal, features.has_refraction];
            !features.has_cylinders && kinds.iter().filter(|has| **has).count() == 1
        })
    };
    let case = all.find(is_plain).ok_or("no random scene is so plain")?.within(TESTS);
    let features = features_of(&case.config, &case.scene)?;
    Ok((vec![case], features))
}

fn run(chromium: &Path) -> Result<(), Failed> {
    let count = std::env::var("LOWERED_CASES").map_or(Ok(CASES), |text| text.parse())?;
    let cases: Vec<_> = (0..count).map(|index| draw(32, index)).collect();
    let operations: Vec<_> = operations::all().collect();
    let (pictures, features) = pictures()?;
    let mut jobs = Jobs::default();
    add_operations(&mut jobs, operations.iter().copied(), &cases)?;
    let library = Library::standard().lowered(Arithmetic::standard());
    jobs.add_pictures::<f64>(&library, &pictures, &features)?;
    let server = Server::new(0, jobs.into_data())?;
    let profile = Folder::new();
    let _browser = Browser::open(chromium, profile.path(), &format!("http://{}/jobs", server.address()?))?;
    let (sender, receiver) = mpsc::channel();
    std::thread::spawn(move || server.serve(move |posted| drop(sender.send(posted))));
    let (mut compared, mut pixels, mut faults) = (0, 0, Vec::new());
    loop {
        let Posted { name, body } = receiver.recv_timeout(PATIENCE)?;
        let (kind, rest) = name.split_once('/').unwrap_or((&name, ""));
        match (kind, rest.parse::<usize>()) {
            ("failed", _) => return Err(String::from_utf8_lossy(&body).into_owned().into()),
            ("done", _) => break,
            ("operation", Ok(index)) => {
                let operation = operations[index];
                let mut tally = Tally::new(operation);
                assert_eq!(body.len(), cases.len() * operation.outcome.size(), "{}", operation.wgsl);
                for (case, actual) in cases.iter().zip(body.chunks(operation.outcome.size())) {
                    tally.add(operation, case, actual);
                }
                println!("{tally}");
                compared += tally.cases;
                faults.extend((tally.differing > 0).then(|| tally.to_string()));
            }
            ("picture", Ok(index)) => {
                let case = &pictures[index];
                let numbers = bytemuck::pod_collect_to_vec::<u8, f64>(&body);
                let actual: Vec<_> = numbers.chunks(3).map(|rgb| Vec3::new(rgb[0], rgb[1], rgb[2])).collect();
                let mut expected = Vec::new();
                let take = |_, mean| expected.push(mean);
                reference::render_linear(&case.config, &case.scene, Scatter::Deterministic, take)?;
                let found = difference(&actual, &expected);
                println!("{}: {found}", case.name);
                pixels += found.pixels;
                faults.extend((found.differing > 0).then(|| format!("{}: {found}", case.name)));
            }
            _ => println!("{name}: {}", String::from_utf8_lossy(&body)),
        }
    }
    println!("{compared} results and {pixels} pixels of the browser compared with Rust's f64");
    if compared < operations.len() * 1000 || pixels < 1000 {
        return Err("too little was compared".into());
    }
    if faults.is_empty() { Ok(()) } else { Err(faults.join("\n").into()) }
}
