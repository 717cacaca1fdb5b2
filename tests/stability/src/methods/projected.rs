//! The projected form of the intersections, which is the most accurate form in single precision. It starts at the point
//! of the line that is nearest to the centre or the axis, and goes half a chord from there to each side. So the terms
//! that cancel are as large as the line's distance from the centre, and not as large as the origin's distance.

use cpu::internals::geometry::cap;
use cpu::internals::geometry::cylinder::{CylinderPart, CylinderRecord};
use cpu::internals::geometry::ray::in_range;
use cpu::internals::geometry::sphere::SphereRecord;
use cpu::internals::geometry::tie::later_cap_is_closer;
use cpu::internals::math::real::Real;
use cpu::{Ray, Vec3};

/// Returns the two lambdas at which a line crosses a sphere or an infinite cylinder, or `None` if it does not. `r_c` is
/// the vector from the line's origin to the centre. For a cylinder, `direction` and `r_c` are the components
/// perpendicular to the axis.
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

/// Returns the lambda at which the ray hits the sphere, as [`SphereRecord::intersect`] does.
pub fn sphere<T: Real<Mask = bool>>(sphere: &SphereRecord<T>, ray: &Ray<T>) -> Option<T> {
    let crossings = crossings(ray.direction, sphere.center - ray.origin, sphere.radius_squared)?;
    crossings.into_iter().find(|&lambda| in_range(lambda))
}

/// Returns the lambda and the part at which the ray hits the cylinder, as [`CylinderRecord::intersect`] does.
pub fn cylinder<T: Real<Mask = bool>>(cylinder: &CylinderRecord<T>, ray: &Ray<T>) -> Option<(T, CylinderPart)> {
    let r_c = (cylinder.center - ray.origin).perpendicular_to(cylinder.axis);
    let side = crossings(ray.direction.perpendicular_to(cylinder.axis), r_c, cylinder.radius_squared)
        .and_then(|roots| roots.into_iter().find(|&root| in_range(root) && cylinder.within_height(ray, root)));
    let cap = |center: Vec3<T>| cap::intersect(center, cylinder.axis, cylinder.radius, ray);
    let hits = [
        (side, CylinderPart::Side),
        (cap(cylinder.top), CylinderPart::Top),
        (cap(cylinder.bottom), CylinderPart::Bottom),
    ];
    let found = hits.into_iter().filter_map(|(lambda, part)| Some((lambda?, part)));
    found.reduce(|best, hit| if later_cap_is_closer(hit.0, best.0) { hit } else { best })
}
