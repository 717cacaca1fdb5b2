//! Describes the machine on which the times are measured.

use std::fs;
use std::process::Command;

use cpu::internals::InstructionSet;
use serde::{Deserialize, Serialize};

/// The description of a machine and of its state at the time of a measurement.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Machine {
    /// Day of the measurement in UTC, such as `2026-01-31`.
    pub date: String,
    /// Name, family and model of the processor, as the processor reports them.
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
    pub fn here() -> Self {
        let file = |path: &str| fs::read_to_string(path).unwrap_or_default();
        let unknown = |text: String| if text.is_empty() { "unknown".to_owned() } else { text };
        Self {
            date: unknown(said("date", &["-u", "+%F"])),
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
    let value = |name: &str| {
        let mut values = cpuinfo.lines().filter_map(|line| line.split_once(':'));
        values.find(|(key, _)| key.trim() == name).map(|(_, value)| value.trim())
    };
    let name = value("model name").unwrap_or_default();
    // Some names, such as "AMD EPYC", do not tell the generation.
    match (value("cpu family"), value("model")) {
        (Some(family), Some(model)) => format!("{name}, family {family}, model {model}"),
        _ => name.to_owned(),
    }
}

/// Returns the commit of the checkout that contains this program. If it lies elsewhere, the commit is the one that was
/// built.
fn commit() -> String {
    // Another repository may contain the program, such as one of a home folder.
    let own = said("git", &["ls-files", "--error-unmatch", ":/lab/src/bench/machine.rs"]);
    if own.is_empty() {
        return env!("LAB_COMMIT").to_owned();
    }
    said("git", &["describe", "--always", "--dirty", "--abbrev=12", "--exclude=*"])
}

/// Runs another program in the folder of this one, and returns what it prints, or an empty text if it fails.
fn said(program: &str, arguments: &[&str]) -> String {
    let own = std::env::current_exe().unwrap_or_default();
    let mut command = Command::new(program);
    let output = command.current_dir(own.parent().unwrap_or(&own)).args(arguments).output();
    let printed = output.ok().filter(|output| output.status.success()).map(|output| output.stdout);
    String::from_utf8_lossy(&printed.unwrap_or_default()).trim().to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_processor_is_the_first_that_is_named() {
        assert_eq!(processor("processor\t: 0\nmodel name\t: Some CPU\n\nmodel name\t: Other\n"), "Some CPU");
        assert_eq!(processor("cpu family\t: 6\nmodel\t: 2\nmodel name\t: X\n"), "X, family 6, model 2");
        assert_eq!(processor(""), "");
    }
}
