//! Measures whole pictures, from the text of the inputs to the bytes of the file, and checks their digests. Then it
//! measures the time to write a large picture and to read a large scene: `cargo bench -p bench --bench pictures`, with
//! a part of a picture's name, or `large`.
//!
//! The result is the shortest wall-clock time of several turns, because other work of the machine can only add time.
//! Pictures of the reference folder, which take seconds, are rendered once.

use std::fs::{self, File};
use std::path::Path;
use std::time::Instant;

use cpu::internals::Camera;
use cpu::internals::accel::choice::Accel;
use cpu::internals::accel::extent::Extent;
use cpu::internals::accel::object::order_of;
use cpu::internals::layout::Objects;
use cpu::internals::layout::aos::{AosImage, AosObjects};
use cpu::internals::layout::soa::SoaImage;
use cpu::{Aos, Config, Image, Rgb, Scatter, Scene, Size};
use digest::sha256;
use generator::{self, Options};
use test_support::golden::{self, Golden};

/// Calls `work` `turns` times, and returns the shortest time of a call in seconds.
fn fastest<T>(turns: usize, mut work: impl FnMut() -> T) -> f64 {
    let time = |_| {
        let start = Instant::now();
        let result = work();
        let seconds = start.elapsed().as_secs_f64();
        drop(result);
        seconds
    };
    (0..turns).map(time).fold(f64::INFINITY, f64::min)
}

fn picture(golden: &Golden, turns: usize) {
    let read = |path: &Path| fs::read(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let (config, scene) = (read(&golden.config), read(&golden.scene));
    let mut ppm = Vec::new();
    let seconds = fastest(turns, || {
        let config = Config::parse(&config[..]).expect("the configuration is valid");
        let scene = Scene::parse(&scene[..]).expect("the scene is valid");
        ppm = test_support::ppm(&cpu::render::<Aos>(&config, &scene, golden.scatter).expect("it can be rendered"));
    });
    assert_eq!(Ok(sha256(&ppm)), golden.digest(), "{} is another picture", golden.name);
    println!("picture {}: {:.2} ms, its digest is right", golden.name, seconds * 1e3);
}

fn write<I: Image>(layout: &str) {
    let size = Size::new(1600, 1125).expect("it is of moderate size");
    let mut image = I::black(size).expect("it fits");
    for index in 0..size.pixels() {
        let [red, green, blue] = [index, index / 3, index / 7].map(|value| value as u8);
        image.set_pixel(index, Rgb { red, green, blue });
    }
    let (folder, mut turn) = (test_support::folder::Folder::new(), 0);
    let to_file = fastest(15, || {
        // Each turn writes a new file, as the programs do. Truncating an old file would take about as long again.
        turn += 1;
        let file = File::create(folder.file(format!("{turn}.ppm"))).expect("the folder takes files");
        cpu::write_ppm(&image, file).expect("the file takes all");
    });
    let to_nowhere = fastest(15, || cpu::write_ppm(&image, std::io::sink()).expect("a sink takes all"));
    let [file, nowhere] = [to_file, to_nowhere].map(|seconds| seconds * 1e3);
    println!("large picture of {} pixels ({layout}): {file:.1} ms, {nowhere:.1} ms without the file", size.pixels());
}

fn read() {
    const OBJECTS: usize = 1_000_000;
    let options = Options { objects: OBJECTS, ..Options::default() };
    let text = generator::write::scene(&generator::scene(&options));
    let parse = || Scene::parse(text.as_bytes()).expect("it is valid");
    let scene = parse();
    let config = generator::view(&options);
    let camera = Camera::new(&config, config.image_size().expect("it is small")).expect("it sees the scene");
    let build = || {
        let mut objects = AosObjects::build(&scene).expect("it fits");
        let extent = Extent::new(&objects, &camera, &scene.materials_in_use().expect("they fit"));
        let search = Accel::new(&mut objects, &extent).expect("it fits");
        assert!(matches!(search, Accel::LargeBvh(_)) && order_of(&objects, 0) < OBJECTS as u32);
        search
    };
    let (read, built) = (fastest(3, parse), fastest(3, build));
    println!("large scene of a million objects: {read:.2} s to read, {built:.2} s to build the hierarchy");
}

fn main() {
    let arguments: Vec<_> = std::env::args().skip(1).collect();
    // `cargo test --benches` only checks that the benchmark starts.
    if arguments.iter().any(|argument| argument == "--test") {
        return;
    }
    let _ = bench::instruction_set();
    let name = arguments.into_iter().find(|argument| !argument.starts_with('-')).unwrap_or_default();
    let folder = golden::reference_folder();
    let reference = if folder.is_dir() { golden::reference(&folder) } else { Vec::new() };
    for (goldens, turns) in [(golden::cases(), 20), (reference, 1)] {
        let is_measured = |golden: &&Golden| golden.scatter == Scatter::Statement && golden.name.contains(&name);
        goldens.iter().filter(is_measured).for_each(|golden| picture(golden, turns));
    }
    if "large".contains(&name) {
        write::<AosImage>("AoS");
        write::<SoaImage>("SoA");
        read();
    }
}
