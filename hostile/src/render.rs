//! Any bytes as a tiny scene, rendered every way there is.
//!
//! The bytes choose: a menu of hard numbers (0, the smallest and the largest, what is nearly 1), or any number at all. So
//! every input is a valid scene and a valid configuration, and libFuzzer spends its time on geometry and not on grammar.

mod choices;

use cpu::certified::{Certified, Intersect, Textbook};
use cpu::layout::AosImage;
use cpu::material::Material;
use cpu::scene::{Cylinder, Shape, Sphere};
use cpu::{Aos, Config, Image, InstructionSet, Layout, Prepared, Scatter, Scene, Soa, Vec3};

pub use choices::Choices;

const SCATTERS: [Scatter; 3] = [Scatter::Statement, Scatter::Published, Scatter::Deterministic];

/// Up to here a factor of four takes no product of the textbook's beyond f64: the reference takes `b^2 - 4 a c` of the
/// statement, the renderer a quarter of it, which has the same bits short of overflow alone.
const LARGEST_TEXTBOOK: f64 = 1e75;

/// Both layouts give the reference's bytes, or its refusal; the first with every instruction set of the machine.
///
/// # Panics
/// When it does not hold; the message has both files.
pub fn check(bytes: &[u8]) {
    let mut choices = Choices::new(bytes);
    let scatter = SCATTERS[choices.below(3)];
    let certified = choices.below(2) == 0;
    let config = choices.config();
    let scene = choices.scene();
    if certified || largest(&config, &scene) > LARGEST_TEXTBOOK {
        agree::<Certified>(&config, &scene, scatter);
    } else {
        agree::<Textbook>(&config, &scene, scatter);
    }
}

/// The largest magnitude that a ray may bring into a product.
fn largest(config: &Config, scene: &Scene) -> f64 {
    let of = |vector: Vec3| vector.x.abs().max(vector.y.abs()).max(vector.z.abs());
    let materials = scene.materials.iter().map(|material| match material {
        Material::Metal { diffusion, .. } => *diffusion,
        Material::Refractive { index } => index.max(1.0 / index),
        Material::Matte { .. } => 1.0,
    });
    let objects = scene.objects.iter().map(|object| match object.shape {
        Shape::Sphere(Sphere { center, radius }) => of(center).max(radius),
        Shape::Cylinder(Cylinder { center, radius, axis }) => of(center).max(radius).max(of(axis)),
    });
    let camera = of(config.camera_position).max(of(config.camera_target));
    materials.chain(objects).fold(camera, f64::max)
}

fn agree<P: Intersect>(config: &Config, scene: &Scene, scatter: Scatter) {
    let expected =
        cpu::reference::render_with::<AosImage, P>(config, scene, scatter).map_err(|error| error.to_string());
    let all: Vec<_> = InstructionSet::ALL.into_iter().filter(|set| set.is_available()).collect();
    held_to::<Aos, P>(config, scene, scatter, &all, &expected);
    held_to::<Soa, P>(config, scene, scatter, &[InstructionSet::best()], &expected);
}

fn held_to<L: Layout, P: Intersect>(
    config: &Config,
    scene: &Scene,
    scatter: Scatter,
    sets: &[InstructionSet],
    expected: &Result<AosImage, String>,
) {
    let files = || format!("config.txt:\n{}scene.txt:\n{}", tests::write::config(config), tests::write::scene(scene));
    let layout = std::any::type_name::<L>();
    let prepared = Prepared::<L, P>::new(config, scene, scatter).map_err(|error| error.to_string());
    match (prepared, expected) {
        (Err(real), Err(reference)) => assert_eq!(&real, reference, "{}", files()),
        (Ok(prepared), Ok(expected)) => {
            for set in sets {
                let actual = cpu::render_with(&prepared, *set).expect("the picture is tiny");
                assert_eq!(actual.size(), expected.size());
                for index in 0..expected.size().pixels() {
                    let (actual, expected) = (actual.pixel(index), expected.pixel(index));
                    if actual != expected {
                        let (set, precision) = (set.name(), P::PRECISION);
                        let how = format!("{layout}, {set}, {precision:?}, {scatter:?}");
                        panic!("{how}: pixel {index} is {actual:?}, not {expected:?}\n{}", files());
                    }
                }
            }
        }
        (real, reference) => {
            panic!("{:?} where the reference says {:?}\n{}", real.err(), reference.as_ref().err(), files());
        }
    }
}
