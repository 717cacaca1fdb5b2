//! Converts values into the bytes of the WGSL structures that shaders read.
//!
//! These structures have only scalar fields of 4 or 8 bytes, and no padding. So the bytes of a value are the bytes of
//! its numbers, in order.

use cpu::Vec3;
use cpu::internals::Camera;
use cpu::internals::geometry::cylinder::CylinderRecord;
use cpu::internals::geometry::sphere::SphereRecord;
use cpu::internals::layout::Placed;
use cpu::internals::render::background::Background;

use crate::Float;
use crate::picture::PackedMaterial;

/// A value that can be written into a buffer for shaders.
pub trait Packed {
    /// Appends the bytes of the value to `bytes`.
    fn pack(&self, bytes: &mut Vec<u8>);
}

/// Returns the bytes of a buffer that holds `values`.
#[must_use]
pub fn buffer<P: Packed>(values: &[P]) -> Vec<u8> {
    let mut bytes = Vec::new();
    values.iter().for_each(|value| value.pack(&mut bytes));
    bytes
}

impl Packed for u32 {
    fn pack(&self, bytes: &mut Vec<u8>) {
        bytes.extend(bytemuck::bytes_of(self));
    }
}

impl<T: Float> Packed for [T] {
    fn pack(&self, bytes: &mut Vec<u8>) {
        bytes.extend(bytemuck::cast_slice::<T, u8>(self));
    }
}

impl<T: Float> Packed for Vec3<T> {
    fn pack(&self, bytes: &mut Vec<u8>) {
        self.to_array()[..].pack(bytes);
    }
}

impl<T: Float> Packed for SphereRecord<T> {
    /// Appends the numbers from which the shaders compute the others.
    fn pack(&self, bytes: &mut Vec<u8>) {
        let Self { center, radius, .. } = self;
        center.pack(bytes);
        [*radius][..].pack(bytes);
    }
}

impl<T: Float> Packed for CylinderRecord<T> {
    /// Appends the numbers from which the shaders compute the others.
    fn pack(&self, bytes: &mut Vec<u8>) {
        let Self { center, axis, radius, half_height, .. } = self;
        [center, axis].iter().for_each(|vector| vector.pack(bytes));
        [*radius, *half_height][..].pack(bytes);
    }
}

impl<R: Packed> Packed for Placed<R> {
    fn pack(&self, bytes: &mut Vec<u8>) {
        let Self { record, file_index, material } = self;
        record.pack(bytes);
        file_index.pack(bytes);
        material.pack(bytes);
    }
}

impl<T: Float> Packed for PackedMaterial<T> {
    fn pack(&self, bytes: &mut Vec<u8>) {
        let Self { reflectance, index, extent, kind } = self;
        reflectance.pack(bytes);
        [*index, *extent][..].pack(bytes);
        (*kind as u32).pack(bytes);
        0_u32.pack(bytes);
    }
}

impl<T: Float> Packed for Camera<T> {
    fn pack(&self, bytes: &mut Vec<u8>) {
        let Self { position, origin, delta_x, delta_y } = self;
        [position, origin, delta_x, delta_y].iter().for_each(|vector| vector.pack(bytes));
    }
}

impl<T: Float> Packed for Background<T> {
    fn pack(&self, bytes: &mut Vec<u8>) {
        let Self { dark, light } = self;
        dark.pack(bytes);
        light.pack(bytes);
    }
}
