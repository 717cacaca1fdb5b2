//! Frustum culling: finds the objects that the rays of a row may hit, and then those that the rays of a span may hit.
//!
//! The rays of a row lie between two planes through the camera, above and below the row. The rays of a span also lie
//! between two planes to its left and right. An object that lies outside of one of these planes is culled.
//!
//! An object is culled only if a comparison is true. A comparison with NaN is false, so NaN never culls. No value
//! overflows, because objects are culled only in [moderate](crate::accel::extent::Extent::moderate) scenes
//! ([`Candidates::are_culled`]).

use crate::render::{prepared::Prepared, span::Span};
use crate::{
    accel::bounds::Bounds, accel::object, accel::object::ObjectId, accel::object::ObjectRef, counters::Counter,
    counters::add, geometry::camera::HALF_PIXEL, geometry::cylinder::CylinderRecord, geometry::cylinder::CylinderView,
    geometry::sphere::SphereRecord, geometry::sphere::SphereView, input::error::Error, layout::Layout, layout::OBJECTS,
    layout::Objects, layout::with_room, math::vec3::Vec3,
};

/// An object that a span's rays may hit, with the terms of its formula that are constant for all camera rays.
#[derive(Clone, Copy, Debug)]
pub enum Candidate {
    /// A sphere.
    Sphere(SphereRecord, SphereView),
    /// A cylinder: its record, the axis of the scene file, and its view.
    Cylinder(CylinderRecord, Vec3, CylinderView),
}

/// Margin of the culling tests, relative to distance and size of the object. It is about a million times the rounding
/// errors of these tests, of the rays and of the hits.
const MARGIN: f64 = 1e-9;

/// Additional margin relative to a cylinder's radius. It covers the rounding errors of the side for rays along the
/// axis.
const MARGIN_OF_CYLINDERS: f64 = 1e-7;

/// A half-space, as the normal of its plane, which goes through the camera. It contains the points `v`, relative to the
/// camera, with `normal.v >= 0`. The normal has length one.
type HalfSpace = Vec3;

/// An object in the form of the culling tests, with coordinates relative to the camera. A sphere is a cylinder without
/// axis and height.
#[derive(Clone, Copy, Debug)]
struct Outline {
    id: ObjectId,
    center: Vec3,
    /// The direction of a cylinder's axis, of length one. It is null for a sphere.
    axis: Vec3,
    half_height: f64,
    radius: f64,
    /// The margin that covers rounding, in scene units.
    margin: f64,
}

impl Outline {
    fn new<L: Layout>(prepared: &Prepared<L>, id: ObjectId) -> Self {
        let (objects, from) = (&prepared.objects, prepared.camera.position);
        let (center, axis, half_height, radius, margin) = match ObjectRef::of(objects, id) {
            ObjectRef::Sphere(index) => {
                let SphereRecord { center, radius, .. } = objects.sphere(index).record;
                (center, Vec3::ZERO, 0.0, radius, 0.0)
            }
            ObjectRef::Cylinder(index) => {
                let CylinderRecord { center, axis, half_height, radius, .. } = objects.cylinder(index).record;
                (center, axis, half_height, radius, MARGIN_OF_CYLINDERS * radius)
            }
        };
        let center = center - from;
        let margin = MARGIN * (center.length() + from.length() + radius + half_height) + margin;
        Self { id, center, axis, half_height, radius, margin }
    }

    /// Returns false only if the object certainly lies outside of one of the half-spaces. A plane with a NaN culls
    /// nothing.
    fn may_overlap(&self, planes: &[HalfSpace; 2]) -> bool {
        let outside = |normal: &HalfSpace| {
            let beyond = |extent: f64| normal.dot(self.center) < -extent - self.margin;
            // The bounding sphere decides for most cylinders, and for all spheres.
            beyond(self.radius + self.half_height)
                || self.half_height > 0.0 && {
                    let along = normal.dot(self.axis);
                    let across = (1.0 - along * along).max(0.0).sqrt();
                    beyond(self.half_height * along.abs() + self.radius * across)
                }
        };
        !planes.iter().any(outside)
    }
}

/// The candidates: the objects that the camera rays of the present row and of the present span may hit.
#[derive(Debug)]
pub struct Candidates {
    /// All objects, in the order of the scene file.
    all: Vec<ObjectId>,
    /// The objects whose boxes may overlap the frustum of the row, each with its place in the scene file. Only used
    /// with a BVH.
    boxed: Vec<(u32, ObjectId)>,
    row: Vec<Outline>,
    /// The span's candidates with their numbers, in the order of the scene file.
    pub span: Vec<(ObjectId, Candidate)>,
    /// Whether objects are culled. They are not if the scene's magnitudes are not
    /// [moderate](crate::accel::extent::Extent::moderate), because then no margin or bound is valid.
    pub are_culled: bool,
}

impl Candidates {
    /// Returns empty lists with room for all objects.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`] if memory is short.
    pub fn new<L: Layout>(prepared: &Prepared<L>) -> Result<Self, Error> {
        let all = object::in_order(&prepared.objects)?;
        let boxed = with_room(all.len(), OBJECTS)?;
        let (row, span) = (with_room(all.len(), OBJECTS)?, with_room(all.len(), OBJECTS)?);
        Ok(Self { all, boxed, row, span, are_culled: prepared.moderate })
    }

    /// Finds the objects that the camera rays of `row` may hit.
    pub fn begin_row<L: Layout>(&mut self, prepared: &Prepared<L>, row: usize) {
        let camera = &prepared.camera;
        let at = |row: f64| camera.origin - camera.position + camera.delta_y * row;
        let inside = at(row as f64);
        let planes = [-HALF_PIXEL, HALF_PIXEL].map(|side| half_space(camera.delta_x, at(row as f64 + side), inside));
        self.row.clear();
        if prepared.accel.has_boxes() {
            let may_overlap = |bounds: &Bounds| box_may_overlap(bounds, camera.position, &planes);
            self.boxed.clear();
            let accel = &prepared.accel;
            accel.visit_boxes(may_overlap, |id| self.boxed.push((object::order_of(&prepared.objects, id), id)));
            self.boxed.sort_unstable();
            self.row.extend(self.boxed.iter().map(|&(_, id)| Outline::new(prepared, id)));
        } else {
            let all = self.all.iter().map(|&id| Outline::new(prepared, id));
            self.row.extend(all.filter(|outline| !self.are_culled || outline.may_overlap(&planes)));
        }
    }

    /// Finds those objects of the row that the camera rays of `span` may hit.
    pub fn begin_span<L: Layout>(&mut self, prepared: &Prepared<L>, row: usize, span: &Span) {
        let (camera, objects) = (&prepared.camera, &prepared.objects);
        let center = camera.origin - camera.position + camera.delta_y * row as f64;
        let at = |column: f64| center + camera.delta_x * column;
        let (first, last) = (span.first as f64, span.last as f64);
        let inside = at((first + last) / 2.0);
        let planes = [first - HALF_PIXEL, last + HALF_PIXEL].map(|side| half_space(camera.delta_y, at(side), inside));
        self.span.clear();
        for outline in self.row.iter().filter(|outline| !self.are_culled || outline.may_overlap(&planes)) {
            let candidate = match ObjectRef::of(objects, outline.id) {
                ObjectRef::Sphere(index) => {
                    let record = objects.sphere(index).record;
                    Candidate::Sphere(record, record.seen_from(camera.position))
                }
                ObjectRef::Cylinder(index) => {
                    let record = objects.cylinder(index).record;
                    Candidate::Cylinder(record, objects.axis(index), record.seen_from(camera.position))
                }
            };
            self.span.push((outline.id, candidate));
        }
        add(Counter::SpanObjects, self.all.len() as u64);
        add(Counter::SpanCandidates, self.span.len() as u64);
    }
}

/// Returns the half-space that contains `inside` and whose plane goes through the camera along `first` and `second`.
fn half_space(first: Vec3, second: Vec3, inside: Vec3) -> HalfSpace {
    let normal = first.cross(second).unit();
    if normal.dot(inside) < 0.0 { -normal } else { normal }
}

/// Returns false only if the box certainly lies outside of one of the half-spaces. `from` is the camera's position.
fn box_may_overlap(bounds: &Bounds, from: Vec3, planes: &[HalfSpace; 2]) -> bool {
    planes.iter().all(|normal| {
        // `farthest` is the corner that is farthest along the normal.
        let corner = |axis: usize, component: f64| {
            f64::from(if component >= 0.0 { bounds.high[axis] } else { bounds.low[axis] })
        };
        let farthest = Vec3::new(corner(0, normal.x), corner(1, normal.y), corner(2, normal.z)) - from;
        let outside = normal.dot(farthest) < -MARGIN * (farthest.length() + from.length());
        !outside
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const LEFT: Vec3 = Vec3::new(1.0, 0.0, 0.0);
    const RIGHT: Vec3 = Vec3::new(-1.0, 0.0, 0.0);

    #[test]
    fn an_object_is_culled_only_beyond_a_plane_and_never_by_a_nan() {
        let center = Vec3::new(3.0, 0.0, 0.0);
        let ball = Outline { id: 0, center, axis: Vec3::ZERO, half_height: 0.0, radius: 1.0, margin: 0.0 };
        assert!(ball.may_overlap(&[LEFT, LEFT]));
        assert!(!ball.may_overlap(&[LEFT, RIGHT]) && !ball.may_overlap(&[RIGHT, LEFT]));
        let tangent = Outline { radius: 3.0, ..ball };
        assert!(tangent.may_overlap(&[RIGHT, RIGHT]));
        let nan = Vec3::new(f64::NAN, 0.0, 0.0);
        assert!(ball.may_overlap(&[nan, nan]) && !ball.may_overlap(&[nan, RIGHT]));
    }

    #[test]
    fn a_cylinder_reaches_by_its_height_along_the_axis_and_by_its_radius_across() {
        let cylinder = |axis, half_height, radius| {
            let center = Vec3::new(3.0, 0.0, 0.0);
            Outline { id: 0, center, axis, half_height, radius, margin: 0.0 }.may_overlap(&[RIGHT, RIGHT])
        };
        let (along, across) = (Vec3::new(1.0, 0.0, 0.0), Vec3::new(0.0, 1.0, 0.0));
        assert!(cylinder(along, 3.0, 0.1) && !cylinder(along, 2.9, 9.0));
        assert!(cylinder(across, 0.1, 3.0) && !cylinder(across, 9.0, 2.9));
    }
}
