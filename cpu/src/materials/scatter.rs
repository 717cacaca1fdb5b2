//! How surfaces send light on (specification, section 10).

use crate::math::real::Real;
use crate::math::vec3::{NEGLIGIBLE, Vec3};

/// Where a matte surface sends light: around the normal (specification, section 10.1).
#[inline(always)]
#[must_use]
pub fn matte<T: Real<Mask = bool>>(normal: Vec3<T>, vector: Vec3<T>) -> Vec3<T> {
    around(normal, vector, T::of(NEGLIGIBLE))
}

/// The sum of a direction and a random vector; the direction alone where every component of the sum is smaller than
/// `negligible` in magnitude.
#[inline(always)]
#[must_use]
pub fn around<T: Real<Mask = bool>>(base: Vec3<T>, vector: Vec3<T>, negligible: T) -> Vec3<T> {
    let direction = base + vector;
    if direction.x.abs().less(negligible) && are_within(direction.y, direction.z, negligible) {
        return base;
    }
    direction
}

/// The rest of [`Vec3::is_within`]. A call that hardly any ray makes keeps this a branch: of three comparisons the
/// compiler makes a selection, and all that a ray does next would wait for them.
#[cold]
#[inline(never)]
fn are_within<T: Real<Mask = bool>>(y: T, z: T, limit: T) -> bool {
    y.abs().less(limit) && z.abs().less(limit)
}

/// The mirror image of `direction` in a surface.
#[inline(always)]
#[must_use]
pub fn reflect<T: Real>(direction: Vec3<T>, normal: Vec3<T>) -> Vec3<T> {
    direction - normal * (direction.dot(normal) * T::of(2.0))
}

/// The direction, of length one, in which a metal surface without diffusion sends light.
#[inline(always)]
#[must_use]
pub fn mirror<T: Real>(direction: Vec3<T>, normal: Vec3<T>) -> Vec3<T> {
    reflect(direction, normal).unit()
}

/// Where a metal surface sends light: the mirror image's direction, spread (specification, section 10.2).
#[inline(always)]
#[must_use]
pub fn metal<T: Real>(direction: Vec3<T>, normal: Vec3<T>, vector: Vec3<T>) -> Vec3<T> {
    mirror(direction, normal) + vector
}

/// Where a refractive surface sends light (specification, section 10.3). `ratio` is `1 / index` where the ray enters
/// and `index` where it leaves; beyond the critical angle the ray is reflected instead.
#[inline(always)]
#[must_use]
pub fn refract<T: Real>(direction: Vec3<T>, normal: Vec3<T>, ratio: T) -> Vec3<T> {
    let one = T::of(1.0);
    let u = direction.unit();
    let cos = -u.dot(normal);
    let cos = T::select(cos.less(one), cos, one);
    let sin = (one - cos * cos).sqrt();
    let reflected = reflect(u, normal);
    let p = (u + normal * cos) * ratio;
    let refracted = p - normal * (one - p.dot(p)).abs().sqrt();
    let beyond = one.less(ratio * sin);
    Vec3::new(
        T::select(beyond, reflected.x, refracted.x),
        T::select(beyond, reflected.y, refracted.y),
        T::select(beyond, reflected.z, refracted.z),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    const UP: Vec3 = Vec3::new(0.0, 1.0, 0.0);

    #[test]
    fn matte_falls_back_to_the_normal() {
        let vector = Vec3::new(0.5, 0.0, 0.0);
        assert_eq!(matte(UP, vector), Vec3::new(0.5, 1.0, 0.0));
        assert_eq!(matte(UP, -UP), UP);
        assert_eq!(matte(UP, Vec3::new(9e-9, -1.0, 0.0)), UP);
        assert_eq!(matte(UP, Vec3::new(2e-8, -1.0, 0.0)), Vec3::new(2e-8, 0.0, 0.0));
    }

    #[test]
    fn metal_mirrors_and_spreads() {
        let down = Vec3::new(3.0, -4.0, 0.0);
        assert_eq!(reflect(down, UP), Vec3::new(3.0, 4.0, 0.0));
        assert_eq!(metal(down, UP, Vec3::ZERO), Vec3::new(0.6, 0.8, 0.0));
        assert_eq!(metal(down, UP, Vec3::ONE), Vec3::new(1.6, 1.8, 1.0));
    }

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
