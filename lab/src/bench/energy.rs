//! Measures the energy that the processor packages use, or returns the reason why the machine cannot measure it.
//!
//! Linux offers the RAPL counters as files under `/sys/class/powercap`. They count microjoules, and wrap around to 0.
//! They count the whole package, so idle cores and other processes are included. Only root may read the files;
//! docs/measure-perf measures whole programs by `perf stat`.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use serde::{Deserialize, Serialize};

use crate::Failure;

/// The folder in which Linux has the files of the RAPL counters.
pub const POWERCAP: &str = "/sys/class/powercap";

/// The energy of one picture. A figure that could not be measured is `null`, and `reason` gives the reason.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Energy {
    /// The scene's name.
    pub scene: String,
    /// The name of the implementation.
    pub engine: String,
    /// Joules of one picture.
    pub joules: Option<f64>,
    /// Mean power in watts during rendering.
    pub watts: Option<f64>,
    /// The reason why there are no figures; `null` if there are figures.
    pub reason: Option<String>,
}

/// The energy counters of all processor packages.
#[derive(Debug)]
pub struct Meter(Vec<Counter>);

#[derive(Debug)]
struct Counter {
    file: PathBuf,
    /// The counter returns to 0 after this many microjoules.
    range: u64,
}

impl Counter {
    /// Returns the joules between two readings of the counter, which are in microjoules. The counter must have wrapped
    /// around at most once between them.
    fn joules(&self, before: u64, after: u64) -> f64 {
        let microjoules = if after >= before { after - before } else { after + (self.range - before) };
        microjoules as f64 * 1e-6
    }
}

impl Meter {
    /// Returns the energy meter of this machine.
    ///
    /// # Errors
    /// The reason why the machine has no meter, as text.
    pub fn here() -> Result<Self, String> {
        Self::open(Path::new(POWERCAP))
    }

    /// Returns a meter of the packages' counters in `folder`, which is [`POWERCAP`] on a real machine.
    ///
    /// # Errors
    /// The reason why there are no counters, as text.
    pub fn open(folder: &Path) -> Result<Self, String> {
        let entries = fs::read_dir(folder).map_err(|error| format!("no RAPL: {}: {error}", folder.display()))?;
        let mut counters = Vec::new();
        for zone in entries.flatten().map(|entry| entry.path()) {
            // Packages have the names package-0, package-1 and so on. The zones of cores and memory are parts of a
            // package, so counting them would count their energy twice.
            let name = fs::read_to_string(zone.join("name")).unwrap_or_default();
            if name.starts_with("package") {
                let range = number(&zone.join("max_energy_range_uj"))?;
                counters.push(Counter { file: zone.join("energy_uj"), range });
            }
        }
        if counters.is_empty() {
            return Err(format!("no RAPL: no package under {}", folder.display()));
        }
        read(&counters)?;
        Ok(Self(counters))
    }

    /// Runs `work`, and returns the joules and seconds that it took.
    fn during(&self, work: impl FnOnce() -> Result<(), Failure>) -> Result<(f64, f64), Failure> {
        let (before, start) = (read(&self.0)?, Instant::now());
        work()?;
        let (seconds, after) = (start.elapsed().as_secs_f64(), read(&self.0)?);
        let spent = self.0.iter().zip(before.iter().zip(after));
        Ok((spent.map(|(counter, (&before, after))| counter.joules(before, after)).sum(), seconds))
    }
}

/// Returns the readings of all counters, in microjoules.
fn read(counters: &[Counter]) -> Result<Vec<u64>, String> {
    counters.iter().map(|counter| number(&counter.file)).collect()
}

fn number(file: &Path) -> Result<u64, String> {
    let text = fs::read_to_string(file).map_err(|error| format!("no RAPL: {}: {error}", file.display()))?;
    text.trim().parse().map_err(|_| format!("no RAPL: {} holds no number", file.display()))
}

/// Calls `render` again and again for at least the time `shortest`, and returns the mean energy of one call. If `meter`
/// is an error, the figures are `null`.
///
/// # Errors
/// An error of `render`, or of reading a counter.
pub fn measure(
    meter: &Result<Meter, String>,
    [scene, engine]: [&str; 2],
    shortest: Duration,
    mut render: impl FnMut() -> Result<(), Failure>,
) -> Result<Energy, Failure> {
    let (scene, engine) = (scene.to_owned(), engine.to_owned());
    let meter = match meter {
        Ok(meter) => meter,
        Err(reason) => {
            let reason = Some(reason.clone());
            return Ok(Energy { scene, engine, joules: None, watts: None, reason });
        }
    };
    let mut pictures = 0_u32;
    let (joules, seconds) = meter.during(|| {
        let start = Instant::now();
        while pictures == 0 || start.elapsed() < shortest {
            render()?;
            pictures += 1;
        }
        Ok(())
    })?;
    let (per_picture, watts) = (joules / f64::from(pictures), joules / seconds);
    Ok(Energy { scene, engine, joules: Some(per_picture), watts: Some(watts), reason: None })
}

#[cfg(test)]
mod tests {
    use test_support::folder::Folder;

    use super::*;

    /// Creates a folder like [`POWERCAP`] with two zones, a package and its cores. Both counters have the reading
    /// `energy`.
    fn powercap(energy: &str) -> Folder {
        let folder = Folder::new();
        for (zone, name) in [("intel-rapl:0", "package-0\n"), ("intel-rapl:0:0", "core\n")] {
            let zone = folder.file(zone);
            fs::create_dir(&zone).expect("the folder is writable");
            for (file, text) in [("name", name), ("max_energy_range_uj", "1000000000\n"), ("energy_uj", energy)] {
                fs::write(zone.join(file), text).expect("the folder is writable");
            }
        }
        folder
    }

    #[test]
    fn a_picture_takes_what_the_package_counted() {
        let folder = powercap("999000000\n");
        let meter = Meter::open(folder.path());
        let mut count = 999_000_000_u64;
        let render = || {
            // The package's counter rises by two joules, modulo its range. The counter of the cores does not change.
            count = (count + 2_000_000) % 1_000_000_000;
            Ok(fs::write(folder.file("intel-rapl:0/energy_uj"), format!("{count}\n"))?)
        };
        let energy = measure(&meter, ["s", "e"], Duration::ZERO, render).expect("nothing fails");
        assert_eq!((energy.joules, energy.reason), (Some(2.0), None));
        assert!(energy.watts.is_some_and(|watts| watts > 0.0));
    }

    #[test]
    fn without_a_meter_there_is_no_figure_but_a_reason() {
        let folder = powercap("unreadable\n");
        for meter in [Meter::open(Path::new("/nowhere")), Meter::open(folder.path())] {
            let energy = measure(&meter, ["s", "e"], Duration::ZERO, || panic!("nothing to measure"));
            let energy = energy.expect("nothing fails");
            assert_eq!((energy.joules, energy.watts), (None, None));
            assert!(energy.reason.is_some_and(|reason| reason.starts_with("no RAPL: ")));
        }
    }
}
