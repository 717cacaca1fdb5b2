//! The list of the mutants, module by module.

use super::Mutant;

macro_rules! mutants {
    ($($module:literal: $($from:literal => $to:literal,)*;)*) => {
        /// All mutants that the checks must notice.
        pub const MUTANTS: &[Mutant] = &[$($(Mutant { module: $module, from: $from, to: $to },)*)*];
    };
}

mutants! {
    "vec3":
        "+ a.z * b.z" => "- a.z * b.z",
        "a.x * b.x + a.y * b.y + a.z * b.z" => "a.x * b.x + (a.y * b.y + a.z * b.z)",
        "sqrt(vec3_dot(v, v))" => "vec3_dot(v, v)",
        "v / vec3_length(v)" => "v * (real(1.0) / vec3_length(v))",
        "v - axis *" => "v + axis *",
        "abs(v.x) < limit" => "abs(v.x) <= limit",
        "abs(v.y) < limit &&" => "abs(v.y) < limit ||",
        "real(1e-8)" => "real(1e-9)",
    ;
    "exact":
        "let sum = a * one + b;" => "let sum = a + b;",
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
        "return lambda <= closest" => "return lambda < closest",
        "lambda < closest ||" => "lambda > closest ||",
        "order >= closest_order" => "order < closest_order",
    ;
    "cylinder":
        "unit.length / real(2.0)" => "unit.length / real(4.0)",
        "center - half_axis" => "center + half_axis",
        "- cylinder.radius_squared" => "+ cylinder.radius_squared",
        "h * h - a * view.c" => "h * h + a * view.c",
        "<= cylinder.half_height" => "< cylinder.half_height",
        "(-quadratic.h - root)" => "(quadratic.h - root)",
        "near_counts || far_counts" => "near_counts && far_counts",
        "<= cylinder.radius" => "< cylinder.radius",
        "abs(slope) < real(1e-8)" => "abs(slope) <= real(1e-8)",
        "center - ray.origin" => "center + ray.origin",
        "/ slope" => "* slope",
        "ray, cylinder.bottom" => "ray, cylinder.top",
        "return -cylinder.axis" => "return cylinder.axis",
        "!(quadratic.discriminant < real(0.0))" => "!(quadratic.discriminant <= real(0.0))",
        "tie_later_is_closer(top.lambda, closest.lambda)" => "top.lambda < closest.lambda",
        "tie_later_is_closer(bottom.lambda, closest.lambda)" => "bottom.lambda < closest.lambda",
    ;
    "projected":
        "direction * middle" => "direction + middle",
        "if rest < real(0.0)" => "if rest <= real(0.0)",
        "sqrt(rest / a)" => "sqrt(rest) / a",
        "middle - half, middle + half" => "middle + half, middle - half",
        "crossings.some && in_range(lambda)" => "crossings.some && in_range(crossings.near)",
        "near_counts || far_counts" => "near_counts && far_counts",
        "crossings.near, near_counts)" => "crossings.near, far_counts)",
        "ray, cylinder.top" => "ray, cylinder.bottom",
        "ray, cylinder.bottom" => "ray, cylinder.top",
        "tie_later_is_closer(top.lambda, closest.lambda)" => "top.lambda < closest.lambda",
        "tie_later_is_closer(bottom.lambda, closest.lambda)" => "bottom.lambda < closest.lambda",
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
        "if vec3_is_negligible" => "if !vec3_is_negligible",
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
        "sphere.radius, sphere.radius_squared" => "sphere.radius_squared, sphere.radius",
        "vec3_load(cylinder.bottom)" => "vec3_load(cylinder.top)",
        "vec3_load(picture.background.dark), vec3_load(picture.background.light)" => "vec3_load(picture.background.light), vec3_load(picture.background.dark)",
    ;
    "surface":
        "lambda, order, closest.lambda, closest.order" => "closest.lambda, closest.order, lambda, order",
        "closest.part, point" => "TOP, point",
    ;
    "closest_hit":
        "index < picture.sphere_count" => "index + 1u < picture.sphere_count",
    ;
    "hierarchy":
        "at = node.next" => "at = node.next + 1u",
        "select(low - margin, high + margin, is_backwards)" => "select(high + margin, low - margin, is_backwards)",
        "select(high + margin, low - margin, is_backwards)" => "select(low - margin, high + margin, is_backwards)",
        "leaves < enters" => "enters < leaves",
        "let index = node.object / 2u" => "let index = node.object",
        "f32(closest.lambda) * 1.0000002" => "f32(closest.lambda) * 0.5",
        "select(reciprocal, -reciprocal, component < 0.0)" => "reciprocal",
        "farthest = 3e38f" => "farthest = 1f",
    ;
    "trace":
        "depth < min(max_depth, picture.end_depth)" => "depth + 1u < min(max_depth, picture.end_depth)",
        "left - 1u" => "left",
        "material.index, hit.front" => "material.index, !hit.front",
        "vec3_store(vec3<real>())" => "vec3_store(vec3<real>(real(1.0)))",
        "attenuation_count = paths[slot].attenuation_count" => "attenuation_count = 0u",
        "paths[slot].ended != 0u" => "paths[slot].ended != 1u",
        "Ray(hit.point, direction)" => "Ray(ray.origin, direction)",
    ;
    "kernels/image":
        "pixel / picture.width" => "pixel % picture.width",
        "picture.first_pixel + id.x" => "picture.first_pixel",
    ;
    "exact/error_free":
        "large * exact_one - (large - a)" => "large * exact_one - large",
        "SPLIT_LIMIT < abs(a)" => "abs(a) < SPLIT_LIMIT",
        "(xs.high * ys.high - product)" => "(xs.high * ys.high + product)",
        "+ xs.low * ys.low;" => ";",
        "real(1.5)" => "real(0.5)",
        "is_tie && same_side" => "is_tie",
        "is_tie && same_side" => "same_side",
        "(zero < sum.error && zero < middle.error)" => "(zero < sum.error && middle.error < zero)",
    ;
    "exact/error_bound":
        "SHORTEST_SQUARED <= length_squared" => "true",
        "size * limits.error" => "size * limits.share",
        "bound.error < -discriminant" => "bound.error < discriminant",
        "(a * bound.limits.least - numerator)" => "(a * bound.limits.most + numerator)",
        "(share * real(4.0))" => "share",
        "least < root * numerator" => "least < root + numerator",
        "bound.limits.most <= lambda" => "bound.limits.least <= lambda",
    ;
    "exact/sphere":
        "real(3.552713678800501e-15)" => "real(3.552713678800501e-14)",
        "real(8.138020833333333e-05)" => "real(8.138020833333333e-04)",
        "vec3_dot(r_c, r_c) + sphere.radius_squared" => "vec3_dot(r_c, r_c)",
        "near.fails && far.hits" => "far.hits",
        "if far.fails" => "if near.fails",
    ;
    "exact/compensated":
        "sphere.center.x, -origin.x" => "sphere.center.x, origin.x",
        "(zz.error - rr.error)" => "zz.error",
        "sums + products" => "products",
        "abs(quadratic.h) + root" => "abs(quadratic.h) - root",
        "real(4096.0)" => "real(8192.0)",
        "real(7.105427357601002e-15)" => "real(7.105427357601002e-10)",
        "quadratic.h * terms.difference" => "quadratic.h",
    ;
    "exact/double_double":
        "b - (high - a)" => "(high - a) - b",
        "high.error + low.sum" => "low.sum",
        "sum.low + low.error" => "sum.low",
        "exact_mul_add(a.high, b.low, a.low * b.low)" => "a.high * b.low",
        "exact_mul_add(b.low, high, exact.error)" => "exact.error",
        "(a.low - product.low)" => "a.low",
        "sqrt(a.high) * exact_one" => "sqrt(a.high)",
        "(high + high)" => "high",
        "a.low < b.low" => "b.low < a.low",
        "dd3_sub(v, dd3_scaled" => "dd3_add(v, dd3_scaled",
    ;
    "exact/precise_bound":
        "dd_less(bound.error, dd_neg(discriminant))" => "dd_less(bound.error, discriminant)",
        "dd_add(dd_constant(real(1e-3)), dd_constant(limits.lambda_error))" => "dd_constant(real(1e-3))",
        "dd_constant(share * real(4.0))" => "dd_constant(share)",
        "dd_less(dd_add(size, square), dd_mul(root, numerator))" => "dd_less(size, dd_mul(root, numerator))",
    ;
    "exact/precise_sphere":
        "real(6.310887241768095e-30)" => "real(6.310887241768095e-28)",
        "dd_sub(distance_squared, radius_squared)" => "dd_add(distance_squared, radius_squared)",
        "dd_sub(h, root)" => "dd_add(h, root)",
        "near.fails && far.hits" => "far.hits",
    ;
    "exact/cylinder_side":
        "real(2.1316282072803006e-14)" => "real(2.1316282072803006e-12)",
        "real(3.725290298461914e-09)" => "real(3.725290298461914e-06)",
        "real(274877906944.0)" => "real(2748779.0)",
        "side.along + crossing.lambda" => "side.along - crossing.lambda",
        "hits && abs(side.along) < within" => "hits",
        "accurate && beyond < -along" => "accurate && beyond < along",
        "crossing.behind || crossing.above" => "crossing.above",
        "leaving.behind ||" => "entry.behind ||",
    ;
    "exact/cap":
        "steepness + slope_error < real(1e-8)" => "steepness < real(1e-9)",
        "select(to_plane, -to_plane, slope < real(0.0))" => "to_plane",
        "real(262144.0)" => "real(262.0)",
        "from_center < cylinder.radius - margin" => "from_center < cylinder.radius + margin",
        "cylinder.radius + margin < from_center" => "cylinder.radius - margin < from_center",
    ;
    "exact/cylinder":
        "entry.behind && leaving.straight" => "leaving.straight",
        "-side.h - root" => "side.h - root",
        "cylinder.center - along" => "cylinder.center + along * real(2.0)",
        "select(BOTTOM, TOP, down)" => "select(TOP, BOTTOM, down)",
        "!facing.certain || facing.some" => "facing.some",
    ;
    "exact/precise_side":
        "dd_less(dd3_dot(v, v), dd_constant(SHORT_SQUARED))" => "false",
        "dd_constant(real(2.0))" => "dd_constant(real(4.0))",
        "real(1.1102230246251565e-16)" => "real(1.1102230246251565e-10)",
        "dd_add(side.along, dd_mul" => "dd_sub(side.along, dd_mul",
        "dd_less(beyond, dd_neg(along))" => "dd_less(beyond, along)",
    ;
    "exact/precise_cylinder":
        "dd_less(slope, dd_constant(real(0.0)))" => "false",
        "dd_add(dd_neg(side.h), root)" => "dd_add(side.h, root)",
        "dd_sub(cylinder.radius, margin)" => "dd_add(cylinder.radius, margin)",
        "select(BOTTOM, TOP, down)" => "select(TOP, BOTTOM, down)",
        "half = dd_neg(half)" => "half = half",
    ;
}
