//! The literal program in C++ (`tests/literal`), built here, gives the bytes whose digests `tests/cases` has.
//!
//! So those digests can be made again from what is in the repository, and the program that times are held against is
//! one that renders the same pictures. It also renders random ordinary scenes, 200 or `RENDER_LITERAL_SCENES` of them,
//! which the reference and the renderer are held against. Where there is no g++ the tests are shown as ignored.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::Arc;

use cpu::internals::layout::aos::AosImage;
use cpu::{Aos, Config, Scatter, Scene};
use libtest_mimic::{Arguments, Failed, Trial};
use test_support::generator::{self, Options};
use test_support::golden::{self, Golden};
use test_support::{digest, p3};

/// Not any C++ compiler: the digests rest on the distributions of its library.
const COMPILER: &str = "g++";

/// What a trial does with the built program.
type Check = Box<dyn FnOnce(&Path) -> Result<(), Failed> + Send>;

fn main() {
    let arguments = Arguments::from_args();
    let cases = golden::cases();
    assert_eq!(cases.len(), 32, "16 scenes in both conventions");
    let runs = Command::new(COMPILER).arg("--version").output().is_ok_and(|output| output.status.success());

    let folder = tempfile::tempdir().expect("the temporary folder is writable");
    // Built once, before the tests that share it; a list of names needs no program.
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
    let conclusion = libtest_mimic::run(&arguments, trials);
    // Leaving the process drops nothing.
    drop(folder);
    conclusion.exit();
}

/// Builds the program in `folder`.
fn build(folder: &Path) -> Result<PathBuf, String> {
    let program = folder.join("literal");
    let mut compiler = Command::new(COMPILER);
    // A product and a sum that are rounded once give other bytes than two operations.
    compiler.args(["-std=c++20", "-O2", "-ffp-contract=off", "-o"]).arg(&program);
    compiler.arg(test_support::project_root().join("tests/literal/literal.cpp"));
    check(&compiler.output().map_err(|error| error.to_string())?)?;
    Ok(program)
}

fn has_its_digest(golden: &Golden, program: &Path) -> Result<(), Failed> {
    let folder = tempfile::tempdir()?;
    let out = folder.path().join("out.ppm");
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

/// The literal program, the reference with the plain formulas, and the renderer on random ordinary scenes.
///
/// Both must give the literal program's bytes. The renderer's intersections are certified, so on other scenes it might
/// differ where rounding decides a ray for the literal program; in 10,000 of these scenes it does not.
fn renders_random_scenes(program: &Path) -> Result<(), Failed> {
    let scenes: u64 = std::env::var("RENDER_LITERAL_SCENES").map_or(Ok(200), |text| text.parse())?;
    let folder = tempfile::tempdir()?;
    let [config_file, scene_file, out] = ["config.txt", "scene.txt", "out.ppm"].map(|name| folder.path().join(name));
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
        std::fs::write(&config_file, test_support::write::config(&config))?;
        std::fs::write(&scene_file, test_support::write::scene(&scene))?;
        let mut command = Command::new(program);
        command.args([&config_file, &scene_file, &out]);
        if scatter == Scatter::Published {
            command.arg("published");
        }
        check(&command.output()?)?;
        let literal = std::fs::read(&out)?;
        // What is rendered here is what was read from the files.
        let (config, scene) = (Config::read(&config_file)?, Scene::read(&scene_file)?);
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

/// The picture as a file's bytes.
fn p3_of(image: &AosImage) -> std::io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    cpu::internals::image::ppm::write_ppm(image, &mut bytes)?;
    Ok(bytes)
}

/// Both commands succeed without a word.
fn check(output: &Output) -> Result<(), String> {
    let silent = output.stdout.is_empty() && output.stderr.is_empty();
    if output.status.success() && silent { Ok(()) } else { Err(format!("{output:?}")) }
}
