//! The layout with structures of arrays. Each channel of a picture is one array, and so is each number of the objects.

use crate::geometry::{cylinder::CylinderRecord, sphere::SphereRecord};
use crate::image::{Image, Rgb, zeroed};
use crate::input::{error::Error, scene::MaterialId, scene::Scene, size::Size};
use crate::layout::{self, Layout, OBJECTS, Objects, Placed, count_kinds, prefetch::prefetch, with_room};
use crate::math::vec3::Vec3;

/// The layout with structures of arrays. This type only names the layout and has no values.
#[derive(Clone, Copy, Debug)]
pub enum Soa {}

impl Layout for Soa {
    type Image = SoaImage;
    type Objects = SoaObjects;
}

/// A picture as three arrays, one for each channel.
#[derive(Clone, Debug)]
pub struct SoaImage {
    size: Size,
    red: Vec<u8>,
    green: Vec<u8>,
    blue: Vec<u8>,
}

impl Image for SoaImage {
    fn black(size: Size) -> Result<Self, Error> {
        let count = size.pixels();
        Ok(Self { size, red: zeroed(count)?, green: zeroed(count)?, blue: zeroed(count)? })
    }

    fn size(&self) -> Size {
        self.size
    }

    #[inline]
    fn pixel(&self, index: usize) -> Rgb {
        Rgb { red: self.red[index], green: self.green[index], blue: self.blue[index] }
    }

    #[inline]
    fn set_pixel(&mut self, index: usize, color: Rgb) {
        self.red[index] = color.red;
        self.green[index] = color.green;
        self.blue[index] = color.blue;
    }
}

/// A list of vectors as three arrays, one for each component.
#[derive(Clone, Debug)]
struct Vectors {
    x: Vec<f64>,
    y: Vec<f64>,
    z: Vec<f64>,
}

impl Vectors {
    fn with_room(count: usize) -> Result<Self, Error> {
        Ok(Self { x: with_room(count, OBJECTS)?, y: with_room(count, OBJECTS)?, z: with_room(count, OBJECTS)? })
    }

    fn push(&mut self, vector: Vec3) {
        self.x.push(vector.x);
        self.y.push(vector.y);
        self.z.push(vector.z);
    }

    fn swap(&mut self, left: usize, right: usize) {
        for numbers in [&mut self.x, &mut self.y, &mut self.z] {
            numbers.swap(left, right);
        }
    }

    #[inline(always)]
    fn get(&self, index: usize) -> Vec3 {
        Vec3::new(self.x[index], self.y[index], self.z[index])
    }
}

/// Returns the value at `index`, or the default if there is none. The caller has already indexed another array of the
/// same length. A second panic for an invalid index would keep the compiler from removing a load whose value is not
/// used.
#[inline(always)]
fn at<T: Copy + Default>(values: &[T], index: usize) -> T {
    values.get(index).copied().unwrap_or_default()
}

/// The numbers that spheres and cylinders have in common, as one array for each number. The squared radius and a
/// cylinder's caps are not stored. They are computed again by the formulas of the records.
#[derive(Clone, Debug)]
struct Common {
    center: Vectors,
    radius: Vec<f64>,
    order: Vec<u32>,
    material: Vec<MaterialId>,
}

impl Common {
    fn with_room(count: usize) -> Result<Self, Error> {
        Ok(Self {
            center: Vectors::with_room(count)?,
            radius: with_room(count, OBJECTS)?,
            order: with_room(count, OBJECTS)?,
            material: with_room(count, OBJECTS)?,
        })
    }

    fn push(&mut self, center: Vec3, radius: f64, order: u32, material: MaterialId) {
        self.center.push(center);
        self.radius.push(radius);
        self.order.push(order);
        self.material.push(material);
    }

    fn swap(&mut self, left: usize, right: usize) {
        self.center.swap(left, right);
        self.radius.swap(left, right);
        self.order.swap(left, right);
        self.material.swap(left, right);
    }
}

/// The objects of a scene as one array for each number of the spheres and of the cylinders.
#[derive(Clone, Debug)]
pub struct SoaObjects {
    spheres: Common,
    cylinders: Common,
    axis: Vectors,
    /// The cylinders' axes as in the scene file. Only the fallback needs them.
    file_axis: Vectors,
    half_height: Vec<f64>,
}

impl Objects for SoaObjects {
    fn build(scene: &Scene) -> Result<Self, Error> {
        let (sphere_count, cylinder_count) = count_kinds(scene)?;
        let mut objects = Self {
            spheres: Common::with_room(sphere_count)?,
            cylinders: Common::with_room(cylinder_count)?,
            axis: Vectors::with_room(cylinder_count)?,
            file_axis: Vectors::with_room(cylinder_count)?,
            half_height: with_room(cylinder_count, OBJECTS)?,
        };
        for Placed { record, order, material } in layout::spheres(scene) {
            objects.spheres.push(record.center, record.radius, order, material);
        }
        for (Placed { record, order, material }, file_axis) in layout::cylinders(scene) {
            objects.cylinders.push(record.center, record.radius, order, material);
            objects.axis.push(record.axis);
            objects.file_axis.push(file_axis);
            objects.half_height.push(record.half_height);
        }
        Ok(objects)
    }

    fn sphere_count(&self) -> usize {
        self.spheres.order.len()
    }

    fn cylinder_count(&self) -> usize {
        self.cylinders.order.len()
    }

    #[inline(always)]
    fn sphere(&self, index: usize) -> Placed<SphereRecord> {
        let Common { center, radius, order, material } = &self.spheres;
        let record = SphereRecord::new(center.get(index), at(radius, index));
        Placed { record, order: at(order, index), material: at(material, index) }
    }

    #[inline(always)]
    fn prefetch_sphere(&self, index: usize) {
        let Common { center, radius, order, .. } = &self.spheres;
        for numbers in [&center.x, &center.y, &center.z, radius] {
            numbers.get(index).into_iter().for_each(prefetch);
        }
        order.get(index).into_iter().for_each(prefetch);
    }

    #[inline(always)]
    fn cylinder(&self, index: usize) -> Placed<CylinderRecord> {
        let Common { center, radius, order, material } = &self.cylinders;
        let (axis, half_height) = (self.axis.get(index), at(&self.half_height, index));
        let record = CylinderRecord::with_unit_axis(center.get(index), at(radius, index), axis, half_height);
        Placed { record, order: at(order, index), material: at(material, index) }
    }

    fn axis(&self, index: usize) -> Vec3 {
        self.file_axis.get(index)
    }

    fn reorder(&mut self, spheres: &mut [u32], cylinders: &mut [u32]) {
        layout::reorder(spheres, |left, right| self.spheres.swap(left, right));
        layout::reorder(cylinders, |left, right| {
            self.cylinders.swap(left, right);
            self.axis.swap(left, right);
            self.file_axis.swap(left, right);
            self.half_height.swap(left, right);
        });
    }
}
