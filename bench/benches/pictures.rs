//! Measures the time of whole pictures, from the text of the inputs to the bytes of the file, and checks their digests:
//! `cargo bench -p bench --bench pictures [NAME]`.
//!
//! Criterion measures the scenes of `tests/cases`. The scenes of the reference folder take seconds. If that folder
//! exists, each of its scenes is rendered once, and its user time is printed.

use std::fs;
use std::path::Path;
use std::time::Duration;

use cpu::{Aos, Config, Scatter, Scene};
use criterion::{Criterion, criterion_group};
use digest::sha256;
use measure::clock::own_seconds;
use test_support::golden::{self, Golden};

/// Returns the bytes of the picture's file, rendered from the bytes of the configuration and of the scene.
fn picture(config: &[u8], scene: &[u8], scatter: Scatter) -> Vec<u8> {
    let config = Config::parse(config).expect("the configuration is valid");
    let scene = Scene::parse(scene).expect("the scene is valid");
    test_support::ppm(&cpu::render::<Aos>(&config, &scene, scatter).expect("it can be rendered"))
}

/// Returns the bytes of the configuration and of the scene of `golden`.
fn files(golden: &Golden) -> [Vec<u8>; 2] {
    let read = |path: &Path| fs::read(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    [read(&golden.config), read(&golden.scene)]
}

fn check(golden: &Golden, picture: &[u8]) {
    assert_eq!(Ok(sha256(picture)), golden.digest(), "{} is another picture", golden.name);
}

fn cases(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("picture");
    for golden in golden::cases().iter().filter(|golden| golden.scatter == Scatter::Statement) {
        let [config, scene] = files(golden);
        check(golden, &picture(&config, &scene, golden.scatter));
        group.bench_function(&golden.name, |bencher| bencher.iter(|| picture(&config, &scene, golden.scatter)));
    }
    group.finish();
}

criterion_group! {
    name = pictures;
    config = Criterion::default()
        .sample_size(10)
        .warm_up_time(Duration::from_millis(200))
        .measurement_time(Duration::from_millis(700));
    targets = cases
}

fn main() {
    let _ = bench::instruction_set();
    pictures();
    Criterion::default().configure_from_args().final_summary();
    let folder = golden::reference_folder();
    if !folder.is_dir() {
        println!("no reference pictures: there is no folder {}; RENDER_REFERENCE_DIR names another", folder.display());
        return;
    }
    for golden in golden::reference(&folder).iter().filter(|golden| golden.scatter == Scatter::Statement) {
        let [config, scene] = files(golden);
        let before = own_seconds();
        let picture = picture(&config, &scene, golden.scatter);
        let seconds = own_seconds() - before;
        check(golden, &picture);
        println!("reference {}: {seconds:.3} s of user time, its digest is right", golden.name);
    }
}
