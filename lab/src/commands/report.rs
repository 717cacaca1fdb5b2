//! `render-lab report`: draws charts and writes a page from measured data.

use std::path::PathBuf;

use clap::Args;
use output::Options;

use crate::bench::results::Results;
use crate::commands::check::language;
use crate::format::hint::Language;
use crate::{Failure, report};

/// Options of `report`.
#[derive(Debug, Args)]
#[command(after_help = include_str!("../../help/report.txt").trim_ascii_end())]
pub struct Arguments {
    /// Results of `render-lab bench`
    data: PathBuf,
    /// Folder for index.html, findings.json and charts/*.svg; it is made if it is not there
    #[arg(long, value_name = "FOLDER")]
    out: PathBuf,
    /// Language of the page and the charts
    #[arg(long, default_value = "en", value_parser = language())]
    language: Language,
    /// Address of a report in PDF about the results, to which the page links
    #[arg(long, value_name = "ADDRESS")]
    pdf: Option<String>,
}

impl Arguments {
    /// Writes the report into the folder.
    ///
    /// # Errors
    /// An error of the data or the folder.
    pub fn run(&self, options: Options) -> Result<(), Failure> {
        let (results, pictures) = (Results::read(&self.data)?, report::thumbnails);
        let texts = (self.language, self.pdf.as_deref());
        report::write(&results, &self.data, &self.out, texts, options, pictures)
    }
}
