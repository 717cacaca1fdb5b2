//! Describes the machine on which the times are measured.

use std::fs;
use std::process::Command;
use std::time::{SystemTime, UNIX_EPOCH};

use cpu::internals::InstructionSet;
use serde::{Deserialize, Serialize};

/// The description of a machine and of its state at the time of a measurement.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Machine {
    /// Day of the measurement in UTC, such as `2026-01-31`.
    pub date: String,
    /// Name of the processor, as the processor reports it.
    pub processor: String,
    /// Number of processors that the system offers.
    pub processors: usize,
    /// Name of the best instruction set that the renderer finds.
    pub instruction_set: String,
    /// Name of the system and its version.
    pub system: String,
    /// Average number of runnable processes in the minute before the measurement (load); `None` if the system does not
    /// tell it.
    pub load: Option<f64>,
    /// Name and version of the compiler that built the program.
    pub compiler: String,
    /// Build profile, `release` or `debug`.
    pub profile: String,
    /// Commit of the working tree, followed by `-dirty` if the tree has changes.
    pub commit: String,
}

impl Machine {
    /// Returns the description of this machine now.
    #[must_use]
    pub fn here() -> Self {
        let file = |path: &str| fs::read_to_string(path).unwrap_or_default();
        let unknown = |text: String| if text.is_empty() { "unknown".to_owned() } else { text };
        Self {
            date: today(),
            processor: unknown(processor(&file("/proc/cpuinfo"))),
            processors: std::thread::available_parallelism().map_or(1, usize::from),
            instruction_set: InstructionSet::best().name().to_owned(),
            system: unknown(format!("{} {}", std::env::consts::OS, file("/proc/sys/kernel/osrelease").trim())),
            load: measure::busy::load(),
            compiler: env!("LAB_COMPILER").to_owned(),
            profile: env!("LAB_PROFILE").to_owned(),
            commit: unknown(commit()),
        }
    }
}

fn processor(cpuinfo: &str) -> String {
    let mut values = cpuinfo.lines().filter_map(|line| line.split_once(':'));
    values.find(|(key, _)| key.trim() == "model name").map(|(_, name)| name.trim().to_owned()).unwrap_or_default()
}

/// Returns the commit of the checkout that contains this program, or an empty text if it was installed elsewhere.
fn commit() -> String {
    let program = std::env::current_exe().unwrap_or_default();
    let git = |arguments: &[&str]| {
        let mut git = Command::new("git");
        let output = git.current_dir(program.parent()?).args(arguments).output().ok()?;
        output.status.success().then(|| String::from_utf8_lossy(&output.stdout).trim().to_owned())
    };
    // Another repository may contain the program, such as one of a home folder.
    let own = git(&["ls-files", "--error-unmatch", ":/lab/src/bench/machine.rs"]);
    own.and_then(|_| git(&["describe", "--always", "--dirty", "--abbrev=12", "--exclude=*"])).unwrap_or_default()
}

fn today() -> String {
    let seconds = SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |time| time.as_secs());
    let [year, month, day] = civil(seconds / 86_400);
    format!("{year:04}-{month:02}-{day:02}")
}

/// Converts a number of days since 1970-01-01 to year, month and day. Internally, years begin on the first of March, so
/// a leap day is the last day of its year.
fn civil(days: u64) -> [u64; 3] {
    let days = days + 719_468;
    let (era, day_of_era) = (days / 146_097, days % 146_097);
    let year_of_era = (day_of_era - day_of_era / 1_460 + day_of_era / 36_524 - day_of_era / 146_096) / 365;
    let day_of_year = day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let month_from_march = (5 * day_of_year + 2) / 153;
    let day = day_of_year - (153 * month_from_march + 2) / 5 + 1;
    let month = if month_from_march < 10 { month_from_march + 3 } else { month_from_march - 9 };
    [era * 400 + year_of_era + u64::from(month <= 2), month, day]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn days_have_the_calendars_names() {
        // Expected values from `date -u -d @SECONDS`.
        for (days, expected) in
            [(0, [1970, 1, 1]), (11_016, [2000, 2, 29]), (11_017, [2000, 3, 1]), (20_818, [2026, 12, 31])]
        {
            assert_eq!(civil(days), expected);
        }
    }

    #[test]
    fn the_processor_is_the_first_that_is_named() {
        assert_eq!(processor("processor\t: 0\nmodel name\t: Some CPU\n\nmodel name\t: Other\n"), "Some CPU");
        assert_eq!(processor(""), "");
    }

    #[test]
    fn this_machine_is_described() {
        let machine = Machine::here();
        assert!(machine.date.starts_with("20") && machine.compiler.starts_with("rustc"), "{machine:?}");
        assert!(machine.processors >= 1);
    }
}
