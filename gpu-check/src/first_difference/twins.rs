//! The Rust twins of the functions in WGSL, by name. Each takes the numbers of the arguments, and returns the numbers
//! of the result.

use cpu::internals::geometry::camera::Camera;
use cpu::internals::geometry::cap;
use cpu::internals::geometry::cylinder::{CylinderPart, CylinderRecord, CylinderView};
use cpu::internals::geometry::ray::in_range;
use cpu::internals::geometry::sphere::{SphereRecord, SphereView};
use cpu::internals::geometry::tie::later_cap_is_closer;
use cpu::internals::materials::{reflection, refraction, scatter};
use cpu::internals::math::real::Real;
use cpu::internals::math::vec3::NEGLIGIBLE;
use cpu::internals::render::background::Background;
use cpu::{Ray, Vec3};
use stability::methods::projected;
use twin::trace::Hit;

use crate::picture::{Kind, PackedMaterial};
use crate::reader::Reader;
use crate::{Float, Picture};
use twin::trace::scattered;

/// The numbers of a result. `None` stands for a number that has no meaning, such as the lambda of a miss.
pub type Numbers<T> = Vec<Option<T>>;

/// A function in Rust that repeats a call. It takes the picture, if one is rendered, and the numbers of the arguments.
/// It returns `None` if it cannot repeat this call.
pub type Twin<T> = fn(Option<&Picture<T>>, Reader<'_, T>) -> Option<Numbers<T>>;

/// Returns the twin of the function `name`, or `None` if it has none: its formula is a part of another function in
/// Rust, or it reads buffers that Rust does not have.
pub fn twin<T: Float>(name: &str) -> Option<Twin<T>> {
    Some(match name {
        "vec3_load" | "vec3_store" => |_, mut of| vector(of.vector()),
        "vec3_dot" => |_, mut of| number(of.vector().dot(of.vector())),
        "vec3_length" => |_, mut of| number(of.vector().length()),
        "vec3_unit" => |_, mut of| vector(of.vector().unit()),
        "vec3_perpendicular_to" => |_, mut of| vector(of.vector().perpendicular_to(of.vector())),
        "vec3_is_negligible" => |_, mut of| flag(of.vector().is_negligible()),
        "vec3_unit_and_length" => |_, mut of| {
            let (unit, length) = of.vector().unit_and_length();
            join([vector(unit), number(length)])
        },
        "ray_load" | "ray_store" => |_, mut of| ray(of.ray()),
        "ray_at" => |_, mut of| vector(of.ray().at(of.number())),
        "in_range" => |_, mut of| flag(in_range(of.number())),
        "hit_facing" => |_, mut of| hit(&Hit::facing(of.vector(), of.vector(), of.vector())),
        "tie_later_cap_is_closer" => |_, mut of| flag(later_cap_is_closer(of.number(), of.number())),
        "sphere_new" | "sphere_load" => |_, mut of| sphere(&SphereRecord::new(of.vector(), of.number())),
        "sphere_seen_from" => |_, mut of| {
            let view = of.sphere().seen_from(of.vector());
            join([vector(view.to_center), number(view.c)])
        },
        "sphere_quadratic" => |_, mut of| {
            let view = SphereView { to_center: of.vector(), c: of.number(), squares: T::of(0.0) };
            let (h, discriminant) = view.quadratic(of.vector(), of.number());
            join([number(h), number(discriminant)])
        },
        "sphere_outward" => |_, mut of| vector(of.sphere().outward(of.vector())),
        "sphere_intersect" => |_, mut of| root(of.sphere().intersect(&of.ray())),
        "projected_sphere_intersect" => |_, mut of| root(projected::sphere(&of.sphere(), &of.ray())),
        "projected_cylinder_intersect" => |_, mut of| part_of_cylinder(projected::cylinder(&of.cylinder(), &of.ray())),
        "cylinder_new" => |_, mut of| cylinder(&CylinderRecord::new(of.vector(), of.number(), of.vector())),
        "cylinder_with_unit_axis" => |_, mut of| {
            let (center, radius, axis) = (of.vector(), of.number(), of.vector());
            cylinder(&CylinderRecord::with_unit_axis(center, radius, axis, of.number()))
        },
        "cylinder_load" => |_, mut of| {
            let (center, axis, radius) = (of.vector(), of.vector(), of.number());
            cylinder(&CylinderRecord::with_unit_axis(center, radius, axis, of.number()))
        },
        "cylinder_seen_from" => |_, mut of| {
            let view = of.cylinder().seen_from(of.vector());
            join([vector(view.from_axis), number(view.c)])
        },
        "cylinder_quadratic" => |_, mut of| {
            let (cylinder, zero) = (of.cylinder(), T::of(0.0));
            let view = CylinderView { from_axis: of.vector(), c: of.number(), squares: zero, along: zero };
            let (a, h, discriminant) = cylinder.quadratic(&view, of.vector());
            join([number(a), number(h), number(discriminant)])
        },
        "cylinder_within_height" => |_, mut of| flag(of.cylinder().within_height(&of.ray(), of.number())),
        "cylinder_cap" => |_, mut of| {
            let (cylinder, ray) = (of.cylinder(), of.ray());
            root(cap::intersect(of.vector(), cylinder.axis, cylinder.radius, &ray))
        },
        "cylinder_outward" => |_, mut of| {
            let (cylinder, part) = (of.cylinder(), of.part());
            vector(cylinder.outward(part, of.vector()))
        },
        "cylinder_intersect" => |_, mut of| part_of_cylinder(of.cylinder().intersect(&of.ray())),
        "scatter_matte" => |_, mut of| vector(scatter::scatter_around(of.vector(), of.vector(), T::of(NEGLIGIBLE))),
        "scatter_reflect" => |_, mut of| vector(reflection::reflect(of.vector(), of.vector())),
        "scatter_mirror" => |_, mut of| vector(reflection::mirror(of.vector(), of.vector())),
        "scatter_metal" => |_, mut of| vector(reflection::mirror(of.vector(), of.vector()) + of.vector()),
        "scatter_index_ratio" => |_, mut of| {
            let index = of.number();
            number(if of.flag() { T::of(1.0) / index } else { index })
        },
        "scatter_refract" => |_, mut of| vector(refraction::refract(of.vector(), of.vector(), of.number())),
        "bounce_attenuates" => |_, mut of| flag(of.material().kind != Kind::Refractive),
        "bounce_ray" => |_, mut of| {
            let (incoming, hit) = (of.ray(), of.hit());
            ray(scattered(&incoming, &hit, &of.material(), of.vector()))
        },
        "camera_ray" => |_, mut of| {
            let (position, origin) = (of.vector(), of.vector());
            let camera = Camera { position, origin, delta_x: of.vector(), delta_y: of.vector() };
            ray(camera.ray(of.number(), of.number(), [of.number(), of.number()]))
        },
        "picture_camera" => |picture, _| {
            let camera = &picture?.camera;
            join([camera.position, camera.origin, camera.delta_x, camera.delta_y].map(vector))
        },
        "picture_background" => |picture, _| {
            let background = &picture?.background;
            join([background.dark, background.light].map(vector))
        },
        "background_color" => |_, mut of| {
            let background = Background { dark: of.vector(), light: of.vector() };
            vector(background.color(of.vector()))
        },
        "material_load" => |_, mut of| {
            let PackedMaterial { reflectance, index, extent, kind } = of.material();
            let kind = number(T::of(f64::from(kind as u32)));
            join([vector(reflectance), number(index), number(extent), kind])
        },
        "closest_hit" => |picture, mut of| {
            let Some(found) = picture?.closest_hit(&of.ray()) else { return flag(false) };
            let numbers = [found.material, found.order, found.part].map(|number| T::of(f64::from(number)));
            let [material, order, part] = numbers.map(number);
            join([flag(true), hit(&found.hit), material, number(found.lambda), order, part])
        },
        "exact_two_sum" => |_, mut of| {
            let (sum, error) = two_sum(of.number(), of.number());
            join([number(sum), number(error)])
        },
        // A word has 32 bits in each half, which f32 does not hold.
        "uniform_canonical" => |_, mut of| number(of.canonical()?),
        "uniform_draw" => |_, mut of| {
            let canonical = of.canonical()?;
            let (low, high) = (of.number(), of.number());
            number(canonical * (high - low) + low)
        },
        _ => return None,
    })
}

/// Returns the numbers of a whole result, `None` if one of its parts is `None`.
fn join<T, const N: usize>(parts: [Option<Numbers<T>>; N]) -> Option<Numbers<T>> {
    let mut numbers = Vec::new();
    for part in parts {
        numbers.extend(part?);
    }
    Some(numbers)
}

fn number<T>(number: T) -> Option<Numbers<T>> {
    Some(vec![Some(number)])
}

fn flag<T: Float>(flag: bool) -> Option<Numbers<T>> {
    number(T::of(if flag { 1.0 } else { 0.0 }))
}

fn vector<T: Float>(vector: Vec3<T>) -> Option<Numbers<T>> {
    Some(vector.to_array().map(Some).to_vec())
}

fn ray<T: Float>(ray: Ray<T>) -> Option<Numbers<T>> {
    join([vector(ray.origin), vector(ray.direction)])
}

fn hit<T: Float>(hit: &Hit<T>) -> Option<Numbers<T>> {
    join([vector(hit.point), vector(hit.normal), flag(hit.front)])
}

fn sphere<T: Float>(sphere: &SphereRecord<T>) -> Option<Numbers<T>> {
    join([vector(sphere.center), number(sphere.radius), number(sphere.radius_squared)])
}

fn cylinder<T: Float>(cylinder: &CylinderRecord<T>) -> Option<Numbers<T>> {
    let vectors = join([cylinder.center, cylinder.axis, cylinder.top, cylinder.bottom].map(vector));
    let numbers = join([cylinder.radius, cylinder.radius_squared, cylinder.half_height].map(number));
    join([vectors, numbers])
}

/// Returns a `Root`. The lambda of a miss has no meaning.
fn root<T: Float>(lambda: Option<T>) -> Option<Numbers<T>> {
    join([flag(lambda.is_some()), Some(vec![lambda])])
}

/// Returns a `CylinderRoot`. Lambda and part of a miss have no meaning.
fn part_of_cylinder<T: Float>(found: Option<(T, CylinderPart)>) -> Option<Numbers<T>> {
    join([root(found.map(|(lambda, _)| lambda)), Some(vec![found.map(|(_, part)| part.number())])])
}

/// Returns the rounded sum of two numbers and its rounding error. `sum + error` is exactly `a + b`, unless the sum
/// overflows (Knuth, TAOCP 4.2.2, theorem B).
pub fn two_sum<T: Real>(a: T, b: T) -> (T, T) {
    let sum = a + b;
    let b_part = sum - a;
    let a_part = sum - b_part;
    (sum, (a - a_part) + (b - b_part))
}
