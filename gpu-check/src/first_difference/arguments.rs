//! Reads the arguments of a call from their numbers. Each method removes its numbers from the row, and panics if there
//! are too few.

use cpu::internals::geometry::cylinder::{CylinderPart, CylinderRecord};
use cpu::internals::geometry::sphere::SphereRecord;
use twin::trace::Hit;

use crate::Float;
use crate::picture::{Kind, PackedMaterial};
use crate::reader::Reader;
use crate::sampled::twin::canonical;

impl<T: Float> Reader<'_, T> {
    /// Returns the next truth value, which is 1 or 0.
    pub fn flag(&mut self) -> bool {
        self.number() != T::of(0.0)
    }

    /// Returns the next `Hit`.
    pub fn hit(&mut self) -> Hit<T> {
        Hit { point: self.vector(), normal: self.vector(), front: self.flag() }
    }

    /// Returns the `SphereRecord` whose fields are the next five numbers.
    pub fn sphere(&mut self) -> SphereRecord<T> {
        SphereRecord { center: self.vector(), radius: self.number(), radius_squared: self.number() }
    }

    /// Returns the `CylinderRecord` whose fields are the next 15 numbers.
    pub fn cylinder(&mut self) -> CylinderRecord<T> {
        CylinderRecord {
            center: self.vector(),
            axis: self.vector(),
            top: self.vector(),
            bottom: self.vector(),
            radius: self.number(),
            radius_squared: self.number(),
            half_height: self.number(),
        }
    }

    /// Returns the next number of a part of a cylinder. As in WGSL, every other number is the bottom cap.
    pub fn part(&mut self) -> CylinderPart {
        let number = self.number();
        let parts = [CylinderPart::Side, CylinderPart::Top];
        parts.into_iter().find(|part| part.number::<T>() == number).unwrap_or(CylinderPart::Bottom)
    }

    /// Returns the next `Material`, or the first fields of a `PackedMaterial`.
    pub fn material(&mut self) -> PackedMaterial<T> {
        let (reflectance, index, extent) = (self.vector(), self.number(), self.number());
        let kinds = [Kind::Matte, Kind::Metal];
        let number = self.number();
        let kind = kinds.into_iter().find(|kind| T::of(f64::from(*kind as u32)) == number);
        PackedMaterial { reflectance, index, extent, kind: kind.unwrap_or(Kind::Refractive) }
    }

    /// Returns the number in [0, 1) of the next word of a generator, or `None` in f32, which does not hold the halves
    /// of every word.
    pub fn canonical(&mut self) -> Option<T> {
        let (lower, upper) = (self.number(), self.number());
        (size_of::<T>() == size_of::<f64>()).then(|| canonical([lower, upper]))
    }
}
