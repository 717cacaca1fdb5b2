//! The energy that the processor has used, by its own meter (RAPL), where Linux lets this process read it.

use std::fs;
use std::path::{Path, PathBuf};

/// The folder in which Linux shows the meters.
const FOLDER: &str = "/sys/class/powercap";

/// The meters of all processor packages: the file of each counter, and the microjoules up to which it counts before it
/// starts again from 0. They count what the whole machine uses, not one process.
#[derive(Clone, Debug)]
pub struct Meter(Vec<(PathBuf, u64)>);

/// The state of the meters at one moment, in microjoules.
#[derive(Clone, Debug)]
pub struct Reading(Vec<u64>);

impl Meter {
    /// Returns the meters of this machine, or `None` if it has none that this process may read.
    #[must_use]
    pub fn open() -> Option<Self> {
        Self::in_folder(Path::new(FOLDER))
    }

    fn in_folder(folder: &Path) -> Option<Self> {
        let package = |entry: fs::DirEntry| {
            // `intel-rapl:0` is a package, which AMD's processors have too. `intel-rapl:0:1` is a part of it.
            entry.file_name().to_str()?.strip_prefix("intel-rapl:")?.parse::<u32>().ok()?;
            Some((entry.path().join("energy_uj"), number_in(&entry.path().join("max_energy_range_uj"))?))
        };
        let meter = Self(fs::read_dir(folder).ok()?.flatten().filter_map(package).collect());
        (!meter.0.is_empty() && meter.read().is_some()).then_some(meter)
    }

    /// Reads the meters, or returns `None` if one of them cannot be read.
    #[must_use]
    pub fn read(&self) -> Option<Reading> {
        self.0.iter().map(|(counter, _)| number_in(counter)).collect::<Option<_>>().map(Reading)
    }

    /// Returns the energy used since `before` in joules, or `None` if a meter cannot be read. A meter may start again
    /// from 0 once in between.
    #[must_use]
    pub fn joules_since(&self, before: &Reading) -> Option<f64> {
        let after = self.read()?;
        let used = |(((_, range), before), after): ((&(PathBuf, u64), &u64), &u64)| {
            after.checked_sub(*before).unwrap_or_else(|| range.saturating_sub(*before) + after)
        };
        Some(self.0.iter().zip(&before.0).zip(&after.0).map(used).sum::<u64>() as f64 * 1e-6)
    }
}

fn number_in(path: &Path) -> Option<u64> {
    fs::read_to_string(path).ok()?.trim().parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_energy_of_all_packages_is_added() {
        let folder = std::env::temp_dir().join(format!("meter-{}", std::process::id()));
        let write = |name: &str, microjoules: u64| {
            fs::create_dir_all(folder.join(name)).expect("the folder is writable");
            fs::write(folder.join(name).join("energy_uj"), format!("{microjoules}\n")).expect("it is writable");
            fs::write(folder.join(name).join("max_energy_range_uj"), "5000000\n").expect("it is writable");
        };
        assert!(Meter::in_folder(&folder).is_none());
        for (name, microjoules) in [("intel-rapl:0", 1_000_000), ("intel-rapl:1", 4_000_000), ("intel-rapl:0:0", 7)] {
            write(name, microjoules);
        }
        let meter = Meter::in_folder(&folder).expect("there are two");
        let before = meter.read().expect("they can be read");
        write("intel-rapl:0", 1_500_000);
        write("intel-rapl:1", 250_000);
        assert_eq!(meter.joules_since(&before), Some(0.5 + 1.25));
        fs::remove_dir_all(&folder).expect("it is ours");
        assert!(meter.joules_since(&before).is_none());
    }
}
