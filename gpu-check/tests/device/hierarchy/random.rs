//! Random scenes and rays on which a hierarchy may fail: rays that graze small objects, or that start far away.

use cpu::internals::sampling::uniform::Uniform;
use cpu::{Ray, Scene, Vec3};

use gpu_check::{Error, Float, Picture};

use crate::kernels::special;

/// Returns a scene of about 300 objects of very different sizes. Every third scene has a ground sphere.
///
/// # Errors
/// [`Error::Scene`] if the scene is refused, which never happens.
pub fn scene(draws: &mut Uniform, number: usize) -> Result<Scene, Error> {
    let mut text = String::from("matte: m .5 .5 .5\n");
    for _ in 0..300 {
        let center = special::in_cube(draws, 10.0);
        let radius = special::of_any_size(draws, -2.5, 0.3).abs();
        if draws.canonical() < 0.5 {
            text.push_str(&format!("sphere: {} {} {} {radius} m\n", center.x, center.y, center.z));
        } else {
            let mut axis = special::direction(draws) * special::of_any_size(draws, -2.0, 0.5).abs();
            if draws.canonical() < 0.2 {
                axis = Vec3::new(0.0, axis.length(), 0.0);
            }
            let [x, y, z] = axis.to_array();
            text.push_str(&format!("cylinder: {} {} {} {radius} {x} {y} {z} m\n", center.x, center.y, center.z));
        }
    }
    if number.is_multiple_of(3) {
        text.push_str("sphere: 0 -1010 0 1000 m\n");
    }
    Ok(Scene::parse(text.as_bytes())?)
}

/// Returns a ray that starts anywhere or on an object, and aims past the middle of an object by about its radius.
pub fn ray<T: Float>(draws: &mut Uniform, picture: &Picture<T>) -> Ray<T> {
    let objects = picture.spheres.len() + picture.cylinders.len();
    let mut object = || {
        let index = (draws.canonical() * objects as f64) as usize;
        let (center, radius) = match index.checked_sub(picture.spheres.len()) {
            None => (picture.spheres[index].record.center, picture.spheres[index].record.radius),
            Some(index) => (picture.cylinders[index].record.center, picture.cylinders[index].record.radius),
        };
        (center.map(Float::wide), radius.wide())
    };
    let ((from, from_radius), (center, radius)) = (object(), object());
    let origin = match draws.canonical() {
        place if place < 0.3 => from + special::direction(draws) * from_radius,
        place if place < 0.98 => special::in_cube(draws, 12.0),
        // Far away from all objects.
        _ => special::in_cube(draws, 1e4),
    };
    let off = match draws.canonical() {
        aim if aim < 0.5 => 1.0 + special::of_any_size(draws, -17.0, -1.0),
        _ => draws.canonical() * 1.2,
    };
    let across = special::direction(draws).perpendicular_to((center - origin).unit());
    let direction = center + across.unit() * (radius * off) - origin;
    let size = if draws.canonical() < 0.05 { special::of_any_size(draws, -9.0, 17.0).abs() } else { 1.0 };
    Ray { origin: origin.map(T::of), direction: (direction * size).map(T::of) }
}
