//! `render-lab grade`: checks, measures and grades the programs of a folder.

use std::path::PathBuf;

use clap::Args;
use output::Options;

use super::bench::parse_part;
use super::check::Shown;
use crate::bench::commands::Rounds;
use crate::check::{Report, cases};
use crate::grade::{Grading, Row};
use crate::supervise::Limits;
use crate::{Failure, sources, terminal};

/// Options of `grade`.
#[derive(Debug, Args)]
#[command(after_help = include_str!("../../help/grade.txt").trim_ascii_end())]
pub struct Arguments {
    /// Folder with a folder for each team
    folder: PathBuf,
    #[command(flatten)]
    limits: Limits,
    #[command(flatten)]
    rounds: Rounds,
    #[command(flatten)]
    shown: Shown,
    /// Write the table as CSV too; - is standard output
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
    /// Print everything as JSON
    #[arg(long)]
    json: bool,
    /// Keep the results in this folder, team by team: a page, results.json for Gradescope, JUnit XML
    #[arg(long, value_name = "FOLDER")]
    results: Option<PathBuf>,
    /// Take the teams that are in the folder of --results as they are, and check the others
    #[arg(long, requires = "results")]
    resume: bool,
    /// Number of teams that are checked at a time; times are measured one after the other
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u16).range(1..=1024))]
    jobs: u16,
    /// Check this part of the teams only, without times, into the folder of --results
    #[arg(long, value_name = "I/N", value_parser = parse_part, requires = "results")]
    part: Option<(usize, usize)>,
}

impl Arguments {
    /// Grades the programs, and prints the table.
    ///
    /// # Errors
    /// An error of a file, or [`Failure::Interrupted`].
    pub fn run(&self, options: Options) -> Result<(), Failure> {
        let language = self.shown.language;
        let outs: Vec<_> = self.shown.html.iter().chain(&self.csv).map(PathBuf::as_path).collect();
        sources::check_outputs(&outs, &[], self.json)?;
        let open = |path: &Option<PathBuf>| path.as_ref().map(|path| sources::open(path, options)).transpose();
        let (html, csv) = (open(&self.shown.html)?, open(&self.csv)?);
        if let Some(warning) = measure::busy::warning(measure::busy::load()) {
            terminal::note(&warning);
        }
        let results = self.results.as_deref();
        results.map_or(Ok(()), sources::make_folder)?;
        let work = self.shown.folder()?;
        let grading = Grading {
            cases: cases::all()?,
            limits: &self.limits,
            rounds: &self.rounds,
            kept: &work.path,
            results,
            resume: self.resume,
            jobs: usize::from(self.jobs),
            part: self.part,
            language,
            options,
        };
        let grades = grading.of(&self.folder)?;
        if let (Some(results), None) = (results, self.part) {
            grades.write(results, language, options)?;
        }
        if let Some(output) = html {
            let page = grades.page(language, false)?;
            output.fill(|file| file.write_all(page.as_bytes()))?;
        }
        if let Some(output) = csv {
            output.fill(|file| grades.write_csv(language, file))?;
        }
        // The commands that repeat a case need its files.
        let is_passed =
            |row: &Row| row.programs.iter().all(|graded| graded.report.as_ref().is_some_and(Report::is_passed));
        if !grades.teams.iter().all(is_passed) {
            work.keep();
        }
        super::print_as(self.json, &outs, &grades, || terminal::table(&grades.rows(language)))
    }
}
