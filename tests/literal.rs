//! Builds the literal program in C++ (`tests/literal`), and checks that its pictures have the digests in `tests/cases`.
//!
//! So the digests can be computed again from this repository alone, and the program whose times are compared renders
//! the right pictures. The literal program also renders 200 random ordinary scenes, and 200 scenes with hard cameras,
//! or `RENDER_LITERAL_SCENES` of each. Its pictures are compared with those of the reference and of the renderer.
//! Without g++ these tests are shown as ignored.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::Arc;

use cpu::internals::layout::aos::AosImage;
use cpu::internals::math::tangent::tangent;
use cpu::reference::intersect::Exact;
use cpu::{Aos, Config, Scatter, Scene};
use generator::cameras::hard_camera;
use generator::{self, Options};
use libtest_mimic::{Arguments, Failed, Trial};
use test_support::folder::Folder;
use test_support::golden::{self, Golden};
use test_support::p3;

/// The name of the compiler. It must be g++, because the digests depend on the random distributions of its library,
/// libstdc++.
const COMPILER: &str = "g++";

/// A check that takes the path of the built program.
type Check = Box<dyn FnOnce(&Path) -> Result<(), Failed> + Send>;

fn main() {
    let arguments = Arguments::from_args();
    let cases = golden::cases();
    assert_eq!(cases.len(), 32, "16 scenes in both conventions");
    let runs = Command::new(COMPILER).arg("--version").output().is_ok_and(|output| output.status.success());

    let folder = Folder::new();
    // The program is built once for all tests. It is not built if the names of the tests are only listed.
    let program = if runs && !arguments.list { build(folder.path()) } else { Err("it was not built".to_owned()) };
    let program = Arc::new(program);
    let trial = |name: String, check: Check| {
        let program = Arc::clone(&program);
        let trial = Trial::test(name, move || check(program.as_ref().as_ref().map_err(Clone::clone)?));
        if runs { trial } else { trial.with_kind("needs g++").with_ignored_flag(true) }
    };
    let of_case = |golden: Golden| {
        let name = format!("case {} by the literal program", golden.name);
        trial(name, Box::new(move |program| has_its_digest(&golden, program)))
    };
    let mut trials: Vec<_> = cases.into_iter().map(of_case).collect();
    trials.push(trial("random scenes by the literal program".to_owned(), Box::new(renders_random_scenes)));
    trials.push(trial("hard cameras by the literal program".to_owned(), Box::new(renders_hard_cameras)));
    let conclusion = libtest_mimic::run(&arguments, trials);
    // `exit` runs no destructors, so the folder is removed here.
    drop(folder);
    conclusion.exit();
}

/// Builds the program in `folder`, and returns its path.
fn build(folder: &Path) -> Result<PathBuf, String> {
    let program = folder.join("literal");
    let mut compiler = Command::new(COMPILER);
    // A fused multiply-add rounds once instead of twice, which would change bytes of the picture. So contraction is
    // switched off.
    compiler.args(["-std=c++20", "-O2", "-ffp-contract=off", "-o"]).arg(&program);
    compiler.arg(test_support::project_root().join("tests/literal/literal.cpp"));
    check(&compiler.output().map_err(|error| error.to_string())?)?;
    Ok(program)
}

fn has_its_digest(golden: &Golden, program: &Path) -> Result<(), Failed> {
    let folder = Folder::new();
    let out = folder.file("out.ppm");
    let mut command = Command::new(program);
    command.args([&golden.config, &golden.scene, &out]);
    if golden.scatter == Scatter::Published {
        command.arg("published");
    }
    check(&command.output()?)?;
    let bytes = std::fs::read(out)?;
    p3::read(&bytes)?;
    let (actual, expected) = (digest::sha256(&bytes), golden.digest()?);
    if actual == expected { Ok(()) } else { Err(format!("{actual} instead of {expected}").into()) }
}

/// The number of random scenes of each kind.
fn scenes() -> Result<u64, Failed> {
    Ok(std::env::var("RENDER_LITERAL_SCENES").map_or(Ok(200), |text| text.parse())?)
}

/// Renders scenes with the literal program.
struct Literal<'a> {
    program: &'a Path,
    folder: Folder,
}

impl Literal<'_> {
    /// Returns the literal program's picture, and the configuration and scene that it has read. They are read back from
    /// the files, so that all programs render the numbers in the files.
    fn render(&self, config: &Config, scene: &Scene, scatter: Scatter) -> Result<(Vec<u8>, Config, Scene), Failed> {
        let [config_file, scene_file, out] = ["config.txt", "scene.txt", "out.ppm"].map(|name| self.folder.file(name));
        std::fs::write(&config_file, generator::write::config(config))?;
        std::fs::write(&scene_file, generator::write::scene(scene))?;
        let mut command = Command::new(self.program);
        command.args([&config_file, &scene_file, &out]);
        if scatter == Scatter::Published {
            command.arg("published");
        }
        check(&command.output()?)?;
        Ok((std::fs::read(&out)?, Config::read(&config_file)?, Scene::read(&scene_file)?))
    }
}

/// Checks with random ordinary scenes that the reference with the plain formulas, and the renderer, give the literal
/// program's bytes.
///
/// The renderer's intersections are exact. So with other scenes it could differ if rounding decides whether the literal
/// program's ray hits. In 10,000 of these scenes there is no difference.
fn renders_random_scenes(program: &Path) -> Result<(), Failed> {
    let (scenes, literal) = (scenes()?, Literal { program, folder: Folder::new() });
    let mut with_objects = 0;
    for seed in 1..=scenes {
        let options = Options { seed, objects: (seed % 50) as usize, ..Options::default() };
        let scene = generator::scene(&options);
        let config = Config {
            image_width: 8 + seed % 5,
            samples_per_pixel: 1 + seed % 3,
            max_depth: 1 + seed % 9,
            material_rng_seed: seed,
            ray_rng_seed: 3 * seed + 1,
            ..generator::view(&options)
        };
        let scatter = if seed % 2 == 0 { Scatter::Statement } else { Scatter::Published };
        let (literal, config, scene) = literal.render(&config, &scene, scatter)?;
        let reference = |scene: &Scene| cpu::reference::render::<AosImage>(&config, scene, scatter);
        let rendered = [("reference", reference(&scene)?), ("renderer", cpu::render::<Aos>(&config, &scene, scatter)?)];
        for (name, image) in &rendered {
            if p3_of(image)? != literal {
                return Err(format!("the {name} differs from the literal program: scene {seed}, {scatter:?}").into());
            }
        }
        with_objects += u64::from(p3_of(&reference(&Scene::default())?)? != literal);
    }
    println!("{with_objects} of {scenes} pictures show an object");
    if 2 * with_objects > scenes { Ok(()) } else { Err("most pictures show no object".into()) }
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

/// Checks with random [hard cameras](hard_camera) that the reference with the plain formulas gives the literal
/// program's bytes, and that the renderer gives them too where the plain formulas decide as exact arithmetic does.
fn renders_hard_cameras(program: &Path) -> Result<(), Failed> {
    let (scenes, literal) = (scenes()?, Literal { program, folder: Folder::new() });
    let (mut rendered, mut sound, mut with_objects) = (0, 0, 0);
    for seed in 1..=scenes {
        let (scene, config) = hard_camera(seed, (seed % 12) as usize);
        if !has_sound_window(&config) {
            continue;
        }
        let scatter = if seed % 2 == 0 { Scatter::Statement } else { Scatter::Published };
        let (literal, config, scene) = literal.render(&config, &scene, scatter)?;
        let plain = cpu::reference::render::<AosImage>(&config, &scene, scatter)?;
        if p3_of(&plain)? != literal {
            let files = test_support::agreement::files(&config, &scene);
            return Err(
                format!("the reference differs from the literal program: camera {seed}, {scatter:?}\n{files}").into()
            );
        }
        rendered += 1;
        let exact = cpu::reference::render_with::<AosImage, Exact>(&config, &scene, scatter)?;
        if p3_of(&exact)? == literal {
            sound += 1;
            if p3_of(&cpu::render::<Aos>(&config, &scene, scatter)?)? != literal {
                return Err(format!("the renderer differs from the literal program: camera {seed}").into());
            }
            let background = cpu::reference::render::<AosImage>(&config, &Scene::default(), scatter)?;
            with_objects += u64::from(p3_of(&background)? != literal);
        }
    }
    println!(
        "{rendered} of {scenes} cameras have a sound window; with {sound} the plain formulas decide, {with_objects} show objects"
    );
    if 2 * sound > scenes && 4 * with_objects > scenes { Ok(()) } else { Err("too few scenes were compared".into()) }
}

/// Returns `image` as the bytes of a P3 file.
fn p3_of(image: &AosImage) -> std::io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    cpu::internals::image::ppm::write_ppm(image, &mut bytes)?;
    Ok(bytes)
}

/// Returns an error unless a command has succeeded and printed nothing.
fn check(output: &Output) -> Result<(), String> {
    let silent = output.stdout.is_empty() && output.stderr.is_empty();
    if output.status.success() && silent { Ok(()) } else { Err(format!("{output:?}")) }
}
