//! `render-lab check`: holds a program to the specification.

use std::ffi::OsString;
use std::os::unix::fs::MetadataExt;
use std::path::PathBuf;

use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use output::Options;
use tempfile::TempDir;

use crate::bench::commands::Job;
use crate::check::judge::remove;
use crate::check::{Report, cases};
use crate::format::hint::Language;
use crate::supervise::Limits;
use crate::{Failure, sources, terminal};

/// Options of `check`.
#[derive(Debug, Args)]
#[command(after_help = include_str!("../../help/check.txt").trim_ascii_end())]
pub struct Arguments {
    /// The program, and arguments before CONFIG
    #[arg(required = true, trailing_var_arg = true, allow_hyphen_values = true, value_names = ["PROGRAM", "ARG"])]
    program: Vec<OsString>,
    #[command(flatten)]
    limits: Limits,
    #[command(flatten)]
    shown: Shown,
    /// Print the report as JSON
    #[arg(long)]
    json: bool,
}

/// Where the report goes.
#[derive(Debug, Args)]
pub struct Shown {
    /// Language of the report
    #[arg(long, default_value = "en", value_parser = language())]
    pub language: Language,
    /// Write the report as one self-contained page too; - is standard output
    #[arg(long, value_name = "FILE")]
    pub html: Option<PathBuf>,
    /// Keep the files of all cases in this folder; without it, they are kept in a temporary folder if something failed
    #[arg(long, value_name = "FOLDER")]
    pub keep: Option<PathBuf>,
}

/// Returns the parser of the option `--language`.
pub fn language() -> impl TypedValueParser<Value = Language> {
    let of = |code: String| if code == "es" { Language::Spanish } else { Language::English };
    PossibleValuesParser::new(["en", "es"]).map(of)
}

impl Shown {
    /// Makes the folder for the files of the cases.
    ///
    /// # Errors
    /// The folder cannot be made, or belongs to another user, who could replace what is written there.
    pub fn folder(&self) -> Result<Work, Failure> {
        let temporary = TempDir::with_prefix("render-check-")?;
        let Some(folder) = &self.keep else {
            return Ok(Work { path: temporary.path().canonicalize()?, temporary: Some(temporary) });
        };
        sources::make_folder(folder)?;
        if folder.metadata()?.uid() != temporary.path().metadata()?.uid() {
            return Err(
                format!("{}: it belongs to another user; choose a folder of your own", terminal::name(folder)).into()
            );
        }
        Ok(Work { path: folder.canonicalize()?, temporary: None })
    }
}

/// The folder for the files of the cases. A temporary one is removed when this value is dropped.
#[derive(Debug)]
pub struct Work {
    /// Its path.
    pub path: PathBuf,
    temporary: Option<TempDir>,
}

impl Work {
    /// Keeps a temporary folder.
    pub fn keep(mut self) {
        self.temporary.take().map(TempDir::keep);
    }
}

impl Drop for Work {
    fn drop(&mut self) {
        // A program may have left what a temporary folder does not remove by itself.
        if self.temporary.is_some() {
            remove(&self.path);
        }
    }
}

impl Arguments {
    /// Checks the program, and prints the report.
    ///
    /// # Errors
    /// [`Failure::Rejected`] if the program failed a case, or an error of a file or the program.
    pub fn run(&self, options: Options) -> Result<(), Failure> {
        let language = self.shown.language;
        let outs: Vec<_> = self.shown.html.iter().map(PathBuf::as_path).collect();
        sources::check_outputs(&outs, &[], self.json)?;
        let html = self.shown.html.as_ref().map(|path| sources::open(path, options)).transpose()?;
        let cases = cases::all()?;
        let work = self.shown.folder()?;
        let name = terminal::quoted(self.program.iter().map(AsRef::as_ref));
        let program = Job { name, words: self.program.clone(), place: PathBuf::from("."), hidden: Vec::new() };
        let bar = terminal::progress(cases.len(), "cases");
        let report = Report::of(&program, &cases, &self.limits, &work.path, &bar)?;
        bar.finish_and_clear();
        if let Some(output) = html {
            let page = report.page(language)?;
            output.fill(|file| file.write_all(page.as_bytes()))?;
        }
        super::print_as(self.json, &outs, &report, || report.text(language))?;
        if report.is_passed() {
            return Ok(());
        }
        work.keep();
        Err(Failure::Rejected)
    }
}
