//! What the kinds of search have in common: walks are written once over it, and compiled for each kind apart.

use super::{Few, Filter, Found, Hierarchy, ObjectId, Stack, plain};
use crate::layout::Objects;
use crate::prepare::Finish;
use crate::ray::Ray;
use crate::simd::Simd;
use crate::vec3::Vec3;

/// Where a ray starts.
#[derive(Clone, Copy, Debug)]
pub struct Origin {
    /// The object on whose surface.
    pub object: ObjectId,
    /// Whether it is expected to go into that object. What is found does not depend on it, but how soon.
    pub goes_in: bool,
}

/// A kind of search.
pub trait Find {
    /// The nearest object that a ray meets. Who asks counts the ray.
    fn find<S: Simd, O: Objects>(&self, objects: &O, ray: &Ray, origin: Origin, stack: &mut Stack) -> Found;

    /// Where a ray from the surface of `object` starts.
    #[inline(always)]
    fn origin<O: Objects>(&self, _: &O, _: &Ray, object: ObjectId) -> Origin {
        Origin { object, goes_in: false }
    }

    /// Where the ray starts that a surface with this finish makes, with a random vector, of one that has found it; told before
    /// that ray is known.
    #[inline(always)]
    fn next_origin<O: Objects>(&self, _: &O, _: &Ray, found: &Found, _: &Finish, _: Vec3) -> Origin {
        Origin { object: found.object, goes_in: false }
    }
}

/// Every object is asked.
#[derive(Debug)]
pub struct Plain;

impl Find for Plain {
    #[inline(always)]
    fn find<S: Simd, O: Objects>(&self, objects: &O, ray: &Ray, _: Origin, _: &mut Stack) -> Found {
        plain(objects, ray)
    }
}

impl Find for Few {
    #[inline(always)]
    fn find<S: Simd, O: Objects>(&self, objects: &O, ray: &Ray, _: Origin, _: &mut Stack) -> Found {
        self.nearest::<S::F64, O>(objects, ray)
    }
}

impl Find for Filter {
    #[inline(always)]
    fn find<S: Simd, O: Objects>(&self, objects: &O, ray: &Ray, origin: Origin, _: &mut Stack) -> Found {
        self.nearest::<S, O>(objects, ray, origin)
    }

    #[inline(always)]
    fn origin<O: Objects>(&self, objects: &O, ray: &Ray, object: ObjectId) -> Origin {
        let ground = self.ground();
        Origin { object, goes_in: ground.is(object) && ground.is_entered_by(objects, ray) }
    }

    #[inline(always)]
    fn next_origin<O: Objects>(&self, objects: &O, ray: &Ray, found: &Found, finish: &Finish, vector: Vec3) -> Origin {
        let (object, ground) = (found.object, self.ground());
        let goes_in = ground.is(object) && ground.will_be_entered(objects, ray, found.lambda, finish, vector);
        Origin { object, goes_in }
    }
}

impl Find for Hierarchy {
    #[inline(always)]
    fn find<S: Simd, O: Objects>(&self, objects: &O, ray: &Ray, origin: Origin, stack: &mut Stack) -> Found {
        self.nearest::<S, O>(objects, ray, origin.object, stack)
    }
}
