//! `render-lab grade`: checks, measures and grades the programs of a folder.

use std::path::{Path, PathBuf};

use clap::Args;
use output::{Options, Output};
use tempfile::TempDir;

use super::check::Shown;
use crate::bench::commands::Rounds;
use crate::check::{Report, cases};
use crate::grade::{Graded, Grades};
use crate::supervise::Limits;
use crate::{Failure, terminal};

/// Options of `grade`.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  render-lab grade students --html grades.html --csv grades.csv
  render-lab grade students --language es --keep /tmp/files --rounds 9

Each folder in FOLDER with a program render-aos, render-soa or render (in it, or in its build, bin or \
target/release) is checked as by `check`. Programs with the right pictures are measured in turn. The file grade.toml \
in FOLDER may name programs, commands that build them, scenes and weights; docs/files.md has its format.

Points: each part has 0 to 10, and the total is their weighted mean. The default weights are those of the \
statement's section 7 that a machine can measure, performance 20 and energy 20, and its 10 for tests: pictures 7, \
messages 3. The reference time of a scene, by default the median of all programs, has 5 points, and its zero, by \
default four times the reference, none. Without a meter of energy (RAPL), energy does not count. Programs are not \
confined: run only what you trust.

Exit status: 0 graded, 2 an error")]
pub struct Arguments {
    /// Folder with the programs
    folder: PathBuf,
    #[command(flatten)]
    limits: Limits,
    #[command(flatten)]
    rounds: Rounds,
    #[command(flatten)]
    shown: Shown,
    /// Write the table as CSV too
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
        let open = |path: &Option<PathBuf>| path.as_ref().map(|path| Output::open(path, options)).transpose();
        let (html, csv) = (open(&self.shown.html)?, open(&self.csv)?);
        let cases = cases::all(std::env::var_os("RENDER_REFERENCE_DIR").as_deref().map(Path::new))?;
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
        if self.json { super::print_json(&grades) } else { terminal::print(&terminal::table(&rows)) }
    }
}
