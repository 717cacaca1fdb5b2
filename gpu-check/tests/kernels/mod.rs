//! The formulas that are compared: those of `cpu`, with a file for each of its modules, and the projected form of
//! `stability`.

mod background;
mod camera;
mod cylinder;
pub mod kernel;
pub mod row_kernel;
pub mod running;
mod scatter;
pub mod special;
mod sphere;
mod two_sum;

use cpu::Vec3;
use cpu::internals::Hit;
use cpu::internals::math::real::Real;

use kernel::Kernel;

/// The intersection of a ray with a sphere, by the plain formula.
pub const SPHERE: Kernel = Kernel::of::<sphere::Sphere<false>>();
/// The intersection of a ray with a cylinder, by the plain formula.
pub const CYLINDER: Kernel = Kernel::of::<cylinder::Cylinder<false>>();
/// The intersection of a ray with a sphere, in the projected form.
pub const PROJECTED_SPHERE: Kernel = Kernel::of::<sphere::Sphere<true>>();
/// The intersection of a ray with a cylinder, in the projected form.
pub const PROJECTED_CYLINDER: Kernel = Kernel::of::<cylinder::Cylinder<true>>();

/// All kernels whose results must have the bits of their formulas.
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
    Kernel::of::<two_sum::TwoSum>(),
];

/// Names of the numbers of a `HitReport`, in the order of `kernels/hit_report.wgsl`.
const HIT_REPORT: &[&str] =
    &["some", "lambda", "part", "front", "point.x", "point.y", "point.z", "normal.x", "normal.y", "normal.z"];

/// Writes the report of a hit to `result`, or zeros for a miss.
fn report<T: Real>(hit: Option<(T, u32, Hit<T>)>, result: &mut [T]) {
    let Some((lambda, part, hit)) = hit else {
        return result.fill(T::of(0.0));
    };
    let front = T::of(if hit.front { 1.0 } else { 0.0 });
    result[..4].copy_from_slice(&[T::of(1.0), lambda, T::of(part.into()), front]);
    store(hit.point, &mut result[4..]);
    store(hit.normal, &mut result[7..]);
}

/// Writes a vector to the first three numbers of `result`.
fn store<T: Copy>(vector: Vec3<T>, result: &mut [T]) {
    result[..3].copy_from_slice(&vector.to_array());
}
