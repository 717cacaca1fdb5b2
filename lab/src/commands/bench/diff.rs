//! `render-lab bench diff`: says what became faster or slower between two records.

use std::path::PathBuf;

use clap::Args;

use crate::bench::diff::{Change, Changes, Times};
use crate::report::style::{seconds, short};
use crate::{Failure, sources, terminal};

/// Options of `bench diff`.
#[derive(Debug, Args)]
#[command(after_help = include_str!("../../../help/bench-diff.txt").trim_ascii_end())]
pub struct Arguments {
    /// The older record
    old: PathBuf,
    /// The newer record
    new: PathBuf,
    /// Smaller changes, in percent, do not count
    #[arg(long, value_name = "PERCENT", default_value_t = 2.0, value_parser = crate::numbers::above_zero)]
    least: f64,
    /// Print the changes as JSON
    #[arg(long)]
    json: bool,
}

impl Arguments {
    /// Compares the records and prints the changes.
    ///
    /// # Errors
    /// [`Failure::Rejected`] if a case became slower, or an error of a file.
    pub fn run(&self) -> Result<(), Failure> {
        sources::refuse_inputs_in_one(&[&self.old, &self.new])?;
        let changes = Changes::between(&Times::read(&self.old)?, &Times::read(&self.new)?, self.least / 100.0);
        if !changes.has_common_cases() {
            return Err("the two records have no case in common".into());
        }
        if changes.other_processor {
            terminal::note("warning: the records come from different processors, so their times say little");
        }
        super::super::print_as(self.json, &[], &changes, || text(&changes))?;
        if changes.slower.is_empty() { Ok(()) } else { Err(Failure::Rejected) }
    }
}

fn text(changes: &Changes) -> String {
    let row = |word: &str, change: &Change| {
        let [low, high] = change.bounds.map(short);
        let [old, new] = change.seconds.map(seconds);
        let ratio = format!("{} ({low} to {high})", short(change.ratio));
        vec![word.to_owned(), ratio, old, new, terminal::escape_lines(&change.case)]
    };
    let slower = changes.slower.iter().map(|change| row("slower", change));
    let faster = changes.faster.iter().map(|change| row("faster", change));
    let head = ["change", "ratio", "old", "new", "case"].map(str::to_owned).to_vec();
    let rows: Vec<_> = std::iter::once(head).chain(slower).chain(faster).collect();
    let table = if rows.len() > 1 { terminal::table(&rows) + "\n\n" } else { String::new() };
    let Changes { unchanged, unknown, only_old, only_new, .. } = changes;
    format!(
        "{table}{} slower, {} faster, {unchanged} within their spread; {unknown} measured too few times, {only_old} \
         only in the old record, {only_new} only in the new one",
        changes.slower.len(),
        changes.faster.len(),
    )
}
