//! The scenes and rays of the comparison, from a fixed seed.
//!
//! The sum of the spheres' cross-sections is the same for every number of spheres. So a ray flies equally far, whatever
//! the number is. All numbers that both sides read have single precision, except for the origins on surfaces: there
//! only Embree's copy is rounded, because ours need a point on the surface.

use cpu::internals::sampling::uniform::Uniform;
use cpu::{Material, Object, Ray, Scene, Shape, Vec3};

use super::{NO_PLACE, Start, ours::Ours};

/// Half the side of the cube that contains the spheres' centres, in scene units.
const HALF_SIDE: f64 = 4.0;

/// The radius of the ground, in scene units. Its highest point touches the cube's lower side.
const GROUND_RADIUS: f64 = 100.0;

/// Number of free rays that are drawn at once to find points on surfaces.
const BLOCK: usize = 10_000;

/// What a scene holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setting {
    /// Number of spheres, without the ground.
    pub size: usize,
    /// Whether the spheres are four times as large as in a sparse scene.
    pub dense: bool,
    /// Whether one huge sphere lies below the others.
    pub ground: bool,
}

impl Setting {
    /// Returns the settings with `size` spheres: sparse and dense, on a ground and without one.
    #[must_use]
    pub fn all(size: usize) -> [Self; 4] {
        [(false, true), (true, true), (false, false), (true, false)].map(|(dense, ground)| Self { size, dense, ground })
    }

    /// Returns the radius of the spheres, in scene units.
    #[must_use]
    pub fn radius(&self) -> f64 {
        let sparse = 0.3 * (33.0 / self.size as f64).sqrt();
        single(if self.dense { 4.0 * sparse } else { sparse })
    }

    /// Returns the scene: the ground if there is one, then the spheres at random places in a cube.
    #[must_use]
    pub fn scene(&self) -> Scene {
        let mut draws = Uniform::new(1);
        let sphere = |center, radius| Object {
            shape: Shape::Sphere(cpu::internals::input::scene::Sphere { center, radius }),
            material: 0,
        };
        let below = Vec3::new(0.0, -HALF_SIDE - GROUND_RADIUS, 0.0);
        let ground = self.ground.then(|| sphere(below, GROUND_RADIUS));
        let spheres = (0..self.size).map(|_| sphere(in_cube(&mut draws), self.radius()));
        let objects = ground.into_iter().chain(spheres).collect();
        Scene { materials: vec![Material::Matte { reflectance: Vec3::splat(0.5) }], objects }
    }
}

/// Returns `count` rays from random points of the cube in random directions. The seed 1 is that of the spheres.
#[must_use]
pub fn free_rays(count: usize, seed: u64) -> Vec<Start> {
    let mut draws = Uniform::new(seed);
    let mut ray = || Ray { origin: in_cube(&mut draws), direction: direction(&mut draws).map(single) };
    (0..count).map(|_| Start { ray: ray(), from: NO_PLACE }).collect()
}

/// Returns `count` rays that start where free rays hit, scattered as a matte surface scatters: the direction is the
/// normal on the side of the free ray plus a random unit vector. If hardly a ray hits, there are fewer.
#[must_use]
pub fn surface_rays(count: usize, scene: &Scene, ours: &Ours) -> Vec<Start> {
    let mut draws = Uniform::new(3);
    let mut starts = Vec::with_capacity(count);
    for seed in 4..1004 {
        let free = free_rays(BLOCK, seed);
        for (start, hit) in free.iter().zip(ours.hits(&free)) {
            if hit.place == NO_PLACE || starts.len() == count {
                continue;
            }
            let Shape::Sphere(sphere) = scene.objects[hit.place as usize].shape else { continue };
            let origin = start.ray.at(hit.lambda);
            let outward = (origin - sphere.center).unit();
            let normal = if outward.dot(start.ray.direction) < 0.0 { outward } else { -outward };
            let direction = (normal + direction(&mut draws)).map(single);
            starts.push(Start { ray: Ray { origin, direction }, from: hit.place });
        }
        if starts.len() == count {
            break;
        }
    }
    starts
}

/// Rounds to single precision.
fn single(value: f64) -> f64 {
    f64::from(value as f32)
}

fn in_cube(draws: &mut Uniform) -> Vec3 {
    Vec3::from([(); 3].map(|()| single(draws.draw(-HALF_SIDE, HALF_SIDE))))
}

/// Returns a random vector of length one, of uniform direction.
fn direction(draws: &mut Uniform) -> Vec3 {
    loop {
        let vector = Vec3::from([(); 3].map(|()| draws.draw(-1.0, 1.0)));
        if (0.1..=1.0).contains(&vector.length()) {
            return vector.unit();
        }
    }
}
