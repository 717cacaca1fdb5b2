//! Compares the f32 shader in a browser with lavapipe and Rust. The browser is headless Chromium, with the compiler
//! Tint and the driver SwiftShader.
//!
//! The page `web/jobs.html` computes every formula and one picture, and posts each result to the server of this test.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::mpsc;
use std::time::Duration;

use cpu::{Config, Scene, Vec3};
use gpu_check::conformance::csv::Table;
use gpu_check::conformance::{browser, probes};
use gpu_check::difference::difference;
use gpu_check::kernels::KERNELS;
use gpu_check::scenes::Case;
use gpu_check::web::Server;
use gpu_check::web::chromium::Browser;
use gpu_check::web::formulas::{add_formulas, cases, expected};
use gpu_check::web::jobs::Jobs;
use gpu_check::{Float, Gpu, Picture, Renderer, check, features_of};
use libtest_mimic::Failed;
use shaders::Library;
use test_support::folder::Folder;

use crate::documented;

/// Time limit for the next result of the page.
const PATIENCE: Duration = Duration::from_secs(120);

const SCENE: &str = "matte: grey .5 .5 .5\nmetal: mirror .9 .9 .9 0\nrefractive: glass 1.5\n\
    sphere: 0 -100 0 99 grey\nsphere: 0 0 0 1 glass\ncylinder: 2 0 0 .5 0 2 0 mirror\n";

/// Checks the verdicts on the browser's compiler and driver against docs/gpu/probes.csv.
pub fn conformance(chromium: &Path) -> Result<(), Failed> {
    let probes = probes::all();
    let run = browser::run(chromium, &probes)?;
    println!("{}", run.driver);
    documented::check(&Table::default().with(&probes, &[run]), "google swiftshader");
    Ok(())
}

/// Starts the browser, and returns the results of all jobs by their names. Each must come within `patience`.
pub fn results(chromium: &Path, jobs: Jobs, patience: Duration) -> Result<BTreeMap<String, Vec<u8>>, Failed> {
    let profile = Folder::new();
    let server = Server::new(0, jobs.into_data())?;
    let mut browser = Browser::open(chromium, profile.path(), &format!("http://{}/jobs", server.address()?))?;
    let (sender, receiver) = mpsc::channel();
    // The thread runs until the process ends.
    std::thread::spawn(move || server.serve(move |posted| drop(sender.send(posted))));
    let results = browser::collect(&receiver, &mut browser, patience)?;
    println!("browser: {}", String::from_utf8_lossy(&results["adapter"]));
    Ok(results)
}

/// Compares the formulas and a picture.
pub fn tint(chromium: &Path) -> Result<(), Failed> {
    let gpu = Gpu::open()?;
    println!("native: {gpu}");
    let (config, scene) = (Config { image_width: 64, ..Config::default() }, Scene::parse(SCENE.as_bytes())?);
    let features = features_of(&config, &scene)?;
    let picture = Picture::<f32>::new(&config, &scene)?;
    let native = Renderer::<f32>::new(&gpu, &Library::standard(), &features)?.render(&picture)?;
    let mut jobs = Jobs::default();
    add_formulas::<f32>(&mut jobs, &Library::standard(), KERNELS.iter())?;
    jobs.add_pictures::<f32>(&Library::standard(), &[(Case { name: String::new(), config, scene }, features)])?;
    let results = results(chromium, jobs, PATIENCE)?;
    formulas(&gpu, &results)?;
    let colors = floats(&results["picture/0"])?;
    let actual: Vec<_> = colors.chunks(3).map(|rgb| Vec3::new(rgb[0], rgb[1], rgb[2])).collect();
    let found = difference(&actual, &native.pixels);
    println!("picture: {found}");
    if found.differing > 0 || found.pixels != 64 * 36 {
        return Err(format!("the browser's picture is not the native one: {found}").into());
    }
    Ok(())
}

fn floats(bytes: &[u8]) -> Result<Vec<f32>, Failed> {
    if bytes.is_empty() || !bytes.len().is_multiple_of(4) {
        return Err(format!("{} bytes are no row of numbers", bytes.len()).into());
    }
    Ok(bytemuck::pod_collect_to_vec(bytes))
}

/// Checks the results of every kernel compiled by Tint. Each row must be equal to Rust's f32 and to lavapipe, or to f32
/// without subnormal numbers, which WGSL allows.
fn formulas(gpu: &Gpu, results: &BTreeMap<String, Vec<u8>>) -> Result<(), Failed> {
    let (mut compared, mut flushed) = (0, 0);
    let mut faults = Vec::new();
    for kernel in &KERNELS {
        let cases = cases::<f32>(kernel);
        let by_tint = floats(results.get(kernel.module).ok_or_else(|| format!("{} is missing", kernel.module))?)?;
        let pipeline = check::compile::<f32>(gpu, &Library::standard(), kernel)?;
        let native = check::results::<f32>(gpu, &pipeline, kernel, &cases)?;
        let expected = expected(kernel, &cases);
        if (by_tint.len(), native.len()) != (expected.len(), expected.len()) {
            return Err(format!("{}: {} and {} numbers", kernel.module, by_tint.len(), native.len()).into());
        }
        let outputs = kernel.outputs.len();
        let rows = by_tint.chunks(outputs).zip(native.chunks(outputs).zip(expected.chunks(outputs)));
        let (mut without_subnormals, mut neither) = (0, Vec::new());
        for (case, (by_tint, (native, expected))) in cases.chunks(kernel.inputs).zip(rows) {
            let same = |row: &[f32]| by_tint.iter().zip(row).all(|(tint, number)| tint.same(*number));
            if same(native) && same(expected) {
                continue;
            }
            let flushed = kernel.flushed(case);
            if same(&flushed) {
                without_subnormals += 1;
            } else {
                neither.push(format!("{case:?}\n  by Tint {by_tint:?}\n  f32 {expected:?}\n  flushed {flushed:?}"));
            }
        }
        println!(
            "{}: {} numbers in {} cases; {without_subnormals} cases as in f32 without subnormal numbers, {} otherwise",
            kernel.module,
            by_tint.len(),
            by_tint.len() / outputs,
            neither.len()
        );
        if !neither.is_empty() {
            let shown = neither[..neither.len().min(3)].join("\n");
            faults.push(format!("{}: {} cases, as {shown}", kernel.module, neither.len()));
        }
        compared += by_tint.len();
        flushed += without_subnormals;
    }
    println!("{compared} numbers by Tint compared with Rust's f32 and the native driver's; {flushed} cases flushed");
    if compared < 1_000_000 {
        return Err(format!("{compared} numbers are too few").into());
    }
    if faults.is_empty() { Ok(()) } else { Err(faults.join("\n").into()) }
}
