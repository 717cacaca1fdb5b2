//! What the kinds of search have in common: walks are written once over it, and compiled for each kind apart.

use super::{Few, Filter, Found, Hierarchy, ObjectId, Stack, plain};
use crate::certified::Intersect;
use crate::layout::Objects;
use crate::ray::Ray;
use crate::simd::Simd;

/// A kind of search.
pub trait Find {
    /// The nearest object that a ray from the surface of `from` meets. Who asks counts the ray.
    fn find<S: Simd, O: Objects, P: Intersect>(
        &self,
        objects: &O,
        ray: &Ray,
        from: ObjectId,
        stack: &mut Stack,
    ) -> Found;

    /// The search for a handful of objects, if it is this.
    #[inline(always)]
    fn as_few(&self) -> Option<&Few> {
        None
    }
}

/// Every object is asked.
#[derive(Debug)]
pub struct Plain;

impl Find for Plain {
    #[inline(always)]
    fn find<S: Simd, O: Objects, P: Intersect>(&self, objects: &O, ray: &Ray, _: ObjectId, _: &mut Stack) -> Found {
        plain::<O, P>(objects, ray)
    }
}

impl Find for Few {
    #[inline(always)]
    fn find<S: Simd, O: Objects, P: Intersect>(&self, objects: &O, ray: &Ray, _: ObjectId, _: &mut Stack) -> Found {
        self.nearest::<S::F64, O, P>(objects, ray)
    }

    #[inline(always)]
    fn as_few(&self) -> Option<&Few> {
        Some(self)
    }
}

impl Find for Filter {
    #[inline(always)]
    fn find<S: Simd, O: Objects, P: Intersect>(&self, objects: &O, ray: &Ray, from: ObjectId, _: &mut Stack) -> Found {
        self.nearest::<S, O, P>(objects, ray, from)
    }
}

impl Find for Hierarchy {
    #[inline(always)]
    fn find<S: Simd, O: Objects, P: Intersect>(
        &self,
        objects: &O,
        ray: &Ray,
        from: ObjectId,
        stack: &mut Stack,
    ) -> Found {
        if self.covers(ray.origin) {
            self.nearest::<S, O, P>(objects, ray, from, stack)
        } else {
            plain::<O, P>(objects, ray)
        }
    }
}
