//! Shows the progress of a long measurement, and stores it in a file, so that the measurement can continue after an
//! interruption.

use std::fmt::Display;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use output::{Options, Output};
use serde::{Deserialize, Serialize};

use super::results::Results;
use super::results::check::{self, MAX_BYTES};
use crate::{Failure, terminal};

/// The results of an unfinished measurement, as they are stored in a file.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Partial {
    /// The plan and the commit as text. Only a measurement with this plan and this commit can continue with these
    /// results.
    pub request: String,
    /// Names of the finished tasks.
    pub done: Vec<String>,
    /// Results of the finished tasks.
    pub results: Results,
}

impl Partial {
    /// Returns the path of the file beside `out` that stores the results of an unfinished measurement. Returns `None`
    /// if `out` is standard output, a device or a pipe.
    #[must_use]
    pub fn path(out: &Path) -> Option<PathBuf> {
        let mut name = out.file_name()?.to_owned();
        name.push(".partial");
        let is_file = out != Path::new("-") && out.metadata().map_or(true, |metadata| metadata.is_file());
        is_file.then(|| out.with_file_name(name))
    }

    /// Reads a file that [`Self::write`] has written.
    ///
    /// # Errors
    /// An error if the file cannot be read, has another format, or was written for a request other than `request`.
    pub fn read(path: &Path, request: &str) -> Result<Self, Failure> {
        let explain = |error: &dyn Display| format!("{}: {error}", terminal::name(path));
        let text = cpu::internals::input::reader::read(path, MAX_BYTES).map_err(|error| explain(&error))?;
        let partial: Self = check::Total::default().parse(&text).map_err(|error| explain(&error))?;
        partial.results.check().map_err(|error| explain(&error))?;
        if partial.request != request {
            let error = format!("it was measured with other options or another program: {}", partial.request);
            return Err(explain(&error).into());
        }
        Ok(partial)
    }

    /// Writes this value to the file `path`.
    ///
    /// # Errors
    /// An error if the file cannot be written.
    pub fn write(&self, path: &Path, options: Options) -> Result<(), Failure> {
        let json = serde_json::to_string(self).map_err(|error| error.to_string())?;
        Ok(Output::open(path, options)?.fill(|file| file.write_all(json.as_bytes()))?)
    }
}

/// Returns the message that announces task `number` of `of` tasks, with an estimate of the time left. The estimate uses
/// the mean time of the tasks since `since`, of which `measured` are finished.
#[must_use]
pub fn announcement(number: usize, of: usize, task: &impl Display, measured: usize, since: Instant) -> String {
    let left = match measured {
        0 => String::new(),
        // The estimate gives each remaining task the mean time of the measured tasks. The times of tasks differ, so it
        // is rough.
        _ => format!(
            ", about {} left",
            rough(since.elapsed().div_f64(measured as f64).mul_f64((of + 1 - number) as f64))
        ),
    };
    format!("task {number} of {of}: {task}{left}")
}

fn rough(time: Duration) -> String {
    match time.as_secs() {
        seconds @ 0..=99 => format!("{seconds} s"),
        seconds @ 100..=5999 => format!("{} min", seconds.div_ceil(60)),
        seconds => format!("{:.1} h", seconds as f64 / 3600.0),
    }
}

/// Returns a warning if the repeats of some settings differ much from each other, and otherwise `None`.
#[must_use]
pub fn spread_warning(results: &Results) -> Option<String> {
    /// The largest spread without a warning. The spread is the distance between the bounds, divided by the median.
    const MOST_SPREAD: f64 = 0.1;
    let of = results.timings.len();
    let wide = results.timings.iter().filter(|timing| timing.median.spread() > MOST_SPREAD).count();
    (wide > 0).then(|| {
        format!(
            "warning: in {wide} of {of} settings the bounds of the median are more than {:.0} % of it apart: the machine was \
             busy or its clock changed. More --repeats on a quiet machine narrow them.",
            100.0 * MOST_SPREAD
        )
    })
}

#[cfg(test)]
mod tests {
    use test_support::folder::Folder;

    use super::*;

    #[test]
    fn a_task_is_announced_with_its_number_and_the_time_left() {
        let now = Instant::now();
        assert_eq!(announcement(1, 21, &"scale width", 0, now), "task 1 of 21: scale width");
        let earlier = now.checked_sub(Duration::from_secs(20)).expect("the clock has run that long");
        let text = announcement(3, 4, &"x", 2, earlier);
        assert!(text.starts_with("task 3 of 4: x, about 20 s left"), "{text}");
        assert_eq!([5, 100, 6000].map(|seconds| rough(Duration::from_secs(seconds))), ["5 s", "2 min", "1.7 h"]);
    }

    #[test]
    fn an_interrupted_measurement_goes_on_only_as_it_was_asked_for() {
        let folder = Folder::new();
        let path = Partial::path(&folder.file("b.json")).expect("it has a name");
        assert!(path.ends_with("b.json.partial"));
        assert!(["-", "/dev/null"].iter().all(|out| Partial::path(Path::new(out)).is_none()));
        let partial = Partial { request: "quick".to_owned(), done: vec!["a".to_owned()], ..Partial::default() };
        partial.write(&path, Options::default()).expect("the folder is writable");
        assert_eq!(Partial::read(&path, "quick").expect("it was written"), partial);
        assert!(Partial::read(&path, "full").is_err());
    }
}
