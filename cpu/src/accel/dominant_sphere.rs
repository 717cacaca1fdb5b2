//! The dominant sphere: a sphere that is much larger than all other objects, for example a ground. Nearly every ray
//! must be tested against it. So it is not in the flat filter or a tree, and is tested separately.
//!
//! Only [`crate::accel::may_hit::conservative`] decides which rays cannot hit the dominant sphere. This file also
//! predicts whether a ray enters it. A wrong prediction costs time, but never changes the closest hit.

use crate::accel::{
    accelerator::ScatterTerms, bounds::Bounds, extent::Extent, extent::is_tiny, isolated::SEPARATION,
    may_hit::conservative::ConservativeRay, may_hit::target::Target, object::ObjectId, object::bounding_sphere,
    object::count,
};
use crate::geometry::ray::Ray;
use crate::layout::Objects;

/// A sphere is dominant if its radius is at least this many times each other object's bounding radius.
const RATIO: f64 = 8.0;

/// Maximum number of objects that overlap the dominant sphere. With more objects, intersecting each of them takes
/// longer than the flat filter.
const MOST_OVERLAPPING: usize = 4;

/// The number of the dominant sphere, or `None` if no sphere is dominant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DominantSphere(pub Option<ObjectId>);

impl DominantSphere {
    /// Finds the dominant sphere among `objects`.
    pub(crate) fn of(objects: &impl Objects) -> Self {
        let radius = |id: ObjectId| bounding_sphere(objects, id).1;
        let spheres = 0..objects.sphere_count() as ObjectId;
        let largest = spheres.max_by(|&left, &right| radius(left).total_cmp(&radius(right)));
        Self(largest.filter(|&largest| {
            let others = (0..count(objects) as ObjectId).filter(|&id| id != largest);
            !is_tiny(objects, largest) && radius(largest) >= RATIO * others.map(radius).fold(0.0, f64::max)
        }))
    }

    /// Whether the object with the number `id` is the dominant sphere.
    #[inline(always)]
    pub(crate) fn is(self, id: ObjectId) -> bool {
        self.0 == Some(id)
    }

    /// Whether there are a dominant sphere and other objects, and the centres of all others lie outside of it.
    /// Otherwise the sphere may be a room, which few rays that start in it leave.
    pub(crate) fn is_ground(self, objects: &impl Objects) -> bool {
        count(objects) > 1
            && self.0.map(|id| bounding_sphere(objects, id)).is_some_and(|(center, radius)| {
                let others = (0..count(objects) as ObjectId).filter(|&id| !self.is(id));
                others.map(|id| bounding_sphere(objects, id).0).all(|other| (other - center).length() > radius)
            })
    }

    /// Returns the objects that overlap the dominant sphere, including those that rounding may move into it. The result
    /// is `None` if they are more than [`MOST_OVERLAPPING`], or if there is no dominant sphere.
    ///
    /// A sphere is convex. So if a ray from its surface hits it again, the ray is inside the sphere between the two
    /// points. Such a ray can hit only the dominant sphere and the objects that overlap it.
    pub(crate) fn overlapping(self, objects: &impl Objects, extent: &Extent) -> Option<Vec<ObjectId>> {
        let (center, radius) = bounding_sphere(objects, self.0?);
        let reach = radius + SEPARATION * extent.max_coordinate;
        let overlaps = |&id: &ObjectId| !self.is(id) && Bounds::of_object(objects, id).distance(center) <= reach;
        let ids = (0..count(objects) as ObjectId).filter(overlaps);
        let overlapping: Vec<_> = ids.take(MOST_OVERLAPPING + 1).collect();
        (overlapping.len() <= MOST_OVERLAPPING).then_some(overlapping)
    }

    /// Whether a ray from the surface of the dominant sphere enters it. The result is false if there is no dominant
    /// sphere.
    #[inline(always)]
    pub(crate) fn is_entered_by<O: Objects>(self, objects: &O, ray: &Ray) -> bool {
        self.0.is_some_and(|id| ray.direction.dot(ray.origin - objects.sphere(id as usize).record.center) < 0.0)
    }

    /// Predicts whether the next ray of a path enters the dominant sphere. The path's last ray, `ray`, hits the
    /// dominant sphere at `lambda`, and the surface scatters by `terms`. Fewer than one prediction in 1,000 is wrong
    /// (`cpu/tests/counters.rs`).
    ///
    /// The processor often mispredicts a branch on whether a ray enters. The prediction of this function is known
    /// earlier than the ray. Computing the ray takes a point, a normal, a mirrored direction and its length, one after
    /// the other.
    ///
    /// Let `w` be the vector from the centre to the hit point. The ray enters if the dot product of its direction and
    /// `w` is negative. The direction is the random vector plus the mirrored direction (metal) or the normal (matte),
    /// both of length one. The dot product of the mirrored direction and `w` is `-d.w / |d|`, and that of the normal is
    /// `|w|` or `-|w|`. All these products follow from `w = (O - C) + lambda d`. So only lambda is needed of the hit.
    #[inline(always)]
    pub(crate) fn predicts_entry<O: Objects>(self, objects: &O, ray: &Ray, lambda: f64, terms: &ScatterTerms) -> bool {
        let Some(id) = self.0 else {
            return false;
        };
        let record = objects.sphere(id as usize).record;
        let (direction, from_center) = (ray.direction, ray.origin - record.center);
        let squared = direction.dot(direction);
        let of_direction = direction.dot(from_center) + lambda * squared;
        let of_vector = terms.vector.dot(from_center) + lambda * terms.vector.dot(direction);
        let of_base = if terms.is_around_normal {
            record.radius.copysign(-of_direction)
        } else {
            // Single precision is enough for a prediction, and has a lower latency.
            -of_direction * f64::from(1.0 / (squared as f32).sqrt())
        };
        of_base + of_vector < 0.0
    }

    /// Returns the index of the dominant sphere among the spheres if the ray may hit it. The result is `None` if the
    /// ray certainly misses it, or if there is no dominant sphere.
    #[inline(always)]
    pub(crate) fn may_be_hit<O: Objects>(self, objects: &O, conservative: &ConservativeRay<f64>) -> Option<usize> {
        let index = self.0? as usize;
        conservative.sphere(&Target::sphere(&objects.sphere(index).record)).then_some(index)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accel::closest_hit::ClosestHit;
    use crate::input::scene::Scene;
    use crate::layout::aos::AosObjects;
    use crate::materials::prepared::{BsdfKind, PreparedMaterial};
    use crate::math::vec3::Vec3;
    use crate::render::surface_hit::SurfaceHit;
    use crate::sampling::scatter_vectors::Scatter;
    use crate::sampling::uniform::Uniform;

    fn dominant_of(objects: &str) -> Option<ObjectId> {
        let scene = Scene::parse(format!("matte: m 1 1 1\n{objects}").as_bytes()).expect("the scene is valid");
        DominantSphere::of(&AosObjects::build(&scene).expect("it fits")).0
    }

    #[test]
    fn only_a_sphere_much_larger_than_all_else_is_dominant() {
        assert_eq!(dominant_of("sphere: 0 0 0 1 m\nsphere: 0 -9 0 8 m\n"), Some(1));
        assert_eq!(dominant_of("sphere: 0 0 0 1 m\nsphere: 0 -9 0 7.9 m\n"), None);
        assert_eq!(dominant_of("sphere: 0 -9 0 8 m\ncylinder: 0 0 0 .1 0 3 0 m\n"), None, "the cylinder is long");
        assert_eq!(dominant_of("cylinder: 0 0 0 .1 0 3 0 m\n"), None, "there is no sphere");
        assert_eq!(dominant_of("sphere: 0 0 0 1 m\n"), Some(0), "a single sphere is larger than all else");
    }

    #[test]
    fn objects_stand_on_a_ground_and_are_inside_of_a_room() {
        let is_ground = |text: &str| {
            let scene = Scene::parse(format!("matte: m 1 1 1\n{text}").as_bytes()).expect("the scene is valid");
            let objects = AosObjects::build(&scene).expect("it fits");
            DominantSphere::of(&objects).is_ground(&objects)
        };
        assert!(is_ground("sphere: 0 -50 0 50 m\nsphere: 0 1 0 1 m\ncylinder: 2 .1 0 1 0 3 0 m\n"));
        assert!(!is_ground("sphere: 0 -50 0 50 m\nsphere: 0 1 0 1 m\ncylinder: 2 -1 0 1 0 3 0 m\n"), "one is inside");
        assert!(!is_ground("sphere: 0 0 0 50 m\nsphere: 0 1 0 1 m\n"), "a room");
        assert!(!is_ground("sphere: 0 -3 0 3 m\nsphere: 0 1 0 1 m\n"), "no sphere is dominant");
        assert!(!is_ground("sphere: 0 0 0 50 m\n"), "the camera may be inside");
    }

    #[test]
    fn the_entry_of_a_scattered_ray_is_predicted_before_the_ray_is_known() {
        let text = "matte: m 1 1 1\nmetal: s 1 1 1 0.4\nmetal: r 1 1 1 2.5\n\
                    sphere: 0 -50 0 50 m\nsphere: 0 0 0 1 m\nsphere: 0 2 0 1 m\n";
        let scene = Scene::parse(text.as_bytes()).expect("the scene is valid");
        let objects = AosObjects::build(&scene).expect("it fits");
        let (dominant, record) = (DominantSphere::of(&objects), objects.sphere(0).record);
        let mut draws = Uniform::new(12);
        let mut counts = [[0; 2]; 3];
        for number in 0..30_000 {
            let mut vector = || Vec3::from([(); 3].map(|()| draws.draw(-1.0, 1.0)));
            // The rays start above the dominant sphere and inside it.
            let origin =
                if number % 2 == 0 { Vec3::new(0.0, 5.0, 0.0) + vector() } else { vector() * 20.0 + record.center };
            let ray = Ray { origin, direction: vector() * 3.0 };
            let scatter_sample = vector().map(|component| (component + 1.0) / 2.0);
            let mut hit = ClosestHit::NOTHING;
            hit.intersect_sphere(&objects, 0, &ray);
            if !hit.is_hit() {
                continue;
            }
            let material = number % 3;
            let material_data = PreparedMaterial::new(&scene.materials[material], Scatter::Statement);
            let surface_hit = SurfaceHit::new(&objects, &ray, &hit);
            let unperturbed = material_data.unperturbed_direction(ray.direction, surface_hit.outward);
            let direction = material_data.scatter_params.scatter_around(unperturbed, scatter_sample);
            let next = Ray { origin: surface_hit.point, direction };
            let is_around_normal = material_data.bsdf_kind == BsdfKind::Matte;
            let terms = ScatterTerms { is_around_normal, vector: material_data.scatter_params.vector(scatter_sample) };
            let predicted = dominant.predicts_entry(&objects, &ray, hit.lambda, &terms);
            // If the ray is nearly parallel to the surface, the prediction may be wrong.
            if next.direction.dot(surface_hit.outward).abs() > 1e-5 {
                assert_eq!(predicted, dominant.is_entered_by(&objects, &next), "{ray:?}, {material_data:?}");
                counts[material][usize::from(predicted)] += 1;
            }
        }
        assert!(counts.as_flattened().iter().all(|&count| count > 1500), "{counts:?}");
    }
}
