//! The objects of a picture on a device, and the loop of each ray over them or over the nodes of their hierarchy.
//! Drivers limit its iterations, so a run traces few surfaces of each path where the loop is long.

use std::ops::Range;

use crate::hierarchy::Hierarchy;
use crate::packed::buffer;
use crate::pipeline::Content;
use crate::{Error, Float, Picture};

/// Largest number of iterations of all loops of an invocation together. After 65,535 iterations lavapipe leaves a loop
/// without an error, so the colours would be wrong.
pub(crate) const MAX_ITERATIONS: u64 = 65_535;

/// Largest number of nodes that the rays of an invocation visit in one run; `MOST_VISITS` in `hierarchy.wgsl`. It
/// leaves iterations for the other loops. A ray that would visit more nodes gives up, and then the run returns an
/// error.
const MOST_VISITS: u64 = 60_000;

/// Largest number of objects over which a ray loops if its hierarchy is useless; `MOST_OBJECTS` in `hierarchy.wgsl`.
const MOST_OBJECTS: u64 = 20_000;

/// In a hierarchy a ray rarely visits more nodes than this. The number decides only how many rays a run has.
const TYPICAL_VISITS: u64 = 1 << 10;

/// The objects of a picture, and the loop of each of its rays.
#[derive(Debug, Default)]
pub(crate) struct RayLoop {
    /// The bytes of the spheres, the cylinders and the materials.
    objects: [Vec<u8>; 3],
    /// The bytes of the hierarchy; `None` if each ray intersects all objects.
    hierarchy: Option<Vec<u8>>,
    /// Number of objects of the picture. In a hierarchy the number of nodes, and of objects over which a ray may loop.
    length: u64,
}

impl RayLoop {
    /// Returns the loop over the objects of `picture`, or over their hierarchy if `in_hierarchy`.
    pub fn new<T: Float>(picture: &Picture<T>, in_hierarchy: bool) -> Self {
        let objects = [buffer(&picture.spheres), buffer(&picture.cylinders), buffer(&picture.materials)];
        let count = picture.spheres.len() as u64 + picture.cylinders.len() as u64;
        if in_hierarchy {
            let hierarchy = Hierarchy::new(picture);
            // The invocations of a workgroup run together, and for some of them the hierarchy may be useless.
            let looped = if count <= MOST_OBJECTS { count } else { 0 };
            return Self { objects, hierarchy: Some(hierarchy.bytes()), length: hierarchy.len() as u64 + looped };
        }
        Self { objects, hierarchy: None, length: count }
    }

    /// Returns the contents of all bindings of a kernel that traces rays: `head` and the objects, then `own` of the
    /// kernel. The hierarchy, if there is one, has the highest number of all bindings.
    pub fn contents<'a>(&'a self, head: Content<'a>, own: &[Content<'a>]) -> Vec<Content<'a>> {
        let mut contents = vec![head];
        contents.extend(self.objects.iter().map(|bytes| Content::Input(bytes)));
        contents.extend(own);
        contents.extend(self.hierarchy.as_deref().map(Content::Input));
        contents
    }

    /// Returns how many objects or nodes a ray usually tests.
    pub fn tests(&self) -> u64 {
        if self.hierarchy.is_some() { self.length.min(TYPICAL_VISITS) } else { self.length }
    }

    /// Returns how many surfaces of each path one run may trace, at least one. `tries` is the largest number of vectors
    /// from which the shader chooses a scatter vector in a loop; 0 if it has no such loop.
    ///
    /// # Errors
    /// [`Error::TooManyIterations`] if one surface already takes more iterations than a run may have.
    pub fn surfaces_of_a_run(&self, depth: u32, tries: u64) -> Result<u32, Error> {
        if self.hierarchy.is_none() {
            return surfaces_of_a_run(self.length, depth, tries);
        }
        let visits = self.length.clamp(1, MOST_VISITS);
        Ok(surfaces_of_a_run(visits, depth, tries)?.min((MOST_VISITS / visits) as u32))
    }
}

/// Returns how many surfaces of each path one run may trace if each ray intersects `objects` objects; see
/// [`RayLoop::surfaces_of_a_run`].
///
/// # Errors
/// [`Error::TooManyIterations`] if one surface already takes more than [`MAX_ITERATIONS`].
pub(crate) fn surfaces_of_a_run(objects: u64, depth: u32, tries: u64) -> Result<u32, Error> {
    // For each surface there is a loop over the objects. In addition the loop over a path's materials is counted, since
    // the invocations of a workgroup run together, and the path of a neighbour may end at any surface.
    match MAX_ITERATIONS / (objects + u64::from(depth) + 1 + tries) {
        0 => Err(Error::TooManyIterations { objects, depth: depth.into(), limit: MAX_ITERATIONS }),
        surfaces => Ok(surfaces as u32),
    }
}

/// Returns an error if a scene of `objects` objects cannot be rendered to this depth: in a hierarchy if `in_hierarchy`,
/// or else with a loop over all objects. `tries` is that of [`RayLoop::surfaces_of_a_run`].
///
/// # Errors
/// [`Error::TooManyIterations`].
pub(crate) fn check(objects: usize, in_hierarchy: bool, depth: u32, tries: u64) -> Result<(), Error> {
    let objects = objects as u64;
    let length = if in_hierarchy { objects.min(MOST_VISITS) } else { objects };
    surfaces_of_a_run(length, depth, tries).map(drop)
}

/// Divides `0..depth` into ranges of length `step`. Returns at least one range, even if it is empty.
pub(crate) fn steps(depth: u32, step: u32) -> Vec<Range<u32>> {
    (0..depth.max(1)).step_by(step as usize).map(|first| first..first.saturating_add(step).min(depth)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_depth_is_taken_in_steps() {
        assert_eq!(steps(5, 13_000), [Range { start: 0, end: 5 }]);
        assert_eq!(steps(7, 3), [0..3, 3..6, 6..7]);
    }

    #[test]
    fn as_many_objects_and_surfaces_as_the_limit_are_taken_and_one_more_is_refused() {
        assert!(matches!(surfaces_of_a_run(65_529, 5, 0), Ok(1)));
        assert!(matches!(surfaces_of_a_run(0, 65_534, 0), Ok(1)));
        assert!(matches!(surfaces_of_a_run(65_530, 5, 0), Err(Error::TooManyIterations { .. })));
        assert!(matches!(surfaces_of_a_run(0, 65_535, 0), Err(Error::TooManyIterations { .. })));
        assert!(matches!(surfaces_of_a_run(4, 5, 0), Ok(6553)));
        assert!(matches!(surfaces_of_a_run(4, 5, 100), Ok(595)));
    }

    #[test]
    fn a_hierarchy_of_any_size_is_taken_and_a_run_never_visits_too_many_nodes() {
        let surfaces = |length, depth| {
            RayLoop { hierarchy: Some(Vec::new()), length, ..RayLoop::default() }.surfaces_of_a_run(depth, 100)
        };
        assert!(matches!(surfaces(2_000_000, 50), Ok(1)));
        assert!(matches!(surfaces(60_000, 50), Ok(1)));
        assert!(matches!(surfaces(20_001, 50), Ok(2)));
        assert!(matches!(surfaces(20_000, 50), Ok(3)));
        assert!(matches!(surfaces(2_000_000, 5_434), Ok(1)));
        assert!(matches!(surfaces(2_000_000, 5_435), Err(Error::TooManyIterations { .. })));
        assert!(check(2_000_000, true, 50, 0).is_ok());
        assert!(check(2_000_000, false, 50, 0).is_err());
    }
}
