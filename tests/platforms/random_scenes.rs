//! Compares pictures of random scenes on another system, byte for byte, with those that this machine renders.

use cpu::internals::{InstructionSet, Prepared, render_with};
use cpu::{Aos, Config, Scatter, Scene};
use generator::write;
use generator::{self, Arrangement, Options};
use libtest_mimic::Failed;
use test_support::folder::Folder;
use test_support::ppm;

use super::host::Job;
use super::table::Platform;

/// Number of scenes.
const SCENES: u64 = 200;

/// Renders all scenes in both layouts and with every instruction set of the platform.
pub fn are_equal(platform: &Platform) -> Result<(), Failed> {
    let built = platform.build.release()?;
    let mut with_objects = 0;
    for number in 0..SCENES {
        let (config, scene) = random(number);
        let expected = picture(&config, &scene)?;
        with_objects += u64::from(expected != picture(&config, &Scene::default())?);
        let folder = Folder::with_scene(write::config(&config), write::scene(&scene));
        for set in platform.sets {
            for layout in ["aos", "soa"] {
                let job = Job { config: &folder.file("config.txt"), scene: &folder.file("scene.txt"), layout, set };
                if platform.host.render(&built, job)? != expected {
                    let message = format!("scene {number} differs with {set} in {layout}");
                    return Err(format!("{message}\n{}", test_support::agreement::files(&config, &scene)).into());
                }
            }
        }
    }
    if 2 * with_objects > SCENES { Ok(()) } else { Err(format!("only {with_objects} pictures show an object").into()) }
}

/// Returns scene `number`. Small numbers of objects make small scenes, larger ones need a flat filter or a BVH.
fn random(number: u64) -> (Config, Scene) {
    let choose = |values: [f64; 3], step: u64| values[(number / step % 3) as usize];
    let options = Options {
        seed: number,
        objects: (number * number % 151) as usize,
        cylinders: choose([0.5, 0.0, 1.0], 3),
        extent: choose([10.0, 1e-4, 1e5], 9),
        arrangement: [Arrangement::Scattered, Arrangement::Grid, Arrangement::Degenerate][(number % 3) as usize],
        ..Options::default()
    };
    let config = Config {
        image_width: 16,
        samples_per_pixel: 1 + number % 5,
        material_rng_seed: 1 + number,
        ray_rng_seed: 1000 + number,
        ..generator::view(&options)
    };
    (config, generator::scene(&options))
}

/// Returns the PPM file that this machine renders with its best instruction set.
fn picture(config: &Config, scene: &Scene) -> Result<Vec<u8>, Failed> {
    let prepared = Prepared::<Aos>::new(config, scene, Scatter::Statement).map_err(|error| error.to_string())?;
    Ok(ppm(&render_with(&prepared, InstructionSet::best()).map_err(|error| error.to_string())?))
}
