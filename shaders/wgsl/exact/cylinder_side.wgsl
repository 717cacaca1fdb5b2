// The side of a cylinder with its error bound; twin of the side in cpu/src/exact/cylinder_parts.rs.

// LIMITS: the error constant 192 times 2^-53, the reciprocal of the condition limit 65,536, and 10^-3 times one minus
// and plus 256 * 65,536 * 2^-53.
fn exact_cylinder_limits() -> Limits {
    let error = real(2.1316282072803006e-14);
    return Limits(error, real(1.52587890625e-05), real(0.0009999999981373548), real(0.0010000000018626453));
}

// magnitude: returns the sum of the components' magnitudes, which is at least the length.
fn exact_magnitude(v: vec3<real>) -> real {
    return abs(v.x) + abs(v.y) + abs(v.z);
}

// extent_of_axis: returns an upper bound of the coordinates of points on the axis.
fn exact_extent_of_axis(cylinder: CylinderRecord) -> real {
    return exact_magnitude(cylinder.center) + cylinder.half_height + EXTENT_UNDERFLOW;
}

// margin: returns a bound of the distance by which rounding moves the ray's point at an accepted lambda. The factors
// are 512 * 65,536 * 2^-53 and 64 * 2^-53.
fn exact_cylinder_margin(cylinder: CylinderRecord, ray: Ray, lambda: real) -> real {
    let along = lambda * exact_magnitude(ray.direction) * real(3.725290298461914e-09);
    return along + (exact_extent_of_axis(cylinder) + cylinder.radius) * real(7.105427357601002e-15);
}

// Side: the quadratic of one ray and an infinite cylinder, with its bound.
struct ExactSide {
    bound: ErrorBound,
    length_squared: real,
    a: real,
    a_is_accurate: bool,
    h: real,
    discriminant: real,
    // How far the ray's origin is above the middle, along the axis, and how fast the ray rises.
    along: real,
    slope: real,
}

// Side::new
fn exact_side_new(cylinder: CylinderRecord, ray: Ray) -> ExactSide {
    let from_center = ray.origin - cylinder.center;
    let quadratic = cylinder_quadratic(cylinder, cylinder_seen_from(cylinder, ray.origin), ray.direction);
    let length_squared = vec3_dot(ray.direction, ray.direction);
    let squares = vec3_dot(from_center, from_center) + cylinder.radius_squared;
    let bound = error_bound_new(exact_cylinder_limits(), length_squared, squares);
    let along = vec3_dot(from_center, cylinder.axis);
    let slope = vec3_dot(ray.direction, cylinder.axis);
    // The limit of `a` is 64 * 65,536^2.
    let a_is_accurate = length_squared <= quadratic.a * real(274877906944.0);
    let discriminant = quadratic.discriminant;
    return ExactSide(bound, length_squared, quadratic.a, a_is_accurate, quadratic.h, discriminant, along, slope);
}

// Crossing: what is certain about a point where the line crosses the infinite cylinder.
struct ExactCrossing {
    lambda: real,
    hits: bool,
    // `hits` holds, and the ray starts between the caps' planes.
    straight: bool,
    behind: bool,
    above: bool,
    below: bool,
}

// Side::crossing: returns the crossing at `numerator / a`.
fn exact_side_crossing(
    side: ExactSide,
    cylinder: CylinderRecord,
    ray: Ray,
    numerator: real,
    root: real,
) -> ExactCrossing {
    let crossing = error_bound_root(side.bound, side.a, numerator, root);
    let along = side.along + crossing.lambda * side.slope;
    let margin = exact_cylinder_margin(cylinder, ray, crossing.lambda);
    let accurate = side.a_is_accurate && crossing.hits;
    let within = cylinder.half_height - margin;
    let beyond = cylinder.half_height + margin;
    let hits = accurate && abs(along) < within;
    let straight = hits && abs(side.along) < within;
    let behind = side.a_is_accurate && crossing.fails;
    return ExactCrossing(
        crossing.lambda,
        hits,
        straight,
        behind,
        accurate && beyond < along,
        accurate && beyond < -along,
    );
}

// Crossing::fails: returns whether the ray certainly does not hit the side at this point.
fn exact_crossing_fails(crossing: ExactCrossing) -> bool {
    return crossing.behind || crossing.above || crossing.below;
}

// Crossing::passes_by: returns whether a ray that enters at `entry` and leaves at `leaving` certainly hits no part.
fn exact_crossing_passes_by(entry: ExactCrossing, leaving: ExactCrossing) -> bool {
    return leaving.behind || (entry.above && leaving.above) || (entry.below && leaving.below);
}
