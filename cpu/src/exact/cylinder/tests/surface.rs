//! Checks the order of a cylinder's surfaces without a gap. A line crosses the infinite cylinder at two lambdas, and
//! the planes of the caps at two. Which part is hit depends only on the order of these four, of the ray's origin and of
//! the least lambda. The tests try each order, and in each order all sets of facts that may be certain.

use crate::exact::cylinder::*;
use crate::exact::cylinder_decision::{CapFormulas, CapPlane, Crossing, CylinderHit, SideFacts, SideFormulas};
use crate::exact::cylinder_lanes::SideLanes;
use crate::geometry::ray::LAMBDA_MIN;

/// Values on both sides of the ray's origin and of the least lambda, and these two. Four lambdas find room in each gap.
const PLACES: [f64; 14] = [
    -4.0,
    -3.0,
    -2.0,
    -1.0,
    0.0,
    0.2 * LAMBDA_MIN,
    0.4 * LAMBDA_MIN,
    0.6 * LAMBDA_MIN,
    0.8 * LAMBDA_MIN,
    LAMBDA_MIN,
    1.0,
    2.0,
    3.0,
    4.0,
];

/// Where a line crosses the infinite cylinder.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Line {
    Crosses,
    Misses,
    /// It is parallel to the axis, inside or outside.
    AlongInside,
    AlongOutside,
}

/// A line, and the lambdas at which it enters and leaves the infinite cylinder and the slab between the caps' planes.
#[derive(Clone, Copy, Debug)]
struct Order {
    line: Line,
    side: [f64; 2],
    caps: [f64; 2],
    /// The ray runs along the axis, and not against it.
    upward: bool,
    /// The caps are skipped because the ray is nearly parallel to them.
    skipped: bool,
}

/// The facts that are certain, beside those that follow from them.
#[derive(Clone, Copy, Debug)]
struct Facts {
    misses: bool,
    is_accurate: bool,
    inside: bool,
    /// Of the entry and of the exit: 1 if lambda is certain, and 2 if also the origin's height is.
    crossings: [u8; 2],
    caps: [bool; 2],
}

impl Order {
    /// Returns a cylinder and a ray that cross in this order.
    fn objects(&self) -> (CylinderRecord, Ray) {
        let Self { line, side: [enters, leaves], caps: [near, far], upward, .. } = *self;
        let (sign, radius) = (if upward { 1.0 } else { -1.0 }, (leaves - enters) / 2.0);
        let record = CylinderRecord::new(Vec3::ZERO, radius, Vec3::new(0.0, 0.0, far - near));
        let (x, height) = (-(enters + leaves) / 2.0, -(near + far) / 2.0 * sign);
        let (origin, across) = match line {
            Line::Crosses => (Vec3::new(x, 0.0, height), 1.0),
            Line::Misses => (Vec3::new(x, 2.0 * radius, height), 1.0),
            Line::AlongInside => (Vec3::new(0.5 * radius, 0.0, height), 0.0),
            Line::AlongOutside => (Vec3::new(2.0 * radius, 0.0, height), 0.0),
        };
        (record, Ray { origin, direction: Vec3::new(across, 0.0, sign) })
    }

    /// Returns the hit that the definition gives: of all points of the surface in range the first, and of equal ones
    /// that of the side.
    fn expected(&self) -> CylinderHit<f64> {
        let Self { line, side, caps, upward, skipped } = *self;
        let within = |[enters, leaves]: [f64; 2], lambda: f64| enters <= lambda && lambda <= leaves;
        let on_side = side.into_iter().filter(|&lambda| line == Line::Crosses && within(caps, lambda));
        let [near, far] =
            if upward { [CylinderPart::Bottom, CylinderPart::Top] } else { [CylinderPart::Top, CylinderPart::Bottom] };
        let on_caps = caps.into_iter().zip([near, far]).filter(|&(lambda, _)| {
            !skipped && if line == Line::Crosses { within(side, lambda) } else { line == Line::AlongInside }
        });
        let hits = on_side.map(|lambda| (lambda, CylinderPart::Side)).chain(on_caps);
        hits.filter(|(lambda, _)| *lambda >= LAMBDA_MIN).reduce(|a, b| if b.0 < a.0 { b } else { a })
    }

    /// Calls `visit` with each set of facts that may be certain.
    fn each_facts(&self, mut visit: impl FnMut(Facts)) {
        let line = self.line;
        let starts_inside = match line {
            Line::Crosses => self.side[0] < 0.0 && 0.0 < self.side[1],
            line => line == Line::AlongInside,
        };
        let most = if line == Line::Crosses { 2 } else { 0 };
        let both = |is_true: bool| 0..=u8::from(is_true);
        for misses in both(line == Line::Misses) {
            for inside in both(starts_inside) {
                for (entry, exit) in (0..=most).flat_map(|entry| (0..=most).map(move |exit| (entry, exit))) {
                    for caps in 0..4 {
                        for is_accurate in [true, false] {
                            if is_accurate || (entry, exit) == (0, 0) {
                                let caps = [caps & 1 != 0, caps & 2 != 0];
                                let crossings = [entry, exit];
                                let (misses, inside) = (misses == 1, inside == 1);
                                visit(Facts { misses, is_accurate, inside, crossings, caps });
                            }
                        }
                    }
                }
            }
        }
    }
}

/// The facts about an order, as formulas of the side and of the caps.
struct Known<'a>(&'a Order, Facts);

impl SideFormulas<f64> for Known<'_> {
    fn facts(&self) -> SideFacts<f64> {
        let Facts { misses, is_accurate, inside, .. } = self.1;
        SideFacts { misses, is_accurate, inside }
    }

    fn enters_behind(&self) -> bool {
        self.crossing(false).behind
    }

    fn crossing(&self, at_exit: bool) -> Crossing<f64> {
        let (Self(order, facts), [near, far]) = (self, self.0.caps);
        let place = usize::from(at_exit);
        let (lambda, known) = (order.side[place], facts.crossings[place]);
        let in_range = known > 0 && LAMBDA_MIN < lambda;
        let hits = in_range && near < lambda && lambda < far;
        let (before, after) = (in_range && lambda < near, in_range && far < lambda);
        Crossing {
            lambda,
            error_bound: 0.0,
            hits,
            straight: hits && known == 2 && near < 0.0 && 0.0 < far,
            behind: known > 0 && lambda < LAMBDA_MIN,
            above: if order.upward { after } else { before },
            below: if order.upward { before } else { after },
        }
    }
}

impl CapFormulas<f64> for Known<'_> {
    fn plane(&self, _: &CylinderRecord, ray: &Ray, center: Vec3, is_top: bool) -> CapPlane<f64> {
        let Self(order, facts) = self;
        let place = usize::from(is_top == order.upward);
        let (lambda, known, slope) = (order.caps[place], facts.caps[place], ray.direction.z);
        let fails = known && (order.skipped || lambda < LAMBDA_MIN);
        let not_parallel = known && !order.skipped;
        CapPlane {
            center,
            to_plane: lambda * slope,
            slope,
            fails,
            not_parallel,
            accurate: not_parallel,
            error_bound: 0.0,
        }
    }
}

#[test]
fn no_order_of_surfaces_is_decided_wrongly() {
    let pairs: Vec<_> =
        (0..PLACES.len()).flat_map(|to| (0..to).map(move |from| [from, to].map(|at| PLACES[at]))).collect();
    let (mut orders, mut certain) = (0, 0);
    let lines = [Line::Crosses, Line::Misses, Line::AlongInside, Line::AlongOutside];
    for (line, side) in lines.into_iter().flat_map(|line| pairs.iter().map(move |&side| (line, side))) {
        for (caps, number) in pairs.iter().flat_map(|&caps| (0..4).map(move |number| (caps, number))) {
            let order = Order { line, side, caps, upward: number & 1 != 0, skipped: number & 2 != 0 };
            let ((record, ray), expected) = (order.objects(), order.expected());
            orders += 1;
            let is_right = |hit: CylinderHit<f64>| match (hit, expected) {
                (Some((lambda, part)), Some((exact, expected))) => part == expected && (lambda - exact).abs() < 1e-9,
                (hit, expected) => hit.is_none() && expected.is_none(),
            };
            order.each_facts(|facts| {
                let known = Known(&order, facts);
                if let Decision::Certain(hit) = decide(&record, &ray, &known, &known) {
                    assert!(is_right(hit), "{hit:?} for {expected:?}: {order:?}, {facts:?}");
                    certain += 1;
                }
                let lanes = SideLanes::new(&known);
                for hits in [lanes.without_caps(), lanes.with_caps(&record, &ray, &known)] {
                    let part = match (hits.bottom, hits.top) {
                        (true, _) => CylinderPart::Bottom,
                        (_, true) => CylinderPart::Top,
                        _ => CylinderPart::Side,
                    };
                    let hit = (hits.lambda < f64::INFINITY).then_some((hits.lambda, part));
                    assert!(!hits.certain || is_right(hit), "in lanes {hit:?} for {expected:?}: {order:?}, {facts:?}");
                }
            });
        }
    }
    assert!(orders == 132_496 && certain > 700_000, "{orders} orders, {certain} certain decisions");
}
