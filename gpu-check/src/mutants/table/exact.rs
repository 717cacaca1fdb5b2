//! The mutants of the exact intersections.

use super::super::Mutant;
use super::mutants;

mutants! {
    "exact/error_free":
        "exact_mul_add(-c, d, product)" => "real(0.0)",
        "exact_two_sum(a.x, -b.x)" => "exact_two_sum(a.x, b.x)",
        "large - (large - a)" => "large - large",
        "SPLIT_LIMIT < abs(a)" => "abs(a) < SPLIT_LIMIT",
        "SPLIT_LIMIT < abs(b)" => "abs(b) < SPLIT_LIMIT",
        "(xs.high * ys.high - product)" => "(xs.high * ys.high + product)",
        "+ xs.low * ys.low;" => ";",
        "real(1.5)" => "real(0.5)",
        "is_tie && same_side" => "is_tie",
        "is_tie && same_side" => "same_side",
        "(zero < sum.error && zero < middle.error)" => "(zero < sum.error && middle.error < zero)",
        "difference.error + (left.error - right.error)" => "difference.error",
        "+ more);" => ");",
    ;
    "exact/error_bound":
        "whole < ERROR_OVERFLOW" => "true",
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
    "exact/compensated_roots":
        "quadratic.h * quadratic.h - quadratic.a" => "quadratic.h * quadratic.h + quadratic.a",
        "(zz.error - s.error)" => "zz.error",
        "second.error + difference.error) + of_squares" => "second.error + difference.error)",
        "(abs(quadratic.c) + lost)" => "abs(quadratic.c)",
        "abs(h) + root" => "abs(h) - root",
        "quadratic.terms_of_h < w * real(4096.0)" => "true",
        "root * w * real(4096.0)" => "root * w * real(8192.0)",
        "error < discriminant.value" => "real(0.0) < discriminant.value",
        "error_of_c * real(2199023255552.0) < c" => "true",
        "(size / root + quadratic.terms_of_h)" => "(size / root)",
        "error < -discriminant.value" => "real(0.0) < -discriminant.value",
        "zero < signed_c" => "zero < h",
        "c + error_of_c < w * limits.least" => "false",
        "let backward = h < zero" => "let backward = zero < h",
        "exact_sphere_limits().most <= lambda" => "true",
    ;
    "exact/compensated_sphere":
        "+ exact_cross(terms.r_c.error, terms.direction)" => "",
        "of_radius - of_distance" => "of_radius + of_distance",
        "if near.certain" => "if false",
        "roots.small_fails && roots.large_fails" => "roots.small_fails",
        "roots.accurate && roots.small_is_ahead" => "roots.small_is_ahead",
        "roots.small_fails && real(0.0)" => "real(0.0)",
    ;
    "exact/cylinder_side":
        "real(2.1316282072803006e-14)" => "real(2.1316282072803006e-12)",
        "real(3.725290298461914e-09)" => "real(3.725290298461914e-06)",
        "real(17179869184.0)" => "real(2748779.0)",
        "start + lambda * slope" => "start - lambda * slope",
        "hits && abs(start) < within" => "hits",
        "accurate && beyond < -along" => "accurate && beyond < along",
        "crossing.behind || crossing.above" => "crossing.above",
        "cylinder.radius * real(8.0) < cylinder.half_height" => "false",
        "error_bound_misses(error_bound_of_size(exact_cylinder_limits(), squares, squares, squares), c)" => "c < real(0.0)",
        "c + cylinder.radius_squared + cylinder.radius_squared" => "c + cylinder.radius_squared",
        "(length_squared * across + a * squares)" => "(length_squared * across)",
        "whole * real(5.684341886080802e-14)" => "whole",
        "+ LEAST_SIZE" => "",
        "-side.h - root" => "side.h - root",
        "leaving.behind ||" => "entry.behind ||",
    ;
    "exact/cap":
        "steepness + slope_error < real(1e-8)" => "steepness < real(1e-9)",
        "select(to_plane, -to_plane, slope < real(0.0))" => "to_plane",
        "real(262144.0)" => "real(262.0)",
        "lambda * plane.error" => "lambda",
        "from_center < cylinder.radius - margin" => "from_center < cylinder.radius + margin",
        "cylinder.radius + margin < from_center" => "cylinder.radius - margin < from_center",
    ;
    "exact/cylinder":
        "entry.behind && leaving.straight" => "leaving.straight",
        "if crossings.misses" => "if false",
        "ExactWithoutCaps(inside, decision_uncertain())" => "ExactWithoutCaps(true, decision_uncertain())",
        "ExactWithoutCaps(inside, decision_uncertain())" => "ExactWithoutCaps(false, decision_uncertain())",
        "if last.certain && !last.some" => "if false",
        "cylinder.center - along" => "cylinder.center + along * real(2.0)",
        "select(BOTTOM, TOP, down)" => "select(TOP, BOTTOM, down)",
        "!first.certain || first.some" => "first.some",
    ;
    "exact/compensated_cylinder":
        "rr.sum * sum_error + rr.error * second.sum" => "rr.sum * sum_error",
        "product.error + (" => "(",
        "(first.error + second.error) + (xx.error" => "(xx.error",
        "parts.rounded + parts.error" => "parts.rounded",
        "far * real(8.077935669463161e-28)" => "far",
        "+ vec3_dot(difference.error, p)" => "",
        "abs(aside) * sqrt(reach)" => "abs(aside)",
        "-vec3_dot(q, p)" => "vec3_dot(q, p)",
        "far * real(4.0)" => "far * real(1e30)",
        "(of_radius - aside * aside)" => "(of_radius + aside * aside)",
        "!(discriminant.size < terms.far.size)" => "terms.far.size < real(0.0)",
        "!(discriminant.size < terms.far.size)" => "true",
        "lambda_small * relative + (" => "(",
        "lambda_large * relative)" => "lambda_large)",
        "accurate && roots.small_is_ahead" => "accurate",
        "accurate && !backward" => "accurate",
        "if backward {" => "if false {",
        "select(-axis, axis, is_top)" => "axis",
        "(second.sum + rest)" => "second.sum",
        "/ (cylinder.half_height * real(4.0))" => "/ (cylinder.half_height * real(2.0))",
        "real(9.094947017729282e-13)" => "real(1.0)",
        "of_distance + of_slope" => "of_distance",
        "!exact_is_long(cylinder) && inside" => "true",
        "exact_is_inside(view.c, exact_squares(cylinder, ray.origin))" => "true",
        "select(cylinder.bottom, cylinder.top, down)" => "select(cylinder.top, cylinder.bottom, down)",
    ;
    "exact/order":
        "real(1.000000001862645149230957)" => "real(1.0)",
    ;
}
