//! A search for scenes of a handful of objects: every object is filtered in double precision, by several rays at once
//! or, for one ray, several objects at once.
//!
//! The [filter](crate::accel::conservative) says which objects a ray may meet, and so which rays certainly leave the
//! scene; the exact formulas are for the others.

use crate::accel::bvh::stack::Stack;
use crate::accel::closest_hit::ClosestHit;
use crate::accel::conservative::{ConservativeRay, is_too_short};
use crate::accel::extent::Extent;
use crate::accel::find::{Accelerator, Origin};
use crate::accel::object::{ObjectId, count, in_order};
use crate::accel::side_by_side::{MayHitLanes, ObjectLanes, PLACES};
use crate::geometry::ray::Ray;
use crate::input::error::Error;
use crate::layout::Objects;
use crate::simd::{Simd, SimdF64};

/// Fewest objects of which those that one ray may meet are found side by side: fewer fill too few lanes.
const FEWEST_SIDE_BY_SIDE: usize = 4;

/// A search over a handful of objects.
#[derive(Clone, Debug)]
pub struct SmallScene {
    in_order: Vec<ObjectId>,
    side_by_side: ObjectLanes,
    reach: f64,
}

impl SmallScene {
    /// The search over `objects`.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    pub fn new(objects: &impl Objects, extent: &Extent) -> Result<Self, Error> {
        let side_by_side = ObjectLanes::new(objects, extent.reach);
        Ok(Self { in_order: in_order(objects)?, side_by_side, reach: extent.reach })
    }

    /// The objects in the order of the file.
    #[must_use]
    pub fn in_order(&self) -> &[ObjectId] {
        &self.in_order
    }

    /// How far the scene reaches.
    #[inline(always)]
    pub(super) const fn reach(&self) -> f64 {
        self.reach
    }

    /// Whether lanes hold several objects for one ray; otherwise they hold several rays for one object.
    #[inline(always)]
    #[must_use]
    pub fn uses_object_lanes(&self) -> bool {
        self.in_order.len() >= FEWEST_SIDE_BY_SIDE
    }

    /// The nearest object that a ray, which starts within the scene's reach, meets.
    #[inline(always)]
    pub fn closest_hit<V: SimdF64, O: Objects>(&self, objects: &O, ray: &Ray) -> ClosestHit {
        let (touched, mut found) = (self.objects_may_hit::<V, O>(objects, ray), ClosestHit::NOTHING);
        // Where there are several of a kind, mostly none of them is touched.
        if touched & ((1 << objects.sphere_count()) - 1) != 0 {
            intersect_spheres(&mut found, objects, ray, touched);
        }
        if touched >> objects.sphere_count() != 0 {
            intersect_cylinders(&mut found, objects, ray, touched >> objects.sphere_count());
        }
        found
    }

    /// The objects that one ray, which starts within the scene's reach, may meet: a bit each, by [id](ObjectId).
    #[inline(always)]
    pub fn objects_may_hit<V: SimdF64, O: Objects>(&self, objects: &O, ray: &Ray) -> u32 {
        if self.uses_object_lanes() {
            return self.side_by_side.objects_may_hit::<V>(ray);
        }
        let touch = ConservativeRay::new(*ray);
        if is_too_short(touch.length_squared) {
            return (1 << self.in_order.len()) - 1;
        }
        let mut touched = 0;
        for index in 0..objects.sphere_count() {
            touched |= u32::from(touch.sphere_at(objects, index)) << index;
        }
        for index in 0..objects.cylinder_count() {
            let id = objects.sphere_count() + index;
            touched |= u32::from(touch.cylinder_at(objects, index, self.reach)) << id;
        }
        touched
    }

    /// Whether each of several rays, which start within the scene's reach, may meet an object. Of no meaning for
    /// directions that are [too short](is_too_short).
    #[inline(always)]
    pub fn touches<V: SimdF64>(&self, id: ObjectId, touch: &ConservativeRay<V>) -> V::Mask {
        self.side_by_side.touches(id as usize, touch)
    }

    /// The objects that each of several rays, which start within the scene's reach, may meet. `too_short` holds the
    /// lanes whose directions are [too short](is_too_short), as bits, or more lanes.
    #[inline(always)]
    pub fn objects_may_hit_lanes<V: SimdF64>(&self, ray: &Ray<V>, too_short: u32) -> MayHitLanes {
        self.side_by_side.objects_may_hit_lanes(ray, too_short)
    }
}

/// Of the objects that this ray may meet, a bit each, the nearest that it meets.
#[inline(always)]
pub fn closest_hit_among<O: Objects>(objects: &O, ray: &Ray, touched: u32) -> ClosestHit {
    let mut found = ClosestHit::NOTHING;
    intersect_spheres(&mut found, objects, ray, touched);
    intersect_cylinders(&mut found, objects, ray, touched >> objects.sphere_count());
    found
}

/// Takes the spheres of `touched` into account: one after the other, so that the processor can guess which it will be
/// before it knows the bits.
#[inline(always)]
fn intersect_spheres<O: Objects>(found: &mut ClosestHit, objects: &O, ray: &Ray, touched: u32) {
    for index in 0..objects.sphere_count() {
        if touched >> index & 1 == 1 {
            found.intersect_sphere(objects, index, ray);
        }
    }
}

/// The same with cylinders.
#[inline(always)]
fn intersect_cylinders<O: Objects>(found: &mut ClosestHit, objects: &O, ray: &Ray, touched: u32) {
    for index in 0..objects.cylinder_count() {
        if touched >> index & 1 == 1 {
            found.intersect_cylinder(objects, index, ray);
        }
    }
}

/// Whether a scene of this many objects is searched like this.
#[must_use]
pub fn suits(objects: &impl Objects) -> bool {
    count(objects) <= PLACES
}

impl Accelerator for SmallScene {
    #[inline(always)]
    fn closest_hit_from<S: Simd, O: Objects>(&self, objects: &O, ray: &Ray, _: Origin, _: &mut Stack) -> ClosestHit {
        self.closest_hit::<S::F64, O>(objects, ray)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
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
    const REACH: f64 = 201.0;

    /// Which objects the first lane's ray, the same in all lanes, may meet, and which it meets first.
    struct Touched<'a> {
        few: &'a SmallScene,
        objects: &'a AosObjects,
        ray: Ray,
    }

    impl Kernel for Touched<'_> {
        type Output = (u32, ClosestHit);

        #[inline(always)]
        fn call<S: Simd>(self, _: S) -> (u32, ClosestHit) {
            let ray = Ray { origin: self.ray.origin.map(S::F64::of), direction: self.ray.direction.map(S::F64::of) };
            let each = self.few.objects_may_hit_lanes(&ray, 0);
            let touched = each.by(0);
            assert_eq!(each.any(), if touched == 0 { 0 } else { (1 << S::F64::LANES) - 1 });
            assert!((1..S::F64::LANES).all(|lane| each.by(lane) == touched), "{each:?}");
            assert_eq!(self.few.objects_may_hit::<S::F64, _>(self.objects, &self.ray), touched);
            (touched, self.few.closest_hit::<S::F64, _>(self.objects, &self.ray))
        }
    }

    #[test]
    fn what_a_ray_meets_it_touches_and_most_of_what_it_touches_it_meets() {
        let scene = Scene::parse(SCENE.as_bytes()).expect("the scene is valid");
        let objects = AosObjects::build(&scene).expect("it fits");
        let few = SmallScene::new(&objects, &Extent { reach: REACH, moderate: true }).expect("it fits");
        // As few as make it ask one object after the other, of all.
        let one_by_one = SmallScene { in_order: few.in_order[..1].to_vec(), ..few.clone() };
        let mut draws = Uniform::new(5);
        let (mut touched_in_all, mut met_in_all) = (0, 0);
        for number in 0..4000 {
            let mut place = || Vec3::from([(); 3].map(|()| draws.draw(-3.0, 3.0)));
            let (mut origin, mut direction) = (place(), place());
            if number % 2 == 0 {
                // From a surface, and every other time along it.
                let sphere = objects.sphere(number / 2 % 3).record;
                let normal = (origin - sphere.center).unit();
                origin = sphere.center + normal * sphere.radius;
                if number % 4 == 0 {
                    direction = direction.perpendicular_to(normal) + normal * (draws.draw(-1.0, 1.0) * 1e-9);
                }
            }
            let ray = Ray { origin, direction };
            let mut met = 0;
            for index in 0..objects.sphere_count() {
                let record = objects.sphere(index).record;
                let any = [Plain::sphere(&record, &ray), Exact::sphere(&record, &ray)];
                met |= u32::from(any.iter().any(Option::is_some)) << index;
            }
            for index in 0..objects.cylinder_count() {
                let (record, axis) = (objects.cylinder(index).record, objects.axis(index));
                let any = [Plain::cylinder(&record, &axis, &ray), Exact::cylinder(&record, &axis, &ray)];
                met |= u32::from(any.iter().any(Option::is_some)) << (objects.sphere_count() + index);
            }
            for set in InstructionSet::ALL.into_iter().filter(|set| set.is_available()) {
                let (touched, nearest) = set.run(Touched { few: &few, objects: &objects, ray });
                assert_eq!(met & !touched, 0, "{}, {ray:?}: met {met:b}, touched {touched:b}", set.name());
                let alone = set.run(Touched { few: &one_by_one, objects: &objects, ray });
                assert_eq!((touched, nearest), alone, "{}, {ray:?}", set.name());
                assert_eq!(nearest, closest_hit_among(&objects, &ray, met), "{}, {ray:?}", set.name());
                touched_in_all += touched.count_ones();
                met_in_all += met.count_ones();
            }
        }
        assert!(met_in_all > 10_000 && touched_in_all < met_in_all * 3 / 2, "{touched_in_all} for {met_in_all}");
    }
}
