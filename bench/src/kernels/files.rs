//! Kernels of files: parsing the configuration and the scene, building the acceleration structure, and writing the
//! picture.

use std::hint::black_box;
use std::io;

use cpu::internals::accel::choice::Accel;
use cpu::internals::accel::extent::Extent;
use cpu::internals::layout::Objects;
use cpu::internals::layout::aos::{AosImage, AosObjects};
use cpu::{Config, Image, Rgb, Scene, Size};
use generator::{self, Arrangement, Options};

use super::{Kernel, Work, plain};

pub const KERNELS: &[Kernel] = &[
    Kernel { name: "parse-config", new: parse_config },
    Kernel { name: "parse-scene", new: parse_scene },
    Kernel {
        name: "build-flat-filter",
        new: || build(36, Arrangement::Grid, |accel| matches!(accel, Accel::FlatFilter(_))),
    },
    Kernel { name: "build-bvh", new: || build(5000, Arrangement::Scattered, |accel| matches!(accel, Accel::Bvh(_))) },
    Kernel { name: "write-ppm", new: write_ppm },
];

fn parse_config() -> Box<dyn Work> {
    let text = generator::write::config(&Config::default());
    plain(text.lines().count(), move || {
        black_box(Config::parse(black_box(text.as_bytes())).expect("it is valid"));
    })
}

fn parse_scene() -> Box<dyn Work> {
    let text = generator::write::scene(&generator::scene(&Options { objects: 1000, ..Options::default() }));
    plain(text.lines().count(), move || {
        black_box(Scene::parse(black_box(text.as_bytes())).expect("it is valid"));
    })
}

/// Builds the structure of a scene, which must be the expected one. A grid has a ground, which is a dominant sphere.
fn build(objects: usize, arrangement: Arrangement, is_expected: fn(&Accel) -> bool) -> Box<dyn Work> {
    let scene = generator::scene(&Options { objects, arrangement, ..Options::default() });
    let mut objects = AosObjects::build(&scene).expect("it fits");
    let extent = Extent { max_coordinate: 100.0, moderate: true, has_tiny: false };
    plain(objects.sphere_count() + objects.cylinder_count(), move || {
        let accel = Accel::new(black_box(&mut objects), &extent).expect("it fits");
        assert!(is_expected(black_box(&accel)), "another structure is chosen");
    })
}

fn write_ppm() -> Box<dyn Work> {
    let size = Size::new(256, 256).expect("it is small");
    let mut image = AosImage::black(size).expect("it is small");
    for index in 0..size.pixels() {
        let [red, green, blue] = [index, index / 3, index / 7].map(|value| value as u8);
        image.set_pixel(index, Rgb { red, green, blue });
    }
    plain(size.pixels(), move || {
        cpu::internals::image::ppm::write_ppm(black_box(&image), io::sink()).expect("a sink takes all")
    })
}
