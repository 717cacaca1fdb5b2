//! Counts with how many objects rays are intersected.

use std::cell::Cell;

use cpu::internals::geometry::cylinder::CylinderRecord;
use cpu::internals::geometry::sphere::SphereRecord;
use cpu::internals::layout::{Objects, Placed};
use cpu::internals::math::vec3::Vec3;
use cpu::{Error, Scene};

/// Objects that count how often one of them is read to intersect it with a ray.
pub struct Counted<'a, O> {
    /// The objects.
    pub objects: &'a O,
    /// How often one of them was read.
    pub reads: Cell<u64>,
}

impl<O> Counted<'_, O> {
    fn count(&self) {
        self.reads.set(self.reads.get() + 1);
    }
}

impl<O: Objects> Objects for Counted<'_, O> {
    fn build(_: &Scene) -> Result<Self, Error> {
        Err(Error::OutOfMemory { what: "objects that are borrowed" })
    }

    fn sphere_count(&self) -> usize {
        self.objects.sphere_count()
    }

    fn cylinder_count(&self) -> usize {
        self.objects.cylinder_count()
    }

    fn sphere(&self, index: usize) -> Placed<SphereRecord> {
        self.count();
        self.objects.sphere(index)
    }

    fn prefetch_sphere(&self, index: usize) {
        self.objects.prefetch_sphere(index);
    }

    fn cylinder(&self, index: usize) -> Placed<CylinderRecord> {
        self.count();
        self.objects.cylinder(index)
    }

    fn axis(&self, index: usize) -> Vec3 {
        self.objects.axis(index)
    }

    fn reorder(&mut self, _: &mut [u32], _: &mut [u32]) {}
}
