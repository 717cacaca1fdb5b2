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

/// Returns the value at `index`, or the default if there is none. The caller has already indexed another array of the
/// same length. A second panic for an invalid index would keep the compiler from removing a load whose value is not
/// used.
#[inline(always)]
fn at<T: Copy + Default>(values: &[T], index: usize) -> T {
    values.get(index).copied().unwrap_or_default()
}

/// The objects of one kind: an array for each of the `N` numbers of an object, and arrays of their places in the scene
/// file and of their materials. The squared radius and a cylinder's caps are not stored. They are computed again by the
/// formulas of the records.
#[derive(Clone, Debug)]
struct ObjectColumns<const N: usize> {
    numbers: [Vec<f64>; N],
    file_index: Vec<u32>,
    material: Vec<MaterialId>,
}

impl<const N: usize> ObjectColumns<N> {
    /// Returns empty arrays with room for `count` objects.
    fn with_room(count: usize) -> Result<Self, Error> {
        let mut numbers = [const { Vec::new() }; N];
        for list in &mut numbers {
            *list = with_room(count, OBJECTS)?;
        }
        Ok(Self { numbers, file_index: with_room(count, OBJECTS)?, material: with_room(count, OBJECTS)? })
    }

    /// Appends an object with its numbers.
    fn push<R>(&mut self, numbers: [f64; N], object: &Placed<R>) {
        for (list, number) in self.numbers.iter_mut().zip(numbers) {
            list.push(number);
        }
        self.file_index.push(object.file_index);
        self.material.push(object.material);
    }

    /// Swaps two objects.
    fn swap(&mut self, left: usize, right: usize) {
        self.numbers.iter_mut().for_each(|list| list.swap(left, right));
        self.file_index.swap(left, right);
        self.material.swap(left, right);
    }
}

/// The objects of a scene as one array for each number of the spheres and of the cylinders.
#[derive(Clone, Debug)]
pub struct SoaObjects {
    /// The numbers are centre and radius.
    spheres: ObjectColumns<4>,
    /// The numbers are centre, radius, axis of length one and half height. Then follows the axis as in the scene file,
    /// which only the compensated and exact formulas need.
    cylinders: ObjectColumns<11>,
}

impl Objects for SoaObjects {
    fn build(scene: &Scene) -> Result<Self, Error> {
        let (sphere_count, cylinder_count) = count_kinds(scene)?;
        let (mut spheres, mut cylinders) =
            (ObjectColumns::with_room(sphere_count)?, ObjectColumns::with_room(cylinder_count)?);
        for sphere in layout::spheres(scene) {
            let SphereRecord { center, radius, .. } = sphere.record;
            spheres.push([center.x, center.y, center.z, radius], &sphere);
        }
        for (cylinder, file_axis) in layout::cylinders(scene) {
            let CylinderRecord { center: c, radius, axis, half_height, .. } = cylinder.record;
            let ([x, y, z], [file_x, file_y, file_z]) = (axis.to_array(), file_axis.to_array());
            cylinders.push([c.x, c.y, c.z, radius, x, y, z, half_height, file_x, file_y, file_z], &cylinder);
        }
        Ok(Self { spheres, cylinders })
    }

    fn sphere_count(&self) -> usize {
        self.spheres.file_index.len()
    }

    fn cylinder_count(&self) -> usize {
        self.cylinders.file_index.len()
    }

    #[inline(always)]
    fn sphere(&self, index: usize) -> Placed<SphereRecord> {
        let ObjectColumns { numbers: [x, y, z, radius], file_index, material } = &self.spheres;
        let record = SphereRecord::new(Vec3::new(x[index], y[index], z[index]), at(radius, index));
        Placed { record, file_index: at(file_index, index), material: at(material, index) }
    }

    #[inline(always)]
    fn prefetch_sphere(&self, index: usize) {
        for numbers in &self.spheres.numbers {
            numbers.get(index).into_iter().for_each(prefetch);
        }
        self.spheres.file_index.get(index).into_iter().for_each(prefetch);
    }

    #[inline(always)]
    fn cylinder(&self, index: usize) -> Placed<CylinderRecord> {
        let ObjectColumns { numbers, file_index, material } = &self.cylinders;
        let [x, y, z, radius, axis_x, axis_y, axis_z, half_height, ..] = numbers;
        let center = Vec3::new(x[index], y[index], z[index]);
        let axis = Vec3::new(axis_x[index], axis_y[index], axis_z[index]);
        let record = CylinderRecord::with_unit_axis(center, at(radius, index), axis, at(half_height, index));
        Placed { record, file_index: at(file_index, index), material: at(material, index) }
    }

    fn file_axis(&self, index: usize) -> Vec3 {
        let [.., x, y, z] = &self.cylinders.numbers;
        Vec3::new(x[index], y[index], z[index])
    }

    fn reorder(&mut self, spheres: &mut [u32], cylinders: &mut [u32]) {
        layout::reorder(spheres, |left, right| self.spheres.swap(left, right));
        layout::reorder(cylinders, |left, right| self.cylinders.swap(left, right));
    }
}
