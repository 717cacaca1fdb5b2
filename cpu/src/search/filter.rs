//! A filter over all objects, several at once, in single precision.

use super::ground::{Ground, is_avoided};
use super::leaving::leaves_cylinder;
use super::{Found, NOWHERE, ObjectId};
use crate::certified::Intersect;
use crate::error::Error;
use crate::layout::Objects;
use crate::prepare::Extent;
use crate::ray::{LAMBDA_MIN, Ray};
use crate::simd::{FilterLanes, Simd};
use crate::vec3::Vec3;

/// Objects filtered at once; every instruction set's lanes divide it.
const BLOCK: usize = 16;

/// Most spheres, and most cylinders, of a filter: their bits fill a word.
pub const CAPACITY: usize = 64;

/// Half a unit in the last place of 1: the relative error of one rounding to single precision.
const ROUNDING: f32 = f32::EPSILON / 2.0;
/// Margin of the sphere's discriminant, in roundings of its terms.
const SPHERE_MARGIN: f32 = 64.0 * ROUNDING;
/// Margin of the cylinder's discriminant, whose terms have passed through one more cancellation.
const SIDE_MARGIN: f32 = 224.0 * ROUNDING;

/// Bounding spheres of 16 objects, relative to the scene's middle; what is not there has radius "minus infinity".
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
struct Balls {
    x: [f32; BLOCK],
    y: [f32; BLOCK],
    z: [f32; BLOCK],
    /// Minus the radius squared, with its margin.
    minus_radius_squared: [f32; BLOCK],
}

/// Infinite cylinders of 16 objects.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
struct Tubes {
    x: [f32; BLOCK],
    y: [f32; BLOCK],
    z: [f32; BLOCK],
    /// Minus the radius squared, with its margin.
    minus_radius_squared: [f32; BLOCK],
}

impl Balls {
    const EMPTY: Self =
        Self { x: [0.0; BLOCK], y: [0.0; BLOCK], z: [0.0; BLOCK], minus_radius_squared: [f32::INFINITY; BLOCK] };
}

impl Tubes {
    const EMPTY: Self =
        Self { x: [0.0; BLOCK], y: [0.0; BLOCK], z: [1.0; BLOCK], minus_radius_squared: [f32::INFINITY; BLOCK] };
}

/// The filter's data: lanes in both layouts, for it decides nothing but which objects are asked.
#[derive(Debug)]
pub struct Filter {
    middle: Vec3,
    ground: Ground,
    /// See [`Ground::sunk`].
    sunk: Option<Vec<ObjectId>>,
    spheres: Vec<Balls>,
    cylinders: Vec<(Balls, Tubes)>,
    sphere_count: u32,
}

/// A ray as the filter sees it.
struct FilterRay<F> {
    origin: [F; 3],
    direction: [F; 3],
    minus_a: F,
    /// `a t^2` and `-2 t` for the smallest lambda that counts, `t`.
    a_t_t: F,
    minus_two_t: F,
    /// Minus the margins' share that grows with the origin's distance from the middle.
    minus_sphere_share: F,
    minus_side_share: F,
}

impl<F: FilterLanes> FilterRay<F> {
    #[inline(always)]
    fn new(ray: &Ray, middle: Vec3, a: f64) -> Self {
        let (origin, direction) = (ray.origin - middle, ray.direction);
        let distance_squared = origin.dot(origin) as f32;
        let a = a as f32;
        Self {
            origin: [F::splat(origin.x as f32), F::splat(origin.y as f32), F::splat(origin.z as f32)],
            direction: [F::splat(direction.x as f32), F::splat(direction.y as f32), F::splat(direction.z as f32)],
            minus_a: F::splat(-a),
            a_t_t: F::splat(a * (LAMBDA_MIN * LAMBDA_MIN) as f32),
            minus_two_t: F::splat((-2.0 * LAMBDA_MIN) as f32),
            minus_sphere_share: F::splat(-SPHERE_MARGIN * distance_squared),
            minus_side_share: F::splat(-SIDE_MARGIN * distance_squared),
        }
    }

    /// Products of a ball with the ray: from origin to centre, `h` and the distance squared.
    #[inline(always)]
    fn relative(&self, balls: &Balls, at: usize) -> ([F; 3], F, F) {
        let [dx, dy, dz] = self.direction;
        let x = F::load(&balls.x[at..]) - self.origin[0];
        let y = F::load(&balls.y[at..]) - self.origin[1];
        let z = F::load(&balls.z[at..]) - self.origin[2];
        let h = dz.mul_add(z, dy.mul_add(y, dx * x));
        let q = z.mul_add(z, y.mul_add(y, x * x));
        ([x, y, z], h, q)
    }

    /// Which balls the ray may enter ahead.
    #[inline(always)]
    fn meets(&self, h: F, q: F, minus_radius_squared: F) -> u32 {
        let zero = F::splat(0.0);
        let c = q.mul_add(F::splat(1.0 - SPHERE_MARGIN), minus_radius_squared + self.minus_sphere_share);
        let discriminant = h.mul_add(h, self.minus_a * c);
        let past = h.mul_add(self.minus_two_t, self.a_t_t) + c;
        zero.less_equal(discriminant) & (zero.less_equal(h) | past.less_equal(zero))
    }

    /// Which infinite cylinders the ray may touch.
    #[inline(always)]
    fn touches(&self, r: [F; 3], h: F, q: F, tubes: &Tubes, at: usize) -> u32 {
        let [dx, dy, dz] = self.direction;
        let (x, y, z) = (F::load(&tubes.x[at..]), F::load(&tubes.y[at..]), F::load(&tubes.z[at..]));
        let zero = F::splat(0.0);
        let slope = dz.mul_add(z, dy.mul_add(y, dx * x));
        let along = r[2].mul_add(z, r[1].mul_add(y, r[0] * x));
        let minus_slope = zero - slope;
        // Minus a, and h, of the components perpendicular to the axis; c with its margin.
        let minus_a = slope.mul_add(slope, self.minus_a);
        let h = minus_slope.mul_add(along, h);
        let constant = F::load(&tubes.minus_radius_squared[at..]) + self.minus_side_share;
        let c = (zero - along).mul_add(along, q.mul_add(F::splat(1.0 - SIDE_MARGIN), constant));
        // The rounding of minus_a can outweigh it where the ray runs along the axis: a share of the whole a stays.
        let slack = self.minus_a * F::splat(-SIDE_MARGIN) * (q - constant);
        zero.less_equal(h.mul_add(h, minus_a.mul_add(c, slack)))
    }
}

impl Filter {
    /// The filter over `objects`.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    pub fn new(objects: &impl Objects, extent: &Extent) -> Result<Self, Error> {
        let (sphere_count, cylinder_count) = (objects.sphere_count(), objects.cylinder_count());
        let ground = Ground::of(objects);
        let middle = middle(objects, ground);
        let mut spheres = blocks(sphere_count, Balls::EMPTY)?;
        let mut cylinders = blocks(cylinder_count, (Balls::EMPTY, Tubes::EMPTY))?;
        for index in (0..sphere_count).filter(|&index| !ground.is(index as ObjectId)) {
            let sphere = objects.sphere(index).record;
            let (block, lane) = (&mut spheres[index / BLOCK], index % BLOCK);
            block.set(lane, sphere.center - middle, sphere.radius_squared);
        }
        for index in 0..cylinder_count {
            let cylinder = objects.cylinder(index).record;
            let ((balls, tubes), lane) = (&mut cylinders[index / BLOCK], index % BLOCK);
            let half_height_squared = cylinder.half_height * cylinder.half_height;
            balls.set(lane, cylinder.center - middle, cylinder.radius_squared + half_height_squared);
            tubes.x[lane] = cylinder.axis.x as f32;
            tubes.y[lane] = cylinder.axis.y as f32;
            tubes.z[lane] = cylinder.axis.z as f32;
            tubes.minus_radius_squared[lane] = -outer(cylinder.radius_squared, SIDE_MARGIN);
        }
        let sunk = ground.sunk(objects, extent);
        Ok(Self { middle, ground, sunk, spheres, cylinders, sphere_count: sphere_count as u32 })
    }

    /// See [`Search::forget_who_is_alone`](super::Search::forget_who_is_alone).
    pub fn forget_who_is_alone(&mut self) {
        self.sunk = None;
    }

    /// The nearest object that a ray from the surface of `from` meets.
    #[inline(always)]
    pub fn nearest<S: Simd, O: Objects, P: Intersect>(&self, objects: &O, ray: &Ray, from: ObjectId) -> Found {
        let mut found = Found::NOTHING;
        let a = ray.direction.dot(ray.direction);
        if self.ground.is(from)
            && let Some(sunk) = &self.sunk
        {
            self.ground.ask::<O, P>(&mut found, objects, ray, a);
            if found.is_hit() {
                for &id in sunk {
                    found.ask::<O, P>(objects, id, ray);
                }
                return found;
            }
        }
        let filter_ray = FilterRay::<S::F32>::new(ray, self.middle, a);
        let mut spheres = 0_u64;
        for (number, balls) in self.spheres.iter().enumerate() {
            for at in (0..BLOCK).step_by(S::F32::LANES) {
                let (_, h, q) = filter_ray.relative(balls, at);
                let bits = filter_ray.meets(h, q, S::F32::load(&balls.minus_radius_squared[at..]));
                spheres |= u64::from(bits) << (number * BLOCK + at);
            }
        }
        let mut cylinders = 0_u64;
        for (number, (balls, tubes)) in self.cylinders.iter().enumerate() {
            for at in (0..BLOCK).step_by(S::F32::LANES) {
                let (r, h, q) = filter_ray.relative(balls, at);
                let ball_bits = filter_ray.meets(h, q, S::F32::load(&balls.minus_radius_squared[at..]));
                let bits = ball_bits & filter_ray.touches(r, h, q, tubes, at);
                cylinders |= u64::from(bits) << (number * BLOCK + at);
            }
        }
        // The object that the ray starts on passes every filter; mostly the ray leaves it.
        if from < self.sphere_count {
            if !self.ground.is(from) && is_avoided(objects, from as usize, ray, a) {
                spheres &= !(1 << from);
            }
        } else if from != NOWHERE {
            let index = from - self.sphere_count;
            let cylinder = objects.cylinder(index as usize).record;
            if leaves_cylinder(&cylinder, &cylinder.seen_from(ray.origin), ray.direction, ray.origin) {
                cylinders &= !(1 << index);
            }
        }
        if let Some(ground) = self.ground.id()
            && !(self.sunk.is_some() && from == ground)
            && !is_avoided(objects, ground as usize, ray, a)
        {
            spheres |= 1 << ground;
        }
        // One branch for the commonest answer, as early as it can be known.
        if spheres | cylinders == 0 {
            return found;
        }
        while spheres != 0 {
            found.ask_sphere::<O, P>(objects, spheres.trailing_zeros() as usize, ray);
            spheres &= spheres - 1;
        }
        while cylinders != 0 {
            found.ask_cylinder::<O, P>(objects, cylinders.trailing_zeros() as usize, ray);
            cylinders &= cylinders - 1;
        }
        found
    }
}

impl Balls {
    fn set(&mut self, lane: usize, center: Vec3, radius_squared: f64) {
        self.x[lane] = center.x as f32;
        self.y[lane] = center.y as f32;
        self.z[lane] = center.z as f32;
        self.minus_radius_squared[lane] = -outer(radius_squared, SPHERE_MARGIN);
    }
}

/// `radius_squared` rounded up with its margin.
fn outer(radius_squared: f64, margin: f32) -> f32 {
    (radius_squared * (1.0 + f64::from(margin))) as f32
}

/// As many blocks as `count` objects take.
fn blocks<T: Clone>(count: usize, empty: T) -> Result<Vec<T>, Error> {
    let mut blocks = Vec::new();
    let number = count.div_ceil(BLOCK);
    blocks.try_reserve_exact(number).map_err(|_| Error::OutOfMemory { what: "the objects" })?;
    blocks.resize(number, empty);
    Ok(blocks)
}

/// The middle of all that is filtered: coordinates relative to it lose least in single precision.
fn middle(objects: &impl Objects, ground: Ground) -> Vec3 {
    let (mut low, mut high) = (Vec3::splat(f64::INFINITY), Vec3::splat(f64::NEG_INFINITY));
    let spheres = (0..objects.sphere_count()).filter(|&index| !ground.is(index as ObjectId));
    let centers = spheres.map(|index| objects.sphere(index).record.center);
    for center in centers.chain((0..objects.cylinder_count()).map(|index| objects.cylinder(index).record.center)) {
        low = Vec3::new(low.x.min(center.x), low.y.min(center.y), low.z.min(center.z));
        high = Vec3::new(high.x.max(center.x), high.y.max(center.y), high.z.max(center.z));
    }
    if low.x > high.x { Vec3::ZERO } else { (low + high) * 0.5 }
}
