//! The structure for up to eight objects. All of them are tested in double precision: one object for several rays at
//! once, or several objects for one ray at once.
//!
//! The [conservative tests](crate::accel::may_hit::conservative) find the objects that a ray may hit, and the exact
//! formulas intersect these. If a ray may hit no object, it certainly escapes.

use crate::accel::{
    accelerator::Accelerator, accelerator::Start, closest_hit::ClosestHit, dominant_sphere::DominantSphere,
    extent::Extent, extent::is_within, may_hit::conservative::ConservativeRay, may_hit::conservative::is_too_short,
    may_hit::object_lanes::ObjectLanes, object::ObjectId, object::count, stack::Stack,
};
use crate::{geometry::ray::Ray, layout::Objects, simd::Simd, simd::SimdF64};

/// If a scene has at least this many objects, a ray of a path is tested against several objects at once, one in each
/// lane. Fewer objects would fill too few lanes, so such a scene may be traced with a lookahead instead.
const FEWEST_IN_LANES: usize = 4;

/// The limit for a scene with a ground, which counts as an object. Many rays escape above a ground, so a lookahead
/// often ends several paths at once (docs/experiments.md).
const FEWEST_IN_LANES_ON_GROUND: usize = 6;

/// The structure for up to eight objects.
#[derive(Clone, Debug)]
pub struct SmallScene {
    /// Number of objects.
    count: usize,
    /// Whether lanes hold several objects for one ray. Otherwise they hold several rays for one object.
    pub(super) uses_object_lanes: bool,
    /// Whether the scene has a ground, above which many rays escape; see [`DominantSphere::is_ground`].
    has_ground: bool,
    /// The objects in lanes, for one ray or several, which start within the scene's extent.
    pub object_lanes: ObjectLanes,
    /// The largest coordinate of the scene; see [`Extent::max_coordinate`].
    pub(super) max_coordinate: f64,
}

impl SmallScene {
    /// Builds the structure over `objects`.
    pub(crate) fn new(objects: &impl Objects, &Extent { max_coordinate, .. }: &Extent) -> Self {
        let count = count(objects);
        let has_ground = DominantSphere::of(objects).is_ground(objects);
        let uses_object_lanes = count >= if has_ground { FEWEST_IN_LANES_ON_GROUND } else { FEWEST_IN_LANES };
        let object_lanes = ObjectLanes::new(objects, max_coordinate);
        Self { count, uses_object_lanes, has_ground, object_lanes, max_coordinate }
    }

    /// Whether lanes hold several objects for one ray. Otherwise lanes hold several rays for one object.
    #[inline(always)]
    pub const fn uses_object_lanes(&self) -> bool {
        self.uses_object_lanes
    }

    /// Whether the latency of comparisons matters more than the width of the lanes for a lookahead. Above a ground it
    /// does not, because a wider lookahead ends more paths at once.
    pub(crate) const fn looks_ahead_promptly(&self) -> bool {
        !self.has_ground
    }

    /// Returns a bit for each object, by its [number](ObjectId). The bit is 1 if the ray may hit the object. The ray
    /// must start inside the scene's extent.
    #[inline(always)]
    pub(crate) fn objects_may_hit<V: SimdF64, O: Objects>(&self, objects: &O, ray: &Ray) -> u32 {
        debug_assert!(is_within(ray.origin, self.max_coordinate));
        if self.uses_object_lanes() {
            return self.object_lanes.objects_may_hit::<V>(ray);
        }
        let conservative = ConservativeRay::new(*ray);
        if is_too_short(conservative.length_squared) {
            return (1 << self.count) - 1;
        }
        let mut may_hit = 0;
        for id in 0..count(objects) as ObjectId {
            may_hit |= u32::from(conservative.may_hit(objects, id, self.max_coordinate)) << id;
        }
        may_hit
    }
}

/// Returns the closest hit of a ray among the objects whose bits are set in `may_hit`.
#[inline(always)]
pub(crate) fn closest_hit_among<O: Objects>(objects: &O, ray: &Ray, may_hit: u32) -> ClosestHit {
    let mut closest = ClosestHit::NOTHING;
    intersect_spheres(&mut closest, objects, ray, may_hit);
    intersect_cylinders(&mut closest, objects, ray, may_hit >> objects.sphere_count());
    closest
}

/// Intersects the spheres whose bits are set in `may_hit`, and updates `closest`. The loop visits all spheres. So the
/// processor can predict each branch before the bits are known.
#[inline(always)]
fn intersect_spheres<O: Objects>(closest: &mut ClosestHit, objects: &O, ray: &Ray, may_hit: u32) {
    for index in 0..objects.sphere_count() {
        if may_hit >> index & 1 == 1 {
            closest.intersect_sphere(objects, index, ray);
        }
    }
}

/// Intersects the cylinders whose bits are set in `may_hit`, and updates `closest`. See [`intersect_spheres`].
#[inline(always)]
fn intersect_cylinders<O: Objects>(closest: &mut ClosestHit, objects: &O, ray: &Ray, may_hit: u32) {
    for index in 0..objects.cylinder_count() {
        if may_hit >> index & 1 == 1 {
            closest.intersect_cylinder(objects, index, ray);
        }
    }
}

impl Accelerator for SmallScene {
    const MAY_BE_SLOW: bool = false;

    #[inline(always)]
    fn closest_hit<S: Simd, O: Objects>(&self, objects: &O, ray: &Ray, _: Start, _: &mut Stack) -> ClosestHit {
        let (may_hit, mut closest) = (self.objects_may_hit::<S::F64, O>(objects, ray), ClosestHit::NOTHING);
        // Most rays can hit no object of a kind, so one branch for each kind skips the loop over its objects.
        if may_hit & ((1 << objects.sphere_count()) - 1) != 0 {
            intersect_spheres(&mut closest, objects, ray, may_hit);
        }
        if may_hit >> objects.sphere_count() != 0 {
            intersect_cylinders(&mut closest, objects, ray, may_hit >> objects.sphere_count());
        }
        closest
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accel::object::NO_OBJECT;
    use crate::input::scene::Scene;
    use crate::layout::aos::AosObjects;
    use crate::math::real::Real;
    use crate::math::vec3::Vec3;
    use crate::reference::intersect::{Exact, Intersect, Plain};
    use crate::sampling::uniform::Uniform;
    use crate::simd::instruction_set::InstructionSet;
    use crate::simd::{Kernel, Simd};

    const SCENE: &str = "matte: m 1 1 1\nsphere: 0 -101 0 100 m\nsphere: 1 0 0 1 m\nsphere: -1 0.5 2 .25 m\n\
                         cylinder: 0 0 -2 .5 1 2 .5 m\ncylinder: 3 1 1 .1 0 0 4 m\n";
    const EXTENT: f64 = 201.0;

    /// A kernel that intersects one ray, the same in all lanes. It returns the objects that the ray may hit, and the
    /// hit.
    struct MayHit<'a> {
        small_scene: &'a SmallScene,
        objects: &'a AosObjects,
        ray: Ray,
    }

    impl Kernel for MayHit<'_> {
        type Output = (u32, ClosestHit);

        #[inline(always)]
        fn call<S: Simd>(self, _: S) -> (u32, ClosestHit) {
            let ray = Ray { origin: self.ray.origin.map(S::F64::of), direction: self.ray.direction.map(S::F64::of) };
            let each = self.small_scene.object_lanes.objects_may_hit_lanes(&ray, 0);
            let may_hit = each.of_lane(0);
            assert_eq!(each.any, if may_hit == 0 { 0 } else { (1 << S::F64::LANES) - 1 });
            assert!((1..S::F64::LANES).all(|lane| each.of_lane(lane) == may_hit), "{each:?}");
            // Lane 1, marked as too short, gets all objects, and lane 0 keeps its own.
            let with_short = self.small_scene.object_lanes.objects_may_hit_lanes(&ray, 0b10);
            assert_eq!([0, 1].map(|lane| with_short.of_lane(lane)), [may_hit, (1 << count(self.objects)) - 1]);
            assert_eq!(self.small_scene.objects_may_hit::<S::F64, _>(self.objects, &self.ray), may_hit);
            let (start, mut stack) = (Start { object: NO_OBJECT, enters: false }, Stack::EMPTY);
            (may_hit, self.small_scene.closest_hit::<S, _>(self.objects, &self.ray, start, &mut stack))
        }
    }

    #[test]
    fn every_object_that_a_ray_hits_passes_and_few_others_do() {
        let scene = Scene::parse(SCENE.as_bytes()).expect("the scene is valid");
        let objects = AosObjects::build(&scene).expect("it fits");
        let small_scene =
            SmallScene::new(&objects, &Extent { max_coordinate: EXTENT, moderate: true, has_tiny: false });
        // The other way to test the objects: one after the other, or several at once.
        let other_way = SmallScene { uses_object_lanes: !small_scene.uses_object_lanes, ..small_scene.clone() };
        let mut draws = Uniform::new(5);
        let (mut tests_passed, mut hits) = (0, 0);
        for number in 0..4000 {
            let mut place = || Vec3::from([(); 3].map(|()| draws.draw(-3.0, 3.0)));
            let (mut origin, mut direction) = (place(), place());
            if number % 2 == 0 {
                // The ray starts on a surface. Every other such ray goes along the surface.
                let sphere = objects.sphere(number / 2 % 3).record;
                let normal = (origin - sphere.center).unit();
                origin = sphere.center + normal * sphere.radius;
                if number % 4 == 0 {
                    direction = direction.perpendicular_to(normal) + normal * (draws.draw(-1.0, 1.0) * 1e-9);
                }
            }
            let ray = Ray { origin, direction };
            let mut hit = 0;
            for index in 0..objects.sphere_count() {
                let record = objects.sphere(index).record;
                let any = [record.intersect(&ray), Plain::sphere(&record, &ray), Exact::sphere(&record, &ray)];
                hit |= u32::from(any.iter().any(Option::is_some)) << index;
            }
            for index in 0..objects.cylinder_count() {
                let (record, file_axis) = (objects.cylinder(index).record, objects.file_axis(index));
                let exact = Exact::cylinder(&record, &file_axis, &ray);
                let any = [record.intersect(&ray), Plain::cylinder(&record, &file_axis, &ray), exact];
                hit |= u32::from(any.iter().any(Option::is_some)) << (objects.sphere_count() + index);
            }
            for set in InstructionSet::available() {
                let (may_hit, closest) = set.run(MayHit { small_scene: &small_scene, objects: &objects, ray });
                assert_eq!(hit & !may_hit, 0, "{}, {ray:?}: hit {hit:b}, may hit {may_hit:b}", set.name());
                let by_other = set.run(MayHit { small_scene: &other_way, objects: &objects, ray });
                assert_eq!((may_hit, closest), by_other, "{}, {ray:?}", set.name());
                assert_eq!(closest, closest_hit_among(&objects, &ray, hit), "{}, {ray:?}", set.name());
                tests_passed += may_hit.count_ones();
                hits += hit.count_ones();
            }
        }
        let sets = InstructionSet::available().count() as u32;
        assert!(hits > 2_500 * sets && tests_passed < hits * 3 / 2, "{tests_passed} for {hits} with {sets} sets");
    }
}
