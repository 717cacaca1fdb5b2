//! The formulas that are compared, one file for each module of `cpu`.

mod background;
mod barrier;
mod camera;
mod cylinder;
mod scatter;
mod sphere;

pub use barrier::two_sum;

use cpu::real::Real;
use cpu::{Hit, Vec3};

use crate::Kernel;

/// Every kernel that must give the bits of `cpu`.
pub const KERNELS: [Kernel; 9] = [
    Kernel::of::<sphere::Sphere>(),
    Kernel::of::<cylinder::Cylinder>(),
    Kernel::of::<camera::CameraRay>(),
    Kernel::of::<background::Gradient>(),
    Kernel::of::<scatter::Matte>(),
    Kernel::of::<scatter::Reflection>(),
    Kernel::of::<scatter::Metal>(),
    Kernel::of::<scatter::Refraction>(),
    Kernel::of::<barrier::Barrier>(),
];

/// The numbers of a `HitReport`, as `kernels/hit_report.wgsl` has them.
const HIT_REPORT: &[&str] =
    &["some", "lambda", "part", "front", "point.x", "point.y", "point.z", "normal.x", "normal.y", "normal.z"];

/// Writes the report of a hit, or of none.
fn report<T: Real>(hit: Option<(T, u32, Hit<T>)>, result: &mut [T]) {
    let Some((lambda, part, hit)) = hit else {
        return result.fill(T::of(0.0));
    };
    let front = T::of(if hit.front { 1.0 } else { 0.0 });
    result[..4].copy_from_slice(&[T::of(1.0), lambda, T::of(part.into()), front]);
    store(hit.point, &mut result[4..]);
    store(hit.normal, &mut result[7..]);
}

/// Writes a vector at the start of `result`.
fn store<T: Copy>(vector: Vec3<T>, result: &mut [T]) {
    result[..3].copy_from_slice(&vector.to_array());
}
