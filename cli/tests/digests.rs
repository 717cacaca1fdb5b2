//! Compares whole pictures with digests that other programs made. The scenes are those of `tests/cases` and of the
//! reference folder. Pictures with `Scatter::Statement` are rendered by the built programs, those with
//! `Scatter::Published` through the library. Every picture is rendered with both layouts.
//!
//! If there is no reference folder, the tests of its pictures are shown as ignored. The programs are those in the
//! folder `RENDER_PROGRAMS`, or else those that Cargo built with this test. A debug build is too slow for the course's
//! pictures 3 and 4, so `RENDER_ALL=1` asks for these.

use std::path::{Path, PathBuf};

use cpu::{Aos, Config, Renderable, Scatter, Scene, Soa};
use libtest_mimic::{Failed, Trial};
use test_support::folder::Folder;
use test_support::golden::{self, Golden};
use test_support::{everything, p3, ppm};

/// One layout's two ways to render: the built program, and the function of the library.
#[derive(Clone, Copy)]
struct Renderer {
    program: &'static str,
    path: &'static str,
    library: fn(&Golden) -> Result<Vec<u8>, Failed>,
}

const RENDERERS: [Renderer; 2] = [
    Renderer { program: "render-aos", path: env!("CARGO_BIN_EXE_render-aos"), library: through_the_library::<Aos> },
    Renderer { program: "render-soa", path: env!("CARGO_BIN_EXE_render-soa"), library: through_the_library::<Soa> },
];

fn main() {
    let folder = golden::reference_folder();
    let obstacle = obstacle(&folder);
    let cases = golden::cases();
    let reference = golden::reference(&folder);
    assert_eq!((cases.len(), reference.len()), (32, 8), "no picture is left out");

    let mut conformance = trials("reference", &reference);
    let mut trials = trials("case", &cases);
    let ignored = |trial: Trial| {
        let is_optimised = !cfg!(debug_assertions) || is_of_programs(&trial) && programs().is_some();
        let is_long = ["/3.ppm", "/4.ppm"].iter().any(|name| trial.name().contains(name));
        let slow = (is_long && !is_optimised && !everything()).then_some("a debug build needs RENDER_ALL=1");
        let reason = obstacle.as_deref().or(slow);
        trial.with_kind(reason.unwrap_or_default()).with_ignored_flag(reason.is_some())
    };
    conformance = conformance.into_iter().map(ignored).collect();
    trials.extend(conformance);
    let of_programs = trials.iter().filter(|&trial| is_of_programs(trial)).count();
    assert_eq!((trials.len(), of_programs), (2 * 32 + 2 * 8, 40), "one of two scatters is that of the programs");
    test_support::run_trials(trials)
}

/// Whether the picture is rendered by a built program, and not through the library.
fn is_of_programs(trial: &Trial) -> bool {
    trial.name().contains("statement/")
}

/// The folder of the programs to test instead of those that Cargo built with this test.
fn programs() -> Option<PathBuf> {
    std::env::var_os("RENDER_PROGRAMS").map(PathBuf::from)
}

/// Returns the reason why the reference pictures cannot be rendered, or `None` if they can.
fn obstacle(folder: &Path) -> Option<String> {
    (!folder.is_dir()).then(|| format!("needs RENDER_REFERENCE_DIR: no folder {}", folder.display()))
}

fn trials(set: &str, goldens: &[Golden]) -> Vec<Trial> {
    let both = |golden: &Golden| RENDERERS.map(|renderer| (golden.clone(), renderer));
    let trial = |(golden, renderer): (Golden, Renderer)| {
        let name = format!("{set} {} by {}", golden.name, renderer.program);
        Trial::test(name, move || has_its_digest(&golden, renderer))
    };
    goldens.iter().flat_map(both).map(trial).collect()
}

fn has_its_digest(golden: &Golden, renderer: Renderer) -> Result<(), Failed> {
    let expected = golden.digest()?;
    let bytes = match golden.scatter {
        Scatter::Statement => {
            let path = programs().map_or(renderer.path.into(), |folder| folder.join(renderer.program));
            through_the_program(golden, &path)?
        }
        _ => (renderer.library)(golden)?,
    };
    p3::read(&bytes)?;
    let actual = format::digest::sha256(&bytes);
    if actual == expected { Ok(()) } else { Err(format!("{actual} instead of {expected}").into()) }
}

fn through_the_program(golden: &Golden, program: &Path) -> Result<Vec<u8>, Failed> {
    let folder = Folder::new();
    let out = folder.file("out.ppm");
    let output = test_support::running::program(program).args([&golden.config, &golden.scene, &out]).output()?;
    if !output.status.success() || !output.stdout.is_empty() || !output.stderr.is_empty() {
        return Err(format!("{output:?}").into());
    }
    Ok(std::fs::read(out)?)
}

fn through_the_library<L: Renderable>(golden: &Golden) -> Result<Vec<u8>, Failed> {
    let (config, scene) = (Config::read(&golden.config)?, Scene::read(&golden.scene)?);
    Ok(ppm(&cpu::render::<L>(&config, &scene, golden.scatter)?))
}
