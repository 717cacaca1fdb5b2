//! What the builder of the tree handles: objects with their boxes, and ranges of these objects.

use crate::accel::{bounds::Bounds, object::ObjectId};

/// A box in a form in which the union of two boxes is one minimum for each number. The compiler makes vector
/// instructions of it.
#[derive(Clone, Copy, Debug)]
pub struct PackedBounds {
    /// The smallest coordinates along x, y and z. The fourth number has no meaning here.
    pub low: [f32; 4],
    /// The largest coordinates along x, y and z, with the opposite sign. The fourth number has no meaning.
    pub minus_high: [f32; 4],
}

impl PackedBounds {
    /// The empty box. Its union with another box is that other box.
    pub const EMPTY: Self = Self { low: [f32::INFINITY; 4], minus_high: [f32::INFINITY; 4] };

    /// Returns the smallest box around both boxes. Of -0 and 0, `f32::min` may return either, depending on the
    /// processor. So the comparison is written out, and the box has the same bits everywhere.
    #[inline(always)]
    #[must_use]
    pub(crate) fn union(self, other: Self) -> Self {
        let least = |left: [f32; 4], right: [f32; 4]| -> [f32; 4] {
            std::array::from_fn(|at| if left[at] < right[at] { left[at] } else { right[at] })
        };
        Self { low: least(self.low, other.low), minus_high: least(self.minus_high, other.minus_high) }
    }

    /// Returns the box in its usual form.
    pub(crate) fn unpacked(&self) -> Bounds {
        let ([low_x, low_y, low_z, _], [x, y, z, _]) = (self.low, self.minus_high);
        Bounds { low: [low_x, low_y, low_z], high: [-x, -y, -z] }
    }
}

/// An object that the builder places in the tree, with its box. The object's number is stored in the bits of a number
/// of the box that has no meaning, so that an item has 32 bytes.
#[derive(Clone, Copy, Debug)]
#[repr(align(32))]
pub struct Item(PackedBounds);

impl Item {
    /// Returns the item for the object with the number `id`.
    pub(crate) fn new(bounds: &Bounds, id: ObjectId) -> Self {
        let ([x, y, z], high) = (bounds.low, bounds.high);
        Self(PackedBounds { low: [x, y, z, f32::from_bits(id)], minus_high: [-high[0], -high[1], -high[2], 0.0] })
    }

    /// Returns the object's number.
    pub(crate) const fn id(&self) -> ObjectId {
        self.0.low[3].to_bits()
    }

    /// Returns the object's box.
    #[inline(always)]
    pub(crate) const fn bounds(&self) -> PackedBounds {
        self.0
    }

    /// Returns twice the coordinate of the box's middle along an axis.
    #[inline(always)]
    pub(crate) fn twice_middle(&self, axis: usize) -> f32 {
        self.0.low[axis] - self.0.minus_high[axis]
    }

    /// Returns a box that is only the middle of the object's box. All its coordinates are doubled.
    #[inline(always)]
    pub(crate) fn middle(&self) -> PackedBounds {
        let Self(PackedBounds { low, minus_high }) = self;
        PackedBounds {
            low: std::array::from_fn(|at| low[at] - minus_high[at]),
            minus_high: std::array::from_fn(|at| minus_high[at] - low[at]),
        }
    }
}

/// A part of the list of items, which becomes one child.
#[derive(Clone, Copy, Debug)]
pub struct ItemRange {
    /// The index of the first item.
    pub from: usize,
    /// The index behind the last item.
    pub to: usize,
    /// The box around the items.
    pub bounds: PackedBounds,
    /// The box around the middles of the items' boxes. All its coordinates are doubled.
    pub middles: PackedBounds,
}

impl ItemRange {
    /// Returns the range of the items from index `from` to before index `to`.
    pub(crate) fn new(items: &[Item], from: usize, to: usize) -> Self {
        let (mut bounds, mut middles) = (PackedBounds::EMPTY, PackedBounds::EMPTY);
        for item in &items[from..to] {
            bounds = bounds.union(item.bounds());
            middles = middles.union(item.middle());
        }
        Self { from, to, bounds, middles }
    }

    /// Returns the number of items.
    pub(crate) const fn count(&self) -> usize {
        self.to - self.from
    }

    /// Returns the item if the range has only one.
    pub(crate) fn only_item<'items>(&self, items: &'items [Item]) -> Option<&'items Item> {
        (self.count() == 1).then(|| &items[self.from])
    }
}
