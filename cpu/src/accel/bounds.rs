//! Axis-aligned boxes around objects. They contain their objects in spite of rounding.

use crate::accel::{object::ObjectId, object::ObjectRef};
use crate::{geometry::cylinder::CylinderRecord, layout::Objects, math::real::Real, math::vec3::Vec3};

/// Returns at least the half width along a direction of a disc of radius 1: how far the disc reaches from its centre.
/// `along` is the dot product of the direction and the disc's axis, both of length one.
#[inline(always)]
pub fn half_width_of_disc<T: Real>(along: T) -> T {
    let across = T::of(1.0) - along * along;
    T::select(T::of(0.0).less(across), across, T::of(0.0)).sqrt() + T::of(DISC_MARGIN)
}

/// If a component of the axis is close to 1, the difference in [`half_width_of_disc`] cancels. The error of its square
/// root is at most the square root of its error, which this covers.
pub const DISC_MARGIN: f64 = 1e-7;

/// Returns the half width of a cylinder along a direction: how far it reaches from its centre. `along` is the dot
/// product of the direction and the cylinder's axis, both of length one.
#[inline(always)]
pub fn half_width_of_cylinder<T: Real>(along: T, half_height: T, radius: T) -> T {
    half_height * along.abs() + radius * half_width_of_disc(along)
}

/// The part by which the half sizes of boxes are enlarged, to cover their rounding. The rounding to single precision,
/// outward by more than a unit in the last place, covers that of the sum with the centre.
pub const ENLARGEMENT: f64 = 1e-6;

/// An axis-aligned box, in scene units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// The smallest coordinate along each axis.
    pub low: [f32; 3],
    /// The largest coordinate along each axis.
    pub high: [f32; 3],
}

impl Bounds {
    /// The empty box. Its union with another box is that other box.
    pub const EMPTY: Self = Self { low: [f32::INFINITY; 3], high: [f32::NEG_INFINITY; 3] };

    /// Returns the smallest box around both boxes.
    pub fn union(mut self, other: &Self) -> Self {
        for axis in 0..3 {
            self.low[axis] = self.low[axis].min(other.low[axis]);
            self.high[axis] = self.high[axis].max(other.high[axis]);
        }
        self
    }

    /// Returns half of the surface area, or 0 for an empty box. The share of random lines that hit a box is
    /// proportional to this.
    pub fn half_area(&self) -> f32 {
        let [x, y, z] = std::array::from_fn(|axis| (self.high[axis] - self.low[axis]).max(0.0));
        x * y + y * z + z * x
    }

    /// Returns the axis along which the box is longest: 0 for x, 1 for y, 2 for z.
    pub fn longest_axis(&self) -> usize {
        let length = |axis: usize| self.high[axis] - self.low[axis];
        (0..3).max_by(|&left, &right| length(left).total_cmp(&length(right))).unwrap_or(0)
    }

    /// Returns the box with each of its six planes moved outward by at least `by`, in scene units.
    pub(crate) fn enlarged(mut self, by: f32) -> Self {
        for axis in 0..3 {
            self.low[axis] = (self.low[axis] - by).next_down();
            self.high[axis] = (self.high[axis] + by).next_up();
        }
        self
    }

    /// Returns the distance between the box and a point, or 0 if the point is inside.
    pub fn distance(&self, point: Vec3) -> f64 {
        let point = point.to_array();
        let outside = |axis: usize| {
            let (low, high) = (f64::from(self.low[axis]), f64::from(self.high[axis]));
            (low - point[axis]).max(point[axis] - high).max(0.0)
        };
        Vec3::from([0, 1, 2].map(outside)).length()
    }

    /// Whether the boxes have a point in common.
    pub(crate) fn overlaps(&self, other: &Self) -> bool {
        (0..3).all(|axis| self.low[axis] <= other.high[axis] && other.low[axis] <= self.high[axis])
    }

    /// Returns twice the coordinate of the box's middle along an axis.
    pub fn twice_middle(&self, axis: usize) -> f32 {
        self.low[axis] + self.high[axis]
    }

    /// Returns a box that contains the object with the number `id`.
    pub fn of_object<O: Objects>(objects: &O, id: ObjectId) -> Self {
        match ObjectRef::of(objects, id) {
            ObjectRef::Sphere(index) => {
                let sphere = objects.sphere(index).record;
                Self::around(sphere.center, Vec3::splat(sphere.radius))
            }
            ObjectRef::Cylinder(index) => {
                let cylinder = objects.cylinder(index).record;
                let CylinderRecord { axis, half_height, radius, .. } = cylinder;
                let half_size = axis.map(|along| half_width_of_cylinder(along, half_height, radius));
                Self::around(cylinder.center, half_size)
            }
        }
    }

    /// Returns a box around `center` with a little more than `half_size` to each side.
    fn around(center: Vec3, half_size: Vec3) -> Self {
        let half_size = (half_size * (1.0 + ENLARGEMENT)).to_array();
        let center = center.to_array();
        Self {
            low: std::array::from_fn(|axis| -above(half_size[axis] - center[axis])),
            high: std::array::from_fn(|axis| above(center[axis] + half_size[axis])),
        }
    }
}

/// Returns a number in single precision that is larger than `coordinate`.
#[inline(always)]
pub const fn above(coordinate: f64) -> f32 {
    (coordinate as f32).next_up()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::scene::Scene;
    use crate::layout::aos::AosObjects;

    fn bounds(line: &str) -> Bounds {
        let scene = Scene::parse(format!("matte: m 1 1 1\n{line} m\n").as_bytes()).expect("the scene is valid");
        let objects = AosObjects::build(&scene).expect("one object fits");
        Bounds::of_object(&objects, 0)
    }

    fn assert_tight(actual: Bounds, low: [f32; 3], high: [f32; 3]) {
        for axis in 0..3 {
            assert!(actual.low[axis] < low[axis] && actual.low[axis] > low[axis] - 1e-5, "{actual:?}");
            assert!(actual.high[axis] > high[axis] && actual.high[axis] < high[axis] + 1e-5, "{actual:?}");
        }
    }

    #[test]
    fn boxes_hold_their_objects_tightly() {
        assert_tight(bounds("sphere: 1 2 3 .5"), [0.5, 1.5, 2.5], [1.5, 2.5, 3.5]);
        assert_tight(bounds("cylinder: 1 2 3 .5 0 4 0"), [0.5, 0.0, 2.5], [1.5, 4.0, 3.5]);
        let diagonal = bounds("cylinder: 0 0 0 1 2 2 0");
        let half = 1.0 + 0.5_f32.sqrt();
        assert_tight(diagonal, [-half, -half, -1.0], [half, half, 1.0]);
    }

    #[test]
    fn a_box_holds_the_rim_of_a_flat_cylinder_whose_tilt_is_rounded_away() {
        // The unit axis is rounded to (1, 4e-9, 0), so `1 - 1 * 1` is 0, and the rim reaches 4e-9 farther.
        let flat = bounds("cylinder: 0 0 0 1 2e-6 8e-15 0");
        assert!(f64::from(flat.high[0]) > 1e-6 + 4e-9, "{flat:?}");
    }

    #[test]
    fn the_union_holds_both() {
        let left = Bounds { low: [0.0; 3], high: [1.0; 3] };
        let right = Bounds { low: [2.0, -1.0, 0.0], high: [3.0, 0.5, 3.0] };
        let both = Bounds { low: [0.0, -1.0, 0.0], high: [3.0, 1.0, 3.0] };
        assert_eq!(left.union(&right), both);
        assert_eq!(Bounds::EMPTY.union(&left), left);
        assert_eq!((both.half_area(), Bounds::EMPTY.half_area()), (21.0, 0.0));
        assert_eq!(right.twice_middle(0), 5.0);
        let long = |axis: usize| Bounds { low: [0.0; 3], high: [0, 1, 2].map(|at| if at == axis { 3.0 } else { 1.0 }) };
        assert_eq!([0, 1, 2].map(|axis| long(axis).longest_axis()), [0, 1, 2]);
    }

    #[test]
    fn boxes_overlap_where_they_share_a_point() {
        let left = Bounds { low: [0.0; 3], high: [1.0; 3] };
        for axis in 0..3 {
            for (from, overlaps) in [(1.0, true), (1.1, false), (-1.0, true), (-1.1, false), (0.5, true)] {
                let mut right = left;
                (right.low[axis], right.high[axis]) = (from, from + 1.0);
                assert_eq!((left.overlaps(&right), right.overlaps(&left)), (overlaps, overlaps), "{axis}: {from}");
                assert!(left.overlaps(&right.enlarged(0.2)));
            }
        }
    }

    #[test]
    fn a_box_is_as_far_from_a_point_as_its_nearest_corner_edge_or_face() {
        let unit = Bounds { low: [0.0; 3], high: [1.0; 3] };
        assert_eq!(unit.distance(Vec3::new(0.5, 0.2, 1.0)), 0.0);
        assert_eq!(unit.distance(Vec3::new(0.5, 0.5, -2.0)), 2.0);
        assert_eq!(unit.distance(Vec3::new(4.0, -4.0, 0.5)), 5.0);
        assert_eq!(unit.distance(Vec3::new(3.0, 3.0, 2.0)), 3.0);
    }

    #[test]
    fn a_disc_reaches_by_the_sine_of_its_tilt() {
        for (along, half_width) in [(0.0, 1.0), (0.6, 0.8), (-0.6, 0.8), (1.0, 0.0), (1.0_f64.next_up(), 0.0)] {
            assert!((half_width..half_width + 2e-7).contains(&half_width_of_disc(along)), "{along}");
        }
    }
}
