//! Generates scenes with hard cameras: far from the origin of coordinates, with a window that is near or far, and with
//! any field of view.
//!
//! A camera ray is rounded to the spacing of numbers near the camera's position. So if the window is much nearer than
//! the origin of coordinates, rays of neighbouring pixels may be equal, or turned by more than a pixel. Objects are put
//! where such a camera sees them.

use cpu::internals::input::scene::{Cylinder, MaterialId, Object, Shape, Sphere};
use cpu::{Config, Material, Scene, Vec3};

use super::draws::Draws;

/// The largest valid field of view, in degrees.
const WIDEST: f64 = 180.0_f64.next_down();

/// Returns a scene with `objects` objects, and the configuration of a small picture of it. Equal seeds give equal
/// scenes. Some cameras have no window, and renderers refuse them.
#[must_use]
pub fn hard_camera(seed: u64, objects: usize) -> (Scene, Config) {
    let mut draws = Draws::new(seed);
    let config = config(&mut draws, seed);
    let materials = [
        Material::Matte { reflectance: draws.color(0.2) },
        Material::Metal { reflectance: draws.color(0.2), diffusion: draws.between(0.0, 1.0) },
        Material::Refractive { index: 1.5 },
    ];
    let count = materials.len();
    let objects = (0..objects)
        .map(|_| Object { shape: visible(&mut draws, &config), material: draws.index(count) as MaterialId })
        .collect();
    (Scene { materials: materials.into(), objects }, config)
}

/// Returns a random vector whose components are from -1 to 1, with all digits of f64.
fn cube(draws: &mut Draws) -> Vec3 {
    Vec3::from([(); 3].map(|()| draws.between(-1.0, 1.0)))
}

fn field_of_view(draws: &mut Draws) -> f64 {
    match draws.index(5) {
        0 => draws.decades(-12.0, -3.0),
        1 => WIDEST - draws.decades(-14.0, 1.0),
        2 if draws.chance(0.1) => WIDEST,
        _ => draws.between(1.0, 120.0),
    }
}

fn config(draws: &mut Draws, seed: u64) -> Config {
    // In most scenes the numbers are moderate, so that the renderer takes its shortcuts (tests/properties counts them).
    let any = draws.chance(0.15);
    let size = if any { draws.decades(-300.0, 300.0) } else { draws.decades(-2.0, 9.0) };
    let distance = match draws.index(4) {
        0 => size * draws.decades(-3.0, 1.0),
        1 if any => draws.decades(-300.0, 300.0),
        2 if any => size * draws.decades(-16.0, -4.0),
        // The window is so near that the grid of the camera's position shows.
        _ => size * draws.decades(-13.0, -4.0),
    };
    let position = cube(draws) * size;
    let view = if draws.chance(0.2) { draws.along_an_axis(1.0) } else { cube(draws).unit() };
    // In a third of the scenes the camera's north is nearly parallel to the view.
    let north = if draws.chance(0.3) { view + cube(draws) * draws.decades(-15.0, 0.0) } else { cube(draws) };
    let length = if draws.chance(0.3) { draws.decades(-300.0, 300.0) } else { 1.0 };
    Config {
        image_width: 1 + draws.index(16) as u64,
        aspect_ratio: [1 + draws.index(3) as u64, 1 + draws.index(2) as u64],
        camera_position: position,
        camera_target: position + view * distance,
        camera_north: north * length,
        field_of_view: field_of_view(draws),
        samples_per_pixel: 1 + draws.index(4) as u64,
        max_depth: 1 + draws.index(5) as u64,
        material_rng_seed: seed | 1,
        ray_rng_seed: (seed >> 1) | 1,
        ..Config::default()
    }
}

/// Returns a shape that is about as large as a part of the picture, around a point that a camera ray passes.
fn visible(draws: &mut Draws, config: &Config) -> Shape {
    let (position, view) = (config.camera_position, config.camera_target - config.camera_position);
    // With a wide field of view the shape is not far aside.
    let tangent = (config.field_of_view.to_radians() / 2.0).tan().min(20.0);
    // The shape is about as far away as the origin of coordinates, or much nearer.
    let nearest = if draws.chance(0.8) { 0.0 } else { -12.0 };
    let lambda = position.length() / view.length() * draws.decades(nearest, 0.5);
    let aside = cube(draws) * (view.length() * tangent);
    let center = position + (view + aside) * lambda;
    // The lengths of extreme views overflow or vanish.
    let center = if center.is_finite() { center } else { position };
    let radius = view.length() * lambda * tangent.min(1.0) * draws.decades(-1.5, 0.5);
    // In most scenes no size is below the smallest one of a moderate scene. Elsewhere a much shorter or longer axis
    // would be invalid, because its square vanishes or overflows.
    let smallest = if (1e-3..1e10).contains(&position.length()) { 1.1e-6 } else { 1e-140 };
    let radius = if radius.is_finite() { radius.clamp(smallest, 1e150) } else { smallest };
    if draws.chance(0.5) {
        return Shape::Sphere(Sphere { center, radius });
    }
    let axis = cube(draws).unit() * (radius * draws.decades(0.31, 1.0));
    Shape::Cylinder(Cylinder { center, radius, axis })
}
