//! Runs f64 by integers in headless Chromium, where WebGPU has no f64, and compares the results with Rust's f64.
//!
//! The variable `LOWERED_CASES` sets the number of cases of each operation. With `LOWERED_PICTURES=all` pictures
//! of matte and of metal spheres are rendered, not only one picture.

use std::collections::BTreeMap;
use std::path::Path;
use std::time::Duration;

use cpu::{Scatter, Vec3, reference};
use gpu_check::difference::difference;
use gpu_check::features_of;
use gpu_check::lowered::{Tally, operands::draw, operations};
use gpu_check::scenes::{self, Case};
use gpu_check::web::formulas::{add_formulas, cases as formula_cases, expected};
use gpu_check::web::{jobs::Jobs, lowered::add_operations};
use gpu_check::{Float, Kernel, kernels::KERNELS};
use libtest_mimic::Failed;
use shaders::{Features, Library, lower::Arithmetic};

use super::browser::results;

/// Number of cases of each operation, unless `LOWERED_CASES` sets another.
const CASES: u64 = 1_000_000;
/// Number of random scenes among which those that a browser can render are found.
const RANDOM_SCENES: u64 = 400;
/// Largest number of pictures of each kind of material with `LOWERED_PICTURES=all`.
const PICTURES: usize = 10;
/// The kernels that SwiftShader does not compile: the browser's process takes 7 GB of memory and ends after a minute.
const TOO_LARGE: [&str; 2] = ["kernels/cylinder", "kernels/projected_cylinder"];
/// Limit on the number of pixels times objects of one picture; see [`Case::within`].
const TESTS: usize = 200_000;
/// How long to wait for the next result of the page. The largest shader is compiled before its first result, by
/// Chromium's software renderer in 23 s on an idle machine. The limit leaves room for a busy one.
const PATIENCE: Duration = Duration::from_secs(600);

/// Returns scenes for the browser, made small, with the features of their pipelines. They have spheres alone, of one
/// kind of material, matte or metal: SwiftShader compiles other shaders for more than eight minutes, or not at all. By
/// default there is one scene.
fn pictures() -> Result<Vec<(Case, Features)>, Failed> {
    let is_all = std::env::var("LOWERED_PICTURES").is_ok_and(|which| which == "all");
    let (kinds, count) = if is_all { (2, PICTURES) } else { (1, 1) };
    let all = scenes::all(RANDOM_SCENES, TESTS)?;
    let deepest = all.iter().map(|case| case.config.max_depth as u32).max().ok_or("there are no scenes")?;
    // All pipelines have the largest depth, so that scenes with the same features share one.
    let matte = Features { has_cylinders: false, has_metal: false, has_refraction: false, ..Features::all(deepest) };
    let metal = Features { has_matte: false, has_metal: true, ..matte };
    let mut pictures = Vec::new();
    for kind in [matte, metal].into_iter().take(kinds) {
        let is_of_kind = |case: &&Case| {
            features_of(&case.config, &case.scene).is_ok_and(|of| Features { max_depth: deepest, ..of } == kind)
        };
        pictures.extend(all.iter().filter(is_of_kind).take(count).map(|case| (case.clone(), kind)));
    }
    Ok(pictures)
}

/// Compares the results of operations, formulas and pictures.
pub fn compare(chromium: &Path) -> Result<(), Failed> {
    let count = std::env::var("LOWERED_CASES").map_or(Ok(CASES), |text| text.parse())?;
    let cases: Vec<_> = (0..count).map(|index| draw(32, index)).collect();
    let operations: Vec<_> = operations::all().collect();
    let pictures = pictures()?;
    let mut jobs = Jobs::default();
    add_operations(&mut jobs, operations.iter().copied(), &cases)?;
    let library = Library::standard().lowered(Arithmetic::standard());
    add_formulas::<f64>(&mut jobs, &library, kernels())?;
    jobs.add_pictures::<f64>(&library, &pictures)?;
    let results = results(chromium, jobs, PATIENCE)?;
    let (mut compared, mut numbers, mut pixels, mut faults) = (0, 0, 0, Vec::new());
    for (index, &operation) in operations.iter().enumerate() {
        let mut tally = Tally::new(operation);
        let body = result(&results, &format!("operation/{index}"), cases.len() * operation.outcome.size())?;
        for (case, actual) in cases.iter().zip(body.chunks(operation.outcome.size())) {
            tally.add(operation, case, actual);
        }
        println!("{tally}");
        compared += tally.cases;
        faults.extend((tally.differing > 0).then(|| tally.to_string()));
    }
    for kernel in kernels() {
        let expected = expected(kernel, &formula_cases::<f64>(kernel));
        let actual = floats(result(&results, kernel.module, 8 * expected.len())?);
        let differing = actual.iter().zip(&expected).filter(|(one, other)| !one.same(**other)).count();
        println!("{}: {differing} of {} numbers differ", kernel.module, actual.len());
        numbers += actual.len();
        faults.extend((differing > 0).then(|| format!("{}: {differing} numbers differ", kernel.module)));
    }
    for (index, (case, _)) in pictures.iter().enumerate() {
        let mut expected = Vec::new();
        reference::render_linear(&case.config, &case.scene, Scatter::Deterministic, |_, mean| expected.push(mean))?;
        let numbers = floats(result(&results, &format!("picture/{index}"), 24 * expected.len())?);
        let actual: Vec<_> = numbers.chunks(3).map(|rgb| Vec3::new(rgb[0], rgb[1], rgb[2])).collect();
        let found = difference(&actual, &expected);
        println!("{}: {found}", case.name);
        pixels += found.pixels;
        faults.extend((found.differing > 0).then(|| format!("{}: {found}", case.name)));
    }
    println!(
        "{compared} results, {numbers} numbers of formulas and {pixels} pixels of the browser compared with Rust's f64"
    );
    if compared < operations.len() * 1000 || numbers < 100_000 || pixels < 1000 {
        return Err("too little was compared".into());
    }
    if faults.is_empty() { Ok(()) } else { Err(faults.join("\n").into()) }
}

fn kernels() -> impl Iterator<Item = &'static Kernel> {
    KERNELS.iter().filter(|kernel| !TOO_LARGE.contains(&kernel.module))
}

/// Returns the result of a job, or an error if it does not have this number of bytes.
fn result<'a>(results: &'a BTreeMap<String, Vec<u8>>, name: &str, bytes: usize) -> Result<&'a [u8], Failed> {
    let found = results.get(name).filter(|body| body.len() == bytes);
    Ok(found.ok_or_else(|| format!("{name} has no result of {bytes} bytes"))?)
}

fn floats(bytes: &[u8]) -> Vec<f64> {
    bytemuck::pod_collect_to_vec(bytes)
}
