//! What a surface does to rays that have just met it, several at once.

use crate::accel::object::{ObjectId, ObjectRef};
use crate::counters::{Counter, add};
use crate::geometry::cylinder::CylinderPart;
use crate::geometry::ray::Ray;
use crate::layout::{Layout, Objects};
use crate::materials::prepared::{BsdfKind, PreparedMaterial};
use crate::materials::scatter;
use crate::math::vec3::Vec3;
use crate::render::hit_lanes::HitLanes;
use crate::render::lane_by_lane::MOST_LANES;
use crate::render::path_vertex::PathVertex;
use crate::render::prepared::Prepared;
use crate::simd::{LaneMask, SimdF64};

/// Lanes on the surfaces that they have met; of no meaning in the others.
pub struct Shaded<V> {
    pub vertex: PathVertex<V>,
    /// Lanes whose surface is refractive, as bits.
    pub refractive: u32,
}

/// Shades the lanes that meet something.
#[inline(always)]
pub fn shade<V: SimdF64, L: Layout>(prepared: &Prepared<L>, ray: &Ray<V>, hits: &HitLanes<V>) -> Shaded<V> {
    let objects = &prepared.objects;
    let mut numbers = [0.0; MOST_LANES];
    hits.object.store(&mut numbers);
    let point = ray.at(hits.lambda);
    let mut shaded =
        Shaded { vertex: PathVertex::new(point, point, hits.object, &PreparedMaterial::BLACK), refractive: 0 };
    add(Counter::Hits, u64::from(hits.bits.count_ones()));
    let mut left = hits.bits;
    while left != 0 {
        // Neighbours mostly meet the same object: all lanes that meet this one are done together.
        let number = numbers[left.trailing_zeros() as usize % MOST_LANES];
        let object = number as ObjectId;
        let same = V::of(number).less_equal(hits.object) & hits.object.less_equal(V::of(number));
        let same_bits = same.bits() & left;
        left &= !same_bits;
        let (outward, material) = match ObjectRef::of(objects, object) {
            ObjectRef::Sphere(index) => {
                let sphere = objects.sphere(index);
                (sphere.record.lanes::<V>().outward(point), sphere.material)
            }
            ObjectRef::Cylinder(index) => {
                let cylinder = objects.cylinder(index);
                let record = cylinder.record.lanes::<V>();
                let side = record.outward(CylinderPart::Side, point);
                let is_side = hits.part.less(V::of(0.5));
                let is_top = hits.part.less(V::of(1.5));
                let base = Vec3::select(
                    is_top,
                    record.outward(CylinderPart::Top, side),
                    record.outward(CylinderPart::Bottom, side),
                );
                (Vec3::select(is_side, side, base), cylinder.material)
            }
        };
        let front = ray.direction.dot(outward).less(V::of(0.0));
        let normal = Vec3::select(front, outward, -outward);
        let material_data = &prepared.materials[material as usize];
        let base = match material_data.kind {
            BsdfKind::Matte => normal,
            BsdfKind::Metal => scatter::mirror(ray.direction, normal),
            BsdfKind::Refractive => {
                shaded.refractive |= same_bits;
                let ratio = V::select(front, V::of(material_data.inverse_index), V::of(material_data.index));
                scatter::refract(ray.direction, normal, ratio)
            }
        };
        shaded.vertex = PathVertex::new(point, base, hits.object, material_data).where_else(same, &shaded.vertex);
    }
    shaded
}
