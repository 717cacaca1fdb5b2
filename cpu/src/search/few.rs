//! A search for scenes of a handful of objects: every object is filtered in double precision, by several rays at once or,
//! for one ray, several objects at once.
//!
//! The [filter](super::touch) says which objects a ray may meet, and so which rays certainly leave the scene; the exact
//! formulas are for the others.

use super::side_by_side::SideBySide;
use super::touch::Touch;
use super::{Found, ObjectId};
use crate::certified::Intersect;
use crate::error::Error;
use crate::layout::Objects;
use crate::prepare::Extent;
use crate::ray::Ray;
use crate::simd::Lanes;

/// Most objects.
pub const CAPACITY: usize = 8;

/// Fewest objects of which those that one ray may meet are found side by side: fewer fill too few lanes.
const FEWEST_SIDE_BY_SIDE: usize = 4;

/// A search over a handful of objects.
#[derive(Clone, Debug)]
pub struct Few {
    in_order: Vec<ObjectId>,
    side_by_side: SideBySide,
    reach: f64,
}

impl Few {
    /// The search over `objects`.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    pub fn new(objects: &impl Objects, extent: &Extent) -> Result<Self, Error> {
        let side_by_side = SideBySide::new(objects, extent.reach);
        Ok(Self { in_order: super::in_order(objects)?, side_by_side, reach: extent.reach })
    }

    /// The objects in the order of the file.
    #[must_use]
    pub fn in_order(&self) -> &[ObjectId] {
        &self.in_order
    }

    /// Whether one ray asks several objects at once; otherwise several rays ask one.
    #[inline(always)]
    #[must_use]
    pub fn is_side_by_side(&self) -> bool {
        self.in_order.len() >= FEWEST_SIDE_BY_SIDE
    }

    /// The nearest object that a ray, which starts within the scene's reach, meets.
    #[inline(always)]
    pub fn nearest<V: Lanes, O: Objects, P: Intersect>(&self, objects: &O, ray: &Ray) -> Found {
        if self.is_side_by_side() {
            return nearest_of::<O, P>(objects, ray, self.side_by_side.touched_by_one::<V>(ray));
        }
        let (touch, mut found) = (Touch::new(*ray), Found::NOTHING);
        for index in 0..objects.sphere_count() {
            if touch.sphere_at(objects, index) {
                found.ask_sphere::<O, P>(objects, index, ray);
            }
        }
        for index in 0..objects.cylinder_count() {
            if touch.cylinder_at(objects, index, self.reach) {
                found.ask_cylinder::<O, P>(objects, index, ray);
            }
        }
        found
    }

    /// Whether each of several rays, which start within the scene's reach, may meet an object.
    #[inline(always)]
    pub fn touches<V: Lanes>(&self, id: ObjectId, touch: &Touch<V>) -> V::Mask {
        self.side_by_side.touches(id as usize, touch)
    }

    /// The objects that each ray, which starts within the scene's reach, may meet: the sum of 2^[id](ObjectId).
    #[inline(always)]
    pub fn touched<V: Lanes>(&self, ray: &Ray<V>) -> V {
        self.side_by_side.touched_by_each(ray)
    }
}

/// Of objects that rays may meet, as [`Few::touched`] gives them, the nearest that this one meets.
#[inline(always)]
pub fn nearest_of<O: Objects, P: Intersect>(objects: &O, ray: &Ray, touched: u32) -> Found {
    let mut found = Found::NOTHING;
    // Object by object, so that the processor can guess which it will be before it knows the bits; but nothing for a kind
    // that is not touched at all.
    let spheres = (1 << objects.sphere_count()) - 1;
    if touched & spheres != 0 {
        for index in 0..objects.sphere_count() {
            if touched >> index & 1 == 1 {
                found.ask_sphere::<O, P>(objects, index, ray);
            }
        }
    }
    if touched & !spheres != 0 {
        for index in 0..objects.cylinder_count() {
            if touched >> (objects.sphere_count() + index) & 1 == 1 {
                found.ask_cylinder::<O, P>(objects, index, ray);
            }
        }
    }
    found
}

/// Whether a scene of this many objects is searched like this.
#[must_use]
pub fn suits(objects: &impl Objects) -> bool {
    objects.sphere_count() + objects.cylinder_count() <= CAPACITY
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::certified::{Certified, Textbook};
    use crate::layout::AosObjects;
    use crate::real::Real;
    use crate::rng::Uniform;
    use crate::scene::Scene;
    use crate::simd::{InstructionSet, Kernel, Simd};
    use crate::vec3::Vec3;

    const SCENE: &str = "matte: m 1 1 1\nsphere: 0 -101 0 100 m\nsphere: 1 0 0 1 m\nsphere: -1 0.5 2 .25 m\n\
                         cylinder: 0 0 -2 .5 1 2 .5 m\ncylinder: 3 1 1 .1 0 0 4 m\n";
    const REACH: f64 = 201.0;

    /// Which objects the first lane's ray, the same in all lanes, may meet, and which it meets first.
    struct Touched<'a> {
        few: &'a Few,
        objects: &'a AosObjects,
        ray: Ray,
    }

    impl Kernel for Touched<'_> {
        type Output = (u32, Found);

        #[inline(always)]
        fn call<S: Simd>(self, _: S) -> (u32, Found) {
            let ray = Ray { origin: self.ray.origin.map(S::F64::of), direction: self.ray.direction.map(S::F64::of) };
            let mut touched = [0.0; 8];
            self.few.touched(&ray).store(&mut touched);
            let lanes = &touched[..S::F64::LANES];
            assert!(lanes.iter().all(|&lane| lane == lanes[0]), "{lanes:?}");
            assert_eq!(self.few.side_by_side.touched_by_one::<S::F64>(&self.ray), lanes[0] as u32);
            (lanes[0] as u32, self.few.nearest::<S::F64, _, Certified>(self.objects, &self.ray))
        }
    }

    #[test]
    fn what_a_ray_meets_it_touches_and_most_of_what_it_touches_it_meets() {
        let scene = Scene::parse(SCENE.as_bytes()).expect("the scene is valid");
        let objects = AosObjects::build(&scene).expect("it fits");
        let few = Few::new(&objects, &Extent { reach: REACH, moderate: true }).expect("it fits");
        // As few as make it ask one object after the other, of all.
        let one_by_one = Few { in_order: few.in_order[..1].to_vec(), ..few.clone() };
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
                let any = [Textbook::sphere(&record, &ray), Certified::sphere(&record, &ray)];
                met |= u32::from(any.iter().any(Option::is_some)) << index;
            }
            for index in 0..objects.cylinder_count() {
                let (record, axis) = (objects.cylinder(index).record, objects.axis(index));
                let any = [Textbook::cylinder(&record, &axis, &ray), Certified::cylinder(&record, &axis, &ray)];
                met |= u32::from(any.iter().any(Option::is_some)) << (objects.sphere_count() + index);
            }
            for set in InstructionSet::ALL.into_iter().filter(|set| set.is_available()) {
                let (touched, nearest) = set.run(Touched { few: &few, objects: &objects, ray });
                assert_eq!(met & !touched, 0, "{}, {ray:?}: met {met:b}, touched {touched:b}", set.name());
                let alone = set.run(Touched { few: &one_by_one, objects: &objects, ray });
                assert_eq!((touched, nearest), alone, "{}, {ray:?}", set.name());
                assert_eq!(nearest, nearest_of::<_, Certified>(&objects, &ray, met), "{}, {ray:?}", set.name());
                touched_in_all += touched.count_ones();
                met_in_all += met.count_ones();
            }
        }
        assert!(met_in_all > 10_000 && touched_in_all < met_in_all * 3 / 2, "{touched_in_all} for {met_in_all}");
    }
}
