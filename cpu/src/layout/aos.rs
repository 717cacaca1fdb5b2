//! Arrays of structures: a pixel's channels side by side, an object's values side by side.

use crate::geometry::{cylinder::CylinderRecord, sphere::SphereRecord};
use crate::image::{Image, Rgb, zeroed};
use crate::input::{error::Error, scene::Scene, size::Size};
use crate::layout::{self, Layout, Objects, Placed, count_kinds, with_room};
use crate::math::vec3::Vec3;

/// Arrays of structures.
#[derive(Clone, Copy, Debug)]
pub enum Aos {}

impl Layout for Aos {
    type Image = AosImage;
    type Objects = AosObjects;
}

/// One array of pixels.
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

/// One array of spheres, one of cylinders.
#[derive(Clone, Debug)]
pub struct AosObjects {
    spheres: Vec<Placed<SphereRecord>>,
    cylinders: Vec<Placed<CylinderRecord>>,
    /// The axes as the file has them. They are apart, since only the fallback of an uncertain intersection needs them.
    axes: Vec<Vec3>,
}

impl Objects for AosObjects {
    fn build(scene: &Scene) -> Result<Self, Error> {
        let (sphere_count, cylinder_count) = count_kinds(scene)?;
        let mut spheres = with_room(sphere_count)?;
        let mut cylinders = (with_room(cylinder_count)?, with_room(cylinder_count)?);
        spheres.extend(layout::spheres(scene));
        cylinders.extend(layout::cylinders(scene));
        Ok(Self { spheres, cylinders: cylinders.0, axes: cylinders.1 })
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
    fn cylinder(&self, index: usize) -> Placed<CylinderRecord> {
        self.cylinders[index]
    }

    fn axis(&self, index: usize) -> Vec3 {
        self.axes[index]
    }
}
