//! The calls along a path in Rust: the functions that `trace_path` calls, with the arguments that it passes.

use cpu::{Ray, Vec3};

use super::calls::{Call, Tracer};
use super::{FirstDifference, Unequal, rest};
use crate::{Float, Picture};

/// Returns the first call along the path of the pixel at `index` whose arguments differ from those in Rust.
pub fn first_other_arguments<T: Float>(
    picture: &Picture<T>,
    index: usize,
    tracer: &Tracer<'_, T>,
    calls: &[Call<T>],
) -> Option<FirstDifference<T>> {
    let expected = expected(picture, index);
    let functions = &tracer.trace().functions;
    let on_path = |call: &&Call<T>| call.depth == 1 && NAMES.contains(&&functions[call.function].name[..]);
    expected.iter().zip(calls.iter().filter(on_path)).find_map(|((name, expected), call)| {
        let function = &functions[call.function];
        // Another function than in Rust is called: the difference is in what stands between the calls.
        if function.name != *name || expected.len() != call.arguments.len() {
            return Some(rest(tracer, calls));
        }
        let place = expected.iter().zip(&call.arguments).position(|(one, other)| !one.same(*other))?;
        let (cpu, wgsl) = (expected[place], call.arguments[place]);
        let number = Unequal { name: function.arguments[place].name.clone(), cpu, wgsl };
        Some(FirstDifference::Arguments { function: function.name.clone(), number })
    })
}

/// Names of the functions whose arguments are compared.
const NAMES: [&str; 4] = ["camera_ray", "closest_hit", "bounce_ray", "background_color"];

/// Returns the names of the functions that are called along a path, and their arguments.
fn expected<T: Float>(picture: &Picture<T>, index: usize) -> Vec<(&'static str, Vec<T>)> {
    let zero = T::of(0.0);
    let width = picture.size.width();
    let [row, column] = [index / width, index % width].map(|number| T::of(number as f64));
    let camera = &picture.camera;
    let mut ray = camera.ray(row, column, [zero; 2]);
    let vectors = [camera.position, camera.origin, camera.delta_x, camera.delta_y].map(Vec3::to_array);
    let mut calls = vec![("camera_ray", [&vectors.concat()[..], &[row, column, zero, zero]].concat())];
    for _ in 0..picture.max_depth {
        calls.push(("closest_hit", of_ray(&ray)));
        let Some(surface) = picture.closest_hit(&ray) else {
            let background = [picture.background.dark, picture.background.light, ray.direction].map(Vec3::to_array);
            calls.push(("background_color", background.concat()));
            break;
        };
        let material = picture.materials[surface.material as usize];
        let front = T::of(if surface.hit.front { 1.0 } else { 0.0 });
        let mut arguments = of_ray(&ray);
        arguments.extend([surface.hit.point, surface.hit.normal].map(Vec3::to_array).concat());
        arguments.push(front);
        arguments.extend(material.reflectance.to_array());
        arguments.extend([material.index, material.extent, T::of(f64::from(material.kind as u32)), zero, zero, zero]);
        calls.push(("bounce_ray", arguments));
        ray = picture.scatter_ray(&ray, &surface, Vec3::splat(zero));
    }
    calls
}

fn of_ray<T: Float>(ray: &Ray<T>) -> Vec<T> {
    [ray.origin, ray.direction].map(Vec3::to_array).concat()
}
