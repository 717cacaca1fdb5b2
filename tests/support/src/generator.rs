//! Scenes from a seed: the same options give the same scene on every machine, for ever.
//!
//! The numbers come from `std::mt19937_64` (through [`cpu::internals::sampling::uniform::Uniform`]) and go only
//! through operations that IEEE 754 defines exactly, so no library of elementary functions can change a digit.
//! Everything is proportional to [`Options::extent`]; the objects of a scene are those of a larger one with the same
//! options, as far as they go, unless they stand on a [grid](Arrangement::Grid).

mod arrange;
mod draws;

use cpu::internals::input::scene::{MaterialId, Object};
use cpu::{Config, Material, Scene, Vec3};

use draws::Draws;

/// Materials in every scene, each kind as often as the options say.
const PALETTE: usize = 24;

/// What the ground of a grid is made of: a warm grey that leaves the colours to the objects.
const GROUND: Material = Material::Matte { reflectance: Vec3::new(0.5, 0.47, 0.42) };

/// Where objects are put.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Arrangement {
    /// Anywhere in the cube, of any size that suits it.
    #[default]
    Scattered,
    /// On the ground, one on each square of a board, with the ground itself as the first object.
    Grid,
    /// Where arithmetic is hard: copies, touching and nested objects, common axes and planes, the huge beside the tiny.
    Degenerate,
}

/// What to generate.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// Where all random numbers come from.
    pub seed: u64,
    /// How many objects.
    pub objects: usize,
    /// The share of cylinders among them, from 0 to 1; the others are spheres.
    pub cylinders: f64,
    /// Weights of matte, metal and refractive materials.
    pub materials: [f64; 3],
    /// Half the side of the cube that the objects' centres lie in.
    pub extent: f64,
    /// Where objects are put.
    pub arrangement: Arrangement,
}

impl Default for Options {
    fn default() -> Self {
        let arrangement = Arrangement::default();
        Self { seed: 1, objects: 100, cylinders: 0.5, materials: [2.0, 1.0, 1.0], extent: 10.0, arrangement }
    }
}

/// The scene that `options` describe. A scene without objects has its materials all the same.
///
/// ```
/// use test_support::generator::{Options, scene};
///
/// let options = Options { objects: 7, ..Options::default() };
/// assert_eq!(scene(&options).objects.len(), 7);
/// assert_eq!(scene(&options), scene(&options));
/// ```
#[must_use]
pub fn scene(options: &Options) -> Scene {
    let mut draws = Draws::new(options.seed);
    let mut materials: Vec<_> = (0..PALETTE).map(|_| material(&mut draws, options.materials)).collect();
    let shapes = arrange::shapes(&mut draws, options);
    let mut objects: Vec<_> =
        shapes.into_iter().map(|shape| Object { shape, material: draws.index(PALETTE) as MaterialId }).collect();
    if let (Arrangement::Grid, Some(ground)) = (options.arrangement, objects.first_mut()) {
        ground.material = materials.len() as MaterialId;
        materials.push(GROUND);
    }
    Scene { materials, objects }
}

/// A configuration that shows such a scene as a small picture.
#[must_use]
pub fn view(options: &Options) -> Config {
    let [position, target] = match options.arrangement {
        Arrangement::Grid => {
            // From before the near edge, a few squares up, so that a board of any size is seen from among its objects.
            let square = 2.0 / arrange::squares_a_side(options.objects) as f64;
            [[0.7 * square, 3.2 * square, -1.0 - 2.6 * square], [0.0, 0.0, -1.0 + 2.8 * square]]
        }
        _ => [[1.2, 0.9, -2.2], [0.0; 3]],
    };
    let place = |point: [f64; 3]| Vec3::from(point.map(|component| draws::round(component * options.extent)));
    Config {
        image_width: 400,
        camera_position: place(position),
        camera_target: place(target),
        field_of_view: 50.0,
        samples_per_pixel: 8,
        max_depth: 8,
        background_dark_color: Vec3::new(0.25, 0.45, 0.85),
        background_light_color: Vec3::new(1.0, 0.92, 0.82),
        ..Config::default()
    }
}

fn material(draws: &mut Draws, weights: [f64; 3]) -> Material {
    let [matte, metal, refractive] = weights;
    let kind = draws.between(0.0, matte + metal + refractive);
    if kind < matte {
        Material::Matte { reflectance: draws.color(0.05) }
    } else if kind < matte + metal {
        let reflectance = draws.color(0.5);
        // Every other metal is a mirror.
        let diffusion = if draws.chance(0.5) { 0.0 } else { draws::round(draws.between(0.0, 0.6)) };
        Material::Metal { reflectance, diffusion }
    } else {
        Material::Refractive { index: draws::round(draws.between(0.6, 2.4)) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use cpu::internals::input::scene::Shape;

    const ARRANGEMENTS: [Arrangement; 3] = [Arrangement::Scattered, Arrangement::Grid, Arrangement::Degenerate];

    fn is_cylinder(object: &Object) -> bool {
        matches!(object.shape, Shape::Cylinder(_))
    }

    #[test]
    fn there_are_as_many_objects_as_asked_for() {
        for arrangement in ARRANGEMENTS {
            for objects in [0, 1, 2, 100, 1000] {
                let scene = scene(&Options { objects, arrangement, ..Options::default() });
                assert_eq!(scene.objects.len(), objects);
                assert!(scene.materials.len() >= PALETTE);
            }
        }
    }

    #[test]
    fn another_seed_gives_another_scene() {
        let first = scene(&Options::default());
        assert_eq!(first, scene(&Options::default()));
        assert_ne!(first, scene(&Options { seed: 2, ..Options::default() }));
    }

    #[test]
    fn a_smaller_scene_is_the_start_of_a_larger_one() {
        for arrangement in [Arrangement::Scattered, Arrangement::Degenerate] {
            let options = |objects| Options { objects, arrangement, ..Options::default() };
            let shapes = |objects| scene(&options(objects)).objects.into_iter().map(|object| object.shape);
            assert!(shapes(20).eq(shapes(50).take(20)));
        }
    }

    #[test]
    fn the_share_of_cylinders_is_the_one_asked_for() {
        for (cylinders, least, most) in [(0.0, 0, 0), (0.5, 350, 650), (1.0, 1000, 1000)] {
            let scene = scene(&Options { objects: 1000, cylinders, ..Options::default() });
            let count = scene.objects.iter().filter(|object| is_cylinder(object)).count();
            assert!((least..=most).contains(&count), "{count} of 1000 with a share of {cylinders}");
        }
    }

    #[test]
    fn a_weight_of_zero_leaves_a_material_out() {
        let kinds = |materials| {
            let scene = scene(&Options { materials, ..Options::default() });
            let count = |wanted: fn(&Material) -> bool| scene.materials.iter().filter(|m| wanted(m)).count();
            [
                count(|material| matches!(material, Material::Matte { .. })),
                count(|material| matches!(material, Material::Metal { .. })),
                count(|material| matches!(material, Material::Refractive { .. })),
            ]
        };
        assert_eq!(kinds([1.0, 0.0, 0.0]), [PALETTE, 0, 0]);
        assert_eq!(kinds([0.0, 1.0, 0.0]), [0, PALETTE, 0]);
        assert_eq!(kinds([0.0, 0.0, 1.0]), [0, 0, PALETTE]);
        assert!(kinds([1.0, 1.0, 1.0]).iter().all(|&count| count > 0));
    }

    #[test]
    fn every_view_is_a_picture_and_every_scene_a_valid_file() {
        for arrangement in ARRANGEMENTS {
            for extent in [1e-4, 1.0, 1e5] {
                let options = Options { arrangement, extent, ..Options::default() };
                let config = view(&options);
                let size = config.image_size().expect("the picture is small");
                assert!(cpu::internals::geometry::camera::Camera::new(&config, size).is_ok());
                let text = crate::write::scene(&scene(&options));
                assert_eq!(Scene::parse(text.as_bytes()).ok(), Some(scene(&options)), "{options:?}");
            }
        }
    }
}
