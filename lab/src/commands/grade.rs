//! `render-lab grade`: checks, measures and grades the programs of a folder.

use std::path::PathBuf;

use clap::Args;
use output::Options;
use tempfile::TempDir;

use super::check::Shown;
use crate::bench::commands::Rounds;
use crate::check::{Report, cases};
use crate::grade::{Graded, Grades};
use crate::supervise::Limits;
use crate::{Failure, sources, terminal};

/// Options of `grade`.
#[derive(Debug, Args)]
#[command(after_help = include_str!("../../help/grade.txt").trim_ascii_end())]
pub struct Arguments {
    /// Folder with the programs
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
}

impl Arguments {
    /// Grades the programs, and prints the table.
    ///
    /// # Errors
    /// An error of a file, or [`Failure::Interrupted`].
    pub fn run(&self, options: Options) -> Result<(), Failure> {
        let outs: Vec<_> = self.shown.html.iter().chain(&self.csv).map(PathBuf::as_path).collect();
        sources::check_outputs(&outs, &[], self.json)?;
        let open = |path: &Option<PathBuf>| path.as_ref().map(|path| sources::open(path, options)).transpose();
        let (html, csv) = (open(&self.shown.html)?, open(&self.csv)?);
        let cases = cases::all()?;
        if let Some(warning) = measure::busy::warning(measure::busy::load()) {
            terminal::note(&warning);
        }
        let (kept, temporary) = self.shown.folder()?;
        let grades = Grades::of(&self.folder, &cases, &self.limits, &self.rounds, &kept)?;
        let rows = grades.rows(self.shown.language);
        if let Some(output) = html {
            let page = grades.page(self.shown.language, &kept)?;
            output.fill(|file| file.write_all(page.as_bytes()))?;
        }
        if let Some(output) = csv {
            output.fill(|file| {
                let mut writer = csv::Writer::from_writer(file);
                rows.iter().try_for_each(|row| writer.write_record(row))?;
                writer.flush()
            })?;
        }
        // The commands that repeat a case need its files.
        let is_passed = |graded: &Graded| graded.report.as_ref().is_some_and(Report::is_passed);
        temporary.filter(|_| !grades.programs.iter().all(is_passed)).map(TempDir::keep);
        super::print_as(self.json, &outs, &grades, || terminal::table(&rows))
    }
}
