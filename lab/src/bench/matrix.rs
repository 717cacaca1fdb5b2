//! Lists everything that `bench all` measures, as tasks that different nodes of a cluster can run.

mod times;

use std::path::PathBuf;
use std::time::Duration;

use cpu::{Config, Scene};
use generator::{self, Arrangement, Options};

use super::energy::{self, Meter};
use super::error;
use super::intersections::{self, OBJECTS};
use super::results::{Omitted, Results, Setting};
use super::scenes;
use crate::engine::Engine;
use crate::interrupt::Interrupt;
use crate::{Failure, sources};

/// A task: one part of the matrix, which is everything that `bench all` measures.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Task {
    /// Measures the time for rising values of a parameter: `width`, `samples`, `depth`, `objects` or `density`.
    Scale(&'static str),
    /// Measures, for this scene, the error and the time of every engine for each number of samples.
    Error(&'static str),
    /// Measures the time and the error of intersections with this kind of object.
    Intersection(&'static str),
    /// Measures the time of this scene's picture, each time without one optimisation.
    Gain(&'static str),
    /// Measures the energy of this scene's picture.
    Energy(&'static str),
}

impl std::fmt::Display for Task {
    fn fmt(&self, out: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Scale(parameter) => write!(out, "scale {parameter}"),
            Self::Error(scene) => write!(out, "error {scene}"),
            Self::Intersection(object) => write!(out, "intersection {object}"),
            Self::Gain(scene) => write!(out, "gain {scene}"),
            Self::Energy(scene) => write!(out, "energy {scene}"),
        }
    }
}

/// Name of a generated scene with many objects.
pub const BOARD: &str = "board";

/// Number of objects of [`BOARD`] where their number does not vary.
pub const BOARD_OBJECTS: u64 = 1024;

/// Names of the course's four cases. Their files are in a folder that is not part of this project.
const CASES: [&str; 4] = ["case-1", "case-2", "case-3", "case-4"];

/// Name of the scene in which width, samples and depth are varied. For the other parameters, scenes are generated.
const SCALED: &str = "materials";

/// Names of the parameters of [`Task::Scale`]. With `objects`, the camera keeps a distance of a few squares from the
/// near edge of the board, so additional objects are farther away. With `density`, the camera does not move, so more
/// objects are smaller objects in the same view.
pub const PARAMETERS: [&str; 5] = ["width", "samples", "depth", "objects", "density"];

/// Returns all tasks in a fixed order. `--part` chooses tasks by their position in it.
#[must_use]
pub fn tasks() -> Vec<Task> {
    let scale = PARAMETERS.map(Task::Scale);
    let gains = scenes::NAMES.into_iter().chain([BOARD]).chain(CASES).map(Task::Gain);
    scale
        .into_iter()
        .chain(scenes::NAMES.map(Task::Error))
        .chain(OBJECTS.map(Task::Intersection))
        .chain(gains)
        .chain(scenes::NAMES.map(Task::Energy))
        .collect()
}

fn scene(name: &str) -> Result<(Config, Scene), Failure> {
    Ok(scenes::named(name).ok_or_else(|| format!("there is no scene [{name}]"))?)
}

/// Options for the tasks: how much to measure, and where the course's cases are.
#[derive(Clone, Debug)]
pub struct Plan {
    /// Whether to measure the small matrix, with smaller pictures and fewer values.
    pub quick: bool,
    /// Number of measurements of each time.
    pub repeats: usize,
    /// Whether to subtract the power of the idle machine from energies.
    pub idle: bool,
    /// The folder of the course's cases, with `config1.txt`, `scene1.txt` and so on. `None` if their gains are not
    /// measured.
    pub reference: Option<PathBuf>,
}

impl Plan {
    /// Returns the width of pictures in pixels, for all tasks that do not vary the width.
    const fn width(&self) -> u64 {
        if self.quick { 96 } else { 240 }
    }

    /// Returns the longest time in seconds that one picture may take. A picture with a longer predicted time is left
    /// out.
    const fn patience(&self) -> f64 {
        if self.quick { 0.7 } else { 4.0 }
    }

    fn values(&self, parameter: &str) -> Vec<u64> {
        let powers = |from: u32, to: u32| (from..=to).map(|power| 1 << power).collect();
        match (parameter, self.quick) {
            ("width", true) => vec![32, 64, 128, 256],
            ("width", false) => vec![64, 128, 256, 512, 1024],
            ("samples", true) => powers(0, 5),
            ("samples", false) => powers(0, 8),
            ("depth", true) => powers(0, 5),
            ("depth", false) => powers(0, 8),
            ("density", true) => vec![1000, 2000, 4000, 8000],
            ("density", false) => vec![1000, 3162, 10_000, 31_623, 100_000],
            (_, true) => vec![4, 16, 64, 256, 1024, 4096],
            (_, false) => vec![4, 16, 64, 256, 1024, 4096, 16_384],
        }
    }

    /// Returns whether a task has nothing to measure, because the folder of the course's cases was not given.
    #[must_use]
    pub fn is_empty(&self, task: &Task) -> bool {
        self.reference.is_none() && matches!(task, Task::Gain(scene) if CASES.contains(scene))
    }

    /// Measures a task, and adds its figures to `results`.
    ///
    /// # Errors
    /// An error if a scene cannot be read or the pictures of two engines differ, or [`Failure::Interrupted`].
    pub fn run(&self, task: &Task, results: &mut Results, interrupt: &Interrupt) -> Result<(), Failure> {
        match task {
            Task::Scale(parameter) => self.scale(parameter, results, interrupt),
            Task::Error(scene) => self.error(scene, results, interrupt),
            Task::Intersection(object) => {
                let count = if self.quick { 2_000 } else { 20_000 };
                let found = intersections::measure(object, count, self.repeats, interrupt)?;
                results.intersections.extend(found);
                Ok(())
            }
            Task::Gain(scene) => self.gain(scene, results, interrupt),
            Task::Energy(scene) => self.energy(scene, results, interrupt),
        }
    }

    fn scale(&self, parameter: &str, results: &mut Results, interrupt: &Interrupt) -> Result<(), Failure> {
        let (base, scene) = scene(SCALED)?;
        let base = Config { image_width: self.width(), samples_per_pixel: 4, max_depth: 8, ..base };
        let pictures = self.values(parameter).into_iter().map(|value| match parameter {
            "width" => (value, Config { image_width: value, ..base.clone() }, scene.clone()),
            "samples" => (value, Config { samples_per_pixel: value, ..base.clone() }, scene.clone()),
            "depth" => (value, Config { max_depth: value, ..base.clone() }, scene.clone()),
            "density" => (value, board(1000, self.width()).0, board(value, self.width()).1),
            _ => {
                let (config, scene) = board(value, self.width());
                (value, config, scene)
            }
        });
        let name = if matches!(parameter, "objects" | "density") { BOARD } else { SCALED };
        self.times(["scale", name, parameter], &Engine::main(), pictures, results, interrupt)
    }

    fn error(&self, name: &str, results: &mut Results, interrupt: &Interrupt) -> Result<(), Failure> {
        let (config, scene) = scene(name)?;
        let config = Config { image_width: self.width(), ..config };
        let samples: Vec<u64> = (0..=if self.quick { 5 } else { 6 }).map(|power| 1 << power).collect();
        // The converged picture has 64 times the samples of the finest picture, so its error is an eighth of that
        // picture's.
        let reference = 64 * samples.iter().max().copied().unwrap_or(1);
        results.curves.push(error::curve(name, &config, &scene, &samples, 5, reference, interrupt)?);
        let pictures = samples.into_iter().map(|samples| {
            let config = Config { samples_per_pixel: samples, ..config.clone() };
            (samples, config, scene.clone())
        });
        self.times(["error", name, "samples"], &Engine::all(), pictures, results, interrupt)
    }

    fn gain(&self, name: &str, results: &mut Results, interrupt: &Interrupt) -> Result<(), Failure> {
        let samples = if self.quick { 4 } else { 16 };
        let (config, scene) = match (CASES.iter().position(|case| *case == name), &self.reference) {
            (Some(_), None) => {
                let [suite, scene, parameter, engine] = ["gain", name, "samples", "all"].map(str::to_owned);
                let setting = Setting { suite, scene, parameter, value: 0, engine };
                let reason = "the folder of the course's cases was not given (--reference)".to_owned();
                results.omitted.push(Omitted { setting, reason });
                return Ok(());
            }
            (Some(index), Some(folder)) => {
                let file = |kind: &str| folder.join(format!("{kind}{}.txt", index + 1));
                (sources::config(&file("config"), &[])?, sources::scene(&file("scene"))?)
            }
            (None, _) => {
                if name == BOARD {
                    board(BOARD_OBJECTS, self.width())
                } else {
                    scene(name)?
                }
            }
        };
        let config = Config { image_width: self.width(), samples_per_pixel: samples, ..config };
        let picture = (samples, config, scene);
        self.times(["gain", name, "samples"], &Engine::changed(), [picture].into_iter(), results, interrupt)
    }

    fn energy(&self, name: &str, results: &mut Results, interrupt: &Interrupt) -> Result<(), Failure> {
        let (config, scene) = scene(name)?;
        let meter = Meter::here();
        let shortest = Duration::from_secs(if self.quick { 2 } else { 8 });
        for engine in Engine::main() {
            let names = [name, &engine.to_string()];
            results.energy.push(energy::measure(&meter, names, self.idle, shortest, || {
                interrupt.check()?;
                std::hint::black_box(engine.ppm(&config, &scene)?);
                Ok(())
            })?);
        }
        Ok(())
    }
}

/// Returns a scene of `objects` objects on the squares of a board, and a configuration with a camera near the edge of
/// the board and pictures of `width` pixels.
#[must_use]
pub fn board(objects: u64, width: u64) -> (Config, Scene) {
    let objects = usize::try_from(objects).unwrap_or(usize::MAX);
    let options = Options { objects, arrangement: Arrangement::Grid, materials: [3.0, 2.0, 1.0], ..Options::default() };
    let view = generator::view(&options);
    (Config { image_width: width, samples_per_pixel: 4, ..view }, generator::scene(&options))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parameters_rise() {
        for quick in [true, false] {
            let plan = Plan { quick, repeats: 1, idle: false, reference: None };
            for parameter in PARAMETERS {
                let values = plan.values(parameter);
                assert!(values.len() >= 4 && values.is_sorted_by(|a, b| a < b), "{parameter}: {values:?}");
            }
        }
    }
}
