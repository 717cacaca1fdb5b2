// The side of a cylinder with its error bound; twin of the side in cpu/src/exact/cylinder_plain.rs.

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

// reach_of_axis: returns an upper bound of the coordinates of points on the axis.
fn exact_reach_of_axis(cylinder: CylinderRecord) -> real {
    return exact_magnitude(cylinder.center) + cylinder.half_height + EXTENT_UNDERFLOW;
}

// margin: returns a bound of the distance by which rounding moves the ray's point. `error` is twice the bound of the
// error of lambda, or more. The factor is 64 * 2^-53.
fn exact_cylinder_margin(cylinder: CylinderRecord, ray: Ray, error: real) -> real {
    let extent = exact_reach_of_axis(cylinder) + cylinder.radius;
    return error * exact_magnitude(ray.direction) + extent * real(7.105427357601002e-15);
}

// Twice the bound of the relative error of an accepted lambda: 512 * 65,536 * 2^-53.
fn exact_cylinder_lambda_error() -> real {
    return real(3.725290298461914e-09);
}

// is_long: returns whether rays may run nearly along the axis from one side to the other.
fn exact_is_long(cylinder: CylinderRecord) -> bool {
    return cylinder.radius * real(8.0) < cylinder.half_height;
}

// is_inside: returns whether the ray certainly starts inside the infinite cylinder.
fn exact_is_inside(c: real, squares: real) -> bool {
    return error_bound_misses(error_bound_of_size(exact_cylinder_limits(), squares, squares, squares), c);
}

// Returns `|O - C|^2 + r^2`.
fn exact_squares(cylinder: CylinderRecord, origin: vec3<real>) -> real {
    let from_center = origin - cylinder.center;
    return vec3_dot(from_center, from_center) + cylinder.radius_squared;
}

// size: returns the size of the terms that cancel in the discriminant. `squares` is the square of the distance from the
// ray's origin to the centre plus that of the radius. The share is 2^-44.
fn exact_side_size(cylinder: CylinderRecord, c: real, squares: real, a: real, length_squared: real) -> real {
    let whole = length_squared * squares;
    if !exact_is_long(cylinder) {
        return whole;
    }
    let across = c + cylinder.radius_squared + cylinder.radius_squared;
    let product = a * (across * (length_squared * across + a * squares));
    return sqrt(product + product) + whole * real(5.684341886080802e-14) + LEAST_SIZE;
}

// Side: the quadratic of one ray and an infinite cylinder, with its bound.
struct ExactSide {
    bound: ErrorBound,
    length_squared: real,
    // The ray certainly starts inside the infinite cylinder.
    inside: bool,
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
    let view = cylinder_seen_from(cylinder, ray.origin);
    let quadratic = cylinder_quadratic(cylinder, view, ray.direction);
    let length_squared = vec3_dot(ray.direction, ray.direction);
    let squares = exact_squares(cylinder, ray.origin);
    let inside = exact_is_inside(view.c, squares);
    let size = exact_side_size(cylinder, view.c, squares, quadratic.a, length_squared);
    let bound = error_bound_of_size(exact_cylinder_limits(), size, length_squared * squares, squares);
    let along = vec3_dot(from_center, cylinder.axis);
    let slope = vec3_dot(ray.direction, cylinder.axis);
    // The limit of `a` is 4 * 65,536^2.
    let a_is_accurate = length_squared <= quadratic.a * real(17179869184.0);
    let discriminant = quadratic.discriminant;
    let a = quadratic.a;
    return ExactSide(bound, length_squared, inside, a, a_is_accurate, quadratic.h, discriminant, along, slope);
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

// Crossing::new: returns the crossing at `lambda`. `start` and `slope` are `along` and `slope` of ExactSide. `accurate`
// and `behind` tell whether lambda certainly is in range and accurate, or certainly below the smallest lambda.
fn exact_crossing_new(
    cylinder: CylinderRecord,
    start: real,
    slope: real,
    lambda: real,
    margin: real,
    accurate: bool,
    behind: bool,
) -> ExactCrossing {
    let along = start + lambda * slope;
    let within = cylinder.half_height - margin;
    let beyond = cylinder.half_height + margin;
    let hits = accurate && abs(along) < within;
    let straight = hits && abs(start) < within;
    return ExactCrossing(lambda, hits, straight, behind, accurate && beyond < along, accurate && beyond < -along);
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
    let margin = exact_cylinder_margin(cylinder, ray, crossing.lambda * exact_cylinder_lambda_error());
    let accurate = side.a_is_accurate && crossing.hits;
    let behind = side.a_is_accurate && crossing.fails;
    return exact_crossing_new(cylinder, side.along, side.slope, crossing.lambda, margin, accurate, behind);
}

// SideLanes: where the ray's line enters and leaves the infinite cylinder.
struct ExactCrossings {
    entry: ExactCrossing,
    leaving: ExactCrossing,
    misses: bool,
}

// SideLanes::new: returns the crossings by the plain formula.
fn exact_side_crossings(side: ExactSide, cylinder: CylinderRecord, ray: Ray) -> ExactCrossings {
    let root = sqrt(side.discriminant);
    let entry = exact_side_crossing(side, cylinder, ray, -side.h - root, root);
    let leaving = exact_side_crossing(side, cylinder, ray, -side.h + root, root);
    return ExactCrossings(entry, leaving, error_bound_misses(side.bound, side.discriminant));
}

// Crossing::fails: returns whether the ray certainly does not hit the side at this point.
fn exact_crossing_fails(crossing: ExactCrossing) -> bool {
    return crossing.behind || crossing.above || crossing.below;
}

// Crossing::passes_by: returns whether a ray that enters at `entry` and leaves at `leaving` certainly hits no part.
fn exact_crossing_passes_by(entry: ExactCrossing, leaving: ExactCrossing) -> bool {
    return leaving.behind || (entry.above && leaving.above) || (entry.below && leaving.below);
}
