//! The largest magnitudes of the numbers of a formula, which show that nothing overflows.
//!
//! Each number of the table has a bound of its exact size and of its error. Here the variables of both get the largest
//! values of a domain, and of the bounds that follow from the polynomials and from the operands the smaller one counts.
//! In logarithms all bounds are convex functions of the variables, so they are largest at a corner of the domain. The
//! bounds have margins far above the rounding of logarithms.

use cpu::internals::accel::extent::Extent;
use cpu::internals::accel::may_hit::conservative::{ConservativeRay, QUADRATIC_MARGIN as SHARE};
use cpu::internals::accel::may_hit::filter_ray::MAX_COORDINATE;
use cpu::internals::exact::cylinder_decision::{CYLINDER_BOUND, CapPlane};
use cpu::internals::exact::cylinder_plain::{LEAST_SIZE, SHARE_ACROSS_AXIS};
use cpu::internals::exact::error_bound::{HEADROOM, LARGEST_IN_SCALE, OVERFLOW, SMALLEST_IN_SCALE, UNDERFLOW};
use cpu::internals::geometry::ray::LAMBDA_MIN;
use cpu::internals::render::hit_lanes::LARGEST_SQUARES;

use super::bounded::{Bounded, LOST_MARGIN, MARGIN, Operation, begin, numbers};
use super::bounds::{Arithmetic, arithmetic};
use super::exact;
use super::filters::{self, FLAT_MARGIN, FlatNumbers};
use super::logarithm::{Corner, Log, sum};
use super::parts::{FILE_AXIS, record};
use super::polynomial::Polynomial;
use super::row::{IN_SCALE, Row, U, family::*, is, ray, squared};

/// What is known of a number beside its bounds: the smallest and the largest magnitude.
type Known = (Bounded, [Log; 2]);

/// Returns the largest value of a polynomial. What the bounds have a margin for is measured in that margin.
fn value(polynomial: &Polynomial, corner: Corner) -> Log {
    let terms = polynomial.0.iter().map(|(monomial, coefficient)| {
        let known = |family| corner.iter().find(|(known, _)| *known == family).map(|(_, most)| *most);
        let is_one = |family| [AXIS, MARGIN.0, LOST_MARGIN.0].contains(&family).then_some(0.0);
        let log = |family| known(family).or(is_one(family)).unwrap_or_else(|| panic!("no limit of family {family}"));
        let logs = monomial.iter().map(|&(family, _)| log(family));
        coefficient.log2() + logs.sum::<f64>()
    });
    terms.fold(f64::NEG_INFINITY, sum)
}

/// Returns the number of the table with the largest magnitude, and that magnitude.
fn largest(corner: Corner, known: &[Known]) -> (Bounded, Log) {
    let mut reached: Vec<Log> = Vec::new();
    for number in numbers() {
        let of = |number: Bounded| reached[number.place()];
        let bounds = number.bounds();
        let from_bounds = sum(value(&bounds.size, corner), value(&bounds.error, corner) + arithmetic().roundoff.log2());
        let least =
            |number: Bounded| known.iter().find(|(of, _)| *of == number).map_or(f64::NEG_INFINITY, |of| of.1[0]);
        let from_operands = match number.operation() {
            // An infinite constant is a result that is chosen.
            Operation::Constant(bits) if f64::from_bits(bits).is_infinite() => f64::NEG_INFINITY,
            Operation::Input(_) | Operation::Constant(_) => f64::INFINITY,
            Operation::Sum(a, b) | Operation::Difference(a, b) => sum(of(a), of(b)),
            Operation::Product(a, b) => of(a) + of(b),
            Operation::Fused(a, b, c) => sum(of(a) + of(b), of(c)),
            Operation::Quotient(a, b) => of(a) - least(b),
            Operation::Negative(a) | Operation::Magnitude(a) | Operation::Flipped(a, _) => of(a),
            Operation::Root(a) => of(a) / 2.0,
        };
        let most = known.iter().find(|(of, _)| *of == number).map_or(f64::INFINITY, |of| of.1[1]);
        reached.push(from_bounds.min(from_operands).min(most));
    }
    let computed =
        numbers().filter(|number| !matches!(number.operation(), Operation::Input(_) | Operation::Constant(_)));
    let all = computed.map(|number| (number, reached[number.place()]));
    all.max_by(|a, b| a.1.total_cmp(&b.1)).expect("the formulas compute something")
}

/// Returns the row of the largest number that the formulas of the table compute.
///
/// # Panics
/// If it may overflow.
fn row(what: &'static str, file: &'static str, corners: &[(Corner, &[Known])]) -> Row {
    let constant = if arithmetic().roundoff == Arithmetic::F32.roundoff { 128.0 } else { 1024.0 };
    let each = corners.iter().map(|(corner, known)| largest(corner, known));
    let (number, need) = each.max_by(|a, b| a.1.total_cmp(&b.1)).expect("a domain has a corner");
    assert!(need < constant, "{what}: 2^{need:.1} overflows in {}", number.formula(4));
    Row::new(what, file, [constant, need], "log2")
}

/// Returns the rows.
pub fn rows() -> [Row; 7] {
    [sphere(), side(), cap(), underflow(), long_side(), conservative(), flat_filter()]
}

/// The families of lengths and of sizes along and across the axis, each with a limit.
fn corner(direction: Log, size: Log, extent: Log) -> [(u8, Log); 10] {
    let directions = [DIRECTION, DIRECTION_ACROSS].map(|family| (family, direction));
    let sizes = [TO_CENTER, TO_CENTER_ACROSS, RADIUS, INNER_RADIUS].map(|family| (family, size));
    let extents = [CENTER, ORIGIN, HALF_HEIGHT].map(|family| (family, extent));
    // The length of an axis is finite.
    let axis = [(FILE_AXIS, extent.min(500.0))];
    [&directions[..], &sizes, &extents, &axis].concat().try_into().expect("there are ten families")
}

/// The logarithms of the lengths of directions that are in scale.
fn in_scale() -> [Log; 2] {
    [SMALLEST_IN_SCALE, LARGEST_IN_SCALE].map(|squared| squared.log2() / 2.0)
}

/// Returns the row of the quadratic `a, h, c, D` and its roots, where `a` is at least `share |d|^2`.
///
/// The error bound is infinite, and nothing is certain, if not both `w^2 = |O - C|^2 + r^2` and `|d|^2 w^2` are below
/// the limit. The bound has a factor for that, which is left out here. A margin of a height that overflows decides
/// nothing, so the coordinates of objects have the same limit.
fn quadratic(what: &'static str, file: &'static str, share: f64, run: impl Fn() -> [Bounded; 4]) -> Row {
    begin(Arithmetic::F64, HEADROOM);
    let ([a, ..], most, [shortest, longest]) = (run(), OVERFLOW.log2() / 2.0, in_scale());
    assert_eq!(HEADROOM.log2() + OVERFLOW.log2(), 1024.0, "the error bound is infinite from the limit on");
    // In lanes every ray may hit an object that is farther away.
    let farthest = [LARGEST_SQUARES, LARGEST_SQUARES * LARGEST_IN_SCALE].map(|squares| squares.log2() / 2.0);
    assert!(farthest.iter().all(|size| *size <= most), "in lanes nothing says that the bound is infinite");
    let known = [(a, [2.0 * shortest + share.log2(), f64::INFINITY])];
    let corners = [(0.0, most), (longest, most - longest)].map(|(direction, size)| corner(direction, size, 2.0 * most));
    row(what, file, &corners.each_ref().map(|corner| (&corner[..], &known[..])))
}

fn sphere() -> Row {
    quadratic("largest number of a sphere", "exact/error_bound.rs", 1.0, exact::sphere)
}

/// Returns the row of the side of a cylinder, whose `a` must be accurate. If the size of a long one overflows, nothing
/// is certain.
fn side() -> Row {
    let share = 0.5 / (SHARE_ACROSS_AXIS * CYLINDER_BOUND.condition_limit.powi(2));
    quadratic("largest number of a side", "exact/cylinder_decision.rs", share, || exact::cylinder(false))
}

/// Returns the row of a cap, for coordinates up to 2^480. Farther hits are no hits: the radius is smaller, because the
/// quadratic was certain before.
fn cap() -> Row {
    begin(Arithmetic::F64, f64::NAN);
    let (ray, record) = (ray(), record());
    is(record.top - ray.origin, TO_CENTER);
    let plane = CapPlane::new(&record, &ray, record.top);
    _ = plane.disc(&record, &ray);
    let slope = ray.direction.dot(record.axis);
    // A slope that is accurate exceeds `|d|_1 / (8 k)`.
    let corners = in_scale().map(|direction| {
        let least = direction - (8.0 * CYLINDER_BOUND.condition_limit).log2();
        (corner(direction, 480.0, 480.0), [(slope, [least, f64::INFINITY])])
    });
    let corners = corners.each_ref().map(|(corner, known)| (&corner[..], &known[..]));
    row("largest number of a cap", "exact/cylinder_decision.rs", &corners)
}

/// Returns the row of the constant that covers underflow in a discriminant, in bits above the smallest number, 2^-1074.
fn underflow() -> Row {
    let size = squared(DIRECTION).times(&squared(TO_CENTER).plus(&squared(RADIUS)));
    assert!(IN_SCALE.direction.powi(2) <= SMALLEST_IN_SCALE, "a direction may be shorter than the proof allows");
    let each = [exact::sphere, || exact::cylinder(false)].map(|run: fn() -> _| {
        begin(Arithmetic::F64, HEADROOM);
        let [.., discriminant]: [Bounded; 4] = run();
        IN_SCALE.relative_and_rest(&discriminant.bounds().error, &size, 1.0)[1] * U
    });
    let logs = [UNDERFLOW, each[0].max(each[1])].map(|bound| bound.log2() - f64::from_bits(1).log2());
    Row::new("underflow of a discriminant", "exact/error_bound.rs", logs, "log2")
}

/// Returns the row of the size `m` of a long cylinder, in bits below 1. The square `m^2 / 2` is a product with `a`,
/// which is at most the largest square of a direction in scale. The other factor is the smallest product that counts.
fn long_side() -> Row {
    let need = LARGEST_IN_SCALE.log2() - (LEAST_SIZE * LEAST_SIZE / 2.0).log2();
    let logs = [-f64::MIN_POSITIVE.log2(), need];
    Row::new("underflow of a long side", "exact/cylinder_plain.rs", logs, "log2")
}

/// The lengths in a scene with this largest coordinate `L`. No two points are farther apart than `3.5 L`. So a ray with
/// `t |d| > 3.5 L` has passed all objects at the least lambda `t`, and a miss is right.
fn scene(largest: f64) -> [(u8, Log); 10] {
    let size = (3.5 * largest).log2();
    corner(size - LAMBDA_MIN.log2(), size, size)
}

/// Returns the row of the conservative tests in `f64`.
fn conservative() -> Row {
    begin(Arithmetic::F64, SHARE);
    let (ray, target) = (ray(), filters::target(false));
    is(target.center - ray.origin, TO_CENTER);
    let test = ConservativeRay::new(ray);
    _ = test.cylinder(&target);
    _ = test.starts_within(&test.cylinder_quadratic(&target).0);
    // The direction of a ray that starts inside an object must be in scale.
    let [_, longest] = in_scale();
    let corners = [scene(Extent::LARGEST), corner(longest, (3.5 * Extent::LARGEST).log2(), Extent::LARGEST.log2())]
        .map(|corner| [&corner[..], &[(filters::EXTENT, Extent::LARGEST.log2())]].concat());
    let corners = corners.each_ref().map(|corner| (&corner[..], &[][..]));
    row("largest number of a conservative test", "accel/extent.rs", &corners)
}

/// Returns the row of the flat filter, whose coordinates are relative to the middle of the scene. There centres are at
/// most `sqrt(3) L` away, and radii are at most `L`.
///
/// `a'` is at most `a`, and `|h'|` at most `|d| |O - C|`. `c` and `c'` lie between `-R^2` and `|O - C|^2`. So both
/// discriminants are at most `a (|O - C|^2 + R^2)`. The polynomials do not show this, because terms cancel.
fn flat_filter() -> Row {
    let FlatNumbers { sphere, cylinder, .. } = filters::flat_numbers(FLAT_MARGIN);
    let [to_center, center, origin, radius] =
        [3.5, 3.0_f64.sqrt(), 12.0_f64.sqrt(), 1.0].map(|share| (share * MAX_COORDINATE).log2());
    let direction = to_center - LAMBDA_MIN.log2();
    let corner = [(DIRECTION, direction), (CENTER, center), (ORIGIN, origin), (RADIUS, radius)];
    let Operation::Difference(discriminant, _) = cylinder.operation() else { panic!("the margin is subtracted") };
    let Operation::Fused(_, h, product) = discriminant.operation() else { panic!("the square is subtracted") };
    let Operation::Product(a, c) = product.operation() else { panic!("it is a product") };
    let squares = 2.0 * direction + sum(2.0 * to_center, 2.0 * radius);
    // `h'`, `a'` and `c'` are doubled. The last thousandth covers rounding.
    let most = [(h, direction + to_center), (a, 2.0 * direction), (c, 2.0 * to_center)]
        .map(|(number, most)| (number, most + 1.0));
    let known = [&most[..], &[sphere, discriminant].map(|number| (number, squares + 2.0))].concat();
    let known: Vec<_> = known.into_iter().map(|(number, most)| (number, [f64::NEG_INFINITY, most + 1e-3])).collect();
    row("largest number of the flat filter", "accel/may_hit/filter_ray.rs", &[(&corner, &known)])
}
