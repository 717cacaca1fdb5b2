//! Grades the programs of a folder: checks them, measures them in turn, and adds points.

pub mod file;
pub mod page;
mod points;

use std::fs;
use std::path::Path;

use cpu::Config;
use cpu::internals::input::reader::read;
use cpu::internals::input::text::MAX_FILE_BYTES;
use serde::Serialize;

use crate::bench::commands::{Job, Rounds, Timed};
use crate::bench::scenes;
use crate::check::Report;
use crate::check::cases::{Case, Group, picture};
use crate::supervise::{self, End, Limits, PRINTED};
use crate::{Failure, sources, terminal};
use file::File;

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
                let job =
                    timed_job(scene, &program.job(folder), graded.report.as_ref(), &kept.join(&graded.program), limits);
                ready.push(graded.keep(job)?.flatten());
            }
            let measured: Vec<_> = ready.iter().flatten().cloned().collect();
            let mut measured = rounds.measure(&measured, limits, |_| Ok(()))?.into_iter();
            for (graded, job) in programs.iter_mut().zip(ready) {
                let timed = job.and_then(|_| measured.next()).transpose();
                let timed = timed.map_err(|message| format!("{}: {message}", scene_name(scene)).into());
                let timed = graded.keep(timed)?;
                graded.times.push(timed.flatten());
            }
        }
        points::add(&mut programs, &file);
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
    let run = supervise::run(&build.words, &build.place, printed, &Limits { seconds: BUILD, ..supervise::NONE })?;
    if run.end == End::Status(0) {
        return Ok(());
    }
    let said = supervise::start_of(&printed.join(PRINTED[1]));
    Err(format!("it cannot be built: {}\n{}", run.end, String::from_utf8_lossy(&said)).trim_end().into())
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
    let own = ["materials", "grid"].into_iter().filter_map(|name| Some((name, scenes::named(name)?)));
    Ok(own
        .map(|(name, (config, scene))| {
            let config = Config { image_width: 240, samples_per_pixel: 16, ..config };
            case(name, [generator::write::config(&config), generator::write::scene(&scene)].map(Into::into))
        })
        .collect())
}

/// Returns the job that renders a scene, or `None` if the course does not accept the picture. `report` is that of the
/// program, if it could be checked.
fn timed_job(
    scene: &Case,
    program: &Job,
    report: Option<&Report>,
    kept: &Path,
    limits: &Limits,
) -> Result<Option<Job>, Failure> {
    let Some(report) = report else { return Ok(None) };
    let place = kept.join(&scene.name);
    let outcome = scene.run(program, &place, limits).map_err(|error| error.about(scene_name(scene)))?;
    let is_right = outcome.is_ok_and(|compared| compared[report.convention].difference.accepted);
    Ok(is_right.then(|| Job { words: scene.command(program, &place), ..program.clone() }))
}
