//! Sphere leaves: nodes whose children are all spheres, and which have bounding spheres instead of boxes.
//!
//! Almost half of the rays that hit a sphere's box miss the sphere. A bounding sphere excludes these rays, so the
//! sphere's record is not loaded for them. Its test also reads four numbers instead of six, but takes more operations.
//! The savings outweigh the operations in trees that hold only spheres, if rays test many of them. [`save_time`] has
//! the rule. All other trees have boxes in every node.
//!
//! A bounding sphere is computed from the sphere's box. Let `u = 2^-24`, and let `P` be the largest magnitude of the
//! box's coordinates. Without rounding, the box would be a cube around the sphere. Rounding moves each plane outward by
//! at most 1.5 units in the last place, which is `3 u P` ([`Bounds::of_object`]). So the middle of the box is not the
//! sphere's centre. The radius has room for that, and for the rounding in [`SphereLeaf::overlaps`]
//! (`tests/stability/src/proof/boxes.rs`). This is true for coordinates. Trees with bytes are so large that isolated
//! objects, for which boxes are tested for overlaps, are not sought.

use crate::accel::bounds::Bounds;
use crate::accel::bvh::{planes::PlaneNumber, planes::WIDTH};
use crate::simd::SimdF32;

/// Whether sphere leaves save time in a tree over objects that are `only_spheres` or not. `half_areas` is the sum of
/// the half surface areas of their boxes, and `half_area` that of the box around all of them. The quotient of the two
/// is the average number of objects' boxes that a line through the scene crosses. If it is below 1, rays test few
/// objects, and sphere leaves would cost time. In a tree with cylinders few nodes hold only spheres, and preparing each
/// ray for them costs what they save (docs/experiments.md, "Which limits were measured?").
pub(crate) fn save_time(only_spheres: bool, half_areas: f64, half_area: f32) -> bool {
    only_spheres && half_areas >= f64::from(half_area)
}

/// The part of a box's largest coordinate by which the radius is enlarged: `16 u`.
const RADIUS_ENLARGEMENT: f64 = 8.0 * f32::EPSILON as f64;

/// A bounding sphere of a sphere, in scene units.
#[derive(Clone, Copy, Debug)]
pub struct BoundingSphere {
    /// The coordinates of the centre.
    pub center: [f64; 3],
    /// The radius, with room for rounding.
    radius: f64,
}

impl BoundingSphere {
    /// Returns a bounding sphere of the sphere whose box is `bounds`.
    pub fn of(bounds: &Bounds) -> Self {
        let (low, high) = (bounds.low.map(f64::from), bounds.high.map(f64::from));
        let most =
            |of: fn(f64, f64) -> f64| [0, 1, 2].map(|axis| of(low[axis], high[axis])).into_iter().fold(0.0, f64::max);
        let largest = most(|low, high| low.abs().max(high.abs()));
        Self {
            center: [0, 1, 2].map(|axis| (low[axis] + high[axis]) / 2.0),
            radius: most(|low, high| (high - low) / 2.0) + RADIUS_ENLARGEMENT * largest,
        }
    }

    /// Returns the radius of the smallest sphere around this one that has its centre at `center`.
    pub fn radius_around(&self, center: [f64; 3]) -> f64 {
        let squares = [0, 1, 2].map(|axis| (center[axis] - self.center[axis]).powi(2));
        self.radius + squares.iter().sum::<f64>().sqrt()
    }
}

/// The scale of stored numbers, in scene units: along each axis, the number `n` means `origin + n step`.
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    /// The coordinates of the number 0.
    pub origin: [f32; 3],
    /// The length of a step along each axis.
    pub steps: [f32; 3],
    /// The length of a step of a radius.
    pub radius_step: f32,
}

impl Frame {
    /// The scale with which numbers are the coordinates themselves.
    pub const IDENTITY: Self = Self { origin: [0.0; 3], steps: [1.0; 3], radius_step: 1.0 };
}

/// The bounding spheres of up to 16 children, which are tested together.
#[derive(Clone, Copy, Debug)]
pub struct SphereLeaf<'a, P> {
    /// At least four rows: the x, y and z coordinates of the centres, and the radii.
    pub rows: &'a [[P; WIDTH]],
    /// The scale of the numbers.
    pub frame: Frame,
}

impl<P: PlaneNumber> SphereLeaf<'_, P> {
    /// Returns the centres and radii of the lanes from `at` on. The centres are relative to `origin`.
    #[inline(always)]
    pub fn load<F: SimdF32>(&self, at: usize, origin: &[f32; 3]) -> ([F; 3], F) {
        let Self { rows, frame } = self;
        let mut center = [F::splat(0.0); 3];
        // This is a loop and no closure; see `Kernel::call`.
        for (axis, center) in center.iter_mut().enumerate() {
            let (step, start) = (F::splat(frame.steps[axis]), F::splat(frame.origin[axis] - origin[axis]));
            *center = P::load::<F>(&rows[axis][at..]).mul_add(step, start);
        }
        (center, P::load::<F>(&rows[3][at..]) * F::splat(frame.radius_step))
    }

    /// Returns 16 bits. Bit `i` is 1 if the box around bounding sphere `i` overlaps `bounds`. It may also be 1 if the
    /// two are near each other.
    #[inline(always)]
    pub fn overlaps<F: SimdF32>(&self, bounds: &Bounds) -> u32 {
        let mut bits = 0;
        for at in (0..WIDTH).step_by(F::LANES) {
            let (center, radius) = self.load::<F>(at, &[0.0; 3]);
            let mut overlaps = u32::MAX;
            for (axis, center) in center.into_iter().enumerate() {
                overlaps &= (center - radius).less_equal(F::splat(bounds.high[axis]));
                overlaps &= F::splat(bounds.low[axis]).less_equal(center + radius);
            }
            bits |= overlaps << at;
        }
        bits
    }

    /// Returns the box around the bounding sphere in a lane.
    pub(crate) fn bounds(&self, lane: usize) -> Bounds {
        let Self { rows, frame } = self;
        let number = |row: usize| -> f64 { rows[row][lane].into() };
        let center = |axis: usize| f64::from(frame.origin[axis]) + f64::from(frame.steps[axis]) * number(axis);
        let radius = f64::from(frame.radius_step) * number(3);
        Bounds {
            low: [0, 1, 2].map(|axis| ((center(axis) - radius) as f32).next_down()),
            high: [0, 1, 2].map(|axis| ((center(axis) + radius) as f32).next_up()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accel::bvh::{boxes::Boxes, boxes::FloatBoxes, byte_boxes::ByteBoxes};
    use crate::sampling::uniform::Uniform;
    use crate::simd::instruction_set::InstructionSet;
    use crate::simd::{Kernel, Simd};

    /// A kernel that finds the bounding spheres that overlap a box.
    struct Overlaps<'a, P>(SphereLeaf<'a, P>, &'a Bounds);

    impl<P: PlaneNumber> Kernel for Overlaps<'_, P> {
        type Output = u32;

        #[inline(always)]
        fn call<S: Simd>(self, _: S) -> u32 {
            self.0.overlaps::<S::F32>(self.1)
        }
    }

    /// Returns the boxes of 16 random spheres, and the length of a side of the cube that contains their centres.
    fn boxes(draws: &mut Uniform) -> (Vec<Bounds>, f64) {
        let side = 10.0_f64.powf(draws.draw(-3.0, 6.0));
        let offset = draws.draw(-1.0, 1.0) * side * 10.0_f64.powf(draws.draw(-1.0, 2.0));
        let cube = || {
            let center = [(); 3].map(|()| offset + draws.draw(-0.5, 0.5) * side);
            let radius = side * 10.0_f64.powf(draws.draw(-2.0, 0.0));
            let [low, high] = [-radius, radius].map(|radius| center.map(|at| (at + radius) as f32));
            Bounds { low: low.map(f32::next_down), high: high.map(f32::next_up) }
        };
        (std::iter::repeat_with(cube).take(WIDTH).collect(), side)
    }

    #[test]
    fn bounding_spheres_that_overlap_a_box_are_found_by_every_set() {
        let mut draws = Uniform::new(7);
        let (mut overlaps, mut more) = (0, 0);
        for _ in 0..2000 {
            let (bounds, side) = boxes(&mut draws);
            // This box only touches the box of the first sphere.
            let low = [bounds[0].high[0], bounds[0].low[1], bounds[0].low[2]];
            let other = Bounds { low, high: low.map(|low| low + (0.3 * side) as f32) };
            let expected = (0..WIDTH).fold(0, |bits, lane| bits | u32::from(bounds[lane].overlaps(&other)) << lane);
            let (wide, bytes) = (FloatBoxes::of_spheres(&bounds), ByteBoxes::of_spheres(&bounds));
            let (wide, bytes) = (wide.bounding_spheres(), bytes.bounding_spheres());
            for set in InstructionSet::available() {
                let found = [set.run(Overlaps(wide, &other)), set.run(Overlaps(bytes, &other))];
                assert_eq!(found.map(|found| expected & !found), [0; 2], "{}, {bounds:?}, {other:?}", set.name());
                overlaps += expected.count_ones();
                more += (found[1] & !expected).count_ones();
            }
            for (lane, inner) in bounds.iter().enumerate() {
                let around = [wide.bounds(lane), bytes.bounds(lane)];
                assert!(around.iter().all(|around| around.union(inner) == *around), "{inner:?} in {around:?}");
            }
        }
        assert!(overlaps > 2000 && more < overlaps / 10, "{overlaps}, and {more} that are only near");
    }

    #[test]
    fn a_sphere_around_a_bounding_sphere_reaches_its_far_side() {
        let inner = BoundingSphere::of(&Bounds { low: [-1.0; 3], high: [1.0; 3] });
        let enlargement = 2.0_f64.powi(-20);
        assert_eq!(inner.radius_around([0.0, 3.0, -4.0]), 5.0 + (1.0 + enlargement));
    }
}
