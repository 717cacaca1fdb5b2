//! Mirror images (specification, section 10.2). The reference has a copy of these formulas in `reference.rs`
//! (`scatter`), and WGSL has one in `scatter.wgsl`.

use crate::math::{real::Real, vec3::Vec3};

/// Returns `direction - 2 (direction . normal) normal`. If `normal` has length one, this is the mirror image. The
/// normal of a cylinder's side is as long as the radius (specification, section 9.2), and must be passed without
/// normalising it. For a radius other than one, the result is then in general not the mirror image.
#[inline(always)]
pub fn reflect<T: Real>(direction: Vec3<T>, normal: Vec3<T>) -> Vec3<T> {
    direction - normal * (direction.dot(normal) * T::of(2.0))
}

/// Returns [`reflect`] with length one. A metal surface without diffusion reflects light in this direction.
#[inline(always)]
pub fn mirror<T: Real>(direction: Vec3<T>, normal: Vec3<T>) -> Vec3<T> {
    reflect(direction, normal).unit()
}

#[cfg(test)]
mod tests {
    use super::*;

    const UP: Vec3 = Vec3::new(0.0, 1.0, 0.0);

    #[test]
    fn a_mirror_image_leaves_at_the_angle_at_which_light_comes() {
        let down = Vec3::new(3.0, -4.0, 0.0);
        assert_eq!(reflect(down, UP), Vec3::new(3.0, 4.0, 0.0));
        assert_eq!(mirror(down, UP), Vec3::new(0.6, 0.8, 0.0));
    }

    #[test]
    fn a_normal_and_its_opposite_give_the_same_mirror_image() {
        let (direction, normal) = (Vec3::new(3.0, -4.0, 0.3), Vec3::new(0.1, 0.9, -0.2));
        assert_eq!(mirror(direction, normal), mirror(direction, -normal));
    }
}
