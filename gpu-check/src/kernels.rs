//! The formulas that are compared, one file for each module of `cpu`, and the projected form of `stability`.

mod background;
mod barrier;
mod camera;
mod cylinder;
mod projected;
mod scatter;
mod sphere;

pub use barrier::two_sum;

use cpu::Vec3;
use cpu::internals::Hit;
use cpu::internals::math::real::Real;

use crate::Kernel;

/// Ray against sphere, by the plain formula.
pub const SPHERE: Kernel = Kernel::of::<sphere::Sphere>();
/// Ray against cylinder, by the plain formula.
pub const CYLINDER: Kernel = Kernel::of::<cylinder::Cylinder>();
/// Ray against sphere in the projected form.
pub const PROJECTED_SPHERE: Kernel = Kernel::of::<projected::Sphere>();
/// Ray against cylinder in the projected form.
pub const PROJECTED_CYLINDER: Kernel = Kernel::of::<projected::Cylinder>();

/// Every kernel that must give its formula's bits.
pub const KERNELS: [Kernel; 11] = [
    SPHERE,
    CYLINDER,
    PROJECTED_SPHERE,
    PROJECTED_CYLINDER,
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

/// Writes the report of a hit, or zeros for a miss.
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
