//! Completes a scene that has been read: the caps of cylinders, the sky, the size of the picture and the camera.

use cpu::internals::Camera;
use cpu::{Config, Shape, Vec3};

use super::notes::{Fault, Place};
use super::world::{View, World};

/// Largest error of a length, as a part of the cylinder's size and distance: files have numbers of `f32`.
const ERROR: f64 = 1e-5;

/// Sets the values of the configuration that depend on several plugins, and notes what is missing.
///
/// # Errors
/// A fault if nothing has a match, or if the camera is wrong.
pub fn complete(world: &mut World) -> Result<(), Fault> {
    const START: Place = (0, 1);
    if world.scene.objects.is_empty() && world.view.is_none() && world.sky.is_none() {
        return Err((START, "nothing in this file has a match: no camera, sky, sphere or cylinder".to_owned()));
    }
    close_cylinders(world);
    set_size(&mut world.config, world.film);
    if let Some([dark, light]) = world.sky {
        (world.config.background_dark_color, world.config.background_light_color) = (dark, light);
    } else {
        world.notes.add(START, "no sky surrounds the scene; our default sky, the only light, takes its place");
    }
    let Some(view) = world.view.take() else {
        world.notes.add(START, "there is no camera; our default takes its place");
        return check(&world.config, START);
    };
    set_camera(world, &view);
    let fov = world.config.field_of_view;
    if !(fov > 0.0 && fov < 180.0) {
        return Err((view.place, format!("the field of view is {fov} degrees; it must be above 0 and below 180")));
    }
    check(&world.config, view.place)
}

/// Checks the camera and the size of the picture. A fault is that of `place`.
fn check(config: &Config, place: Place) -> Result<(), Fault> {
    let camera = config.image_size().and_then(|size| Camera::new(config, size));
    camera.map(drop).map_err(|error| (place, error.to_string()))
}

fn set_camera(world: &mut World, view: &View) {
    let [width, height] = world.film.map(|side| side as f64);
    if view.window.is_some_and(|[right, top]| (right / top * height / width - 1.0).abs() > 1e-3) {
        world.notes.add(view.place, "[screenwindow] is not as wide as the picture; its height is taken");
    }
    let top = view.window.map_or_else(|| (view.top)(height / width), |[_, top]| top);
    let half = (view.fov.to_radians() / 2.0).tan() * top;
    let config = &mut world.config;
    config.field_of_view = if top == 1.0 { view.fov } else { 2.0 * half.atan().to_degrees() };
    let [_, north, forward] = view.to_world.columns;
    let found = view.to_world.view.unwrap_or([view.to_world.origin, view.to_world.origin + forward, north]);
    [config.camera_position, config.camera_target, config.camera_north] = found;
    if !view.to_world.scale_of(3).1 {
        world.notes.add(view.place, "a camera that is scaled unequally or sheared has no match; that is left out");
    }
    if (view.to_world.determinant() > 0.0) == view.x_is_right {
        world.notes.add(view.place, "left and right of the picture are swapped as against ours; all x are negated");
        let mirror = |vector: &mut Vec3| vector.x = 0.0 - vector.x;
        mirror(&mut config.camera_position);
        mirror(&mut config.camera_target);
        mirror(&mut config.camera_north);
        for object in &mut world.scene.objects {
            match &mut object.shape {
                Shape::Sphere(sphere) => mirror(&mut sphere.center),
                Shape::Cylinder(cylinder) => {
                    mirror(&mut cylinder.center);
                    mirror(&mut cylinder.axis);
                }
            }
        }
    }
}

/// Sets the width and a ratio of sides that gives the height: the simplest one, unless rounding gives another height.
fn set_size(config: &mut Config, [width, height]: [u64; 2]) {
    let (mut divisor, mut rest) = (width, height);
    while rest > 0 {
        (divisor, rest) = (rest, divisor % rest);
    }
    config.image_width = width;
    // The height is rounded down, so the second ratio, which is in the middle of those that give it, always does.
    for ratio in [[width / divisor, height / divisor], [width.saturating_mul(2), height.saturating_mul(2) | 1]] {
        config.aspect_ratio = ratio;
        if config.image_size().is_ok_and(|size| (size.width() as u64, size.height() as u64) == (width, height)) {
            return;
        }
    }
}

/// Notes cylinders that two disks do not close, and disks that close none. Cylinders of pbrt and Mitsuba are open, and
/// ours are closed.
fn close_cylinders(world: &mut World) {
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
