//! A sphere much larger than all else, which nearly every ray would have to ask: it is asked apart.
//!
//! Rays are stopped before it by the test of [`crate::accel::conservative`] alone, which keeps what it cannot judge.
//! Which way a ray is expected to go decides how soon it is answered, and never what.

use crate::accel::bounds::Bounds;
use crate::accel::closest_hit::ClosestHit;
use crate::accel::conservative::ConservativeRay;
use crate::accel::extent::Extent;
use crate::accel::object::{ObjectId, count};
use crate::geometry::ray::Ray;
use crate::layout::Objects;
use crate::materials::prepared::{BsdfKind, PreparedMaterial};
use crate::math::vec3::Vec3;
use crate::simd::Simd;

/// A sphere at least this many times as large as everything else is asked apart.
const RATIO: f64 = 8.0;

/// Most overlapping objects for which it pays to test each of them.
const MOST_SUNK: usize = 4;

/// The sphere that is tested apart, if there is one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DominantSphere(Option<ObjectId>);

impl DominantSphere {
    /// Finds the dominant sphere among `objects`.
    #[must_use]
    pub fn of(objects: &impl Objects) -> Self {
        let radius = |index| objects.sphere(index).record.radius;
        let by_radius = |&left: &usize, &right: &usize| radius(left).total_cmp(&radius(right));
        let Some(largest) = (0..objects.sphere_count()).max_by(by_radius) else {
            return Self(None);
        };
        let others = (0..objects.sphere_count()).filter(|&index| index != largest).map(radius);
        let cylinders = (0..objects.cylinder_count()).map(|index| {
            let record = objects.cylinder(index).record;
            record.radius.hypot(record.half_height)
        });
        let next = others.chain(cylinders).fold(0.0, f64::max);
        Self((radius(largest) >= RATIO * next).then_some(largest as ObjectId))
    }

    /// Its number among the objects.
    #[must_use]
    pub const fn id(self) -> Option<ObjectId> {
        self.0
    }

    /// Whether it is the object `id`.
    #[inline(always)]
    #[must_use]
    pub fn is(self, id: ObjectId) -> bool {
        self.0 == Some(id)
    }

    /// The objects that reach into it, but for what rounding may do to points of its surface: a ray from that surface
    /// that meets it again stays inside in between, for it is convex, and can meet no other. `None` when there are more
    /// than [`MOST_SUNK`], or no ground.
    #[must_use]
    pub fn overlapping(self, objects: &impl Objects, extent: &Extent) -> Option<Vec<ObjectId>> {
        let ground = self.0?;
        let record = objects.sphere(ground as usize).record;
        // A textbook's root moves a point off the surface by some 26 units in the last place of (q + r^2) / r.
        let squares = 12.0 * extent.reach * extent.reach;
        let slack = 1e-9 * extent.reach + 64.0 * f64::EPSILON * squares / record.radius;
        let mut overlapping = Vec::new();
        for id in (0..count(objects) as ObjectId).filter(|&id| !self.is(id)) {
            if Bounds::of_object(objects, id, extent).distance(record.center) <= record.radius + slack {
                if overlapping.len() == MOST_SUNK {
                    return None;
                }
                overlapping.push(id);
            }
        }
        Some(overlapping)
    }

    /// Whether a ray from its surface goes into it; false where there is none.
    #[inline(always)]
    pub fn is_entered_by<O: Objects>(self, objects: &O, ray: &Ray) -> bool {
        self.0.is_some_and(|id| ray.direction.dot(ray.origin - objects.sphere(id as usize).record.center) < 0.0)
    }

    /// Predicts whether the ray that its surface scatters, with this material and a random vector, at `lambda` enters
    /// it: nearly always right, and early. The ray itself is known only when a point, a normal, a mirror image and its
    /// length have been computed one after the other, and nobody can guess which way it goes.
    ///
    /// With `w` from the centre to the point, a mirror image of length one has the product `-d.w / |d|` with `w`, a
    /// normal `|w|` or its opposite; and a product with `w = (O - C) + lambda d` needs only lambda of what the search
    /// has found.
    #[inline(always)]
    pub fn will_be_entered<O: Objects>(
        self,
        objects: &O,
        ray: &Ray,
        lambda: f64,
        material_data: &PreparedMaterial,
        vector: Vec3,
    ) -> bool {
        let Some(id) = self.0 else {
            return false;
        };
        let record = objects.sphere(id as usize).record;
        let (direction, from_center) = (ray.direction, ray.origin - record.center);
        let squared = direction.dot(direction);
        let of_direction = direction.dot(from_center) + lambda * squared;
        let of_vector = vector.dot(from_center) + lambda * vector.dot(direction);
        let of_base = match material_data.kind {
            BsdfKind::Matte => record.radius.copysign(-of_direction),
            // Single precision is enough for a guess, and sooner there.
            _ => -of_direction * f64::from(1.0 / (squared as f32).sqrt()),
        };
        of_base + of_vector < 0.0
    }

    /// Whether the ray may meet it; false where there is none.
    #[inline(always)]
    pub fn may_be_met<O: Objects>(self, objects: &O, touch: &ConservativeRay<f64>) -> bool {
        self.0.is_some_and(|id| touch.sphere_at(objects, id as usize))
    }

    /// Takes it into account, unless the ray certainly does not meet it.
    #[inline(always)]
    pub fn intersect<O: Objects>(self, found: &mut ClosestHit, objects: &O, touch: &ConservativeRay<f64>) {
        if let Some(id) = self.0
            && self.may_be_met(objects, touch)
        {
            found.intersect_sphere(objects, id as usize, &touch.ray);
        }
    }

    /// The same, where the closer look that large spheres often take is no call, if the machine is good at it.
    #[inline(always)]
    pub fn intersect_closely<S: Simd, O: Objects>(
        self,
        found: &mut ClosestHit,
        objects: &O,
        touch: &ConservativeRay<f64>,
    ) {
        if let Some(id) = self.0
            && self.may_be_met(objects, touch)
        {
            found.intersect_dominant_sphere::<S, O>(objects, id as usize, &touch.ray);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    use crate::input::scene::Scene;
    use crate::layout::aos::AosObjects;
    use crate::render::surface::{ScatterResult, Surface};
    use crate::sampling::scatter_vectors::Scatter;
    use crate::sampling::uniform::Uniform;

    fn ground_of(objects: &str) -> Option<ObjectId> {
        let scene = Scene::parse(format!("matte: m 1 1 1\n{objects}").as_bytes()).expect("the scene is valid");
        DominantSphere::of(&AosObjects::build(&scene).expect("it fits")).id()
    }

    #[test]
    fn only_a_sphere_much_larger_than_all_else_is_asked_apart() {
        assert_eq!(ground_of("sphere: 0 0 0 1 m\nsphere: 0 -9 0 8 m\n"), Some(1));
        assert_eq!(ground_of("sphere: 0 0 0 1 m\nsphere: 0 -9 0 7.9 m\n"), None);
        assert_eq!(ground_of("sphere: 0 -9 0 8 m\ncylinder: 0 0 0 .1 0 3 0 m\n"), None, "the cylinder is long");
        assert_eq!(ground_of("cylinder: 0 0 0 .1 0 3 0 m\n"), None, "there is no sphere");
        assert_eq!(ground_of("sphere: 0 0 0 1 m\n"), Some(0), "alone it is larger than all else");
    }

    #[test]
    fn where_a_scattered_ray_goes_is_told_before_it_is_known() {
        let text = "matte: m 1 1 1\nmetal: s 1 1 1 0.4\nmetal: r 1 1 1 2.5\n\
                    sphere: 0 -50 0 50 m\nsphere: 0 0 0 1 m\nsphere: 0 2 0 1 m\n";
        let scene = Scene::parse(text.as_bytes()).expect("the scene is valid");
        let objects = AosObjects::build(&scene).expect("it fits");
        let (ground, record) = (DominantSphere::of(&objects), objects.sphere(0).record);
        let mut draws = Uniform::new(12);
        let mut counts = [[0; 2]; 3];
        for number in 0..30_000 {
            let mut vector = || Vec3::from([(); 3].map(|()| draws.draw(-1.0, 1.0)));
            // From above, and from within.
            let origin =
                if number % 2 == 0 { Vec3::new(0.0, 5.0, 0.0) + vector() } else { vector() * 20.0 + record.center };
            let ray = Ray { origin, direction: vector() * 3.0 };
            let triple = vector().map(|component| (component + 1.0) / 2.0);
            let mut found = ClosestHit::NOTHING;
            found.intersect_sphere(&objects, 0, &ray);
            if !found.is_hit() {
                continue;
            }
            let material = number % 3;
            let material_data = PreparedMaterial::new(&scene.materials[material], Scatter::Statement);
            let surface = Surface::new(&objects, &ray, &found);
            let ScatterResult::Around(base) = surface.scatter_result(&material_data, ray.direction) else {
                unreachable!()
            };
            let next = Ray { origin: surface.point, direction: material_data.spread.around(base, triple) };
            let told = ground.will_be_entered(
                &objects,
                &ray,
                found.lambda,
                &material_data,
                material_data.spread.vector(triple),
            );
            // Along the surface it may be told wrong.
            if next.direction.dot(surface.outward).abs() > 1e-5 {
                assert_eq!(told, ground.is_entered_by(&objects, &next), "{ray:?}, {material_data:?}");
                counts[material][usize::from(told)] += 1;
            }
        }
        assert!(counts.as_flattened().iter().all(|&count| count > 1500), "{counts:?}");
    }
}
