//! A dated record of the renderer's times: a file of `bench/record`, and the comparison of two records.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::{fs, io};

use serde::{Deserialize, Serialize};

/// The time of one scene with one instruction set.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Time {
    /// Median of the user times of all rounds, in seconds.
    pub seconds: f64,
    /// Median of the relative times of all rounds. A relative time is the user time divided by the yardstick's user
    /// time in the same round. The yardstick is `cpu::reference` on one scene, so relative times of different machines
    /// can be compared.
    pub relative: f64,
}

/// The times that were measured on one day on one machine.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// Day of the measurement, such as `2026-01-31`.
    pub date: String,
    /// The name of the processor, as the processor reports it.
    pub processor: String,
    /// Commit of the working tree, followed by `-dirty` if the tree has changes.
    pub commit: String,
    /// Name and version of the compiler that built the renderer.
    pub compiler: String,
    /// Load of the machine: the average number of runnable processes in the minute before the measurement. A high load
    /// makes the times less certain.
    pub load: f64,
    /// Number of measurements of each time.
    pub rounds: usize,
    /// The times by scene, then by instruction set.
    pub times: BTreeMap<String, BTreeMap<String, Time>>,
}

impl Record {
    /// Returns the name of the record's file, `DATE-MACHINE.json`.
    #[must_use]
    pub fn file_name(&self) -> String {
        let letters = self.processor.to_lowercase().replace(|letter: char| !letter.is_ascii_alphanumeric(), " ");
        let words: Vec<_> = letters.split_whitespace().collect();
        format!("{}-{}.json", self.date, words.join("-"))
    }

    /// Reads a record from the file `path`.
    ///
    /// # Errors
    /// An error if the file cannot be read, or is not a record.
    pub fn read(path: &Path) -> io::Result<Self> {
        let named = |error: String| io::Error::other(format!("{}: {error}", path.display()));
        let text = fs::read_to_string(path).map_err(|error| named(error.to_string()))?;
        serde_json::from_str(&text).map_err(|error| named(error.to_string()))
    }

    /// Returns a table that compares this record with an older one. It shows the quotient new / old of each time. If
    /// both records come from one machine, the seconds are divided, otherwise the times relative to the yardstick.
    #[must_use]
    pub fn compared_with(&self, old: &Self) -> String {
        let same_machine = self.processor == old.processor;
        let unit = if same_machine { "seconds" } else { "relative to the yardstick, since the machines differ" };
        let mut table = format!("new / old, {unit}: {} ({}) / {} ({})\n", self.date, self.commit, old.date, old.commit);
        for (scene, sets) in &self.times {
            for (set, time) in sets {
                let quotient = match old.times.get(scene).and_then(|sets| sets.get(set)) {
                    Some(before) if same_machine => format!("{:.3}", time.seconds / before.seconds),
                    Some(before) => format!("{:.3}", time.relative / before.relative),
                    None => "new".to_owned(),
                };
                let _ = writeln!(table, "{scene:14} {set:18} {quotient:>6}  {:9.4} s", time.seconds);
            }
        }
        table
    }
}

/// Returns the latest record in `folder` of this `processor`. If there is none, returns the latest record of any
/// processor, or `None` if the folder has no record. The file `except` is ignored, because it is the record just
/// written.
///
/// # Errors
/// An error if the folder or a record in it cannot be read.
pub fn latest(folder: &Path, except: &Path, processor: &str) -> io::Result<Option<Record>> {
    let entries = fs::read_dir(folder)?.collect::<Result<Vec<_>, _>>()?;
    let paths = entries.into_iter().map(|entry| entry.path());
    let mut paths: Vec<PathBuf> =
        paths.filter(|path| path.extension() == Some("json".as_ref()) && path != except).collect();
    paths.sort();
    let records = paths.iter().map(|path| Record::read(path)).collect::<Result<Vec<_>, _>>()?;
    let same = records.iter().rfind(|record| record.processor == processor);
    Ok(same.or(records.last()).cloned())
}

#[cfg(test)]
mod tests {
    use test_support::folder::Folder;

    use super::*;

    fn record(date: &str, processor: &str, seconds: f64, relative: f64) -> Record {
        let times = BTreeMap::from([("avx2".to_owned(), Time { seconds, relative })]);
        Record {
            date: date.to_owned(),
            processor: processor.to_owned(),
            commit: "c".to_owned(),
            compiler: "rustc".to_owned(),
            load: 0.5,
            rounds: 3,
            times: BTreeMap::from([("grid".to_owned(), times)]),
        }
    }

    #[test]
    fn a_record_is_compared_with_the_last_one_of_its_machine() {
        let folder = Folder::new();
        let new = record("2026-03-01", "Fast (TM) 9", 1.0, 0.1);
        assert_eq!(new.file_name(), "2026-03-01-fast-tm-9.json");
        let path = folder.file(new.file_name());
        assert_eq!(latest(folder.path(), &path, &new.processor).expect("it is readable"), None);
        let others = [record("2026-01-01", "Fast (TM) 9", 2.0, 0.3), record("2026-02-01", "Slow", 9.0, 0.2)];
        for other in others.iter().chain([&new]) {
            let text = serde_json::to_string(other).expect("a record is JSON");
            fs::write(folder.file(other.file_name()), text).expect("the folder takes a file");
        }
        let last = latest(folder.path(), &path, &new.processor).expect("they are readable").expect("there are two");
        assert_eq!(last, others[0]);
        assert!(new.compared_with(&last).contains("avx2                0.500"), "{}", new.compared_with(&last));
        // For another machine, the yardstick tells how fast that machine is.
        let last = latest(folder.path(), &path, "Unknown").expect("they are readable").expect("there are two");
        assert_eq!(last, others[1]);
        assert!(new.compared_with(&last).contains("avx2                0.500"), "{}", new.compared_with(&last));
    }
}
