//! Frustum culling: finds the objects that the rays of a row may hit, and then those that the rays of a span may hit.
//!
//! The rays of a row lie between two planes through the camera, above and below the row. The rays of a span also lie
//! between two planes to its left and right. An object that lies outside of one of these planes is culled.
//!
//! An object is culled only if a comparison is true. A comparison with NaN is false, so NaN never culls. Objects are
//! culled only in [moderate](crate::accel::extent::Extent::moderate) scenes: others have no boxes, and
//! [`Candidates::are_culled`] is not set. There only the distance of a giant can overflow. Its margin is then infinite,
//! so it is not culled.
//!
//! The margin of the comparisons is [`TURNS`] times [`RayError::turn`], relative to a bound of the distance from the
//! camera to the farthest point of the object or box. It covers the turn itself, by which a hit point may lie beyond
//! the plane, the error of the plane's normal, and the rounding of both sides of the comparison
//! (`tests/stability/src/proof/frustum.rs`).
//!
//! [`RayError::turn`]: crate::render::ray_error::RayError::turn

use crate::render::{hit_lanes::limited, prepared::Prepared, span::Span};

use crate::{
    accel::bounds::Bounds, accel::bounds::half_width_of_cylinder, accel::object::ObjectId, accel::object::ObjectRef,
    accel::object::count, counters::Counter, counters::add, geometry::camera::Camera, geometry::camera::HALF_PIXEL,
    geometry::cylinder::CylinderRecord, geometry::cylinder::CylinderView, geometry::sphere::SphereRecord,
    geometry::sphere::SphereView, input::error::Error, layout::Layout, layout::OBJECTS, layout::Objects,
    layout::with_room, math::real::Real, math::vec3::Vec3,
};

/// An object that a span's rays may hit, with the terms of its formula that are constant for all camera rays.
#[derive(Clone, Copy, Debug)]
pub enum Candidate {
    /// A sphere.
    Sphere(SphereRecord, SphereView),
    /// A cylinder: its record, the axis of the scene file, and its view.
    Cylinder(CylinderRecord, Vec3, CylinderView),
}

/// The margin of the culling tests, in units of the turn of a camera ray (docs/margins.md).
pub const TURNS: f64 = 8.0;

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
    /// Returns the outline of an object as the camera sees it.
    fn new<L: Layout>(prepared: &Prepared<L>, id: ObjectId) -> Self {
        let objects = &prepared.objects;
        let (center, axis, half_height, radius) = match ObjectRef::of(objects, id) {
            ObjectRef::Sphere(index) => {
                let SphereRecord { center, radius, .. } = objects.sphere(index).record;
                (center, Vec3::ZERO, 0.0, radius)
            }
            ObjectRef::Cylinder(index) => {
                let CylinderRecord { center, axis, half_height, radius, .. } = objects.cylinder(index).record;
                (center, axis, half_height, radius)
            }
        };
        let center = center - prepared.camera.position;
        let margin = margin_of_object(prepared.ray_error.turn, center.length(), radius, half_height);
        Self { id, center, axis, half_height, radius, margin }
    }

    /// Returns false only if the object certainly lies outside of one of the half-spaces. A plane with a NaN culls
    /// nothing.
    fn may_overlap(&self, planes: &[HalfSpace; 2]) -> bool {
        let outside = |normal: &HalfSpace| {
            let beyond = |half_width: f64| is_beyond(*normal, self.center, half_width, self.margin);
            // A sphere around the centre decides for most cylinders, and for all spheres.
            beyond(self.radius + self.half_height)
                || self.half_height > 0.0
                    && beyond(half_width_of_cylinder(normal.dot(self.axis), self.half_height, self.radius))
        };
        !planes.iter().any(outside)
    }
}

/// The candidates: the objects that the camera rays of the present row and of the present span may hit.
#[derive(Debug)]
pub struct Candidates {
    row: Vec<Outline>,
    /// The span's candidates with their numbers.
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
    pub(crate) fn new<L: Layout>(prepared: &Prepared<L>) -> Result<Self, Error> {
        let count = count(&prepared.objects);
        Ok(Self { row: with_room(count, OBJECTS)?, span: with_room(count, OBJECTS)?, are_culled: prepared.moderate })
    }

    /// Finds the objects that the camera rays of `row` may hit.
    pub fn begin_row<L: Layout>(&mut self, prepared: &Prepared<L>, row: usize) {
        let camera = &prepared.camera;
        let at = |row: f64| to_window(camera, row);
        let row = row as f64;
        let above = half_space(at(row - HALF_PIXEL), camera.delta_x);
        let below = half_space(camera.delta_x, at(row + HALF_PIXEL));
        let (planes, margin) = ([above, below], TURNS * prepared.ray_error.turn);
        self.row.clear();
        let may_overlap = |bounds: &Bounds| box_may_overlap(bounds, camera.position, &planes, margin);
        if !prepared.accel.visit_boxes(may_overlap, |id| self.row.push(Outline::new(prepared, id))) {
            let all = (0..count(&prepared.objects) as ObjectId).map(|id| Outline::new(prepared, id));
            self.row.extend(all.filter(|outline| !self.are_culled || outline.may_overlap(&planes)));
        }
    }

    /// Finds those objects of the row that the camera rays of `span` may hit.
    pub fn begin_span<L: Layout>(&mut self, prepared: &Prepared<L>, row: usize, span: &Span) {
        let (camera, objects) = (&prepared.camera, &prepared.objects);
        let center = to_window(camera, row as f64);
        let at = |column: f64| center + camera.delta_x * column;
        let left = half_space(camera.delta_y, at(span.first as f64 - HALF_PIXEL));
        let right = half_space(at(span.last as f64 + HALF_PIXEL), camera.delta_y);
        let planes = [left, right];
        self.span.clear();
        for outline in self.row.iter().filter(|outline| !self.are_culled || outline.may_overlap(&planes)) {
            let candidate = match ObjectRef::of(objects, outline.id) {
                ObjectRef::Sphere(index) => {
                    let record = objects.sphere(index).record;
                    let view = record.seen_from(camera.position);
                    Candidate::Sphere(record, SphereView { squares: limited(view.squares), ..view })
                }
                ObjectRef::Cylinder(index) => {
                    let record = objects.cylinder(index).record;
                    let view = record.seen_from(camera.position);
                    let view = CylinderView { squares: limited(view.squares), ..view };
                    Candidate::Cylinder(record, objects.file_axis(index), view)
                }
            };
            self.span.push((outline.id, candidate));
        }
        add(Counter::SpanObjects, count(objects) as u64);
        add(Counter::SpanCandidates, self.span.len() as u64);
    }
}

/// Returns the half-space whose plane goes through the camera along `first` and `second`, and whose normal is along
/// `first x second`.
///
/// The side follows from the order of the two vectors. Seen from the camera, `delta_y` is a quarter of a turn clockwise
/// from `delta_x`. So for a point `at` of the window, `delta_y x at` points to the right, and `delta_x x at` points up.
pub fn half_space<T: Real>(first: Vec3<T>, second: Vec3<T>) -> Vec3<T> {
    first.cross(second).unit()
}

/// Returns the vector from the camera to the middle of the window's first pixel in a row.
pub fn to_window<T: Real>(camera: &Camera<T>, row: T) -> Vec3<T> {
    camera.origin - camera.position + camera.delta_y * row
}

/// Whether an object certainly lies outside of a half-space. `center` is relative to the camera, and `half_width` is
/// how far the object reaches from there along the normal.
#[inline(always)]
pub fn is_beyond<T: Real>(normal: Vec3<T>, center: Vec3<T>, half_width: T, margin: T) -> T::Mask {
    normal.dot(center).less(-half_width - margin)
}

/// Returns the margin of an object at this distance from the camera, for a turn of its rays.
#[inline(always)]
pub fn margin_of_object<T: Real>(turn: T, distance: T, radius: T, half_height: T) -> T {
    T::of(TURNS) * turn * (distance + radius + half_height)
}

/// Returns the margin of a box whose points have coordinates of at most these magnitudes, relative to the camera.
/// `margin` is that for the length 1.
#[inline(always)]
pub fn margin_of_box<T: Real>(margin: T, largest: Vec3<T>) -> T {
    margin * (largest.x + largest.y + largest.z)
}

/// Returns false only if the box certainly lies outside of one of the half-spaces. `from` is the camera's position, and
/// `margin` is relative to the distance of the box's farthest corner.
fn box_may_overlap(bounds: &Bounds, from: Vec3, planes: &[HalfSpace; 2], margin: f64) -> bool {
    let (low, high) = (Vec3::from(bounds.low.map(f64::from)) - from, Vec3::from(bounds.high.map(f64::from)) - from);
    let larger = |low: f64, high: f64| low.abs().max(high.abs());
    let largest = Vec3::new(larger(low.x, high.x), larger(low.y, high.y), larger(low.z, high.z));
    let margin = margin_of_box(margin, largest);
    planes.iter().all(|normal| {
        // The corner that is farthest along the normal.
        let corner = |component: f64, low: f64, high: f64| if component >= 0.0 { high } else { low };
        let farthest = Vec3::new(
            corner(normal.x, low.x, high.x),
            corner(normal.y, low.y, high.y),
            corner(normal.z, low.z, high.z),
        );
        !is_beyond(*normal, farthest, 0.0, margin)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::camera::Camera;
    use crate::input::{config::Config, scene::Scene};
    use crate::layout::aos::Aos;
    use crate::render::{ray_error::RayError, span::spans_of_row};
    use crate::sampling::scatter_vectors::Scatter;

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
    fn a_box_is_culled_by_the_margin_of_its_farthest_corner() {
        assert_eq!(margin_of_box(2.0, Vec3::new(1.0, 2.0, 3.0)), 12.0);
        // The box lies 1/2 beyond the plane, and reaches to a distance of about 10^6.
        let bounds = Bounds { low: [0.5, -1e6, 0.0], high: [1.0, 0.5, 0.0] };
        let may_overlap = |margin| box_may_overlap(&bounds, Vec3::ZERO, &[RIGHT, RIGHT], margin);
        assert!(!may_overlap(0.0) && !may_overlap(4e-7) && may_overlap(6e-7));
        assert!(may_overlap(f64::INFINITY) && may_overlap(f64::NAN));
        assert!(box_may_overlap(&bounds, Vec3::ZERO, &[LEFT, LEFT], 0.0));
    }

    #[test]
    fn rounded_rays_along_the_edge_of_a_row_reach_objects_within_the_margin() {
        // The directions are rounded to multiples of 1.5e-8.
        let text = "image_width: 12\ncamera_position: 1e8 1e8 1e8\ncamera_target: 1e8 1e8 100000000.01\n";
        let config = Config::parse(text.as_bytes()).expect("the configuration is valid");
        let size = config.image_size().expect("it has a size");
        let camera = Camera::new(&config, size).expect("there is a window");
        let (turn, mut beyond) = (RayError::new(&camera, size).turn, 0);
        for place in 0..72 {
            let (row, column) = (f64::from(place / 12), f64::from(place % 12));
            let at = |row: f64| camera.origin - camera.position + camera.delta_y * row;
            let planes =
                [half_space(at(row - HALF_PIXEL), camera.delta_x), half_space(camera.delta_x, at(row + HALF_PIXEL))];
            for y in [-HALF_PIXEL, HALF_PIXEL] {
                let center = camera.ray(row, column, [0.3, y]).direction;
                let point = Outline { id: 0, center, axis: Vec3::ZERO, half_height: 0.0, radius: 0.0, margin: 0.0 };
                beyond += u32::from(!point.may_overlap(&planes));
                assert!(Outline { margin: TURNS * turn * center.length(), ..point }.may_overlap(&planes));
            }
        }
        assert!(beyond > 30, "{beyond} points beyond the planes");
    }

    #[test]
    fn the_squares_of_far_candidates_are_infinite() {
        let scene = b"matte: m 1 1 1\nsphere: 0 0 1e110 9e109 m\ncylinder: 0 0 1e110 9e109 0 9e109 0 m\n";
        let scene = Scene::parse(&scene[..]).expect("it is valid");
        let prepared =
            Prepared::<Aos>::new(&Config::default(), &scene, Scatter::Statement).expect("it can be rendered");
        let mut candidates = Candidates::new(&prepared).expect("it fits");
        let row = prepared.size.height() / 2;
        candidates.begin_row(&prepared, row);
        let span = spans_of_row(prepared.size.width(), prepared.samples, 1024).next().expect("a row has a span");
        candidates.begin_span(&prepared, row, &span);
        let squares = candidates.span.iter().map(|(_, candidate)| match candidate {
            Candidate::Sphere(_, view) => view.squares,
            Candidate::Cylinder(.., view) => view.squares,
        });
        assert_eq!(squares.collect::<Vec<_>>(), [f64::INFINITY; 2]);
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

    #[test]
    fn planes_and_half_widths_are_those_of_geometry() {
        let config = Config { image_width: 4, aspect_ratio: [2, 1], ..Config::default() };
        let camera = Camera::new(&config, config.image_size().expect("it has a size")).expect("there is a window");
        // The window is in the plane z = 0, and the camera at z = -10.
        assert!((to_window(&camera, 1.0) - Vec3::new(15.0, -5.0, 10.0)).length() < 1e-12);
        assert!(is_beyond(LEFT, Vec3::new(-3.0, 9.0, 9.0), 2.0, 0.5));
        assert!(!is_beyond(LEFT, Vec3::new(-3.0, 9.0, 9.0), 2.5, 0.5), "the margin reaches the plane");
        let half_width = half_width_of_cylinder(LEFT.dot(Vec3::new(0.6, 0.8, 0.0)), 2.0, 1.0);
        assert!((2.0..2.000_001).contains(&half_width), "0.6 of 2, and 0.8 of 1: {half_width}");
    }

    #[test]
    fn rows_and_spans_have_the_objects_in_front_of_them() {
        // The window is 40 wide and 20 high, for 4 columns and 2 rows. The first column is at x = 15.
        let config = Config { image_width: 4, aspect_ratio: [2, 1], ..Config::default() };
        let scene = "matte: m 1 1 1\nsphere: 15 5 0 1 m\nsphere: -15 5 0 1 m\nsphere: 15 -5 0 1 m\n";
        let scene = Scene::parse(scene.as_bytes()).expect("the scene is valid");
        let prepared = Prepared::<Aos>::new(&config, &scene, Scatter::Statement).expect("memory is enough");
        let mut candidates = Candidates::new(&prepared).expect("memory is enough");
        for (row, first, last, expected) in
            [(0, 0, 3, &[0, 1][..]), (0, 0, 1, &[0]), (0, 3, 3, &[1]), (0, 1, 2, &[]), (1, 0, 3, &[2])]
        {
            candidates.begin_row(&prepared, row);
            candidates.begin_span(&prepared, row, &Span { first, first_sample: 0, count: 1, last });
            let found: Vec<_> = candidates.span.iter().map(|(id, _)| *id).collect();
            assert_eq!(found, expected, "row {row}, columns {first} to {last}");
        }
    }
}
