//! What surfaces do with a ray (statement, section 3.5), and their random vectors.

use cpu::{Material, Scatter, Vec3};

use crate::random::Stream;
use crate::rules::Rules;

/// The two kinds of surfaces that have random vectors, as things of [`Rules::covers`].
const MATTE: u32 = 1;
const METAL: u32 = 2;

/// What decides whether a refractive surface reflects a ray.
#[derive(Clone, Copy, Debug)]
pub struct Refraction {
    /// The refractive index of the material.
    pub index: f64,
    /// The index, or its inverse if the ray enters.
    pub ratio: f64,
    /// The cosine of the angle of incidence, by a normal that may not be a unit.
    pub cos: f64,
    /// The sine of the angle of incidence, from the cosine.
    pub sin: f64,
    /// Whether the surface reflects the ray.
    pub reflects: bool,
}

/// How surfaces scatter.
#[derive(Clone, Debug)]
pub struct Scatterer {
    /// The convention of the random vectors.
    pub convention: Scatter,
    /// The stream that all materials share.
    pub stream: Stream,
    /// The random numbers of the last surface.
    pub draws: Vec<f64>,
    /// The random vector that was made last.
    pub last: Vec3,
    /// Half the width of the interval of the last random numbers, and what a vector of length 1 is multiplied by.
    pub half_and_extent: [f64; 2],
    /// What the last surface decided, if it is refractive.
    pub refraction: Option<Refraction>,
}

impl Scatterer {
    /// Returns the surfaces that draw from `stream`.
    pub fn new(convention: Scatter, stream: Stream) -> Self {
        let last = Vec3::ZERO;
        Self { convention, stream, draws: Vec::new(), last, half_and_extent: [1.0; 2], refraction: None }
    }

    /// Returns the direction of the scattered ray. `d` is that of the ray that hits a surface, and `n` the normal on
    /// its side.
    pub fn scatter(&mut self, material: &Material, d: Vec3, n: Vec3, is_front: bool, rules: &Rules) -> Vec3 {
        self.draws.clear();
        self.refraction = None;
        match *material {
            Material::Matte { .. } => self.matte(n, rules),
            Material::Metal { diffusion, .. } => self.metal(diffusion, d, n, rules),
            Material::Refractive { index } => self.refractive(index, d, n, is_front, rules),
        }
    }

    fn matte(&mut self, n: Vec3, rules: &Rules) -> Vec3 {
        let mut vector = self.vector(1.0, MATTE, rules);
        if rules.has("hemisphere") && vector.dot(n) <= 0.0 {
            vector = -vector;
        }
        let is_alone = rules.has("alone") || rules.or("hemisphere", 0.0) == 1.0;
        let direction = if is_alone { vector } else { n + vector };
        if direction.is_negligible() { n } else { direction }
    }

    fn metal(&mut self, diffusion: f64, d: Vec3, n: Vec3, rules: &Rules) -> Vec3 {
        let d = if rules.has("metal-first") { d.unit() } else { d };
        let mirrored = d - n * (rules.or("mirror", 2.0) * d.dot(n));
        let is_raw = ["metal-raw", "metal-first", "metal-last"].iter().any(|name| rules.has(name));
        let mirrored = if is_raw { mirrored } else { mirrored.unit() };
        let diffusion = diffusion.min(rules.or("diffusion-most", f64::INFINITY));
        if rules.has("smooth") && diffusion == 0.0 || rules.or("no-diffusion", 0.0) == 2.0 {
            return mirrored;
        }
        let vector = self.vector(rules.or("diffusion-one", diffusion), METAL, rules);
        let direction = if rules.has("no-diffusion") { mirrored } else { mirrored + vector };
        if rules.has("metal-last") { direction.unit() } else { direction }
    }

    fn refractive(&mut self, index: f64, d: Vec3, n: Vec3, is_front: bool, rules: &Rules) -> Vec3 {
        let u = if rules.has("glass-raw") { d } else { d.unit() };
        let cos = (-u.dot(n)).min(1.0);
        let sin = (1.0 - cos * cos).sqrt();
        let [inside, outside] = if is_front { [1.0 / index, index] } else { [index, 1.0 / index] };
        let ratio = [inside, outside, index, 1.0 / index][rules.or("rho", 0.0) as usize];
        let mut reflects = ratio * sin > 1.0 && !rules.has("no-reflection");
        if rules.has("schlick") && !reflects {
            let r0 = ((1.0 - ratio) / (1.0 + ratio)) * ((1.0 - ratio) / (1.0 + ratio));
            reflects = r0 + (1.0 - r0) * (1.0 - cos).powi(5) > self.stream.draw(0.0, 1.0);
        }
        self.refraction = Some(Refraction { index, ratio, cos, sin, reflects });
        if reflects {
            return u - n * (2.0 * u.dot(n));
        }
        let p = (u + n * cos) * ratio;
        p - n * (rules.or("along", 1.0) * (1.0 - p.dot(p)).abs().sqrt())
    }

    /// Returns the next random vector. `extent` is 1 for a matte surface, and the diffusion for metal.
    pub fn vector(&mut self, extent: f64, surface: u32, rules: &Rules) -> Vec3 {
        let is_unit = self.convention == Scatter::Published || rules.covers("unit-vectors", surface);
        let [is_in_ball, is_cube] = ["ball", "cube"].map(|name| rules.covers(name, surface));
        let half = if is_unit || is_in_ball || is_cube { 1.0 } else { extent };
        self.half_and_extent = [half, extent];
        let [low, high] = [half * rules.or("low", -1.0), half * rules.or("high", 1.0)];
        loop {
            if self.convention == Scatter::Deterministic {
                return Vec3::ZERO;
            }
            let mut numbers = [self.stream.draw(low, high); 3];
            if !rules.has("one-draw") {
                numbers[1..].fill_with(|| self.stream.draw(low, high));
            }
            self.draws.extend(numbers);
            if rules.has("zyx") {
                numbers.reverse();
            }
            let vector = Vec3::from(numbers);
            let squared = vector.dot(vector);
            if (is_unit || is_in_ball) && !(squared > 1e-160 && squared <= 1.0) {
                continue;
            }
            let length = if is_unit || is_cube { squared.sqrt() } else { 1.0 };
            self.last = if half == extent && length == 1.0 { vector } else { vector / length * extent };
            return self.last;
        }
    }
}
