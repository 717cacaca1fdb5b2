//! Tests that several rays in lanes get the answers that each ray gets alone.

use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

use cpu::internals::exact;
use cpu::internals::exact::error_bound::Decision;
use cpu::internals::geometry::cylinder::{CylinderPart, CylinderRecord};
use cpu::internals::geometry::sphere::SphereRecord;
use cpu::internals::input::scene::Shape;
use cpu::internals::math::real::Real;
use cpu::internals::math::rounding::Rounding;
use cpu::{Ray, Vec3};
use stability::case::Case;
use stability::regimes::{CYLINDERS, Regime, SPHERES};

const SEED: u64 = 11;
const PAIRS: usize = 2_000;

/// Two lanes, which replace a SIMD register.
#[derive(Clone, Copy, Debug)]
struct Pair([f64; 2]);

/// A mask of two lanes. Unlike a `bool`, it has no order and cannot be used as a condition, so the formulas compile for
/// real masks.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Mask([bool; 2]);

macro_rules! each {
    ($trait:ident, $method:ident, $operator:tt, $type:ident) => {
        impl $trait for $type {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                Self([self.0[0] $operator other.0[0], self.0[1] $operator other.0[1]])
            }
        }
    };
}
each!(Add, add, +, Pair);
each!(Sub, sub, -, Pair);
each!(Mul, mul, *, Pair);
each!(Div, div, /, Pair);
each!(BitAnd, bitand, &, Mask);
each!(BitOr, bitor, |, Mask);

impl Not for Mask {
    type Output = Self;
    fn not(self) -> Self {
        Self(self.0.map(bool::not))
    }
}

impl Neg for Pair {
    type Output = Self;
    fn neg(self) -> Self {
        Self(self.0.map(f64::neg))
    }
}

impl Real for Pair {
    type Mask = Mask;
    fn of(value: f64) -> Self {
        Self([value; 2])
    }
    fn sqrt(self) -> Self {
        Self(self.0.map(f64::sqrt))
    }
    fn abs(self) -> Self {
        Self(self.0.map(f64::abs))
    }
    fn less(self, other: Self) -> Mask {
        Mask([0, 1].map(|lane| self.0[lane] < other.0[lane]))
    }
    fn less_equal(self, other: Self) -> Mask {
        Mask([0, 1].map(|lane| self.0[lane] <= other.0[lane]))
    }
    fn select(mask: Mask, yes: Self, no: Self) -> Self {
        Self([0, 1].map(|lane| if mask.0[lane] { yes.0[lane] } else { no.0[lane] }))
    }
}

impl Rounding for Pair {}

fn together(one: Vec3, other: Vec3) -> Vec3<Pair> {
    let (one, other) = (one.to_array(), other.to_array());
    Vec3::from([0, 1, 2].map(|index| Pair([one[index], other[index]])))
}

/// Calls `compare` with pairs of cases. `compare` returns for each lane whether it is certain. Both results must occur
/// often.
fn for_each_pair(regimes: &[Regime], compare: impl Fn([Case; 2]) -> [bool; 2]) {
    let mut certain = [0; 2];
    for regime in regimes {
        for pair in regime.cases(SEED, 2 * PAIRS).chunks_exact(2) {
            for lane in compare([pair[0], pair[1]]) {
                certain[usize::from(lane)] += 1;
            }
        }
    }
    assert!(certain[0] > PAIRS && certain[1] > PAIRS, "both kinds of rays must come: {certain:?}");
}

fn rays(cases: [Case; 2]) -> Ray<Pair> {
    let [one, other] = cases.map(|case| case.ray);
    Ray { origin: together(one.origin, other.origin), direction: together(one.direction, other.direction) }
}

#[test]
fn spheres_in_lanes_are_as_alone() {
    for_each_pair(&SPHERES, |cases| {
        let records = cases.map(|case| match case.shape {
            Shape::Sphere(sphere) => SphereRecord::new(sphere.center, sphere.radius),
            Shape::Cylinder(_) => panic!("a cylinder among spheres"),
        });
        let (center, radius) = (together(records[0].center, records[1].center), records.map(|record| record.radius));
        let ray = rays(cases);
        let a = ray.direction.dot(ray.direction);
        let view = SphereRecord::new(center, Pair(radius)).seen_from(ray.origin);
        let lanes = exact::sphere::filtered_from(&view, ray.direction, a);
        for lane in 0..2 {
            let alone = exact::sphere::filtered(&records[lane], &cases[lane].ray);
            match alone {
                Decision::Certain(answer) => assert_eq!(lanes.lambda.0[lane], answer.unwrap_or(f64::INFINITY)),
                Decision::Uncertain => {}
            }
            assert_eq!(lanes.certain.0[lane], alone != Decision::Uncertain, "{:?}", cases[lane]);
        }
        lanes.certain.0
    });
}

#[test]
fn cylinders_in_lanes_are_as_alone() {
    for_each_pair(&CYLINDERS, |cases| {
        let shapes = cases.map(|case| match case.shape {
            Shape::Cylinder(cylinder) => cylinder,
            Shape::Sphere(_) => panic!("a sphere among cylinders"),
        });
        let center = together(shapes[0].center, shapes[1].center);
        let axis = together(shapes[0].axis, shapes[1].axis);
        let radius = Pair(shapes.map(|shape| shape.radius));
        let (record, ray) = (CylinderRecord::new(center, radius, axis), rays(cases));
        let side = exact::cylinder::SideLanes::new(&record, &record.seen_from(ray.origin), &ray);
        let lanes = side.with_caps(&record, &ray);
        for lane in 0..2 {
            let shape = shapes[lane];
            let record = CylinderRecord::new(shape.center, shape.radius, shape.axis);
            let alone = exact::cylinder::filtered(&record, &cases[lane].ray);
            assert_eq!(lanes.certain.0[lane], alone != Decision::Uncertain, "{:?}", cases[lane]);
            match alone {
                Decision::Certain(Some((lambda, part))) => {
                    let found = match (lanes.bottom.0[lane], lanes.top.0[lane]) {
                        (true, _) => CylinderPart::Bottom,
                        (false, true) => CylinderPart::Top,
                        (false, false) => CylinderPart::Side,
                    };
                    assert_eq!((lanes.lambda.0[lane], found), (lambda, part), "{:?}", cases[lane]);
                }
                Decision::Certain(None) => assert_eq!(lanes.lambda.0[lane], f64::INFINITY),
                Decision::Uncertain => {}
            }
        }
        lanes.certain.0
    });
}

#[test]
fn what_is_certain_has_the_bits_of_the_plain_formula() {
    let mut compared = 0;
    for case in SPHERES.iter().chain(&CYLINDERS).flat_map(|regime| regime.cases(SEED, PAIRS)) {
        let same = match case.shape {
            Shape::Sphere(sphere) => {
                let record = SphereRecord::new(sphere.center, sphere.radius);
                match exact::sphere::filtered(&record, &case.ray) {
                    Decision::Certain(answer) => answer == record.intersect(&case.ray),
                    Decision::Uncertain => continue,
                }
            }
            Shape::Cylinder(cylinder) => {
                let record = CylinderRecord::new(cylinder.center, cylinder.radius, cylinder.axis);
                match exact::cylinder::filtered(&record, &case.ray) {
                    Decision::Certain(answer) => answer == record.intersect(&case.ray),
                    Decision::Uncertain => continue,
                }
            }
        };
        assert!(same, "{case:?}");
        compared += 1;
    }
    assert!(compared > 5 * PAIRS, "{compared}");
}
