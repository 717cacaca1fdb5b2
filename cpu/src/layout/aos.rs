//! The layout with arrays of structures. The channels of a pixel are side by side in memory, and so are the numbers of
//! an object.

use crate::geometry::{cylinder::CylinderRecord, sphere::SphereRecord};
use crate::image::{Image, Rgb, zeroed};
use crate::input::{error::Error, scene::Scene, size::Size};
use crate::layout::{self, Layout, OBJECTS, Objects, Placed, count_kinds, prefetch::prefetch, with_room};
use crate::math::vec3::Vec3;

/// The layout with arrays of structures. This type only names the layout and has no values.
#[derive(Clone, Copy, Debug)]
pub enum Aos {}

impl Layout for Aos {
    type Image = AosImage;
    type Objects = AosObjects;
}

/// A picture as one array of pixels.
#[derive(Clone, Debug)]
pub struct AosImage {
    size: Size,
    pixels: Vec<Rgb>,
}

impl Image for AosImage {
    fn black(size: Size) -> Result<Self, Error> {
        Ok(Self { size, pixels: zeroed(size.pixels())? })
    }

    fn size(&self) -> Size {
        self.size
    }

    #[inline]
    fn pixel(&self, index: usize) -> Rgb {
        self.pixels[index]
    }

    #[inline]
    fn set_pixel(&mut self, index: usize, color: Rgb) {
        self.pixels[index] = color;
    }
}

/// The objects of a scene as one array of spheres and one array of cylinders.
#[derive(Clone, Debug)]
pub struct AosObjects {
    spheres: Vec<Placed<SphereRecord>>,
    cylinders: Vec<Placed<CylinderRecord>>,
    /// The cylinders' axes as in the scene file. They are stored separately, because only the compensated and
    /// exact formulas need them.
    file_axes: Vec<Vec3>,
}

impl Objects for AosObjects {
    fn build(scene: &Scene) -> Result<Self, Error> {
        let (sphere_count, cylinder_count) = count_kinds(scene)?;
        let mut spheres = with_room(sphere_count, OBJECTS)?;
        let mut cylinders = (with_room(cylinder_count, OBJECTS)?, with_room(cylinder_count, OBJECTS)?);
        spheres.extend(layout::spheres(scene));
        cylinders.extend(layout::cylinders(scene));
        Ok(Self { spheres, cylinders: cylinders.0, file_axes: cylinders.1 })
    }

    fn sphere_count(&self) -> usize {
        self.spheres.len()
    }

    fn cylinder_count(&self) -> usize {
        self.cylinders.len()
    }

    #[inline(always)]
    fn sphere(&self, index: usize) -> Placed<SphereRecord> {
        self.spheres[index]
    }

    #[inline(always)]
    fn prefetch_sphere(&self, index: usize) {
        self.spheres.get(index).into_iter().for_each(prefetch);
    }

    #[inline(always)]
    fn cylinder(&self, index: usize) -> Placed<CylinderRecord> {
        self.cylinders[index]
    }

    fn file_axis(&self, index: usize) -> Vec3 {
        self.file_axes[index]
    }

    fn reorder(&mut self, spheres: &mut [u32], cylinders: &mut [u32]) {
        layout::reorder(spheres, |left, right| self.spheres.swap(left, right));
        layout::reorder(cylinders, |left, right| {
            self.cylinders.swap(left, right);
            self.file_axes.swap(left, right);
        });
    }
}
