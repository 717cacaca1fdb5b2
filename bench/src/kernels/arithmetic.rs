//! Kernels of arithmetic: the background, random numbers, quantising, and exact intersections.

use std::hint::black_box;

use cpu::internals::geometry::cylinder::CylinderRecord;
use cpu::internals::geometry::sphere::SphereRecord;
use cpu::internals::image::quantize::Quantizer;
use cpu::internals::render::background::Background;
use cpu::internals::sampling::block::BlockUniform;
use cpu::internals::sampling::uniform::Uniform;
use cpu::internals::simd;
use cpu::internals::simd::{Simd, SimdF64};
use cpu::internals::{InstructionSet, exact};
use cpu::{Config, Ray, Vec3};

use stability::regimes::{EXTREMES, Regime};

use super::{Kernel, Work, plain};

pub const KERNELS: &[Kernel] = &[
    Kernel { name: "clock", new: clock },
    Kernel { name: "clock-product-sum", new: || chain(|number| number * 0.7 + 0.3) },
    Kernel { name: "clock-quotient", new: || chain(|number| 2.1 / number) },
    Kernel { name: "clock-root-sum", new: || chain(|number| number.sqrt() + 0.3) },
    Kernel { name: "background", new: background },
    Kernel { name: "draws", new: draws },
    Kernel { name: "skipped-draws", new: skipped_draws },
    Kernel { name: "quantize", new: quantize },
    Kernel { name: "quantize-interval", new: quantize_interval },
    Kernel { name: "sphere", new: || spheres(SPHERE, exact::sphere::intersect) },
    Kernel { name: "sphere-compensated", new: ground },
    Kernel { name: "sphere-exact", new: || spheres(Vec3::ONE, exact::sphere::precise) },
    Kernel { name: "cylinder", new: || cylinders(false, exact::cylinder::intersect) },
    Kernel { name: "cylinder-compensated", new: || cylinders(false, exact::cylinder::compensated_or_precise) },
    Kernel { name: "sphere-dearest", new: || dearest(&EXTREMES, "spheres of any magnitude", 2812) },
    Kernel { name: "cylinder-dearest", new: || dearest(&EXTREMES, "axes whose square underflows", 1881) },
    Kernel { name: "cylinder-exact", new: || cylinders(true, exact::cylinder::precise) },
];

/// Returns work that is one exact intersection: one of the dearest that `steps` found, by its regime and number there.
fn dearest(regimes: &[Regime], name: &str, number: usize) -> Box<dyn Work> {
    let regime = regimes.iter().find(|regime| regime.name == name).expect("there is such a regime");
    let (record, ray) = regime.cases(1, number + 1)[number].of();
    plain(1, move || {
        black_box(black_box(&record).exact(black_box(&ray)));
    })
}

/// Returns a chain of multiplications of whole numbers. Each takes three cycles on x86-64, so the time shows the clock.
fn clock() -> Box<dyn Work> {
    let mut number = 3_u64;
    plain(COUNT, move || {
        for _ in 0..COUNT {
            number = number.wrapping_mul(number);
        }
        black_box(&mut number);
    })
}

/// Returns a chain of operations that each wait for the one before, so the time shows their latency. Their numbers stay
/// between 1 and 2.1, away from the values that a processor computes faster or slower.
fn chain(operation: impl Fn(f64) -> f64 + 'static) -> Box<dyn Work> {
    let mut number = 1.3;
    plain(COUNT, move || {
        for _ in 0..COUNT {
            number = operation(number);
        }
        black_box(&mut number);
    })
}

/// Number of rays, directions or means in one turn, and of operations in a chain.
const COUNT: usize = 1024;

/// The centre of a sphere of radius 1. More than a quarter of the rays of [`rays`] hit this sphere.
const SPHERE: Vec3 = Vec3::new(0.3, -0.2, 0.1);

/// Returns [`COUNT`] random rays from points near (0, 0, -10) to points near the origin.
fn rays() -> Vec<Ray> {
    let mut draws = Uniform::new(5);
    let mut near = |middle: Vec3, size: f64| middle + Vec3::from([(); 3].map(|()| draws.draw(-size, size)));
    let ray = |_| {
        let origin = near(Vec3::new(0.0, 0.0, -10.0), 1.0);
        Ray { origin, direction: near(Vec3::ZERO, 1.2) - origin }
    };
    (0..COUNT).map(ray).collect()
}

/// Computes the background's colours for [`COUNT`] directions.
struct Colors<'a> {
    background: &'a Background,
    directions: &'a [Vec<f64>; 3],
    colors: &'a mut [Vec<f64>; 3],
}

impl simd::Kernel for Colors<'_> {
    type Output = ();

    #[inline(always)]
    fn call<S: Simd>(self, _: S) {
        let Self { background, directions: [x, y, z], colors: [red, green, blue] } = self;
        let background = background.lanes::<S::F64>();
        for at in (0..COUNT).step_by(S::F64::LANES) {
            let load = Vec3::new(S::F64::load(&x[at..]), S::F64::load(&y[at..]), S::F64::load(&z[at..]));
            let color = background.color(load);
            color.x.store(&mut red[at..]);
            color.y.store(&mut green[at..]);
            color.z.store(&mut blue[at..]);
        }
    }
}

fn background() -> Box<dyn Work> {
    let rays = rays();
    let directions = [0, 1, 2].map(|axis| rays.iter().map(|ray| ray.direction.to_array()[axis]).collect::<Vec<_>>());
    let (background, mut colors) = (Background::new(&Config::default()), [(); 3].map(|()| vec![0.0; COUNT]));
    plain(COUNT, move || {
        let work = Colors { background: &background, directions: &directions, colors: &mut colors };
        InstructionSet::chosen().run(work);
        black_box(&colors);
    })
}

/// Fills the slice with random numbers of the generator.
struct Draws<'a>(&'a mut BlockUniform, &'a mut [f64]);

impl simd::Kernel for Draws<'_> {
    type Output = ();

    #[inline(always)]
    fn call<S: Simd>(self, _: S) {
        self.0.fill(self.1);
    }
}

/// Makes the generator skip this many random numbers.
struct Skip<'a>(&'a mut BlockUniform, u64);

impl simd::Kernel for Skip<'_> {
    type Output = ();

    #[inline(always)]
    fn call<S: Simd>(self, _: S) {
        self.0.skip(self.1);
    }
}

fn draws() -> Box<dyn Work> {
    let (mut stream, mut place) = (BlockUniform::new(45), vec![0.0; 6240]);
    plain(place.len(), move || {
        InstructionSet::chosen().run(Draws(&mut stream, &mut place));
        black_box(&place);
    })
}

fn skipped_draws() -> Box<dyn Work> {
    let mut stream = BlockUniform::new(45);
    plain(6240, move || InstructionSet::chosen().run(Skip(black_box(&mut stream), 6240)))
}

fn means() -> Vec<f64> {
    let mut draws = Uniform::new(7);
    (0..COUNT).map(|_| draws.canonical()).collect()
}

fn quantize() -> Box<dyn Work> {
    let (quantizer, means) = (Quantizer::new(2.2), means());
    plain(COUNT, move || {
        let sum: u64 = black_box(&means).iter().map(|&mean| u64::from(quantizer.quantize(mean))).sum();
        black_box(sum);
    })
}

fn quantize_interval() -> Box<dyn Work> {
    let (quantizer, means) = (Quantizer::new(2.2), means());
    plain(COUNT, move || {
        let known = |mean: &&f64| quantizer.quantize_interval(**mean, **mean + 1e-6, 128).is_some();
        black_box(black_box(&means).iter().filter(known).count());
    })
}

/// Returns work that intersects rays with a sphere of radius 1. If its centre is [`SPHERE`], the rays are random. If it
/// is (1, 1, 1), every ray is exactly tangent to the sphere.
fn spheres(center: Vec3, intersect: impl Fn(&SphereRecord, &Ray) -> Option<f64> + 'static) -> Box<dyn Work> {
    let sphere = SphereRecord::new(center, 1.0);
    let tangent = |at: f64| Ray { origin: Vec3::new(0.0, 1.0, -at), direction: Vec3::new(0.0, 0.0, 1.0) };
    let rays = if center == SPHERE { rays() } else { (0..COUNT).map(|at| tangent(at as f64)).collect() };
    let hits = rays.iter().filter(|ray| intersect(&sphere, ray).is_some()).count();
    assert!(hits > COUNT / 4, "{hits} hits");
    plain(COUNT, move || {
        black_box(black_box(&rays).iter().filter_map(|ray| intersect(&sphere, ray)).fold(0.0, f64::max));
    })
}

/// Returns work that intersects rays with a ground of radius 10,000, with the compensated formula. The rays start at a
/// height of 1 above the ground, where the plain formula is uncertain.
fn ground() -> Box<dyn Work> {
    let ground = SphereRecord::new(Vec3::new(0.0, -1e4, 0.0), 1e4);
    let mut draws = Uniform::new(5);
    let down = |_| {
        let [x, y, z] = [(); 3].map(|()| draws.draw(0.2, 1.0));
        Ray { origin: Vec3::new(x, 1.0, z), direction: Vec3::new(x, -y, z) }
    };
    let rays: Vec<_> = (0..COUNT).map(down).collect();
    let compensated =
        |ray: &&Ray| exact::sphere_compensated::compensated(&ground, ray) != exact::error_bound::Decision::Uncertain;
    assert_eq!(rays.iter().filter(compensated).count(), COUNT);
    plain(COUNT, move || {
        let lambdas = black_box(&rays).iter().filter_map(|ray| exact::sphere::compensated_or_precise(&ground, ray));
        black_box(lambdas.fold(0.0, f64::max));
    })
}

/// Returns work that intersects rays with a cylinder. If `through_rim`, every ray passes exactly through the rim of a
/// cap.
fn cylinders(
    through_rim: bool,
    intersect: impl Fn(&CylinderRecord, &Vec3, &Ray) -> Option<(f64, cpu::internals::geometry::cylinder::CylinderPart)>
    + 'static,
) -> Box<dyn Work> {
    let axis = if through_rim { Vec3::new(0.0, 4.0, 0.0) } else { Vec3::new(0.2, 1.5, 0.4) };
    let cylinder = CylinderRecord::new(Vec3::ZERO, 1.0, axis);
    let rim = |at: f64| Ray { origin: Vec3::new(0.0, 3.0 + at, -2.0 - at), direction: Vec3::new(0.0, -1.0, 1.0) };
    let rays = if through_rim { (0..COUNT).map(|at| rim(at as f64)).collect() } else { rays() };
    let hits = rays.iter().filter(|ray| intersect(&cylinder, &axis, ray).is_some()).count();
    assert!(hits > COUNT / 4, "{hits} hits");
    plain(COUNT, move || {
        let lambdas = black_box(&rays).iter().filter_map(|ray| intersect(&cylinder, &axis, ray));
        black_box(lambdas.fold(0.0, |most: f64, (lambda, _)| most.max(lambda)));
    })
}
