//! The mutants of the exact intersections.

use super::super::Mutant;
use super::mutants;

mutants! {
    "exact/error_free":
        "exact_mul_add(-c, d, product)" => "real(0.0)",
        "exact_two_sum(a.x, -b.x)" => "exact_two_sum(a.x, b.x)",
        "large - (large - a)" => "large - large",
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
        "(zz.error - rr.error)" => "zz.error",
        "sums + products" => "products",
        "terms.h * terms.h - terms.a" => "terms.h * terms.h + terms.a",
        "+ exact_cross(terms.r_c.error, terms.direction)" => "",
        "of_radius - of_distance" => "of_radius + of_distance",
        "if near.certain" => "if false",
        "abs(terms.h) + root" => "abs(terms.h) - root",
        "terms.length < w * real(4096.0)" => "true",
        "root * w * real(4096.0)" => "root * w * real(8192.0)",
        "c + error_of_c < w * limits.least" => "false",
        "zero < sign" => "zero < terms.h",
        "terms.h < zero ||" => "zero < terms.h ||",
    ;
    "exact/double_double":
        "b - (high - a)" => "(high - a) - b",
        "high.error + low.sum" => "low.sum",
        "sum.low + low.error" => "sum.low",
        "exact_mul_add(a.high, b.low, a.low * b.low)" => "a.high * b.low",
        "exact_mul_add(b.low, high, exact.error)" => "exact.error",
        "(a.low - product.low)" => "a.low",
        "(high + high)" => "high",
        "a.low < b.low" => "b.low < a.low",
        "dd3_sub(v, dd3_scaled" => "dd3_add(v, dd3_scaled",
    ;
    "exact/precise_bound":
        "dd_less(bound.error, dd_neg(discriminant))" => "dd_less(bound.error, discriminant)",
        "dd_add(precise_least_lambda(), dd_of(limits.lambda_error))" => "precise_least_lambda()",
        "real(-1.0842021724855044e-19)" => "real(0.0)",
        "dd_of(share * real(4.0))" => "dd_of(share)",
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
        "!first.certain || first.some" => "first.some",
    ;
    "exact/compensated_cylinder":
        "+ exact_cross(difference.error, axis)" => "",
        "- cylinder.radius_squared * axis_squared" => "- cylinder.radius_squared",
        "h * h - a * c" => "h * h + a * c",
        "select(-axis, axis, is_top)" => "axis",
        "(second.sum + rest)" => "second.sum",
        "/ (cylinder.half_height * real(4.0))" => "/ (cylinder.half_height * real(2.0))",
        "plain.fails || plain.accurate" => "true",
    ;
    "exact/order":
        "real(1.000000001862645149230957)" => "real(1.0)",
        "real(5.551115123125783e-17)" => "real(0.0)",
    ;
    "exact/precise_side":
        "dd_less(dd3_dot(v, v), dd_of(SHORT_SQUARED))" => "false",
        "dd_of(real(2.0))" => "dd_of(real(4.0))",
        "real(1.1102230246251565e-16)" => "real(1.1102230246251565e-10)",
        "dd_add(side.along, dd_mul" => "dd_sub(side.along, dd_mul",
        "dd_less(beyond, dd_neg(along))" => "dd_less(beyond, along)",
    ;
    "exact/precise_cylinder":
        "dd_less(slope, dd_of(real(0.0)))" => "false",
        "dd_add(dd_neg(side.h), root)" => "dd_add(side.h, root)",
        "dd_sub(cylinder.radius, margin)" => "dd_add(cylinder.radius, margin)",
        "select(BOTTOM, TOP, down)" => "select(TOP, BOTTOM, down)",
        "half = dd_neg(half)" => "half = half",
    ;
}
