//! The magnitudes of a scene, which decide whether conservative tests are valid for it.

use crate::accel::{object::ObjectId, object::ObjectRef, object::bounding_sphere, object::count};
use crate::{geometry::camera::Camera, input::material::Material, layout::Objects, math::vec3::Vec3};

/// The largest coordinate of a scene, and whether the scene is moderate: no magnitude is so large or so small that a
/// conservative test could overflow or underflow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extent {
    /// The largest magnitude of a coordinate of the objects and of the camera, in scene units.
    pub max_coordinate: f64,
    /// Whether the scene is moderate: all magnitudes but those of objects are within the limits [`Extent::LARGEST`] and
    /// [`Extent::SMALLEST`]. In any other scene, intermediate values of the conservative tests could overflow or
    /// underflow. So there the exact formulas intersect every object. Giants and tiny objects are apart
    /// ([`crate::accel::giants`]).
    pub moderate: bool,
    /// Whether an object [is tiny](is_tiny).
    pub has_tiny: bool,
}

impl Extent {
    /// The largest coordinate, window distance or diffusion of a moderate scene.
    pub const LARGEST: f64 = 1e9;
    /// The smallest radius or half height of an object in a conservative test. The smallest size of a pixel is the
    /// square of this.
    pub const SMALLEST: f64 = 1e-6;

    /// Returns the extent of a scene with its camera.
    pub fn new(objects: &impl Objects, camera: &Camera, materials: &[Material]) -> Self {
        let place = largest_magnitude(camera.position);
        let mut ids = 0..count(objects) as ObjectId;
        let max_coordinate = ids.clone().map(|id| reach(objects, id)).fold(place, f64::max);
        let has_tiny = ids.any(|id| is_tiny(objects, id));
        let diffusion = materials.iter().fold(0.0, |most: f64, material| match material {
            Material::Metal { diffusion, .. } => most.max(*diffusion),
            _ => most,
        });
        let pixel = camera.delta_x.length().min(camera.delta_y.length());
        let window = (camera.origin - camera.position).length();
        let moderate = [place, diffusion, window].iter().all(|&size| size <= Self::LARGEST)
            && pixel >= Self::SMALLEST * Self::SMALLEST;
        Self { max_coordinate, moderate, has_tiny }
    }

    /// Whether the [conservative tests](crate::accel::may_hit::conservative) are valid for all objects of the scene.
    pub(crate) fn is_ordinary(&self) -> bool {
        self.moderate && !self.has_tiny && self.max_coordinate <= Self::LARGEST
    }
}

/// Returns a bound of the magnitudes of an object's coordinates, in scene units.
pub(crate) fn reach(objects: &impl Objects, id: ObjectId) -> f64 {
    let (center, radius) = bounding_sphere(objects, id);
    largest_magnitude(center) + radius
}

/// Whether the radius or half height of an object is so small that conservative tests might underflow.
pub(crate) fn is_tiny(objects: &impl Objects, id: ObjectId) -> bool {
    let smallest = match ObjectRef::of(objects, id) {
        ObjectRef::Sphere(index) => objects.sphere(index).record.radius,
        ObjectRef::Cylinder(index) => {
            let record = objects.cylinder(index).record;
            record.radius.min(record.half_height)
        }
    };
    smallest < Extent::SMALLEST
}

/// Returns the largest magnitude of a coordinate.
fn largest_magnitude(vector: Vec3) -> f64 {
    vector.x.abs().max(vector.y.abs()).max(vector.z.abs())
}

/// Whether no coordinate of the point exceeds `max_coordinate`, apart from the rounding of a hit point. NaN does not
/// exceed it. Debug builds check with this that a ray starts inside the scene's extent, and trees
/// that a ray does not start too far away.
pub(crate) fn is_within(point: Vec3, max_coordinate: f64) -> bool {
    let limit = max_coordinate * (1.0 + 1e-6);
    point.to_array().iter().all(|coordinate| coordinate.is_nan() || coordinate.abs() <= limit)
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
        assert_eq!(extent.max_coordinate, 35.0);
        assert!(extent.moderate && extent.is_ordinary());
        assert_eq!(self::extent("").max_coordinate, 10.0, "the camera is at z = -10");
    }

    #[test]
    fn extreme_scenes_are_not_moderate_and_have_tiny_objects() {
        for (line, expected) in [
            ("sphere: 1e10 0 0 1 m", (true, false)),
            ("sphere: 0 0 0 1e-6 m", (true, false)),
            ("sphere: 0 0 0 9e-7 m", (true, true)),
            ("cylinder: 0 0 0 1 19e-7 0 0 m", (true, true)),
            ("cylinder: 0 0 0 9e-7 1 0 0 m", (true, true)),
            ("metal: n 1 1 1 1e10", (false, false)),
        ] {
            let extent = extent(&format!("matte: m 1 1 1\n{line}\n"));
            assert_eq!((extent.moderate, extent.has_tiny), expected, "{line}");
            // Of the moderate scenes without tiny objects only the smallest one is within the largest coordinate.
            assert_eq!(extent.is_ordinary(), line.contains("1e-6"), "{line}");
        }
    }
}
