//! The options of `render` that make a picture in several runs, and when a run writes its checkpoint and stops.

use std::fs;
use std::ops::ControlFlow;
use std::path::PathBuf;
use std::time::{Duration, Instant};

use clap::Args;
use cpu::internals::Streams;
use cpu::{Image, Size};
use output::{Options, Output};

use super::lock::Lock;
use crate::checkpoint::{Checkpoint, Origin};
use crate::{Failure, interrupt, terminal};

/// Options of `render` for a picture that takes several runs.
#[derive(Debug, Args)]
pub struct Stages {
    /// Keep in this file what is needed to go on later: after a row every minute, when interrupted, and at the end
    #[arg(long, value_name = "FILE")]
    checkpoint: Option<PathBuf>,
    /// Go on from this checkpoint, and keep it up to date if --checkpoint names no other file; changes no byte. Without
    /// such a file, start and keep the checkpoint there. The signal USR1 writes the checkpoint at once
    #[arg(long, value_name = "FILE")]
    resume: Option<PathBuf>,
    /// Time between two checkpoints, such as 30s or 5m; 0s writes one after each row
    #[arg(long, value_name = "TIME", default_value = "1m", value_parser = humantime::parse_duration)]
    checkpoint_every: Duration,
    /// Write the checkpoint and stop with status 3 at the end of the first row after this time, such as 50m or 2h
    #[arg(long, value_name = "TIME", value_parser = humantime::parse_duration)]
    stop_after: Option<Duration>,
    /// Render these rows of the picture, from A up to B and without B, and stop with status 3; A is the row that comes
    /// next, and may be left out
    #[arg(long, value_name = "A..B", value_parser = rows)]
    rows: Option<(Option<usize>, Option<usize>)>,
}

/// Returns the first row and the row after the last in a text such as `3..9`, `..9` or `3..`.
fn rows(text: &str) -> Result<(Option<usize>, Option<usize>), String> {
    let row = |text: &str| if text.is_empty() { Some(None) } else { text.parse().ok().map(Some) };
    let range = text.split_once("..").and_then(|(first, end)| Some((row(first)?, row(end)?)));
    let range = range.filter(|(first, end)| end.is_none_or(|end| end > first.unwrap_or(0)));
    range.ok_or_else(|| "two rows are needed, the second larger, as in 0..100 or ..100".to_owned())
}

impl Stages {
    /// Returns the file that this run keeps up to date, and the one from which it goes on.
    pub fn files(&self) -> impl Iterator<Item = &PathBuf> {
        self.checkpoint.iter().chain(&self.resume)
    }

    /// Reads the checkpoint to go on from, and checks the options. `rows` is the number of rows that the run is to
    /// finish, and `origin` that of the picture.
    ///
    /// # Errors
    /// A message about an option, or about the checkpoint.
    pub fn begin(&self, origin: impl FnOnce() -> Origin, size: Size, rows: usize, options: Options) -> Begun {
        let Some(path) = self.files().next() else {
            return match (self.rows, self.stop_after) {
                (None, None) => Ok((None, Run { keep: None, last_row: rows, rows, until: None })),
                _ => Err("--rows and --stop-after need --checkpoint FILE or --resume FILE".into()),
            };
        };
        if self.checkpoint.is_some() && self.checkpoint != self.resume && path.is_file() {
            let name = terminal::quoted([path.as_os_str()]);
            return Err(format!("{name}: the file exists; go on by --resume {name}, or delete it").into());
        }
        // An error of the file is found now, and not after the first minute.
        drop(Output::open(path, options)?);
        let lock = Lock::of(path)?;
        interrupt::listen_for_wish();
        let origin = origin();
        let is_there = |path: &&PathBuf| fs::symlink_metadata(path).is_ok();
        let start =
            self.resume.as_ref().filter(is_there).map(|path| Checkpoint::read(path, &origin, size)).transpose()?;
        if let (Some(path), None) = (&self.resume, &start) {
            terminal::note(&format!("{}: there is no checkpoint yet, so the picture begins", terminal::name(path)));
        }
        let next = start.as_ref().map_or(0, |start| start.rows);
        let (first, end) = self.rows.unwrap_or_default();
        if first.is_some_and(|first| first != next) || end.is_some_and(|end| end <= next) {
            return Err(format!("--rows: row {next} comes next, because the random numbers follow the rows").into());
        }
        let every = self.checkpoint_every;
        let (path, written) = (path.clone(), Instant::now());
        let keep = Some(Keep { path, options, origin, every, written, failed: None, _lock: Some(lock) });
        let until = self.stop_after.and_then(|time| Instant::now().checked_add(time));
        Ok((start, Run { keep, last_row: end.unwrap_or(rows).min(rows), rows, until }))
    }
}

/// The checkpoint to start from, and the state of the run.
pub type Begun = Result<(Option<Checkpoint>, Run), Failure>;

/// A run: what it writes, and where it ends.
#[derive(Debug)]
pub struct Run {
    keep: Option<Keep>,
    /// The run stops after so many rows of the picture.
    last_row: usize,
    /// Number of rows that the picture needs.
    rows: usize,
    /// When the run ends, unless that is too far away for the clock.
    until: Option<Instant>,
}

#[derive(Debug)]
struct Keep {
    path: PathBuf,
    options: Options,
    origin: Origin,
    every: Duration,
    /// When the checkpoint was written last, or when the run began.
    written: Instant,
    /// The failure to write the last checkpoint.
    failed: Option<Failure>,
    /// Keeps other runs away from the file.
    _lock: Option<Lock>,
}

impl Run {
    /// Is called after each row. Writes the checkpoint if it is time, and tells whether the run ends here.
    pub fn after_row(&mut self, row: usize, image: &impl Image, streams: &mut Streams<'_>) -> ControlFlow<()> {
        let is_late = self.until.is_some_and(|until| Instant::now() >= until);
        let ends = row >= self.last_row || is_late || interrupt::flow().is_break();
        let is_wished = interrupt::take_wish();
        if let Some(keep) = &mut self.keep
            && (ends || is_wished || keep.written.elapsed() >= keep.every)
        {
            let result = Checkpoint::write((&keep.path, keep.options), &keep.origin, (row, image), streams);
            keep.failed = result.err();
            // A full disk may have room again a minute later, so the run goes on. A finished picture needs no
            // checkpoint.
            let is_error = ends && row < self.rows;
            if let Some(message) = keep.failed.as_ref().and_then(Failure::message).filter(|_| !is_error) {
                terminal::note(&format!("no checkpoint was written: {message}"));
            }
            keep.written = Instant::now();
        }
        if ends { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }

    /// Returns `Ok` if the picture is finished after `row` rows, and otherwise the reason why it is not.
    ///
    /// # Errors
    /// [`Failure::Interrupted`], [`Failure::Kept`], or the error of the last checkpoint. A finished picture
    /// needs no checkpoint, so then there is no error.
    pub fn end(self, row: usize) -> Result<(), Failure> {
        if row >= self.rows {
            return Ok(());
        }
        let keep = self.keep.ok_or(Failure::Interrupted)?;
        if let Some(failure) = keep.failed {
            return Err(failure);
        }
        let (name, rows) = (terminal::quoted([keep.path.as_os_str()]), self.rows);
        let message = format!("{name} has {row} of {rows} rows; go on by --resume {name}");
        Err(Failure::Kept { message, interrupted: interrupt::flow().is_break() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_finished_picture_does_not_need_its_last_checkpoint() {
        let scene = generator::scene(&generator::Options::default());
        let end = |row| {
            let origin = Origin::new(&cpu::Config::default(), &scene, "statement");
            let (path, options, every) = (PathBuf::from("c"), Options::default(), Duration::ZERO);
            let failed = Some("full".into());
            let keep = Some(Keep { path, options, origin, every, written: Instant::now(), failed, _lock: None });
            Run { keep, last_row: 9, rows: 9, until: None }.end(row)
        };
        assert!(end(9).is_ok() && end(8).is_err_and(|failure| failure.status() == 2));
    }
}
