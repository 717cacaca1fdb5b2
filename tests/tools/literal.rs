//! Builds the literal program in C++ (`tests/literal`), and checks that its pictures have the digests in `tests/cases`.
//!
//! So the digests can be computed again from this repository alone, and the program whose times are compared renders
//! the right pictures. The literal program also renders 200 random ordinary scenes, and 200 scenes with hard cameras,
//! or `RENDER_CASES` of each. Its pictures are compared with those of the reference and of the renderer.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::{Arc, LazyLock};

use cpu::internals::layout::aos::AosImage;
use cpu::internals::math::tangent::tangent;
use cpu::reference::intersect::Exact;
use cpu::{Aos, Config, Scatter, Scene};
use generator::Options;
use generator::cameras::hard_camera;
use libtest_mimic::{Failed, Trial};
use test_support::folder::Folder;
use test_support::golden::{self, Golden};
use test_support::{cpp, number_of, p3, ppm, trial};

/// The built program, in a folder that is removed by the last test that uses it.
type Built = Result<(Folder, PathBuf), String>;

/// A check that takes the path of the built program.
type Check = Box<dyn FnOnce(&Path) -> Result<(), Failed> + Send>;

pub fn trials() -> Vec<Trial> {
    let cases = golden::cases();
    assert_eq!(cases.len(), 32, "16 scenes in both conventions");
    let missing = cpp::missing();
    // The program is built once, by the first test that runs. A static value would never be dropped.
    let program: Arc<LazyLock<Built>> = Arc::new(LazyLock::new(build));
    let literal = |name: &str, check: Check| {
        let program = Arc::clone(&program);
        let test = move || check(&program.as_ref().as_ref().map_err(Clone::clone)?.1);
        trial(format!("literal: {name}"), missing, test)
    };
    vec![
        literal("cases", Box::new(move |program| cases.iter().try_for_each(|golden| has_its_digest(golden, program)))),
        literal("random scenes", Box::new(renders_random_scenes)),
        literal("hard cameras", Box::new(renders_hard_cameras)),
    ]
}

/// Builds the program in a new folder.
fn build() -> Built {
    let folder = Folder::new();
    let program = cpp::build("literal", &folder)?;
    Ok((folder, program))
}

/// Returns the picture that the program makes of two files.
fn render(program: &Path, [config, scene]: [&Path; 2], scatter: Scatter) -> Result<Vec<u8>, Failed> {
    let folder = Folder::new();
    let out = folder.file("out.ppm");
    let mut command = Command::new(program);
    command.args([config, scene, &out]).args((scatter == Scatter::Published).then_some("published"));
    check(&command.output()?)?;
    Ok(std::fs::read(out)?)
}

fn has_its_digest(golden: &Golden, program: &Path) -> Result<(), Failed> {
    let bytes = render(program, [&golden.config, &golden.scene], golden.scatter)?;
    p3::read(&bytes)?;
    let (actual, expected) = (format::digest::sha256(&bytes), golden.digest()?);
    if actual == expected { Ok(()) } else { Err(format!("{}: {actual} instead of {expected}", golden.name).into()) }
}

/// Returns the literal program's picture of a scene, and the configuration and scene that it has read. They are read
/// back from the files, so that all programs render the numbers in the files.
fn literal(
    program: &Path,
    (config, scene): (&Config, &Scene),
    scatter: Scatter,
) -> Result<(Vec<u8>, Config, Scene), Failed> {
    let folder = Folder::with_scene(generator::write::config(config), generator::write::scene(scene));
    let [config, scene] = ["config.txt", "scene.txt"].map(|name| folder.file(name));
    Ok((render(program, [&config, &scene], scatter)?, Config::read(&config)?, Scene::read(&scene)?))
}

/// Checks with random ordinary scenes that the reference and the renderer give the literal program's bytes.
///
/// The renderer's intersections are exact. So with other scenes it could differ if rounding decides whether the literal
/// program's ray hits. In 10,000 of these scenes there is no difference.
fn renders_random_scenes(program: &Path) -> Result<(), Failed> {
    compare(program, (1.0, 0.5), |seed| {
        let options = Options { seed, objects: (seed % 50) as usize, ..Options::default() };
        let config = Config {
            image_width: 8 + seed % 5,
            samples_per_pixel: 1 + seed % 3,
            max_depth: 1 + seed % 9,
            material_rng_seed: seed,
            ray_rng_seed: 3 * seed + 1,
            ..generator::view(&options)
        };
        (generator::scene(&options), config)
    })
}

/// Checks with random [hard cameras](hard_camera) that the reference with the plain formulas gives the literal
/// program's bytes, and that the renderer gives them too where the plain formulas decide as exact arithmetic does.
fn renders_hard_cameras(program: &Path) -> Result<(), Failed> {
    compare(program, (0.5, 0.25), |seed| hard_camera(seed, (seed % 12) as usize))
}

/// Renders scenes with the literal program, the reference and the renderer. The renderer is compared if the plain
/// formulas decide as exact arithmetic does. `least` has the shares of scenes that must be compared and show objects.
fn compare(program: &Path, least: (f64, f64), make: impl Fn(u64) -> (Scene, Config)) -> Result<(), Failed> {
    let scenes = number_of("RENDER_CASES").unwrap_or(200);
    let (mut sound, mut with_objects) = (0_u64, 0_u64);
    for seed in 1..=scenes {
        let (scene, config) = make(seed);
        if !has_sound_window(&config) {
            continue;
        }
        let scatter = if seed % 2 == 0 { Scatter::Statement } else { Scatter::Published };
        let (literal, config, scene) = literal(program, (&config, &scene), scatter)?;
        let differs = |name: &str| {
            let files = test_support::agreement::files(&config, &scene);
            Failed::from(format!("the {name} differs from the literal program: seed {seed}, {scatter:?}\n{files}"))
        };
        if ppm(&cpu::reference::render::<AosImage>(&config, &scene, scatter)?) != literal {
            return Err(differs("reference"));
        }
        if ppm(&cpu::reference::render_with::<AosImage, Exact>(&config, &scene, scatter)?) == literal {
            sound += 1;
            if ppm(&cpu::render::<Aos>(&config, &scene, scatter)?) != literal {
                return Err(differs("renderer"));
            }
            let background = cpu::reference::render::<AosImage>(&config, &Scene::default(), scatter)?;
            with_objects += u64::from(ppm(&background) != literal);
        }
    }
    let text = format!("in {sound} of {scenes} scenes the plain formulas decide, {with_objects} show objects");
    println!("{text}");
    let share = |count: u64| count as f64 / scenes as f64;
    if share(sound) >= least.0 && share(with_objects) >= least.1 { Ok(()) } else { Err(text.into()) }
}

/// Whether the literal program computes the camera's window as the specification says. In its arithmetic the squares of
/// lengths beyond 10^100 or below 10^-100 may overflow or underflow, and the library's tangent may be rounded wrongly.
fn has_sound_window(config: &Config) -> bool {
    let view = config.camera_target - config.camera_position;
    let is_moderate = |length: f64| (1e-100..1e100).contains(&length);
    let angle = config.field_of_view * std::f64::consts::PI / 180.0 / 2.0;
    [config.camera_north, config.camera_position, view].map(|vector| vector.length()).into_iter().all(is_moderate)
        && angle.tan() == tangent(angle)
        && config.check_picture().is_ok()
}

/// Returns an error unless a command has succeeded and printed nothing.
fn check(output: &Output) -> Result<(), String> {
    let silent = output.stdout.is_empty() && output.stderr.is_empty();
    if output.status.success() && silent { Ok(()) } else { Err(format!("{output:?}")) }
}
