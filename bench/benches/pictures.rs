//! Measures the time to write a large picture and to read a large scene: `cargo bench -p bench --bench pictures`.
//!
//! The result is the shortest wall-clock time of several turns, because other work of the machine can only add time.

use std::fs::File;
use std::time::Instant;

use cpu::internals::Camera;
use cpu::internals::accel::choice::Accel;
use cpu::internals::accel::extent::Extent;
use cpu::internals::accel::object::file_index_of;
use cpu::internals::layout::Objects;
use cpu::internals::layout::aos::{AosImage, AosObjects};
use cpu::internals::layout::soa::SoaImage;
use cpu::{Image, Rgb, Scene, Size};
use generator::{self, Options};

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
        assert!(matches!(search, Accel::LargeBvh(_)) && file_index_of(&objects, 0) < OBJECTS as u32);
        search
    };
    let (read, built) = (fastest(3, parse), fastest(3, build));
    println!("large scene of a million objects: {read:.2} s to read, {built:.2} s to build the hierarchy");
}

fn main() {
    // `cargo test --benches` only checks that the benchmark starts.
    if std::env::args().any(|argument| argument == "--test") {
        return;
    }
    write::<AosImage>("AoS");
    write::<SoaImage>("SoA");
    read();
}
