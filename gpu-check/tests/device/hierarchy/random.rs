//! Random scenes and rays on which a hierarchy may fail: rays that graze small objects, or that start far away.

use cpu::{Config, Ray, Scene};
use generator::{Arrangement, Options};
use gpu_check::{Float, Picture};
use stability::random::Random;

use crate::kernels::special::{any_size, direction};

/// Returns a scene of 300 objects of very different sizes, which touch or contain others, or lie on a ground.
fn scene(seed: usize) -> Scene {
    let arrangement = [Arrangement::Degenerate, Arrangement::Scattered, Arrangement::Grid][seed % 3];
    generator::scene(&Options { seed: seed as u64, objects: 300, arrangement, ..Options::default() })
}

/// Returns the picture of the scene of seed `seed`, and `count` rays in it; see [`ray`].
pub fn rays<T: Float>(random: &mut Random, seed: usize, count: usize) -> (Picture<T>, Vec<Ray<T>>) {
    let config = Config { image_width: 8, ..Config::default() };
    let picture = Picture::new(&config, &scene(seed)).expect("it is valid");
    let rays = (0..count).map(|_| ray(random, &picture)).collect();
    (picture, rays)
}

/// Returns a ray that starts anywhere or on an object, and aims past the middle of an object by about its radius.
fn ray<T: Float>(random: &mut Random, picture: &Picture<T>) -> Ray<T> {
    let mut object = || {
        let index = random.below(picture.spheres.len() + picture.cylinders.len());
        let (center, radius) = match index.checked_sub(picture.spheres.len()) {
            None => (picture.spheres[index].record.center, picture.spheres[index].record.radius),
            Some(index) => (picture.cylinders[index].record.center, picture.cylinders[index].record.radius),
        };
        (center.map(Float::wide), radius.wide())
    };
    let ((from, from_radius), (center, radius)) = (object(), object());
    let origin = match random.below(50) {
        0..15 => from + direction(random) * from_radius,
        15..49 => random.cube(12.0),
        // Far away from all objects.
        _ => random.cube(1e4),
    };
    let off = match random.below(2) {
        0 => 1.0 + any_size(random, -17.0, -1.0),
        _ => random.uniform(0.0, 1.2),
    };
    let across = random.perpendicular(center - origin);
    let direction = center + across * (radius * off) - origin;
    let size = if random.below(20) == 0 { random.decades(-9.0, 17.0) } else { 1.0 };
    Ray { origin: origin.map(T::of), direction: (direction * size).map(T::of) }
}
