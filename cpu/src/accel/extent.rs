//! How large a scene is, and whether filters may be trusted with it.

use crate::geometry::camera::Camera;
use crate::input::material::Material;
use crate::layout::Objects;
use crate::math::vec3::Vec3;

/// The magnitudes that occur in a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extent {
    /// Largest magnitude of a coordinate that an object, or the camera, reaches.
    pub reach: f64,
    /// Whether all magnitudes are moderate. Where one is extreme, intermediate values of the filters could overflow or
    /// underflow, and the intersections with them: every object is then intersected, by the exact formulas.
    pub moderate: bool,
}

impl Extent {
    /// Largest coordinate, height, radius or diffusion that counts as moderate.
    pub const LARGEST: f64 = 1e9;
    /// Smallest radius or height that counts as moderate.
    pub const SMALLEST: f64 = 1e-6;

    /// The extent of a scene seen by a camera.
    #[must_use]
    pub fn new(objects: &impl Objects, camera: &Camera, materials: &[Material]) -> Self {
        let (mut low, mut high) = (Vec3::splat(f64::INFINITY), Vec3::splat(f64::NEG_INFINITY));
        let (mut smallest, mut largest_radius) = (f64::INFINITY, 0.0_f64);
        let mut include = |center: Vec3, reach: f64| {
            low = Vec3::new(low.x.min(center.x - reach), low.y.min(center.y - reach), low.z.min(center.z - reach));
            high = Vec3::new(high.x.max(center.x + reach), high.y.max(center.y + reach), high.z.max(center.z + reach));
        };
        for index in 0..objects.sphere_count() {
            let sphere = objects.sphere(index).record;
            include(sphere.center, sphere.radius);
            smallest = smallest.min(sphere.radius);
            largest_radius = largest_radius.max(sphere.radius);
        }
        for index in 0..objects.cylinder_count() {
            let cylinder = objects.cylinder(index).record;
            include(cylinder.center, cylinder.radius.hypot(cylinder.half_height));
            smallest = smallest.min(cylinder.radius).min(cylinder.half_height);
            largest_radius = largest_radius.max(cylinder.radius);
        }
        let empty = low.x > high.x;
        let magnitude = |vector: Vec3| vector.x.abs().max(vector.y.abs()).max(vector.z.abs());
        let reach = if empty { 0.0 } else { magnitude(low).max(magnitude(high)) }.max(magnitude(camera.position));
        let diffusion = materials.iter().fold(0.0, |most: f64, material| match material {
            Material::Metal { diffusion, .. } => most.max(*diffusion),
            _ => most,
        });
        let pixel = camera.delta_x.length().min(camera.delta_y.length());
        let window = (camera.origin - camera.position).length();
        let moderate = reach <= Self::LARGEST
            && diffusion <= Self::LARGEST
            && smallest >= Self::SMALLEST
            && window <= Self::LARGEST
            && pixel >= Self::SMALLEST * Self::SMALLEST;
        Self { reach, moderate }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::config::Config;
    use crate::input::scene::Scene;
    use crate::layout::aos::AosObjects;

    fn extent(scene: &str) -> Extent {
        let config = Config::default();
        let camera = config.image_size().and_then(|size| Camera::new(&config, size)).expect("the defaults render");
        let scene = Scene::parse(scene.as_bytes()).expect("the scene is valid");
        Extent::new(&AosObjects::build(&scene).expect("it fits"), &camera, &scene.materials)
    }

    #[test]
    fn objects_and_camera_are_included() {
        let extent = extent("matte: m 1 1 1\nsphere: 20 0 0 1 m\ncylinder: -30 0 0 3 0 8 0 m\n");
        assert_eq!(extent.reach, 35.0);
        assert!(extent.moderate);
        assert_eq!(self::extent("").reach, 10.0, "the camera is at z = -10");
    }

    #[test]
    fn extreme_scenes_are_told() {
        for line in
            ["sphere: 1e10 0 0 1 m", "sphere: 0 0 0 1e-7 m", "cylinder: 0 0 0 1 1e-9 0 0 m", "metal: n 1 1 1 1e10"]
        {
            assert!(!extent(&format!("matte: m 1 1 1\n{line}\n")).moderate, "{line}");
        }
    }
}
