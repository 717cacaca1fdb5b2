//! The kernels that are compared: those of the formulas of `cpu`, and of the projected form of `stability`.

mod background;
mod camera;
mod cylinder;
pub mod kernel;
mod scatter;
pub mod special;
mod sphere;

use cpu::Ray;
use gpu_check::Float;
use gpu_check::first_difference::twins::{Numbers, Twin, twin};
use gpu_check::reader::Reader;
use stability::methods::projected;
use stability::record::{Found, Record};
use stability::regimes::Regime;
use twin::trace::Hit;

pub use cylinder::{cases as cylinders, record as cylinder};
use kernel::Kernel;
use special::{any_size, pairs, rows};
pub use sphere::{cases as spheres, record as sphere};

/// Returns all kernels whose results must have the bits of their twins.
pub fn all<T: Float>() -> [Kernel<T>; 11] {
    let named = |module, inputs, name, cases| Kernel { module, inputs, twin: twin(name).expect("it has one"), cases };
    let of = |module, inputs, twin: Twin<T>, cases| Kernel { module, inputs, twin, cases };
    [
        of("kernels/sphere", 10, |_, row| report(row, sphere, Record::plain), spheres),
        of("kernels/cylinder", 13, |_, row| report(row, cylinder, Record::plain), cylinders),
        of("kernels/projected_sphere", 10, |_, row| report(row, sphere, by_projection), spheres),
        of("kernels/projected_cylinder", 13, |_, row| report(row, cylinder, by_projection), cylinders),
        named("kernels/camera", 16, "camera_ray", camera::cases),
        named("kernels/background", 9, "background_color", background::cases),
        named("kernels/matte", 6, "scatter_matte", scatter::matte),
        named("kernels/reflection", 6, "scatter_reflect", scatter::reflection),
        named("kernels/metal", 9, "scatter_metal", scatter::metal),
        named("kernels/refraction", 7, "scatter_refract", scatter::refraction),
        named("kernels/two_sum", 2, "exact_two_sum", |count, seed| {
            let edges = |row: &mut special::Row| {
                pairs().for_each(|(a, b)| row.0.extend([a, b]));
            };
            rows(count, seed, edges, |random, row| row.0.extend([(); 2].map(|()| any_size(random, -12.0, 12.0))))
        }),
    ]
}

fn by_projection<T: Float>(record: &Record<T>, ray: &Ray<T>) -> Found<T> {
    record.by(ray, projected::sphere, |record, _, ray| projected::cylinder(record, ray))
}

/// Returns the numbers of a `HitReport`, in the order of `kernels/hit_report.wgsl`, for a row with a ray and an object.
fn report<T: Float>(
    mut row: Reader<'_, T>,
    record: fn(&mut Reader<'_, T>) -> Record<T>,
    intersect: fn(&Record<T>, &Ray<T>) -> Found<T>,
) -> Option<Numbers<T>> {
    let (ray, record) = (row.ray(), record(&mut row));
    let Some((lambda, part)) = intersect(&record, &ray) else { return Some(vec![Some(T::of(0.0)); 10]) };
    let hit = Hit::facing(ray.direction, ray.at(lambda), record.outward(part, ray.at(lambda)));
    let head = [T::of(1.0), lambda, part.number(), T::of(f64::from(u8::from(hit.front)))];
    Some([&head[..], &hit.point.to_array(), &hit.normal.to_array()].concat().into_iter().map(Some).collect())
}

/// Returns `count` cases of each of `regimes` as rows.
pub fn of_regimes<'a>(regimes: impl IntoIterator<Item = &'a Regime>, count: usize, seed: u64) -> Vec<f64> {
    regimes.into_iter().flat_map(|regime| gpu_check::methods::rows::<f64>(&regime.cases(seed, count))).collect()
}
