//! The rule that chooses the acceleration structure of a scene: [`Accel::new`].
//!
//! The first structure of this list that fits the scene is taken:
//! 1. [`Accel::EveryObject`] for extreme magnitudes: a camera, diffusion or window distance beyond 1e9, pixels below
//!    1e-12 ([`Extent`]), or up to 8 objects with one beyond 1e9 or a radius or half height below 1e-6;
//! 2. [`SmallScene`] for up to 8 objects;
//! 3. [`FlatFilter`] for up to 64 objects with coordinates of up to 2e7 and no such tiny object, if there are few
//!    cylinders: up to 20 beside a dominant sphere such as a ground, or else at most as many as spheres, which are at
//!    least 9; for other objects a tree is faster;
//! 4. [`Bvh`] for up to 200,000 objects, with boxes of the form [`FloatBoxes`];
//! 5. [`Bvh`] for all other scenes, with [`ByteBoxes`].
//!
//! How is a scene of 200 objects searched? A [`Bvh`] has nodes of up to 16 children. So a scene of 9 to 256 objects
//! without a flat filter mostly gets a tree of two levels: a root whose children are nodes of objects. A ray is tested
//! against the boxes of the root, then against those of each child that it hits, the nearest child first. Instead of
//! the root and its children a larger tree may have a collapsed root (`accel/bvh/collapsed_root.rs`). This is one list
//! of up to 64 boxes, most of which are those of the second level. The nodes below it are to be full, so not every
//! number of objects has one. It is used by instruction sets with at least eight lanes of `f32`. A [`Bvh`] over spheres
//! alone has bounding spheres instead of boxes in its leaves, unless they are sparse (`accel/bvh/sphere_leaf.rs`).
//!
//! With a [`SmallScene`] one more choice follows. With fewer than four objects, or fewer than six of which one is a
//! ground, paths are traced with a lookahead (`render/trace_paths.rs`). With more, lanes hold several objects for one
//! ray (`accel/small_scene.rs`). Frustum culling visits the boxes of a [`Bvh`] ([`Accel::visit_boxes`]). Specular
//! chains use a structure only beyond 64 objects and with extreme magnitudes; otherwise lanes of rays are tested
//! against every object (`render/specular_chains.rs`). The limits stand beside what they limit: `accel/extent.rs`,
//! `accel/may_hit/object_lanes.rs`, `accel/flat_filter.rs`, `accel/may_hit/filter_ray.rs` and `accel/small_scene.rs`.
//! [`FlatFilter`] and [`Bvh`] test a sphere much larger than all other objects separately (`accel/dominant_sphere.rs`).
//! A [`Bvh`] also tests objects separately that are tiny or reach much farther than all others (`accel/giants.rs`).
//!
//! Every structure gives the same closest hits. The reference has no structure: it intersects every object. WGSL has a
//! hierarchy of its own (`shaders/twin/src/hierarchy.rs`).

use crate::accel::{
    accelerator::Accelerator, bounds::Bounds, bvh, bvh::Bvh, bvh::boxes::FloatBoxes, bvh::byte_boxes::ByteBoxes,
    closest_hit::ClosestHit, every_object::EveryObject, extent::Extent, flat_filter, flat_filter::FlatFilter, may_hit,
    object::ObjectId, object::count, small_scene::SmallScene, stack::Stack,
};
use crate::{counters::Counter, counters::add, geometry::ray::Ray, input::error::Error, layout::Objects, simd::Simd};

/// The acceleration structure of a scene. [`Accel::new`] chooses it by the number and kinds of the objects, and by
/// the scene's largest and smallest numbers.
#[derive(Debug)]
#[expect(clippy::large_enum_variant, reason = "a scene has one")]
pub enum Accel {
    /// No structure: every object is intersected, because the magnitudes are too extreme for conservative tests.
    EveryObject(EveryObject),
    /// The structure for up to eight objects.
    SmallScene(SmallScene),
    /// The structure for up to 64 objects, most of them spheres, which tests several of them at once in single
    /// precision.
    FlatFilter(FlatFilter),
    /// The tree of boxes, for more objects.
    Bvh(Bvh<FloatBoxes>),
    /// The tree of boxes in little memory, for any number of objects.
    LargeBvh(Bvh<ByteBoxes>),
}

/// A structure that [`Accel::of`] can build.
#[cfg(feature = "internals")]
#[derive(Clone, Copy, Debug)]
pub enum Structure {
    /// [`Accel::FlatFilter`], for up to 64 objects with coordinates of up to 2e7.
    FlatFilter,
    /// [`Accel::Bvh`], with or without sphere leaves. `None` leaves this to the builder.
    Bvh(Option<bool>),
    /// [`Accel::LargeBvh`].
    LargeBvh,
}

impl Accel {
    /// Returns the structure that fits the objects. A [`Bvh`] reorders them, so their numbers change.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`] if memory is short.
    pub fn new(objects: &mut impl Objects, extent: &Extent) -> Result<Self, Error> {
        let is_small = count(objects) <= may_hit::object_lanes::PLACES;
        Ok(if !extent.moderate || is_small && !extent.is_ordinary() {
            Self::EveryObject(EveryObject)
        } else if is_small {
            Self::SmallScene(SmallScene::new(objects, extent))
        } else if count(objects) <= flat_filter::MOST_OBJECTS
            && !extent.has_tiny
            && extent.max_coordinate <= flat_filter::MAX_COORDINATE
            && flat_filter::saves_time(objects)
        {
            Self::FlatFilter(FlatFilter::new(objects, extent)?)
        } else if count(objects) <= bvh::MOST_IN_FLOAT_BOXES {
            Self::Bvh(Bvh::new(objects, extent, None)?)
        } else {
            Self::LargeBvh(Bvh::new(objects, extent, None)?)
        })
    }

    /// Returns the structure for few objects, which can be tested with one ray in each lane, if the scene has it.
    #[inline(always)]
    pub(crate) const fn in_lanes(&self) -> Option<&SmallScene> {
        if let Self::SmallScene(small_scene) = self { Some(small_scene) } else { None }
    }

    /// Whether the latency of comparisons matters more than the width of the lanes: in all structures but a tree of
    /// more than 64 objects. The path tracing loop is then run by [`Simd::run_promptly`].
    pub(crate) fn is_prompt(&self, objects: &impl Objects) -> bool {
        !matches!(self, Self::Bvh(_) | Self::LargeBvh(_)) || count(objects) <= flat_filter::MOST_OBJECTS
    }

    /// Calls `visit` with objects of the tree of boxes; see [`Bvh::visit`]. Returns false if the scene has no tree.
    pub fn visit_boxes(&self, may_reach: impl FnMut(&Bounds) -> bool, visit: impl FnMut(ObjectId)) -> bool {
        match self {
            Self::EveryObject(_) | Self::SmallScene(_) | Self::FlatFilter(_) => return false,
            Self::Bvh(bvh) => bvh.visit(may_reach, visit),
            Self::LargeBvh(bvh) => bvh.visit(may_reach, visit),
        }
        true
    }

    /// Disables the shortcut for isolated objects, to measure what it gains. Returns false if there was none.
    #[cfg(feature = "internals")]
    pub fn without_isolation(&mut self) -> bool {
        match self {
            Self::EveryObject(_) | Self::SmallScene(_) => false,
            Self::FlatFilter(filter) => filter.overlapping.take().is_some(),
            Self::Bvh(bvh) => !std::mem::take(&mut bvh.isolated).is_empty(),
            Self::LargeBvh(bvh) => !std::mem::take(&mut bvh.isolated).is_empty(),
        }
    }

    /// Replaces the lookahead of a [`SmallScene`] by objects in lanes, or the other way round, to measure what the
    /// chosen one gains. Returns false for other structures.
    #[cfg(feature = "internals")]
    pub const fn swap_lookahead(&mut self) -> bool {
        let Self::SmallScene(small_scene) = self else { return false };
        small_scene.uses_object_lanes = !small_scene.uses_object_lanes;
        true
    }

    /// Removes the collapsed root, to measure what it gains. Returns false if there was none.
    #[cfg(feature = "internals")]
    pub fn without_collapsed_root(&mut self) -> bool {
        match self {
            Self::EveryObject(_) | Self::SmallScene(_) | Self::FlatFilter(_) => false,
            Self::Bvh(bvh) => bvh.collapsed_root.clear(),
            Self::LargeBvh(bvh) => bvh.collapsed_root.clear(),
        }
    }

    /// Returns another structure than [`Accel::new`] does, to compare the two. It reorders the objects, as a [`Bvh`]
    /// does.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`] if memory is short.
    #[cfg(feature = "internals")]
    pub fn of(structure: Structure, objects: &mut impl Objects, extent: &Extent) -> Result<Self, Error> {
        Ok(match structure {
            Structure::FlatFilter => Self::FlatFilter(FlatFilter::new(objects, extent)?),
            Structure::Bvh(sphere_leaves) => Self::Bvh(Bvh::new(objects, extent, sphere_leaves)?),
            Structure::LargeBvh => Self::LargeBvh(Bvh::new(objects, extent, None)?),
        })
    }

    /// Returns the closest hit of a ray that starts on the surface of `start_object`, and counts the ray. `stack` is
    /// memory for the traversal.
    #[inline(always)]
    pub fn closest_hit<S: Simd, O: Objects>(
        &self,
        objects: &O,
        ray: &Ray,
        start_object: ObjectId,
        stack: &mut Stack,
    ) -> ClosestHit {
        add(Counter::PathRays, 1);
        dispatch!(self, |accel| {
            let start = accel.start(objects, ray, start_object);
            accel.closest_hit::<S, O>(objects, ray, start, stack)
        })
    }
}

/// Evaluates an expression in which a name stands for the [`Accelerator`] of a scene, as in
/// `dispatch!(accel, |structure| work(structure))`. The expression is compiled once for each structure. `accel` is a
/// reference to an [`Accel`]. This is a macro and no closure; see [`Kernel::call`](crate::simd::Kernel::call).
macro_rules! dispatch {
    ($accel:expr, |$structure:ident| $work:expr) => {{
        use crate::accel::choice::Accel;
        match $accel {
            Accel::EveryObject($structure) => $work,
            Accel::SmallScene($structure) => $work,
            Accel::FlatFilter($structure) => $work,
            Accel::Bvh($structure) => $work,
            Accel::LargeBvh($structure) => $work,
        }
    }};
}
pub(crate) use dispatch;
