//! The projected form, the best that one precision can do: from the point of the line nearest to the centre or the
//! axis, half a chord to each side. What cancels is then only as large as the miss distance, not as the way there.

use cpu::internals::geometry::cylinder::{CylinderPart, CylinderRecord, PARALLEL};
use cpu::internals::geometry::ray::in_range;
use cpu::internals::geometry::sphere::SphereRecord;
use cpu::internals::math::real::Real;
use cpu::{Ray, Vec3};

/// Both lambdas at which a line crosses a round surface, given its direction and the way from its start to the centre,
/// both without what runs along the axis if there is one.
fn crossings<T: Real<Mask = bool>>(direction: Vec3<T>, r_c: Vec3<T>, radius_squared: T) -> Option<[T; 2]> {
    let a = direction.dot(direction);
    let middle = direction.dot(r_c) / a;
    let off_center = r_c - direction * middle;
    let rest = radius_squared - off_center.dot(off_center);
    if rest.less(T::of(0.0)) {
        return None;
    }
    let half = (rest / a).sqrt();
    Some([middle - half, middle + half])
}

/// Where the ray meets the sphere; the contract of [`SphereRecord::intersect`].
pub fn sphere<T: Real<Mask = bool>>(sphere: &SphereRecord<T>, ray: &Ray<T>) -> Option<T> {
    let crossings = crossings(ray.direction, sphere.center - ray.origin, sphere.radius_squared)?;
    crossings.into_iter().find(|&lambda| in_range(lambda))
}

/// Where the ray meets the cylinder, and its part; the contract of [`CylinderRecord::intersect`].
pub fn cylinder<T: Real<Mask = bool>>(cylinder: &CylinderRecord<T>, ray: &Ray<T>) -> Option<(T, CylinderPart)> {
    let r_c = (cylinder.center - ray.origin).perpendicular_to(cylinder.axis);
    let side = crossings(ray.direction.perpendicular_to(cylinder.axis), r_c, cylinder.radius_squared)
        .and_then(|roots| roots.into_iter().find(|&root| in_range(root) && cylinder.within_height(ray, root)));
    let base = |base: Vec3<T>| {
        let (lambda, slope) = cylinder.plane(ray, (base - ray.origin).dot(cylinder.axis));
        let met = T::of(PARALLEL).less_equal(slope.abs()) && in_range(lambda) && cylinder.on_disc(ray, base, lambda);
        met.then_some(lambda)
    };
    let hits = [
        (side, CylinderPart::Side),
        (base(cylinder.top), CylinderPart::Top),
        (base(cylinder.bottom), CylinderPart::Bottom),
    ];
    let found = hits.into_iter().filter_map(|(lambda, part)| Some((lambda?, part)));
    found.reduce(|best, hit| if hit.0.less_equal(best.0) { hit } else { best })
}
