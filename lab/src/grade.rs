//! Grades the programs of a folder: checks them, measures them in turn, and adds points.

pub mod file;
pub mod page;

use std::fs;
use std::path::Path;

use cpu::Config;
use cpu::internals::input::reader::read;
use cpu::internals::input::text::MAX_FILE_BYTES;
use measure::statistics::Median;
use serde::Serialize;

use crate::bench::commands::{Job, Rounds, Timed};
use crate::bench::scenes;
use crate::check::Report;
use crate::check::cases::{Case, Group, picture};
use crate::supervise::{self, Limits};
use crate::{Failure, sources, terminal};
use file::{File, Weights};

/// The longest time of a build, in seconds.
const BUILD: f64 = 600.0;

/// The start of the names of the folders for the scenes whose time is measured.
const TIMED: &str = "timed-";

/// What a program did, and its points.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Graded {
    /// Its name.
    pub program: String,
    /// What it did with the cases of [`crate::check`], or `None` if it could not be built or started.
    pub report: Option<Report>,
    /// What it took for each scene; nothing if it did not make the right picture.
    pub times: Vec<Option<Timed>>,
    /// The points from 0 to 10 of the messages, the pictures, the time, and the energy if there is a meter.
    pub points: [Option<f64>; 4],
    /// The weighted mean of the points.
    pub total: f64,
    /// The reasons why there is no report, or no time of a scene.
    pub problems: Vec<String>,
}

/// All programs, with the names of the scenes whose time was measured.
#[derive(Clone, Debug, Serialize)]
pub struct Grades {
    /// Names of the scenes.
    pub scenes: Vec<String>,
    /// The programs, in the order of their names in the file or the folder.
    pub programs: Vec<Graded>,
}

/// The groups of cases that the points for messages and for pictures depend on.
const GROUPS: [[Group; 2]; 2] = [[Group::Arguments, Group::Messages], [Group::Pictures, Group::Course]];

impl Graded {
    /// Returns the value, or keeps the message of an error as a problem: one program may not end the grading of all.
    ///
    /// # Errors
    /// [`Failure::Interrupted`].
    fn keep<T>(&mut self, result: Result<T, Failure>) -> Result<Option<T>, Failure> {
        match result {
            Ok(value) => Ok(Some(value)),
            Err(Failure::Interrupted) => Err(Failure::Interrupted),
            Err(failure) => {
                self.problems.extend(failure.message());
                Ok(None)
            }
        }
    }

    /// Returns the number of passed cases of the groups, and the number of all.
    fn passed(&self, groups: [Group; 2]) -> [usize; 2] {
        let counts = self.report.iter().flat_map(|report| groups.map(|group| report.passed(group)));
        counts.fold([0, 0], |sum, counts| [sum[0] + counts[0], sum[1] + counts[1]])
    }
}

impl Grades {
    /// Builds, checks and measures the programs of `folder`. The files of the cases are written below `kept`.
    ///
    /// # Errors
    /// A file of the folder is wrong, or [`Failure::Interrupted`].
    pub fn of(folder: &Path, cases: &[Case], limits: &Limits, rounds: &Rounds, kept: &Path) -> Result<Self, Failure> {
        let folder = &std::path::absolute(folder)?;
        let file = File::read(folder)?;
        let scenes = timed_scenes(folder, &file)?;
        let mut programs = Vec::new();
        for program in &file.program {
            let (job, place) = (program.job(folder), kept.join(&program.name));
            let mut graded = Graded { program: program.name.clone(), ..Graded::default() };
            let built = program.build_job(folder).map_or(Ok(()), |build| built(&build, &place));
            graded.report = graded.keep(built.and_then(|()| Report::of(&job, cases, limits, &place)))?;
            programs.push(graded);
        }
        for scene in &scenes {
            let mut ready = Vec::new();
            for (graded, program) in programs.iter_mut().zip(&file.program) {
                let (job, place) = (program.job(folder), kept.join(&graded.program).join(&scene.name));
                let Some(convention) = graded.report.as_ref().map(|report| report.convention) else {
                    ready.push(None);
                    continue;
                };
                let outcome = scene.run(&job, &place, limits).map_err(|error| error.about(scene_name(scene)));
                // The time of a picture that the course does not accept says nothing.
                let compared = graded.keep(outcome)?.and_then(Result::ok);
                let is_right = compared.is_some_and(|compared| compared[convention].difference.accepted);
                ready.push(is_right.then(|| Job { words: scene.command(&job, &place), ..job }));
            }
            let measured: Vec<_> = ready.iter().flatten().cloned().collect();
            let mut measured = rounds.measure(&measured, limits, false)?.into_iter();
            for (graded, job) in programs.iter_mut().zip(ready) {
                let timed = job.and_then(|_| measured.next()).transpose();
                let timed = timed.map_err(|message| format!("{}: {message}", scene_name(scene)).into());
                let timed = graded.keep(timed)?;
                graded.times.push(timed.flatten());
            }
        }
        add_points(&mut programs, &file);
        Ok(Self { scenes: scenes.iter().map(|scene| scene_name(scene).to_owned()).collect(), programs })
    }
}

/// Returns the name of a scene without the start of its folder's name.
fn scene_name(scene: &Case) -> &str {
    scene.name.strip_prefix(TIMED).unwrap_or(&scene.name)
}

/// Builds a program.
fn built(build: &Job, printed: &Path) -> Result<(), Failure> {
    fs::create_dir_all(printed)?;
    let limits = Limits { seconds: BUILD, ..supervise::NONE };
    build.run(printed, &limits).map(drop).map_err(|failure| failure.about("it cannot be built"))
}

/// Returns the scenes whose time is measured: those of the file, or two small ones.
fn timed_scenes(folder: &Path, file: &File) -> Result<Vec<Case>, Failure> {
    let case = |name: &str, files: [Vec<u8>; 2]| picture(format!("{TIMED}{name}"), Group::Course, files, [None, None]);
    let read = |path: &Path| {
        let bytes = sources::regular(path).and_then(|path| read(path, MAX_FILE_BYTES));
        bytes.map_err(|error| format!("{}: {error}", terminal::name(path)))
    };
    if !file.scene.is_empty() {
        let scene = |timed: &file::Timed| {
            let [config, scene] = [&timed.config, &timed.scene].map(|file| folder.join(file));
            let files = [read(&config)?, read(&scene)?];
            sources::config(&config, &[])?;
            sources::scene(&scene)?;
            let case = case(&timed.name, files);
            // A wrong scene would give no points to all programs.
            case.expected_pictures().map_err(|error| error.about(&format!("scene [{}]", timed.name)))?;
            Ok(case)
        };
        return file.scene.iter().map(scene).collect();
    }
    // A scene of the repository that this program contains, in a small picture.
    let contained = |name: &str| {
        let (config, scene) = scenes::named(name)?;
        let config = Config { image_width: 240, samples_per_pixel: 16, ..config };
        Some(case(name, [generator::write::config(&config), generator::write::scene(&scene)].map(Into::into)))
    };
    Ok(["materials", "grid"].into_iter().filter_map(contained).collect())
}

/// Computes the points of all programs.
fn add_points(programs: &mut [Graded], file: &File) {
    let given: Vec<_> = file.scene.iter().map(|scene| [scene.reference, scene.zero]).collect();
    let times = means(programs, &given, |timed| Some(timed.median.median)).unwrap_or(vec![0.0; programs.len()]);
    let energies = means(programs, &[], |timed| Some(timed.joules?.median));
    let Weights { messages, pictures, time, energy } = file.points;
    for (index, graded) in programs.iter_mut().enumerate() {
        let share = |[passed, all]: [usize; 2]| Some(10.0 * passed as f64 / all.max(1) as f64);
        let checks = GROUPS.map(|groups| share(graded.passed(groups)));
        graded.points = [checks[0], checks[1], Some(times[index]), energies.as_ref().map(|energies| energies[index])];
        let weights = [messages, pictures, time, energy];
        let parts = || graded.points.iter().zip(weights).filter_map(|(points, weight)| Some(((*points)?, weight)));
        let total: f64 = parts().map(|(_, weight)| weight).sum();
        graded.total = parts().map(|(points, weight)| points * weight).sum::<f64>() / total;
    }
}

/// Returns the mean points of each program for a figure of its scenes, or `None` if no program has the figure. `given`
/// has the figures of each scene with 5 points and with none, where they are given.
fn means(programs: &[Graded], given: &[[Option<f64>; 2]], figure: fn(&Timed) -> Option<f64>) -> Option<Vec<f64>> {
    let scenes = programs.first()?.times.len();
    let mut means = vec![0.0; programs.len()];
    let mut is_known = false;
    for scene in 0..scenes {
        let figures: Vec<_> = programs.iter().map(|graded| figure(graded.times[scene].as_ref()?)).collect();
        let known: Vec<f64> = figures.iter().copied().flatten().collect();
        if known.is_empty() {
            continue;
        }
        is_known = true;
        let [reference, zero] = given.get(scene).copied().unwrap_or_default();
        let reference = reference.unwrap_or_else(|| Median::of(&known).median);
        let zero = zero.unwrap_or(4.0 * reference);
        for (mean, figure) in means.iter_mut().zip(figures) {
            *mean += figure.map_or(0.0, |figure| scaled(figure, reference, zero)) / scenes as f64;
        }
    }
    is_known.then_some(means)
}

/// Returns the points of a time or an energy: 5 for the reference, 0 for `zero`, and equally many more each time that
/// it is divided by the same factor. At most 10.
fn scaled(value: f64, reference: f64, zero: f64) -> f64 {
    /// The clock of user time may count nothing for a tiny picture.
    const LEAST: f64 = 1e-6;
    match (value.max(LEAST), reference.max(LEAST)) {
        (value, _) if value >= zero => 0.0,
        (_, reference) if reference >= zero => 10.0,
        (value, reference) => (5.0 * (zero / value).ln() / (zero / reference).ln()).min(10.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_reference_has_half_the_points() {
        let points = [0.01, 0.25, 0.5, 1.0, 2.0, 4.0, 9.0].map(|value| scaled(value, 1.0, 4.0));
        assert_eq!(points, [10.0, 10.0, 7.5, 5.0, 2.5, 0.0, 0.0]);
        assert_eq!([scaled(0.0, 0.0, 1.0), scaled(1.0, 3.0, 2.0), scaled(0.0, 0.0, 0.0)], [5.0, 10.0, 0.0]);
    }
}
