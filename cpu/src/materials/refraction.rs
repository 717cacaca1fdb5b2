//! Refraction (specification, section 10.3).
//!
//! If the normal has length one, this is Snell's law: the sine of the angle of incidence times the ratio of indices is
//! the sine of the angle of refraction. With `rho` as the object's refractive index:
//!
//! 1. A ray enters if the dot product of its direction and the outward normal is negative. The ratio is then `1 / rho`,
//!    and otherwise `rho`. `front_and_normal` in `geometry/ray.rs` decides whether a ray enters.
//! 2. If the ratio times the sine of incidence is larger than 1, the ray is reflected instead.
//! 3. No random number is drawn, and the reflectance is 1 in every channel. So the renderer records no attenuation for
//!    a refractive surface (`scatter` in `render/path.rs`, and `render/specular_chains.rs`). `input/material.rs` has
//!    the reflectance. Only the reference multiplies by 1.
//!
//! On the side of a cylinder the normal is as long as the radius (section 9.2), and the same formula is used. So the
//! cosine must be limited to 1, and the square root is that of a magnitude.
//!
//! The reference has a copy of this rule in `reference.rs` (`scatter`), and WGSL has one in `scatter.wgsl`
//! (`scatter_index_ratio` and `scatter_refract`).

use crate::{materials::reflection::reflect, math::real::Real, math::vec3::Vec3};

/// Returns the direction of the ray that a refractive surface scatters: the refracted direction, or the mirror
/// direction beyond the critical angle. `direction` is that of the ray that hits the surface, and may have any length.
/// `normal` is on the side that the ray comes from. `ratio` is the refractive index on that side, divided by the one on
/// the other side.
#[inline(always)]
pub fn refract<T: Real>(direction: Vec3<T>, normal: Vec3<T>, ratio: T) -> Vec3<T> {
    let one = T::of(1.0);
    let u = direction.unit();
    let cos = -u.dot(normal);
    let cos = T::select(cos.less(one), cos, one);
    let sin = (one - cos * cos).sqrt();
    let p = (u + normal * cos) * ratio;
    let refracted = p - normal * (one - p.dot(p)).abs().sqrt();
    Vec3::select(one.less(ratio * sin), reflect(u, normal), refracted)
}

#[cfg(test)]
mod tests {
    use super::*;

    const UP: Vec3 = Vec3::new(0.0, 1.0, 0.0);

    #[test]
    fn light_is_bent_by_snells_law() {
        let incoming = Vec3::new(3.0, -4.0, 0.0);
        let bent = refract(incoming, UP, 1.0 / 1.5);
        assert!((bent.length() - 1.0).abs() < 1e-15);
        assert!((bent.x - 0.6 / 1.5).abs() < 1e-15, "sine of refraction is sine of incidence over the index");
        assert!(bent.y < 0.0);
    }

    #[test]
    fn straight_light_stays_straight_and_beyond_the_critical_angle_it_is_reflected() {
        assert_eq!(refract(-UP, UP, 1.5), -UP);
        assert_eq!(refract(Vec3::new(3.0, -4.0, 0.0), UP, 2.0), Vec3::new(0.6, 0.8, 0.0));
        // At the critical angle itself, ratio sin = 1 is not beyond it: the light leaves along the surface.
        let grazing = refract(Vec3::new(1.0, 0.0, 0.0), UP, 1.0);
        assert_eq!(grazing, Vec3::new(1.0, 0.0, 0.0));
    }
}
