//! The boxes of a node's children in little memory: coordinates are stored as bytes.

use crate::accel::bvh::sphere_leaf::{BoundingSphere, Frame, SphereLeaf};
use crate::accel::bvh::{boxes::Boxes, planes::Planes, planes::WIDTH, slab_ray::SlabRay};
use crate::{accel::bounds::Bounds, simd::SimdF32};

/// Up to 16 boxes in 112 bytes. The coordinate of a plane is stored as a byte. The byte `n` means `origin + n * step`.
/// All boxes of a node share one origin, and one step for each axis.
#[derive(Clone, Copy, Debug)]
pub struct ByteBoxes {
    /// The planes, as numbers of steps. The lower planes are rounded down, and the upper planes up. Bounding spheres
    /// have the centres in place of the lower planes, and the radii in place of the first upper planes.
    planes: Planes<u8>,
    /// For each axis, the coordinate of the plane with the number 0, in scene units.
    origin: [f32; 3],
    /// For each axis, the exponent of the step, as in the bits of an `f32`. A step is a power of two, so a number is
    /// multiplied by it without rounding.
    exponents: [u8; 3],
    /// The same for the steps in which radii are stored, if there are bounding spheres.
    radius_exponent: u8,
}

impl ByteBoxes {
    /// Returns the length of a step along each axis, in scene units.
    #[inline(always)]
    fn steps(&self) -> [f32; 3] {
        let [x, y, z] = self.exponents;
        [power_of_two(x), power_of_two(y), power_of_two(z)]
    }
}

/// Returns the `f32` with these exponent bits, whose other bits are 0.
#[inline(always)]
const fn power_of_two(exponent: u8) -> f32 {
    f32::from_bits((exponent as u32) << 23)
}

/// Returns the exponent of a step, as in the bits of an `f32`. 255 of these steps exceed `length`.
fn exponent_of_step(length: f64) -> u8 {
    // The exponent is that of the next larger power of two, so rounding cannot make 255 steps too short.
    (((length / 255.0) as f32).to_bits() >> 23) as u8 + 1
}

impl Boxes for ByteBoxes {
    type Number = u8;

    const EMPTY: Self = Self { planes: [[[0; WIDTH]; 3]; 2], origin: [0.0; 3], exponents: [1; 3], radius_exponent: 1 };

    fn new(boxes: &[Bounds]) -> Self {
        let all = boxes.iter().fold(Bounds::EMPTY, |all, bounds| all.union(bounds));
        let mut result = Self { origin: all.low, ..Self::EMPTY };
        for axis in 0..3 {
            let origin = f64::from(all.low[axis]);
            result.exponents[axis] = exponent_of_step(f64::from(all.high[axis]) - origin);
            let steps_per_unit = 1.0 / f64::from(result.steps()[axis]);
            for (lane, bounds) in boxes.iter().enumerate() {
                let steps = |plane: f32| (f64::from(plane) - origin) * steps_per_unit;
                // The conversion to an integer rounds down, as no number is negative.
                let high = steps(bounds.high[axis]);
                let whole = high as u8;
                result.planes[0][axis][lane] = steps(bounds.low[axis]) as u8;
                result.planes[1][axis][lane] = whole + u8::from(f64::from(whole) < high);
            }
        }
        result
    }

    fn bounds(&self, lane: usize) -> Bounds {
        let steps = self.steps();
        let plane = |side: usize, axis: usize| {
            f64::from(self.origin[axis]) + f64::from(steps[axis]) * f64::from(self.planes[side][axis][lane])
        };
        Bounds {
            low: [0, 1, 2].map(|axis| (plane(0, axis) as f32).next_down()),
            high: [0, 1, 2].map(|axis| (plane(1, axis) as f32).next_up()),
        }
    }

    #[inline(always)]
    fn intersect<F: SimdF32>(&self, slab_ray: &SlabRay<F>, farthest: f32, distances: &mut [f32; WIDTH]) -> u32 {
        slab_ray.in_frame(&self.origin, &self.steps()).intersect(&self.planes, farthest, distances)
    }

    fn of_spheres(boxes: &[Bounds]) -> Self {
        let point = |center: [f64; 3]| Bounds {
            low: center.map(|coordinate| (coordinate as f32).next_down()),
            high: center.map(|coordinate| (coordinate as f32).next_up()),
        };
        let centers = boxes.iter().map(|bounds| point(BoundingSphere::of(bounds).center));
        let all = centers.fold(Bounds::EMPTY, |all, center| all.union(&center));
        let mut leaf = Self { origin: all.low, ..Self::EMPTY };
        for axis in 0..3 {
            leaf.exponents[axis] = exponent_of_step(f64::from(all.high[axis]) - f64::from(all.low[axis]));
        }
        let (origin, steps) = (leaf.origin.map(f64::from), leaf.steps().map(f64::from));
        // Each centre is moved to the nearest whole numbers of steps, and each radius covers the move.
        let mut radii = [0.0; WIDTH];
        for (lane, bounds) in boxes.iter().enumerate() {
            let sphere = BoundingSphere::of(bounds);
            let mut center = [0.0; 3];
            for axis in 0..3 {
                let number = ((sphere.center[axis] - origin[axis]) / steps[axis]).round() as u8;
                leaf.planes[0][axis][lane] = number;
                center[axis] = origin[axis] + steps[axis] * f64::from(number);
            }
            radii[lane] = sphere.radius_around(center);
        }
        leaf.radius_exponent = exponent_of_step(radii.iter().copied().fold(0.0, f64::max));
        let step = f64::from(power_of_two(leaf.radius_exponent));
        leaf.planes[1][0] = radii.map(|radius| (radius / step).ceil() as u8);
        leaf
    }

    #[inline(always)]
    fn bounding_spheres(&self) -> SphereLeaf<'_, u8> {
        let frame = Frame { origin: self.origin, steps: self.steps(), radius_step: power_of_two(self.radius_exponent) };
        SphereLeaf { rows: self.planes.as_flattened(), frame }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accel::bvh::boxes::FloatBoxes;
    use crate::sampling::uniform::Uniform;
    use crate::simd::{Kernel, Simd, instruction_set::InstructionSet};

    /// A kernel that finds the boxes that overlap another box.
    struct Overlaps<'a, B>(&'a B, &'a Bounds);

    impl<B: Boxes> Kernel for Overlaps<'_, B> {
        type Output = u32;

        #[inline(always)]
        fn call<S: Simd>(self, _: S) -> u32 {
            self.0.overlaps::<S::F32>(self.1)
        }
    }

    #[test]
    fn the_sizes_are_as_documented() {
        assert_eq!([size_of::<FloatBoxes>(), size_of::<ByteBoxes>()], [384, 112]);
    }

    #[test]
    fn of_every_length_255_steps_are_longer_and_at_most_twice_as_long() {
        // The exponent grows with the length. So the lengths with an exponent of `e` or less are shorter than the
        // length of 255 steps, if that has a larger exponent.
        for exponent in 1..254 {
            let steps = 255.0 * f64::from(power_of_two(exponent));
            assert_eq!(exponent_of_step(steps), exponent + 1);
            assert_eq!(exponent_of_step(steps / 2.0), exponent, "half as long");
        }
    }

    /// Returns `count` random boxes. Their coordinates differ from `offset` by at most `2 scale`.
    fn boxes(draws: &mut Uniform, count: usize, scale: f64, offset: f64) -> Vec<Bounds> {
        (0..count)
            .map(|_| {
                let low = [(); 3].map(|()| (offset + draws.draw(-scale, scale)) as f32);
                Bounds { low, high: low.map(|low| low + draws.draw(0.0, scale) as f32) }
            })
            .collect()
    }

    #[test]
    fn a_box_of_bytes_contains_the_box_that_was_given_and_is_hardly_larger() {
        let mut draws = Uniform::new(3);
        for number in 0..2000 {
            let scale = 10.0_f64.powf(draws.draw(-5.0, 9.0));
            let offset = if number % 2 == 0 { 0.0 } else { draws.draw(-1e9, 1e9) };
            let given = boxes(&mut draws, 1 + number % WIDTH, scale, offset);
            let all = given.iter().fold(Bounds::EMPTY, |all, bounds| all.union(bounds));
            let (bytes, wide) = (ByteBoxes::new(&given), FloatBoxes::new(&given));
            for (lane, given) in given.iter().enumerate() {
                assert_eq!(wide.bounds(lane), *given);
                let actual = bytes.bounds(lane);
                for axis in 0..3 {
                    let step = (f64::from(all.high[axis]) - f64::from(all.low[axis])) / 127.0;
                    let largest = f64::from(all.low[axis].abs().max(all.high[axis].abs()));
                    let most = step + 3.0 * f64::from(f32::EPSILON) * largest;
                    let below = f64::from(given.low[axis]) - f64::from(actual.low[axis]);
                    let above = f64::from(actual.high[axis]) - f64::from(given.high[axis]);
                    for outside in [below, above] {
                        assert!(outside > 0.0 && outside <= most, "{given:?} in {actual:?}");
                    }
                }
            }
        }
    }

    #[test]
    fn boxes_that_overlap_are_found_by_every_set() {
        let mut draws = Uniform::new(4);
        let mut overlaps = 0;
        for number in 0..2000 {
            let given = boxes(&mut draws, WIDTH, 1.0, (number % 3) as f64 * 1000.0);
            let mut other = boxes(&mut draws, 1, 1.0, (number % 3) as f64 * 1000.0)[0];
            if number % 2 == 0 {
                // The other box only touches the first box.
                other.low[0] = given[0].high[0];
                other.high[0] = other.low[0] + 1.0;
            }
            let expected = (0..WIDTH).fold(0, |bits, lane| bits | u32::from(given[lane].overlaps(&other)) << lane);
            let wide = FloatBoxes::new(&given);
            for set in InstructionSet::available() {
                assert_eq!(set.run(Overlaps(&wide, &other)), expected, "{}", set.name());
            }
            overlaps += expected.count_ones();
        }
        assert!(overlaps > 2000, "{overlaps}");
    }
}
