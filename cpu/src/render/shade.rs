//! Shades several rays that have hit a surface: computes the vertices at their hits.

use crate::render::{hit_lanes::HitLanes, lane_numbers::ObjectNumber, path_vertex::PathVertex, prepared::Prepared};
use crate::{
    accel::object::ObjectRef, counters::Counter, counters::add, geometry::ray::Ray, layout::Layout, layout::Objects,
    materials::prepared::PreparedMaterial, simd::MOST_LANES, simd::SimdF64,
};

/// Returns the vertex at the hit of each lane, and a bit for each lane, which is 1 if the lane has a hit on a
/// refractive surface. Lanes without a hit have the bit 0, and their vertices have no meaning. The caller sets `sample`
/// and `rays` of the vertices.
#[inline(always)]
pub(crate) fn shade<V: SimdF64, L: Layout>(
    prepared: &Prepared<L>,
    ray: &Ray<V>,
    hits: &HitLanes<V>,
) -> (PathVertex<V>, u32) {
    let objects = &prepared.objects;
    let mut objects_hit = [0.0; MOST_LANES];
    let ObjectNumber(object) = hits.object;
    object.store(&mut objects_hit);
    let point = ray.at(hits.lambda);
    let (mut vertex, mut refractive) = (PathVertex::new(point, point, hits.object, &PreparedMaterial::BLACK), 0);
    add(Counter::Hits, u64::from(hits.bits.count_ones()));
    let mut left = hits.bits;
    while left != 0 {
        // Neighbouring rays mostly hit the same object. So all lanes that hit the object of the first lane are shaded
        // together.
        let number = objects_hit[left.trailing_zeros() as usize % MOST_LANES];
        let same = V::of(number).less_equal(object) & object.less_equal(V::of(number));
        let same_bits = V::bits(same) & left;
        left &= !same_bits;
        let (outward, material) = match ObjectRef::of(objects, ObjectNumber(number).id()) {
            ObjectRef::Sphere(index) => {
                let sphere = objects.sphere(index);
                (sphere.record.lanes::<V>().outward(point), sphere.material)
            }
            ObjectRef::Cylinder(index) => {
                let cylinder = objects.cylinder(index);
                (cylinder.record.lanes::<V>().outward_lanes(hits.part, point), cylinder.material)
            }
        };
        let material = &prepared.materials[material as usize];
        let direction = material.unperturbed_direction(ray.direction, outward);
        refractive |= if material.takes_scatter_sample() { 0 } else { same_bits };
        vertex = PathVertex::new(point, direction, hits.object, material).where_else(same, &vertex);
    }
    (vertex, refractive)
}
