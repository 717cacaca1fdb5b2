//! Records a pixel's path step by step. A step is one ray and its hit.

use cpu::Vec3;
use cpu::internals::math::real::Real;

use crate::{Float, Picture};

/// Names of the numbers of a step (one ray of a path and its hit), in the order of `kernels/steps.wgsl`.
pub const NAMES: [&str; 21] = [
    "is_hit",
    "lambda",
    "object",
    "part",
    "front",
    "material",
    "origin.x",
    "origin.y",
    "origin.z",
    "direction.x",
    "direction.y",
    "direction.z",
    "point.x",
    "point.y",
    "point.z",
    "normal.x",
    "normal.y",
    "normal.z",
    "light.r",
    "light.g",
    "light.b",
];

/// A step: one ray of a path and its hit. [`NAMES`] has the names of its numbers.
#[derive(Clone, Copy, Debug)]
pub struct Step<T>(pub [T; NAMES.len()]);

impl<T: Copy> Step<T> {
    /// Returns 1 if the ray hits an object, 0 if it escapes to the background, and -1 for steps after the end of the
    /// path.
    pub const fn is_hit(&self) -> T {
        self.0[0]
    }
}

/// Returns the index of the first number in which two steps differ, or `None` if they are equal.
#[must_use]
pub fn first_difference<T: Float>(one: &Step<T>, other: &Step<T>) -> Option<usize> {
    one.0.iter().zip(&other.0).position(|(one, other)| !one.same(*other))
}

impl<T: Real<Mask = bool>> Picture<T> {
    /// Returns the steps of the pixel at `index`, computed in Rust. Their number is the maximum depth.
    #[must_use]
    pub fn steps(&self, index: usize) -> Vec<Step<T>> {
        let (zero, one) = (T::of(0.0), T::of(1.0));
        let width = self.size.width();
        let [row, column] = [index / width, index % width].map(|number| T::of(number as f64));
        let mut ray = self.camera.ray(row, column, [zero; 2]);
        let mut steps = Vec::new();
        for _ in 0..self.max_depth {
            let found = self.closest_hit(&ray);
            let mut step = [zero; NAMES.len()];
            store(ray.origin, &mut step[6..]);
            store(ray.direction, &mut step[9..]);
            match &found {
                None => store(self.background.color(ray.direction), &mut step[18..]),
                Some(found) => {
                    let whole = |number: u32| T::of(number.into());
                    let front = if found.hit.front { one } else { zero };
                    let numbers = [one, found.lambda, whole(found.order), whole(found.part), front];
                    step[..5].copy_from_slice(&numbers);
                    step[5] = whole(found.material);
                    store(found.hit.point, &mut step[12..]);
                    store(found.hit.normal, &mut step[15..]);
                    ray = self.scatter_ray(&ray, found, Vec3::splat(zero));
                }
            }
            steps.push(Step(step));
            if found.is_none() {
                break;
            }
        }
        let mut ended = Step([zero; NAMES.len()]);
        ended.0[0] = T::of(-1.0);
        steps.resize(self.max_depth as usize, ended);
        steps
    }
}

fn store<T: Copy>(vector: Vec3<T>, place: &mut [T]) {
    place[..3].copy_from_slice(&vector.to_array());
}
