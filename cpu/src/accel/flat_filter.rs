//! The structure for up to 64 objects most of which are spheres. Conservative tests in single precision, several at
//! once, find the objects that a ray may hit.

pub use crate::accel::may_hit::filter_ray::MAX_COORDINATE;
use crate::accel::{
    accelerator::Accelerator, accelerator::ScatterTerms, accelerator::Start, closest_hit::ClosestHit,
    dominant_sphere::DominantSphere, every_object::intersect_every_object, extent::Extent,
    may_hit::conservative::ConservativeRay, may_hit::conservative::is_too_short, may_hit::filter_ray::BLOCK,
    may_hit::filter_ray::BoundingSpheres, may_hit::filter_ray::FilterRay, may_hit::filter_ray::InfiniteCylinders,
    may_hit::filter_ray::misses, may_hit::target::Target, object::ObjectId, object::ObjectRef, object::bounding_sphere,
    object::count, stack::Stack,
};
use crate::{
    counters::Counter, counters::add, geometry::ray::Ray, input::error::Error, layout::OBJECTS, layout::Objects,
    layout::with_room, math::vec3::Vec3, simd::Simd, simd::SimdF32,
};

/// Maximum number of objects in a [`FlatFilter`]. Each object of a kind has one bit in a `u64`.
pub const MOST_OBJECTS: usize = u64::BITS as usize;

/// Maximum number of cylinders beside a dominant sphere. With more of them a tree is faster, because a box encloses a
/// cylinder closer than a bounding sphere does (docs/experiments.md, "Which limits were measured?").
const MOST_CYLINDERS: usize = 20;

/// Minimum number of spheres in a scene without a dominant sphere. With fewer of them a tree is as fast or faster.
const LEAST_SPHERES: usize = 9;

/// Whether this structure takes less time than a tree for these objects, which are at most [`MOST_OBJECTS`].
pub(crate) fn saves_time(objects: &impl Objects) -> bool {
    let (spheres, cylinders) = (objects.sphere_count(), objects.cylinder_count());
    if DominantSphere::of(objects).0.is_some() {
        cylinders <= MOST_CYLINDERS
    } else {
        spheres >= cylinders.max(LEAST_SPHERES)
    }
}

/// A cylinder is slender if its bounding sphere's radius is more than this multiple of its own radius.
const SLENDER: f64 = 2.0;

/// The structure for up to 64 objects. Its data are stored in lanes, whatever the layout of the
/// objects, because they only decide which objects are intersected.
#[derive(Debug)]
pub struct FlatFilter {
    middle: Vec3,
    dominant: DominantSphere,
    /// The objects that overlap the dominant sphere; see [`DominantSphere::overlapping`].
    pub(super) overlapping: Option<Vec<ObjectId>>,
    spheres: Vec<BoundingSpheres>,
    cylinders: Vec<(BoundingSpheres, InfiniteCylinders)>,
    /// Whether the infinite cylinders are tested after the bounding spheres: most cylinders are slender. Most rays that
    /// hit the bounding sphere of a slender cylinder miss the cylinder. Other cylinders nearly fill their spheres.
    pub(super) tests_infinite: bool,
    /// A bit for each lane of `spheres`, which is 1 if the lane holds an object. `cylinder_lanes` has the bits for the
    /// lanes of `cylinders`.
    sphere_lanes: u64,
    cylinder_lanes: u64,
}

impl FlatFilter {
    /// Builds the structure over `objects`.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`] if memory is short.
    pub(crate) fn new(objects: &impl Objects, extent: &Extent) -> Result<Self, Error> {
        let dominant = DominantSphere::of(objects);
        let mut filter = Self {
            middle: middle(objects, dominant),
            dominant,
            overlapping: dominant.overlapping(objects, extent),
            spheres: blocks(objects.sphere_count(), BoundingSpheres::EMPTY)?,
            cylinders: blocks(objects.cylinder_count(), (BoundingSpheres::EMPTY, InfiniteCylinders::EMPTY))?,
            tests_infinite: false,
            sphere_lanes: 0,
            cylinder_lanes: 0,
        };
        let mut slender = 0;
        for id in (0..count(objects) as ObjectId).filter(|&id| !dominant.is(id)) {
            match ObjectRef::of(objects, id) {
                ObjectRef::Sphere(index) => {
                    let record = objects.sphere(index).record;
                    let (block, lane) = (&mut filter.spheres[index / BLOCK], index % BLOCK);
                    block.set(lane, record.center - filter.middle, record.radius_squared);
                    filter.sphere_lanes |= 1 << index;
                }
                ObjectRef::Cylinder(index) => {
                    let target = Target::cylinder(&objects.cylinder(index).record, 0.0);
                    let center = target.center - filter.middle;
                    let ((spheres, cylinders), lane) = (&mut filter.cylinders[index / BLOCK], index % BLOCK);
                    spheres.set(lane, center, target.bounding_radius_squared);
                    cylinders.set(lane, center, &target);
                    filter.cylinder_lanes |= 1 << index;
                    let is_slender = SLENDER * SLENDER * target.radius_squared < target.bounding_radius_squared;
                    slender += usize::from(is_slender);
                }
            }
        }
        filter.tests_infinite = objects.cylinder_count() < 2 * slender;
        Ok(filter)
    }

    /// Returns a bit for each sphere, and a bit for each cylinder, which is 1 if the ray may hit the object. The
    /// dominant sphere is not tested, and its bit is 0.
    #[inline(always)]
    fn may_hit<S: Simd>(&self, ray: &Ray) -> (u64, u64) {
        let filter_ray = FilterRay::<S::F32>::new(ray, self.middle);
        let (mut missed_spheres, mut missed_cylinders) = (0_u64, 0_u64);
        for spheres in self.spheres.iter().rev() {
            for at in (0..BLOCK).step_by(S::F32::LANES).rev() {
                let missed = misses(filter_ray.spheres(spheres, at).miss);
                missed_spheres = missed_spheres << S::F32::LANES | u64::from(missed);
            }
        }
        for (spheres, cylinders) in self.cylinders.iter().rev() {
            for at in (0..BLOCK).step_by(S::F32::LANES).rev() {
                let spheres = filter_ray.spheres(spheres, at);
                let missed = misses(if self.tests_infinite {
                    spheres.miss.max(filter_ray.cylinders(&spheres, cylinders, at))
                } else {
                    spheres.miss
                });
                missed_cylinders = missed_cylinders << S::F32::LANES | u64::from(missed);
            }
        }
        (self.sphere_lanes & !missed_spheres, self.cylinder_lanes & !missed_cylinders)
    }
}

/// Returns as many empty blocks as `count` objects need.
fn blocks<T: Clone>(count: usize, empty: T) -> Result<Vec<T>, Error> {
    let mut blocks = with_room(count.div_ceil(BLOCK), OBJECTS)?;
    blocks.resize(count.div_ceil(BLOCK), empty);
    Ok(blocks)
}

/// Returns the middle of all objects but the dominant sphere. Coordinates relative to it lose the fewest digits in
/// single precision.
fn middle(objects: &impl Objects, dominant: DominantSphere) -> Vec3 {
    let (mut low, mut high) = (Vec3::splat(f64::INFINITY), Vec3::splat(f64::NEG_INFINITY));
    for id in (0..count(objects) as ObjectId).filter(|&id| !dominant.is(id)) {
        let (center, _) = bounding_sphere(objects, id);
        low = Vec3::new(low.x.min(center.x), low.y.min(center.y), low.z.min(center.z));
        high = Vec3::new(high.x.max(center.x), high.y.max(center.y), high.z.max(center.z));
    }
    if low.x > high.x { Vec3::ZERO } else { (low + high) * 0.5 }
}

impl Accelerator for FlatFilter {
    const MAY_BE_SLOW: bool = false;

    #[inline(always)]
    fn closest_hit<S: Simd, O: Objects>(&self, objects: &O, ray: &Ray, start: Start, _: &mut Stack) -> ClosestHit {
        let mut closest = ClosestHit::NOTHING;
        let conservative = ConservativeRay::new(*ray);
        if is_too_short(conservative.length_squared) {
            return intersect_every_object(objects, *ray);
        }
        let starts_on_dominant = self.dominant.is(start.object) && self.overlapping.is_some();
        if starts_on_dominant && let Some(overlapping) = &self.overlapping {
            // The processor often mispredicts a branch on whether a ray enters. So this branch uses the expected entry,
            // which is known early. The later branch on the actual entry is predicted well.
            if start.enters {
                if let Some(index) = self.dominant.may_be_hit(objects, &conservative) {
                    closest.intersect_sphere(objects, index, ray);
                }
                if !closest.is_hit() {
                    add(Counter::MispredictedEntries, 1);
                    return intersect_every_object(objects, *ray);
                }
                for &id in overlapping {
                    closest.intersect(objects, id, ray);
                }
                return closest;
            }
            if self.dominant.may_be_hit(objects, &conservative).is_some() {
                add(Counter::MispredictedEntries, 1);
                return intersect_every_object(objects, *ray);
            }
        }
        let (spheres, mut cylinders) = self.may_hit::<S>(ray);
        if !starts_on_dominant && let Some(index) = self.dominant.may_be_hit(objects, &conservative) {
            closest.intersect_uncertain_sphere(objects, index, ray);
        }
        // Most rays certainly hit no object. One branch returns for all of them, as early as possible.
        if spheres | cylinders == 0 {
            return closest;
        }
        closest.intersect_spheres(objects, spheres, ray);
        while cylinders != 0 {
            closest.intersect_cylinder(objects, cylinders.trailing_zeros() as usize, ray);
            cylinders &= cylinders - 1;
        }
        closest
    }

    #[inline(always)]
    fn start<O: Objects>(&self, objects: &O, ray: &Ray, object: ObjectId) -> Start {
        Start { object, enters: self.dominant.is(object) && self.dominant.is_entered_by(objects, ray) }
    }

    #[inline(always)]
    fn next_start<O: Objects>(&self, objects: &O, ray: &Ray, hit: &ClosestHit, terms: &ScatterTerms) -> Start {
        let &ClosestHit { object, lambda, .. } = hit;
        let is_dominant = self.dominant.is(object);
        Start { object, enters: is_dominant && self.dominant.predicts_entry(objects, ray, lambda, terms) }
    }
}
