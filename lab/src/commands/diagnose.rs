//! `render-lab diagnose`: names the deviations from the statement that explain a program's pictures.
//!
//! [`Diagnosis::of`] runs the program on the cases of [`literal`], which finds the deviations. The order of the
//! arguments, wrong defaults, and random numbers that are others in every run are found by further runs.

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::{fs, io};

use clap::Args;
use literal::cases::cases;
use literal::develop;
use literal::diagnose::Search;
use literal::rules::Variant;
use minijinja::value::Serde;
use serde::Serialize;
use tempfile::TempDir;

use crate::bench::commands::Job;
use crate::picture::Picture;
use crate::supervise::Limits;
use crate::template::filled;
use crate::{Failure, interrupt, terminal};

/// Options of `diagnose`.
#[derive(Debug, Args)]
#[command(after_help = include_str!("../../help/diagnose.txt").trim_ascii_end())]
pub struct Arguments {
    /// The program, and arguments before CONFIG
    #[arg(required = true, trailing_var_arg = true, allow_hyphen_values = true, value_names = ["PROGRAM", "ARG"])]
    program: Vec<OsString>,
    #[command(flatten)]
    limits: Limits,
    /// Print the diagnosis as JSON
    #[arg(long)]
    json: bool,
}

impl Arguments {
    /// Diagnoses the program, and prints the result.
    ///
    /// # Errors
    /// [`Failure::Rejected`] if the program has a fault or is not explained, or an error of a file or the program.
    pub fn run(&self) -> Result<(), Failure> {
        let name = terminal::quoted(self.program.iter().map(AsRef::as_ref));
        let program = Job { name, words: self.program.clone(), place: PathBuf::from("."), hidden: Vec::new() };
        let diagnosis = Diagnosis::of(&program, &self.limits)?;
        let text = filled(include_str!("../../templates/diagnose.txt"), Serde(&diagnosis).into())?;
        super::print_as(self.json, &[], &diagnosis, || text)?;
        if diagnosis.is_right() { Ok(()) } else { Err(Failure::Rejected) }
    }
}

/// What is known about a program.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Diagnosis {
    /// The program.
    pub program: String,
    /// Whether the pictures are explained.
    pub explained: bool,
    /// The sets of deviations that explain the pictures. There is more than one if their pictures are equal.
    pub causes: Vec<Vec<Variant>>,
    /// Deviations that were found by further runs.
    pub others: Vec<Variant>,
    /// Number of bytes of all pictures that differ from the explanation, as by another rounding.
    pub differing: usize,
    /// The first case with another picture than the statement's.
    pub wrong: Option<&'static str>,
}

/// Most bytes of a P3 file that is read. The largest picture has 1,920 pixels.
const MOST_BYTES: u64 = 1 << 18;

/// The scene for pairs of configurations: surfaces before and behind the default camera, between which some paths reach
/// the default depth.
const SCENE_OF_PAIRS: &str = "matte: m .8 .6 .4\nmetal: n .9 .9 .9 .4\nsphere: 0 0 0 5 m\nsphere: 0 0 -20 9 n\n\
                              cylinder: 5 1 -3 1 1 3 1 n\n";

impl Diagnosis {
    /// Runs `program`, and diagnoses it.
    ///
    /// # Errors
    /// A run that gives no picture, a file that cannot be written, or [`Failure::Interrupted`].
    pub fn of(program: &Job, limits: &Limits) -> Result<Self, Failure> {
        let cases = cases()?;
        let mut others = Vec::new();
        let mut other = |section, words: &str| {
            others.push(Variant { name: "", value: 0.0, words: words.to_owned(), section, permitted: false });
        };
        let mut is_swapped = false;
        if let Err(failure) = draw(program, limits, cases[0].files, false) {
            interrupt::check()?;
            is_swapped = true;
            draw(program, limits, cases[0].files, true).map_err(|_| failure.about(&program.name))?;
            other("4.1.1", "the configuration and the scene are swapped");
        }
        let draw = |files: [&str; 2]| draw(program, limits, files, is_swapped);
        let pictures = cases.iter().map(|case| draw(case.files).map_err(|failure| failure.about(case.name)));
        let pictures = pictures.collect::<Result<Vec<_>, _>>()?;
        let mut search = Search::new(&cases);
        let mut found = search.explain(&pictures)?;
        // The last case draws numbers of both streams.
        if cases.last().map(|case| draw(case.files)).transpose()?.as_ref() != pictures.last() {
            other("3.1", "the random numbers are others in every run, so no seed decides them");
            found.clear();
        } else {
            let lines = include_str!("pairs.txt").lines().filter(|line| !line.starts_with('#'));
            for fields in lines.map(|line| line.split(" | ").collect::<Vec<_>>()) {
                let &[section, words, both, second] = &fields[..] else { continue };
                let pictures = [both.to_owned(), format!("{both}{second}")]
                    .map(|config| draw([&config.replace(';', "\n"), SCENE_OF_PAIRS]).ok());
                interrupt::check()?;
                // A program that refuses a configuration has another fault, which `check` names.
                if !pictures.contains(&None) && pictures[0] != pictures[1] {
                    other(section, words);
                }
            }
        }
        Ok(Self {
            program: program.name.clone(),
            explained: !found.is_empty(),
            differing: found.first().map_or(0, |&(_, differing)| differing),
            causes: found.into_iter().map(|(variants, _)| variants).collect(),
            others,
            wrong: search.first_wrong()?.map(|case| case.name),
        })
    }

    /// Whether the program does nothing that is not permitted.
    pub fn is_right(&self) -> bool {
        self.explained && self.others.is_empty() && self.causes.iter().flatten().all(|deviation| deviation.permitted)
    }
}

/// Runs the program on a configuration and a scene, in a new folder. Returns its picture.
fn draw(program: &Job, limits: &Limits, files: [&str; 2], is_swapped: bool) -> Result<develop::Picture, Failure> {
    let folder = TempDir::with_prefix("render-diagnose-")?;
    let mut arguments = ["config.txt", "scene.txt", "out.ppm"].map(|name| folder.path().join(name).into_os_string());
    fs::write(&arguments[0], files[0])?;
    fs::write(&arguments[1], files[1])?;
    if is_swapped {
        arguments.swap(0, 1);
    }
    let words = program.words.iter().chain(&arguments).cloned().collect();
    Job { words, ..program.clone() }.run(folder.path(), limits)?;
    let bytes = read_file(Path::new(&arguments[2])).map_err(|error| format!("no picture: {error}"))?;
    let picture = Picture::parse(&bytes).map_err(|reason| format!("the picture cannot be read: {reason}"))?;
    Ok(develop::Picture { width: picture.width, height: picture.height, pixels: picture.pixels })
}

/// Returns the bytes of a P3 file. A program may have left a link, a pipe, or a file without end.
fn read_file(path: &Path) -> io::Result<Vec<u8>> {
    let metadata = fs::symlink_metadata(path)?;
    if !metadata.is_file() || metadata.len() > MOST_BYTES {
        return Err(io::Error::other(format!("it is no file, or larger than {MOST_BYTES} bytes")));
    }
    let bytes = fs::read(path)?;
    if bytes.starts_with(b"P3") { Ok(bytes) } else { Err(io::Error::other("it is no P3")) }
}
