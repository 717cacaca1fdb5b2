//! Lists everything that `bench all` measures, as tasks that different nodes of a cluster can run.

use cpu::{Config, Scene};
use generator::{self, Arrangement, Options};

use super::error;
use super::results::Results;
use super::scenes;
use crate::Failure;
use crate::engine::Engine;

/// A task: one part of the matrix, which is everything that `bench all` measures.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Task {
    /// Measures the time for rising values of a parameter: `width`, `samples`, `depth`, `objects` or `density`.
    Scale(&'static str),
    /// Measures, for this scene, the error and the time of every engine for each number of samples.
    Error(&'static str),
}

impl std::fmt::Display for Task {
    fn fmt(&self, out: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Scale(parameter) => write!(out, "scale {parameter}"),
            Self::Error(scene) => write!(out, "error {scene}"),
        }
    }
}

/// Name of a generated scene with many objects.
pub const BOARD: &str = "board";

/// Number of objects of [`BOARD`] where their number does not vary.
pub const BOARD_OBJECTS: u64 = 1024;

/// Name of the scene in which width, samples and depth are varied. For the other parameters, scenes are generated.
const SCALED: &str = "materials";

/// Names of the parameters of [`Task::Scale`]. With `objects`, the camera keeps a distance of a few squares from the
/// near edge of the board, so additional objects are farther away. With `density`, the camera does not move, so more
/// objects are smaller objects in the same view.
pub const PARAMETERS: [&str; 5] = ["width", "samples", "depth", "objects", "density"];

/// Returns all tasks in a fixed order. `--part` chooses tasks by their position in it.
pub fn tasks() -> Vec<Task> {
    let scale = PARAMETERS.map(Task::Scale);
    scale.into_iter().chain(scenes::NAMES.map(Task::Error)).collect()
}

fn scene(name: &str) -> Result<(Config, Scene), Failure> {
    Ok(scenes::named(name).ok_or_else(|| format!("there is no scene [{name}]"))?)
}

/// Options for the tasks.
#[derive(Clone, Debug)]
pub struct Plan {
    /// Whether to measure the small matrix, with smaller pictures and fewer values.
    pub quick: bool,
    /// Number of measurements of each time.
    pub repeats: usize,
}

impl Plan {
    /// Returns the width of pictures in pixels, for all tasks that do not vary the width.
    const fn width(&self) -> u64 {
        if self.quick { 96 } else { 240 }
    }

    /// Returns the longest time in seconds that one picture may take. A picture with a longer predicted time is left
    /// out.
    pub(super) const fn patience(&self) -> f64 {
        if self.quick { 0.7 } else { 4.0 }
    }

    fn values(&self, parameter: &str) -> Vec<u64> {
        match (parameter, self.quick) {
            ("width", true) => vec![32, 64, 128, 256],
            ("width", false) => vec![64, 128, 256, 512, 1024],
            ("samples" | "depth", quick) => (0..=if quick { 5 } else { 8 }).map(|power| 1 << power).collect(),
            ("density", true) => vec![1000, 2000, 4000, 8000],
            ("density", false) => vec![1000, 3162, 10_000, 31_623, 100_000],
            (_, true) => vec![4, 16, 64, 256, 1024, 4096],
            (_, false) => vec![4, 16, 64, 256, 1024, 4096, 16_384],
        }
    }

    /// Measures a task, and adds its figures to `results`.
    ///
    /// # Errors
    /// An error if a scene cannot be read or the pictures of two engines differ, or [`Failure::Interrupted`].
    pub fn run(&self, task: &Task, results: &mut Results) -> Result<(), Failure> {
        match task {
            Task::Scale(parameter) => self.scale(parameter, results),
            Task::Error(scene) => self.error(scene, results),
        }
    }

    fn scale(&self, parameter: &str, results: &mut Results) -> Result<(), Failure> {
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
        self.times(["scale", name, parameter], &Engine::main(), pictures, results)
    }

    fn error(&self, name: &str, results: &mut Results) -> Result<(), Failure> {
        let (config, scene) = scene(name)?;
        let config = Config { image_width: self.width(), ..config };
        let samples: Vec<u64> = (0..=if self.quick { 5 } else { 6 }).map(|power| 1 << power).collect();
        results.curves.push(error::curve(name, &config, &scene, &samples)?);
        let pictures = samples.into_iter().map(|samples| {
            let config = Config { samples_per_pixel: samples, ..config.clone() };
            (samples, config, scene.clone())
        });
        self.times(["error", name, "samples"], &Engine::all(), pictures, results)
    }
}

/// Returns a scene of `objects` objects on the squares of a board, and a configuration with a camera near the edge of
/// the board and pictures of `width` pixels.
pub fn board(objects: u64, width: u64) -> (Config, Scene) {
    let objects = usize::try_from(objects).unwrap_or(usize::MAX);
    let options = Options { objects, arrangement: Arrangement::Grid, materials: [3.0, 2.0, 1.0], ..Options::default() };
    let view = generator::view(&options);
    (Config { image_width: width, samples_per_pixel: 4, ..view }, generator::scene(&options))
}
