//! The objects that the rays of a row, and of a span of it, may meet: those that reach into the wedge between the
//! planes through the camera at both ends.
//!
//! An object is left out only where a comparison holds, which none does with what is not a number. Nothing overflows:
//! scenes whose coordinates, window or pixels are beyond 10^9 or below 10^-12 are not culled
//! ([`Candidates::are_culled`]).

use crate::accel::bounds::Bounds;
use crate::accel::choice::Accel;
use crate::accel::object;
use crate::accel::object::{ObjectId, ObjectRef};
use crate::counters::{Counter, add};
use crate::geometry::cylinder::{CylinderRecord, CylinderView};
use crate::geometry::sphere::{SphereRecord, SphereView};
use crate::input::error::Error;
use crate::layout::{Layout, Objects};
use crate::math::vec3::Vec3;
use crate::render::prepared::Prepared;

use crate::render::span::Span;

/// An object that a span's rays may meet, as the camera sees it.
#[derive(Clone, Copy, Debug)]
pub enum Candidate {
    /// A sphere.
    Sphere(SphereRecord, SphereView),
    /// A cylinder, with the file's axis.
    Cylinder(CylinderRecord, Vec3, CylinderView),
}

/// Relative to distance and size: covers the rounding here, of the rays and of the exact formulas many times over.
const MARGIN: f64 = 1e-9;

/// Relative to the radius: what a cylinder's side may be off by for rays along the axis.
const MARGIN_OF_CYLINDERS: f64 = 1e-7;

/// The half-space of the points `v`, relative to the camera, with `normal.v >= 0`; the normal has length one.
type HalfSpace = Vec3;

/// A ball around an object, as the camera sees it; for a sphere itself.
#[derive(Clone, Copy, Debug)]
struct Ball {
    id: ObjectId,
    /// From the camera to its centre.
    middle: Vec3,
    /// With the margin that covers rounding.
    radius: f64,
}

impl Ball {
    fn new<L: Layout>(prepared: &Prepared<L>, id: ObjectId) -> Self {
        let (objects, from) = (&prepared.objects, prepared.camera.position);
        let (center, radius, margin) = match ObjectRef::of(objects, id) {
            ObjectRef::Sphere(index) => {
                let record = objects.sphere(index).record;
                (record.center, record.radius, 0.0)
            }
            ObjectRef::Cylinder(index) => {
                let record = objects.cylinder(index).record;
                (record.center, record.radius + record.half_height, MARGIN_OF_CYLINDERS * record.radius)
            }
        };
        let middle = center - from;
        Self { id, middle, radius: radius + MARGIN * (middle.length() + from.length() + radius) + margin }
    }

    /// Whether it reaches into all half-spaces; true when in doubt, and where a wall is not made of numbers.
    fn reaches(&self, walls: &[HalfSpace; 2]) -> bool {
        let [left, right] = walls.map(|wall| wall.dot(self.middle) < -self.radius);
        !(left | right)
    }
}

/// The candidates of a row and of a span.
#[derive(Debug)]
pub struct Candidates {
    /// All objects, in the order of the file.
    all: Vec<ObjectId>,
    row: Vec<Ball>,
    /// The span's candidates, in the order of the file.
    pub span: Vec<(ObjectId, Candidate)>,
    /// Whether the scene's magnitudes bear a cull at all.
    culls: bool,
}

impl Candidates {
    /// No candidates yet, but room for all objects to be some.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    pub fn new<L: Layout>(prepared: &Prepared<L>) -> Result<Self, Error> {
        let all = object::in_order(&prepared.objects)?;
        let (row, span) = (object::room(all.len())?, object::room(all.len())?);
        Ok(Self { all, row, span, culls: !matches!(prepared.search, Accel::EveryObject) })
    }

    /// Whether the scene's magnitudes are moderate, so that bounds of what rays may meet and see can be trusted.
    pub const fn are_culled(&self) -> bool {
        self.culls
    }

    /// Finds the objects that the rays of `row` may meet.
    pub fn begin_row<L: Layout>(&mut self, prepared: &Prepared<L>, row: usize) {
        let camera = &prepared.camera;
        let at = |row: f64| camera.origin - camera.position + camera.delta_y * row;
        let inside = at(row as f64);
        let walls = [-0.5, 0.5].map(|side| wall(camera.delta_x, at(row as f64 + side), inside));
        self.row.clear();
        match &prepared.search {
            Accel::Bvh(tree) => {
                let reaches = |bounds: &Bounds| box_reaches(bounds, camera.position, &walls);
                tree.visit(reaches, |id| self.row.push(Ball::new(prepared, id)));
                self.row.sort_unstable_by_key(|ball| object::order_of(&prepared.objects, ball.id));
            }
            _ => {
                let meets = |ball: &Ball| !self.culls || reaches(prepared, ball, &walls);
                self.row.extend(self.all.iter().map(|&id| Ball::new(prepared, id)).filter(meets));
            }
        }
    }

    /// Finds those among the row's objects that the rays of `span` may meet.
    pub fn narrow<L: Layout>(&mut self, prepared: &Prepared<L>, row: usize, span: &Span) {
        let camera = &prepared.camera;
        let center = camera.origin - camera.position + camera.delta_y * row as f64;
        let at = |column: f64| center + camera.delta_x * column;
        let inside = at((span.first + span.last) as f64 / 2.0);
        let walls =
            [span.first as f64 - 0.5, span.last as f64 + 0.5].map(|side| wall(camera.delta_y, at(side), inside));
        self.span.clear();
        let meets = |ball: &&Ball| !self.culls || reaches(prepared, ball, &walls);
        for &Ball { id, .. } in self.row.iter().filter(meets) {
            let objects = &prepared.objects;
            let candidate = match ObjectRef::of(objects, id) {
                ObjectRef::Sphere(index) => {
                    let record = objects.sphere(index).record;
                    Candidate::Sphere(record, record.seen_from(camera.position))
                }
                ObjectRef::Cylinder(index) => {
                    let record = objects.cylinder(index).record;
                    Candidate::Cylinder(record, objects.axis(index), record.seen_from(camera.position))
                }
            };
            self.span.push((id, candidate));
        }
        add(Counter::SpanObjects, self.all.len() as u64);
        add(Counter::SpanCandidates, self.span.len() as u64);
    }
}

/// The half-space bounded by the plane through the camera along `first` and `second` that holds `inside`.
fn wall(first: Vec3, second: Vec3, inside: Vec3) -> HalfSpace {
    let normal = first.cross(second).unit();
    if normal.dot(inside) < 0.0 { -normal } else { normal }
}

/// Whether a box reaches into all half-spaces; true when in doubt.
fn box_reaches(bounds: &Bounds, from: Vec3, walls: &[HalfSpace; 2]) -> bool {
    walls.iter().all(|wall| {
        // The corner farthest along the wall's normal.
        let corner = |axis: usize, component: f64| {
            f64::from(if component >= 0.0 { bounds.high[axis] } else { bounds.low[axis] })
        };
        let farthest = Vec3::new(corner(0, wall.x), corner(1, wall.y), corner(2, wall.z)) - from;
        let outside = wall.dot(farthest) < -1e-9 * (farthest.length() + from.length());
        !outside
    })
}

/// Whether an object reaches into all half-spaces; true when in doubt. Its ball spares most cylinders the closer look.
fn reaches<L: Layout>(prepared: &Prepared<L>, ball: &Ball, walls: &[HalfSpace; 2]) -> bool {
    let objects = &prepared.objects;
    if !ball.reaches(walls) {
        return false;
    }
    let ObjectRef::Cylinder(index) = ObjectRef::of(objects, ball.id) else {
        return true;
    };
    let record = objects.cylinder(index).record;
    let scale = ball.middle.length() + prepared.camera.position.length() + record.radius + record.half_height;
    let margin = MARGIN * scale + MARGIN_OF_CYLINDERS * record.radius;
    let outside = |wall: &HalfSpace| {
        let along = wall.dot(record.axis);
        let across = (1.0 - along * along).max(0.0).sqrt();
        let reach = record.half_height * along.abs() + record.radius * across;
        wall.dot(ball.middle) < -reach - margin
    };
    !walls.iter().any(outside)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ball_is_left_out_beyond_a_wall_only_and_never_by_what_is_not_a_number() {
        let ball = Ball { id: 0, middle: Vec3::new(3.0, 0.0, 0.0), radius: 1.0 };
        let (left, right) = (Vec3::new(1.0, 0.0, 0.0), Vec3::new(-1.0, 0.0, 0.0));
        assert!(ball.reaches(&[left, left]) && !ball.reaches(&[left, right]) && !ball.reaches(&[right, left]));
        let touching = Ball { radius: 3.0, ..ball };
        assert!(touching.reaches(&[right, right]));
        let none = Vec3::new(f64::NAN, 0.0, 0.0);
        assert!(ball.reaches(&[none, none]) && !ball.reaches(&[none, right]));
    }
}
