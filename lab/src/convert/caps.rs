//! Finds the disks that close cylinders. Cylinders of pbrt and Mitsuba are open, and ours are closed.

use cpu::{Shape, Vec3};

use super::world::World;

/// Largest error of a length, as a part of the cylinder's size and distance: files have numbers of `f32`.
const ERROR: f64 = 1e-5;

/// Notes cylinders that two disks do not close, and disks that close none.
pub fn close_cylinders(world: &mut World) {
    let disks = &mut world.disks;
    // The disks near a place are found along a direction that no rows of a scene are likely to have.
    let along = |place: Vec3| place.dot(Vec3::new(0.6, 0.53, 0.59));
    disks.sort_by(|one, other| along(one.center).total_cmp(&along(other.center)));
    let mut closes = vec![false; disks.len()];
    let cylinders = world.scene.objects.iter().filter_map(|object| match object.shape {
        Shape::Cylinder(cylinder) => Some((cylinder, object.material)),
        Shape::Sphere(_) => None,
    });
    for ((cylinder, material), &place) in cylinders.zip(&world.cylinders) {
        let near = ERROR * (cylinder.radius + cylinder.axis.length() + cylinder.center.length());
        let mut is_cap = |half: f64| {
            let end = cylinder.center + cylinder.axis * half;
            let first = disks.partition_point(|disk| along(disk.center) < along(end) - near);
            let cap = (first..disks.len()).take_while(|&at| along(disks[at].center) <= along(end) + near).find(|&at| {
                let disk = &disks[at];
                let is_there = !closes[at] && (disk.center - end).length() <= near && disk.material == material;
                let cosine = disk.normal.unit().dot(cylinder.axis.unit()).abs();
                is_there && (disk.radius / cylinder.radius - 1.0).abs() < ERROR && cosine > 1.0 - ERROR
            });
            cap.is_some_and(|at| !std::mem::replace(&mut closes[at], true))
        };
        if [is_cap(0.5), is_cap(-0.5)] != [true; 2] {
            world.notes.add(place, "an open cylinder has no match; ours, with two caps, takes its place");
        }
    }
    for (disk, _) in world.disks.iter().zip(&closes).filter(|(_, closes)| !**closes) {
        world.notes.add(disk.place, "a disk that closes no cylinder has no match; left out");
    }
}
