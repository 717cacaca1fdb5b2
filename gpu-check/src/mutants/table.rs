//! The lists of the mutants, module by module.

pub(super) mod exact;

use super::Mutant;

macro_rules! mutants {
    ($($module:literal: $($from:literal => $to:literal,)*;)*) => {
        pub const MUTANTS: &[Mutant] = &[$($(Mutant { module: $module, from: $from, to: $to },)*)*];
    };
}
use mutants;

mutants! {
    "vec3":
        "+ a.z * b.z" => "- a.z * b.z",
        "a.x * b.x + a.y * b.y + a.z * b.z" => "a.x * b.x + (a.y * b.y + a.z * b.z)",
        "sqrt(vec3_dot(v, v))" => "vec3_dot(v, v)",
        "v / vec3_length(v)" => "v * (real(1.0) / vec3_length(v))",
        "v - axis *" => "v + axis *",
        "abs(v.x) < limit" => "abs(v.x) <= limit",
        "(abs(v.y) < limit) &" => "(abs(v.y) < limit) |",
        "real(1e-8)" => "real(1e-9)",
    ;
    "exact":
        "let sum = a + b;" => "let sum = a - b;",
        "sum - b_part" => "sum + b_part",
        "(a - a_part) + (b - b_part)" => "b - b_part",
    ;
    "ray":
        "+ ray.direction * lambda" => "- ray.direction * lambda",
        "real(1e-3) <= lambda" => "real(1e-3) < lambda",
        "real(1e-3)" => "real(1e-4)",
        "< real(0.0)" => "<= real(0.0)",
        "-outward" => "outward",
    ;
    "sphere":
        "radius * radius" => "radius + radius",
        "sphere.center - origin" => "origin - sphere.center",
        "- sphere.radius_squared" => "+ sphere.radius_squared",
        "h * h - a * view.c" => "h * h + a * view.c",
        "(h - root) / a" => "(h + root) / a",
        "select(far, near, in_range(near))" => "select(near, far, in_range(near))",
        "Root(in_range(lambda), lambda)" => "Root(in_range(near), lambda)",
        "(point - sphere.center) / sphere.radius" => "(point - sphere.center) * sphere.radius",
        "quadratic.discriminant < real(0.0)" => "quadratic.discriminant <= real(0.0)",
    ;
    "unit_and_length":
        "vec3_dot(v, v) < SHORT_SQUARED" => "vec3_dot(v, v) < real(0.0)",
        "length * SHORT_SQUARED" => "length * SHORT_SCALE",
    ;
    "tie":
        "return lambda < closest" => "return lambda <= closest",
        "(lambda < closest) |" => "(lambda > closest) |",
        "lambda <= closest" => "lambda < closest",
        "rank >= closest_rank" => "rank < closest_rank",
        "-1 - i32(order)" => "i32(order)",
    ;
    "cylinder":
        "unit.length / real(2.0)" => "unit.length / real(4.0)",
        "center - to_cap" => "center + to_cap",
        "- cylinder.radius_squared" => "+ cylinder.radius_squared",
        "h * h - a * view.c" => "h * h + a * view.c",
        "<= cylinder.half_height" => "< cylinder.half_height",
        "(-quadratic.h - root)" => "(quadratic.h - root)",
        "near_counts | far_counts" => "near_counts & far_counts",
        "<= cylinder.radius" => "< cylinder.radius",
        "abs(slope) < real(1e-8)" => "abs(slope) <= real(1e-8)",
        "center - ray.origin" => "center + ray.origin",
        "/ slope" => "* slope",
        "ray, cylinder.top)" => "ray, cylinder.bottom)",
        "ray, cylinder.bottom)" => "ray, cylinder.top)",
        "select(-cylinder.axis, cylinder.axis" => "select(cylinder.axis, cylinder.axis",
        "!(quadratic.discriminant < real(0.0))" => "!(quadratic.discriminant <= real(0.0))",
        "tie_later_cap_is_closer(later.lambda, closest.lambda)" => "later.lambda <= closest.lambda",
        "closest.some | later.some" => "later.some",
        "bottom, BOTTOM" => "bottom, TOP",
    ;
    "projected":
        "direction * middle" => "direction + middle",
        "if rest < real(0.0)" => "if rest <= real(0.0)",
        "sqrt(rest / a)" => "sqrt(rest) / a",
        "middle - half, middle + half" => "middle + half, middle - half",
        "crossings.some && in_range(lambda)" => "crossings.some && in_range(crossings.near)",
        "near_counts || far_counts" => "near_counts && far_counts",
        "crossings.near, near_counts)" => "crossings.near, far_counts)",
    ;
    "camera":
        "(column + x)" => "(column - x)",
        "camera.delta_y * (row + y)" => "camera.delta_y * (row)",
        "window_point - camera.position" => "window_point",
    ;
    "background":
        "direction.y" => "direction.x",
        "/ real(2.0)" => "/ real(3.0)",
        "(real(1.0) - m) + background.dark * m" => "(real(1.0) - m) - background.dark * m",
    ;
    "scatter":
        "normal + vector" => "normal - vector",
        "select(direction, normal, vec3" => "select(normal, direction, vec3",
        "direction - normal *" => "direction + normal *",
        "* real(2.0)" => "* real(1.0)",
        "vec3_unit(scatter_reflect(direction, normal))" => "scatter_reflect(direction, normal)",
        "scatter_mirror(direction, normal) + vector" => "scatter_mirror(direction, normal) - vector",
        "select(index, real(1.0) / index, front)" => "select(real(1.0) / index, index, front)",
        "real(1.0) / index" => "index",
        "let product = -vec3_dot" => "let product = vec3_dot",
        "product < one" => "product > one",
        "one - cos * cos" => "one + cos * cos",
        "sqrt(abs(one - vec3_dot(p, p)))" => "sqrt(one - vec3_dot(p, p))",
        "one < ratio * sin" => "one <= ratio * sin",
        "select(refracted, reflected, beyond)" => "select(reflected, refracted, beyond)",
    ;
    "material":
        "METAL: u32 = 1u" => "METAL: u32 = 3u",
    ;
    "layout":
        "vec3<real>(v.x, v.y, v.z)" => "vec3<real>(v.x, v.z, v.y)",
        "PackedVec3(v.x, v.y, v.z)" => "PackedVec3(v.x, v.y, v.x)",
        "vec3_store(ray.direction)" => "vec3_store(ray.origin)",
        "vec3_load(ray.direction)" => "vec3_load(ray.origin)",
    ;
    "picture":
        "vec3_load(sphere.center), sphere.radius" => "vec3_load(sphere.center), real(1.0)",
        "cylinder.radius, axis, cylinder.half_height" => "cylinder.half_height, axis, cylinder.radius",
        "material.index, material.extent" => "material.index, real(1.0)",
        "vec3_load(picture.background.dark), vec3_load(picture.background.light)" => "vec3_load(picture.background.light), vec3_load(picture.background.dark)",
    ;
    "surface":
        "lambda, rank, closest.lambda, closest_rank" => "closest.lambda, closest_rank, lambda, rank",
        "tie_rank(order, part != SIDE)" => "tie_rank(order, part == SIDE)",
        "closest.part, point" => "TOP, point",
    ;
    "every_object":
        "index < picture.sphere_count" => "index + 1u < picture.sphere_count",
        "index < picture.cylinder_count" => "index + 1u < picture.cylinder_count",
    ;
    "closest_hit":
        "intersect_every_object(ray), ray" => "ClosestHit(), ray",
    ;
    "hierarchy":
        "at = node.next" => "at = node.next + 1u",
        "select(low, high, ray.is_backwards)" => "select(high, low, ray.is_backwards)",
        "select(high, low, ray.is_backwards)" => "select(low, high, ray.is_backwards)",
        "!(leaves < enters)" => "leaves < enters",
        "let index = node.object / 2u" => "let index = node.object",
        "f32(closest.lambda) * 1.0000002" => "f32(closest.lambda) * 0.5",
        "select(reciprocal, -reciprocal, component < 0.0)" => "reciprocal",
        "farthest = 3e38f" => "farthest = 1f",
        "enlarged + hierarchy.point" => "hierarchy.point",
        "node.linear * distance" => "node.linear",
        "node.bend * square" => "node.bend * distance",
        "node.low_z) - margin" => "node.low_z)",
        "node.high_z) + margin" => "node.high_z)",
        "1e-28 < magnitude" => "1e-2 < magnitude",
        "node.object % 2u == 1u" => "node.object % 2u == 0u",
        "at = node.next" => "at = at + 2u",
        "near = select(low, high, ray.is_backwards) * ray.reciprocal" => "near = select(low, high, ray.is_backwards) / ray.reciprocal",
        "surface_at(intersect_every_object(ray), ray)" => "surface_at(closest, ray)",
    ;
    "bounce":
        "|| (has_metal" => "&& (has_metal",
        "left - 1u" => "left",
        "material.index, hit.front" => "material.index, !hit.front",
        "Ray(hit.point, direction)" => "Ray(ray.origin, direction)",
        "scatter_metal(ray.direction, hit.normal, scatter_vector)" => "scatter_mirror(ray.direction, hit.normal)",
        "scatter_matte(hit.normal, scatter_vector)" => "hit.normal + scatter_vector",
    ;
    "trace":
        "depth < min(max_depth, picture.end_depth)" => "depth + 1u < min(max_depth, picture.end_depth)",
        "var color = vec3<real>()" => "var color = vec3<real>(real(1.0))",
        "attenuation_count = paths[slot].attenuation_count" => "attenuation_count = 0u",
        "paths[slot].ended != 0u" => "paths[slot].ended != 1u",
    ;
    "uniform":
        "real(word.y) * real(4294967296.0) + real(word.x)" => "real(word.x) * real(4294967296.0) + real(word.y)",
        " + real(word.x)" => "",
        "real(18446744073709551616.0)" => "real(9223372036854775808.0)",
        "return select(BELOW_ONE, quotient, quotient < BELOW_ONE)" => "return quotient",
        "* (high - low) + low" => "* (high - low) - low",
        "* (high - low) + low" => "* high + low",
    ;
    "scatter_vectors":
        "STATEMENT: u32 = 1u" => "STATEMENT: u32 = 2u",
        "scatter_word(word), -half" => "scatter_word(word + 2u), -half",
        "scatter_word(word + 1u)" => "scatter_word(word + 2u)",
        "scatter_word(word + 2u)" => "scatter_word(word + 1u)",
        "scatter_word(word + 1u), -half, half" => "scatter_word(word + 1u), real(0.0), half",
        "scatter_vector_in_cube(word, extent)" => "scatter_vector_in_cube(word, real(1.0))",
        "extent), word + 3u" => "extent), word + 2u",
        "scatter_vector_in_cube(next, real(1.0))" => "scatter_vector_in_cube(next, extent)",
        "scatter_vector_in_cube(next," => "scatter_vector_in_cube(word,",
        "next += 3u" => "next += 1u",
        "LEAST_SQUARED < length_squared &&" => "",
        "length_squared <= real(1.0)" => "length_squared < real(1.0)",
        "length_squared <= real(1.0)" => "length_squared <= real(3.0)",
        "/ sqrt(length_squared)" => "/ length_squared",
        "vector / sqrt(length_squared) * extent" => "vector / sqrt(length_squared)",
        "vector / sqrt(length_squared) * extent" => "vector * extent",
        "tries < MAX_TRIES" => "tries + 1u < MAX_TRIES",
        "first + (index - first)" => "first + 1u + (index - first)",
    ;
    "trace_samples":
        "words[3u * slot], -half" => "words[3u * slot + 1u], -half",
        "words[3u * slot + 1u], -half" => "words[3u * slot], -half",
        "let half = real(0.5)" => "let half = real(1.0)",
        "(picture.first_sample + slot) /" => "slot /",
        "vec2<real>(x, y)" => "vec2<real>(y, x)",
        "let first_word = words[3u * slot + 2u].x" => "let first_word = words[2u].x",
        "let first = slot * max_depth" => "let first = 0u",
        "next_word = sample_paths[slot].next_word" => "next_word = first_word",
        "attenuation_count = sample_paths[slot].attenuation_count" => "attenuation_count = 0u",
        "sample_paths[slot].ended != 0u" => "sample_paths[slot].ended != 1u",
        "depth < min(max_depth, picture.end_depth)" => "depth + 1u < min(max_depth, picture.end_depth)",
        "if bounce_attenuates(material)" => "if material.kind == MATTE",
        "if bounce_attenuates(material)" => "if bounce_attenuates(material) && depth + 1u < max_depth",
        "scatter_vector_next(next_word, material.extent)" => "scatter_vector_next(next_word, real(1.0))",
        "vector = scatter_vector.vector" => "vector = scatter_vector.vector.zyx",
        "next_word = scatter_vector.next_word" => "next_word = next_word",
        "var color = vec3<real>()" => "var color = vec3<real>(real(1.0))",
        "vec3_store(color), next_word - first_word" => "vec3_store(color), next_word - first_word - 1u",
    ;
    "kernels/image":
        "pixel / picture.width" => "pixel % picture.width",
        "picture.first_pixel + id.x" => "picture.first_pixel",
    ;
    "kernels/means":
        "samples[sample - accumulation.first_sample]" => "samples[end - 1u - sample + begin - accumulation.first_sample]",
        "samples[sample - accumulation.first_sample]" => "samples[sample]",
        "var sample = begin" => "var sample = begin + 1u",
        "sample < end" => "sample + 1u < end",
        "accumulation.starts[min(id.x, 1u)]" => "accumulation.starts[1u]",
        "accumulation.starts[min(id.x, 1u)]" => "accumulation.starts[0u]",
        "if end == pixel_end" => "if end <= pixel_end",
        "sum / real(accumulation.samples_per_pixel)" => "sum * (real(1.0) / real(accumulation.samples_per_pixel))",
    ;
}
