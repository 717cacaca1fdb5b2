//! Which acceleration structure a scene gets.

use crate::accel::bvh::Bvh;
use crate::accel::bvh::stack::Stack;
use crate::accel::closest_hit::ClosestHit;
use crate::accel::every_object::EveryObject;
use crate::accel::extent::Extent;
use crate::accel::find::Accelerator;
use crate::accel::flat_filter;
use crate::accel::flat_filter::FlatFilter;
use crate::accel::object::ObjectId;
use crate::accel::small_scene;
use crate::accel::small_scene::SmallScene;
use crate::counters::{Counter, add};
use crate::geometry::ray::Ray;
use crate::input::error::Error;
use crate::layout::Objects;
use crate::simd::Simd;

/// How the nearest object is found; chosen once for a scene.
#[derive(Debug)]
#[expect(clippy::large_enum_variant, reason = "a scene has one")]
pub enum Accel {
    /// Every object is intersected: magnitudes are too extreme for conservative tests.
    EveryObject,
    /// Up to eight objects, tested all at once.
    SmallScene(SmallScene),
    /// A filter over all objects, several at once.
    FlatFilter(FlatFilter),
    /// A tree of boxes.
    Bvh(Bvh),
}

impl Accel {
    /// The structure that fits the objects.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    pub fn new(objects: &impl Objects, extent: &Extent) -> Result<Self, Error> {
        let count = objects.sphere_count().max(objects.cylinder_count());
        Ok(if !extent.moderate {
            Self::EveryObject
        } else if small_scene::suits(objects) {
            Self::SmallScene(SmallScene::new(objects, extent)?)
        } else if count <= flat_filter::CAPACITY && extent.reach <= flat_filter::LARGEST_REACH {
            Self::FlatFilter(FlatFilter::new(objects, extent)?)
        } else {
            Self::Bvh(Bvh::new(objects, extent)?)
        })
    }

    /// Forgets which objects are isolated, so that rays inside them are traced like all others: for measuring what it
    /// gains to know.
    pub fn without_isolation(&mut self) {
        match self {
            Self::EveryObject | Self::SmallScene(_) => {}
            Self::FlatFilter(filter) => filter.without_isolation(),
            Self::Bvh(bvh) => bvh.without_isolation(),
        }
    }

    /// The nearest object that a ray from the surface of `from` meets.
    #[inline(always)]
    pub fn closest_hit<S: Simd, O: Objects>(
        &self,
        objects: &O,
        ray: &Ray,
        from: ObjectId,
        stack: &mut Stack,
    ) -> ClosestHit {
        // Not a closure: it would be compiled without the instruction set.
        macro_rules! closest_hit {
            ($accel:expr) => {
                $accel.closest_hit_from::<S, O>(objects, ray, $accel.origin(objects, ray, from), stack)
            };
        }
        add(Counter::WalkRays, 1);
        match self {
            Self::EveryObject => closest_hit!(EveryObject),
            Self::SmallScene(accel) => closest_hit!(accel),
            Self::FlatFilter(accel) => closest_hit!(accel),
            Self::Bvh(accel) => closest_hit!(accel),
        }
    }
}
