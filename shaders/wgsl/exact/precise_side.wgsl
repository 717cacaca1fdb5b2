// The side of exact/cylinder_side.wgsl in double-double.

// CylinderRecord<DoubleDouble>, without the caps' centres, which the exact formulas do not need.
struct PreciseCylinder {
    center: DoubleDouble3,
    axis: DoubleDouble3,
    radius: DoubleDouble,
    radius_squared: DoubleDouble,
    half_height: DoubleDouble,
}

// CylinderRecord::new: returns the record of a cylinder. The length of `axis` is the height.
fn precise_cylinder_new(center: vec3<real>, radius: real, axis: vec3<real>) -> PreciseCylinder {
    let v = dd3_of(axis);
    // The square of a short axis would underflow, so the axis is scaled by a power of two first.
    let is_short = dd_less(dd3_dot(v, v), dd_of(SHORT_SQUARED));
    let scaled = dd3_scaled(v, dd_of(select(real(1.0), SHORT_SCALE, is_short)));
    let length = dd_sqrt(dd3_dot(scaled, scaled));
    let height = dd_mul(length, dd_of(select(real(1.0), SHORT_SQUARED, is_short)));
    let r = dd_of(radius);
    let half_height = dd_div(height, dd_of(real(2.0)));
    return PreciseCylinder(dd3_of(center), dd3_divided(scaled, length), r, dd_mul(r, r), half_height);
}

// LIMITS: the error constant 192 times 2^-102, the reciprocal of the condition limit 65,536 * 2^24, and 10^-3 times
// 256 * 65,536 * 2^24 * 2^-102.
fn precise_cylinder_limits() -> PreciseLimits {
    return PreciseLimits(real(3.7865323450608567e-29), real(9.094947017729282e-13), real(5.551115123125783e-20));
}

fn precise_extent_of_axis(cylinder: PreciseCylinder) -> DoubleDouble {
    return dd_add(dd_add(dd3_magnitude(cylinder.center), cylinder.half_height), dd_of(EXTENT_UNDERFLOW));
}

// margin: the factors are 512 * 65,536 * 2^24 * 2^-102 and 64 * 2^-102.
fn precise_cylinder_margin(
    cylinder: PreciseCylinder,
    direction: DoubleDouble3,
    lambda: DoubleDouble,
) -> DoubleDouble {
    let along = dd_mul(dd_mul(lambda, dd3_magnitude(direction)), dd_of(real(1.1102230246251565e-16)));
    let extent = dd_add(precise_extent_of_axis(cylinder), cylinder.radius);
    return dd_add(along, dd_mul(extent, dd_of(real(1.262177448353619e-29))));
}

// Side<DoubleDouble>
struct PreciseSide {
    bound: PreciseBound,
    length_squared: DoubleDouble,
    a: DoubleDouble,
    h: DoubleDouble,
    discriminant: DoubleDouble,
    along: DoubleDouble,
    slope: DoubleDouble,
}

fn precise_side_new(cylinder: PreciseCylinder, origin: DoubleDouble3, direction: DoubleDouble3) -> PreciseSide {
    let from_center = dd3_sub(origin, cylinder.center);
    let r_c = dd3_perpendicular_to(from_center, cylinder.axis);
    let c = dd_sub(dd3_dot(r_c, r_c), cylinder.radius_squared);
    let across = dd3_perpendicular_to(direction, cylinder.axis);
    let a = dd3_dot(across, across);
    let h = dd3_dot(r_c, across);
    let discriminant = dd_sub(dd_mul(h, h), dd_mul(a, c));
    let length_squared = dd3_dot(direction, direction);
    let squares = dd_add(dd3_dot(from_center, from_center), cylinder.radius_squared);
    let bound = precise_bound_new(precise_cylinder_limits(), length_squared, squares);
    let along = dd3_dot(from_center, cylinder.axis);
    return PreciseSide(bound, length_squared, a, h, discriminant, along, dd3_dot(direction, cylinder.axis));
}

// Crossing<DoubleDouble>
struct PreciseCrossing {
    lambda: DoubleDouble,
    hits: bool,
    straight: bool,
    behind: bool,
    above: bool,
    below: bool,
}

// Side::crossing: the limit of `a` is 64 * 65,536^2 * 2^48.
fn precise_side_crossing(
    side: PreciseSide,
    cylinder: PreciseCylinder,
    direction: DoubleDouble3,
    numerator: DoubleDouble,
    root: DoubleDouble,
) -> PreciseCrossing {
    let steep_enough = dd_less_equal(side.length_squared, dd_mul(side.a, dd_of(real(7.737125245533627e25))));
    let crossing = precise_bound_root(side.bound, side.a, numerator, root);
    let along = dd_add(side.along, dd_mul(crossing.lambda, side.slope));
    let margin = precise_cylinder_margin(cylinder, direction, crossing.lambda);
    let accurate = steep_enough && crossing.hits;
    let within = dd_sub(cylinder.half_height, margin);
    let beyond = dd_add(cylinder.half_height, margin);
    let hits = accurate && dd_less(dd_abs(along), within);
    return PreciseCrossing(
        crossing.lambda,
        hits,
        hits && dd_less(dd_abs(side.along), within),
        steep_enough && crossing.fails,
        accurate && dd_less(beyond, along),
        accurate && dd_less(beyond, dd_neg(along)),
    );
}

fn precise_crossing_fails(crossing: PreciseCrossing) -> bool {
    return crossing.behind || crossing.above || crossing.below;
}

fn precise_crossing_passes_by(entry: PreciseCrossing, leaving: PreciseCrossing) -> bool {
    return leaving.behind || (entry.above && leaving.above) || (entry.below && leaving.below);
}
