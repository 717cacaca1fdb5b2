//! Grades the programs of a folder: checks them, measures them in turn, and adds points.
//!
//! [`mod@file`] reads `grade.toml`, and [`teams`] finds the programs. [`Grading`] checks team by team and keeps each
//! result, so that it can go on after an interruption. [`points`] adds the points, [`page`] and [`handout`] show them.

pub mod file;
pub mod handout;
pub mod page;
pub mod points;
pub mod teams;

use std::collections::HashSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};

use cpu::Config;
use cpu::internals::input::reader::read;
use cpu::internals::input::text::MAX_FILE_BYTES;
use indicatif::ProgressBar;
use output::{Options, Output};
use serde::{Deserialize, Serialize};

use crate::bench::commands::{Job, Rounds, Timed};
use crate::bench::scenes;
use crate::check::cases::Case;
use crate::check::fault::Fault;
use crate::check::{Report, Verdict};
use crate::format::Words;
use crate::format::hint::Language;
use crate::supervise::{Limits, Run};
use crate::{Failure, sources, supervise, terminal};
use file::File;
use teams::{Entry, Team};

/// The limits of a build. Without a limit of memory, there would be none of the size of files either.
const BUILD: Limits = Limits { seconds: 600.0, memory: 16e3 };

/// The start of the names of the folders for the scenes whose time is measured.
const TIMED: &str = "timed-";

/// The file with what is known of a team, in its folder.
const STATE: &str = "state.json";

/// Why a time does not count.
const COPIED: Words = ["it wrote the picture of an earlier run", "ha escrito la imagen de una ejecución anterior"];

/// Most bytes of that file that are read.
const STATE_BYTES: u64 = 1 << 26;

/// What a program did.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct Graded {
    /// Its name.
    pub program: String,
    /// What it did with the cases of [`crate::check`], or `None` if it could not be built or started.
    pub report: Option<Report>,
    /// Why there is no report.
    pub not_graded: Option<String>,
    /// What it took for each scene, or why that is not known.
    pub times: Vec<Result<Timed, String>>,
}

/// A row of the results: a team, what its programs did, and its points.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    /// The name of the team.
    pub team: String,
    /// The name of the folder with its files.
    pub folder: String,
    /// Its programs.
    pub programs: Vec<Graded>,
    /// The points from 0 to 10 of the messages, the pictures, the time, and the energy if there is a meter.
    pub points: [Option<f64>; 4],
    /// The weighted mean of the points, without the penalty; `None` if the team was not graded.
    pub total: Option<f64>,
    /// The reasons of what is missing and of points that are 0.
    pub problems: Vec<String>,
}

/// All rows, with the names of the scenes whose time was measured.
#[derive(Clone, Debug, Serialize)]
pub struct Grades {
    /// Names of the scenes.
    pub scenes: Vec<String>,
    /// The rows, in the order of the teams in the file or the folder.
    pub teams: Vec<Row>,
}

/// How a folder is graded.
#[derive(Debug)]
pub struct Grading<'a> {
    /// The cases.
    pub cases: Vec<Case>,
    /// The limits of a run.
    pub limits: &'a Limits,
    /// How times are measured.
    pub rounds: &'a Rounds,
    /// The folder for the files of the cases.
    pub kept: &'a Path,
    /// The folder for the results of each team, if they are kept.
    pub results: Option<&'a Path>,
    /// Whether results in that folder count.
    pub resume: bool,
    /// Number of teams that are checked at a time.
    pub jobs: usize,
    /// Which of how many parts of the teams is checked, without times; `None` for all, with times.
    pub part: Option<(usize, usize)>,
    /// The language of the reasons.
    pub language: Language,
    /// How files are written.
    pub options: Options,
}

impl Grading<'_> {
    /// Builds, checks and measures the programs of `folder`.
    ///
    /// # Errors
    /// A file of the folder is wrong, this program cannot do its work, or [`Failure::Interrupted`].
    pub fn of(mut self, folder: &Path) -> Result<Grades, Failure> {
        let folder = &fs::canonicalize(folder).map_err(|error| format!("{}: {error}", terminal::name(folder)))?;
        let (file, mut teams) = File::read(folder)?;
        let is_skipped =
            |name: &str, skip: &String| skip.strip_suffix('*').map_or(name == skip, |start| name.starts_with(start));
        self.cases.retain(|case| !file.skip.iter().any(|skip| is_skipped(&case.name, skip)));
        for own in &file.case {
            let files = files(folder, [&own.config, &own.scene])?;
            let case = Case::picture(&*own.name, files, [own.maximum, own.rmse]);
            let mut case =
                case.map_err(|error| error.about(&format!("case [{}]", terminal::name(Path::new(&own.name)))))?;
            case.weight = own.weight;
            self.cases.push(case);
        }
        if let Some((part, parts)) = self.part {
            teams = teams.into_iter().skip(part - 1).step_by(parts).collect();
        }
        let scenes = timed_scenes(folder, &file)?;
        let mut checked = self.check_all(&teams)?;
        let is_timed = self.part.is_none() && file.points.time + file.points.energy > 0.0;
        for scene in scenes.iter().filter(|_| is_timed) {
            self.measure(scene, &teams, &mut checked)?;
        }
        let scenes: Vec<_> = scenes.iter().filter(|_| is_timed).map(|scene| scene_name(scene).to_owned()).collect();
        let rows = points::rows(&teams, checked, &scenes, &file, self.language);
        Ok(Grades { scenes, teams: rows })
    }

    /// Checks all teams, some of them at a time.
    fn check_all(&self, teams: &[Team]) -> Result<Vec<Vec<Graded>>, Failure> {
        let programs: usize = teams.iter().map(|team| team.programs.len()).sum();
        let bar = terminal::progress(programs * self.cases.len(), "cases");
        let next = AtomicUsize::new(0);
        let results: Vec<_> = teams.iter().map(|_| OnceLock::new()).collect();
        let work = || {
            loop {
                let index = next.fetch_add(1, Ordering::Relaxed);
                let Some(team) = teams.get(index) else { break };
                let result = self.check(team, &bar);
                if result.is_err() {
                    // Our own failure, or a request to stop, ends all work.
                    next.store(teams.len(), Ordering::Relaxed);
                }
                // No other thread has this index.
                let _ = results[index].set(result);
            }
        };
        std::thread::scope(|scope| {
            for _ in 1..self.jobs {
                scope.spawn(work);
            }
            work();
        });
        bar.finish_and_clear();
        let results: Vec<_> = results.into_iter().filter_map(OnceLock::into_inner).collect();
        let count = results.iter().filter(|result| result.is_ok()).count();
        match results.into_iter().collect::<Result<_, _>>() {
            Err(Failure::Interrupted) if self.results.is_some() => {
                let message = format!("{count} of {} teams are checked; --resume goes on", teams.len());
                Err(Failure::Kept { message, interrupted: true })
            }
            result => result,
        }
    }

    /// Builds and checks the programs of a team, or reads what an earlier run has found.
    fn check(&self, team: &Team, bar: &ProgressBar) -> Result<Vec<Graded>, Failure> {
        let kept = self.kept.join(&team.folder);
        let key = self.key(team);
        let state = self.results.map(|results| results.join(&team.folder).join(STATE));
        let known = state.as_ref().filter(|_| self.resume).and_then(|path| supervise::content(path, STATE_BYTES));
        if let Some((found, graded)) =
            known.and_then(|bytes| serde_json::from_slice::<(String, Vec<Graded>)>(&bytes).ok())
            && found == key
        {
            return Ok(graded);
        }
        let mut programs = Vec::new();
        for (number, Entry { job, build }) in team.programs.iter().enumerate() {
            let place = kept.join((number + 1).to_string());
            let job = Job { hidden: self.hidden(job), ..job.clone() };
            let mut graded = Graded { program: job.name.clone(), ..Graded::default() };
            let built = build.as_ref().map_or(Ok(()), |build| built(build, &place));
            let report = built.and_then(|()| Report::of(&job, &self.cases, self.limits, &place, bar));
            match Failure::of_program(report)? {
                Ok(report) => graded.report = Some(report),
                Err(message) => graded.not_graded = Some(message),
            }
            programs.push(graded);
        }
        if let Some(path) = state {
            path.parent().map_or(Ok(()), sources::make_folder)?;
            let text = serde_json::to_vec(&(key, &programs)).map_err(|error| error.to_string())?;
            Output::open(&path, self.options)?.fill(|file| file.write_all(&text))?;
        }
        Ok(programs)
    }

    /// Returns the digest of all that a result depends on, besides the programs.
    fn key(&self, team: &Team) -> String {
        let cases = self.cases.iter().map(|case| (&case.name, &case.files, format!("{:?}", case.expected)));
        let words = team.programs.iter().map(|entry| (&entry.job, &entry.build));
        let all = format!("{:?} {:?} {:?}", cases.collect::<Vec<_>>(), words.collect::<Vec<_>>(), self.limits);
        format::digest::sha256(all.as_bytes())
    }

    /// Returns the folders that a program does not see: those of other teams, and the files of their cases.
    fn hidden(&self, job: &Job) -> Vec<PathBuf> {
        let is_inside = job.place.starts_with(self.kept);
        job.hidden.iter().cloned().chain([self.kept.to_owned()].into_iter().filter(|_| !is_inside)).collect()
    }

    /// Measures a scene with all programs in turn. Every round has other seeds, so that a program cannot copy an
    /// earlier picture, and every picture is compared.
    fn measure(&self, scene: &Case, teams: &[Team], checked: &mut [Vec<Graded>]) -> Result<(), Failure> {
        let rounds = (0..self.rounds.all() as u64).map(|number| scene.seeded(number)).collect::<Result<Vec<_>, _>>()?;
        for case in &rounds {
            for convention in [0, 1] {
                case.expected(convention)?;
            }
        }
        let mut jobs = Vec::new();
        for (team, graded) in teams.iter().zip(checked.iter()) {
            for (number, (entry, graded)) in team.programs.iter().zip(graded).enumerate() {
                if let Some(report) = &graded.report {
                    let place = self.kept.join(&team.folder).join((number + 1).to_string()).join(&scene.name);
                    jobs.push((Job { hidden: self.hidden(&entry.job), ..entry.job.clone() }, place, report.convention));
                }
            }
        }
        let names: Vec<_> = jobs.iter().map(|(job, _, _)| job.name.clone()).collect();
        let mut seen = vec![HashSet::new(); jobs.len()];
        let run = |round: usize, index: usize| {
            let (job, place, convention): &(Job, PathBuf, usize) = &jobs[index];
            self.timed(&rounds[round], job, place, *convention, &mut seen[index])
        };
        let mut measured = self.rounds.measure(&names, run)?.into_iter();
        for graded in checked.iter_mut().flatten() {
            if graded.report.is_some() {
                graded.times.extend(measured.next());
            }
        }
        Ok(())
    }

    /// Runs a program once on a case whose time is measured. The result is a message if its picture is not accepted, or
    /// is the picture of an earlier round, whose digest is in `seen`.
    fn timed(
        &self,
        case: &Case,
        job: &Job,
        place: &Path,
        convention: usize,
        seen: &mut HashSet<String>,
    ) -> Result<Run, Failure> {
        let (run, judged) = case.run(job, place, self.limits, 0)?;
        let mut faults = judged.faults;
        if let Some((picture, both)) = &judged.compared {
            if case.verdict(&both[convention]) == Verdict::AnotherPicture {
                faults.push(case.wrong_picture(&both[convention], convention));
            } else if !seen.insert(format::digest::sha256(picture.pixels.as_flattened())) {
                // Every round has other seeds and another background.
                return Err(Failure::Program(self.language.pick(COPIED).to_owned()));
            }
        }
        let reason = |fault: &Fault| format!("{}: {}", self.language.pick(fault.kind.words()), fault.found);
        let reasons: Vec<_> = faults.iter().map(reason).collect();
        if reasons.is_empty() { Ok(run) } else { Err(Failure::Program(reasons.join("; "))) }
    }
}

/// Returns the name of a scene without the start of its folder's name.
fn scene_name(scene: &Case) -> &str {
    scene.name.strip_prefix(TIMED).unwrap_or(&scene.name)
}

/// Builds a program.
fn built(build: &Job, printed: &Path) -> Result<(), Failure> {
    fs::create_dir_all(printed)?;
    build.run(printed, &BUILD).map(drop).map_err(|failure| failure.about("it cannot be built"))
}

/// Reads the two files of a scene.
fn files(folder: &Path, paths: [&Path; 2]) -> Result<[Vec<u8>; 2], Failure> {
    let [config, scene] = paths.map(|path| folder.join(path));
    let read = |path: &Path| {
        let bytes = sources::regular(path).and_then(|path| read(path, MAX_FILE_BYTES));
        bytes.map_err(|error| format!("{}: {error}", terminal::name(path)))
    };
    let files = [read(&config)?, read(&scene)?];
    sources::config(&config, &[])?;
    sources::scene(&scene)?;
    Ok(files)
}

/// Returns the scenes whose time is measured: those of the file, or two small ones.
fn timed_scenes(folder: &Path, file: &File) -> Result<Vec<Case>, Failure> {
    if !file.scene.is_empty() {
        let scene = |timed: &file::Timed| {
            let files = files(folder, [&timed.config, &timed.scene])?;
            // A wrong scene would give no points to all programs.
            let case = Case::picture(format!("{TIMED}{}", timed.name), files, [None, None]);
            case.map_err(|error| error.about(&format!("scene [{}]", terminal::name(Path::new(&timed.name)))))
        };
        return file.scene.iter().map(scene).collect();
    }
    // A scene of the repository that this program contains, in a small picture with so many samples that noise does not
    // decide whether it is right.
    let contained = |name: &&str| {
        let (config, scene) = scenes::named(name)?;
        let config = Config { image_width: 120, samples_per_pixel: 100, ..config };
        let files = [generator::write::config(&config), generator::write::scene(&scene)].map(Into::into);
        Some(Case::picture(format!("{TIMED}{name}"), files, [None, None]))
    };
    ["materials", "grid"].iter().filter_map(contained).collect()
}
