//! Energy of the processor's packages, where the machine has a meter, and the reason where it has none.
//!
//! Linux offers the counters of RAPL as files under `/sys/class/powercap`: microjoules that wrap around. They count for
//! the whole package, idle cores and neighbours too; [`measure`] can subtract what the machine takes when idle. Where
//! the files cannot be read, `perf` may still be allowed to (the module `perf`).

mod perf;

use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use serde::{Deserialize, Serialize};

use perf::Perf;

use crate::Failure;

/// Where Linux has the counters.
pub const POWERCAP: &str = "/sys/class/powercap";

/// Energy of one picture. What could not be measured is `null`, and `reason` says why.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Energy {
    /// The scene's name.
    pub scene: String,
    /// The implementation.
    pub engine: String,
    /// Joules a picture, idle power subtracted where that was asked for.
    pub joules: Option<f64>,
    /// Watts while rendering, likewise.
    pub watts: Option<f64>,
    /// Watts of the idle machine that were subtracted.
    pub idle_watts: Option<f64>,
    /// Why there are no figures.
    pub reason: Option<String>,
}

/// The energy counters of all packages.
#[derive(Debug)]
pub struct Meter(Source);

#[derive(Debug)]
enum Source {
    Powercap(Vec<Counter>),
    Perf(Perf),
}

#[derive(Debug)]
struct Counter {
    file: PathBuf,
    /// The counter goes back to 0 after this many microjoules.
    range: u64,
}

impl Counter {
    /// Joules from one reading to a later one, when it has not wrapped around twice.
    fn joules(&self, before: u64, after: u64) -> f64 {
        let microjoules = if after >= before { after - before } else { after + (self.range - before) };
        microjoules as f64 * 1e-6
    }
}

impl Meter {
    /// This machine's.
    ///
    /// # Errors
    /// Why it has none, in words.
    pub fn here() -> Result<Self, String> {
        Self::open(Path::new(POWERCAP)).or_else(|first| {
            let perf = Perf::open(Path::new("perf")).map_err(|second| format!("{first}; {second}"))?;
            Ok(Self(Source::Perf(perf)))
        })
    }

    /// The packages' counters under `folder`, [`POWERCAP`] on a real machine.
    ///
    /// # Errors
    /// Why there are none, in words.
    pub fn open(folder: &Path) -> Result<Self, String> {
        let entries = fs::read_dir(folder).map_err(|error| format!("no RAPL: {}: {error}", folder.display()))?;
        let mut counters = Vec::new();
        for zone in entries.flatten().map(|entry| entry.path()) {
            // Packages are named package-0 and so on; cores and memory are parts of them and would count twice.
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
        Ok(Self(Source::Powercap(counters)))
    }

    /// Joules and seconds that `work` takes.
    fn during(&self, work: impl FnOnce() -> Result<(), Failure>) -> Result<(f64, f64), Failure> {
        match &self.0 {
            Source::Powercap(counters) => {
                let (before, start) = (read(counters)?, Instant::now());
                work()?;
                let (seconds, after) = (start.elapsed().as_secs_f64(), read(counters)?);
                let spent = counters.iter().zip(before.iter().zip(after));
                Ok((spent.map(|(counter, (&before, after))| counter.joules(before, after)).sum(), seconds))
            }
            Source::Perf(perf) => {
                let start = Instant::now();
                let counting = perf.start()?;
                let outcome = work();
                // Stopped in any case: it would count for ever.
                let joules = counting.stop()?;
                outcome?;
                Ok((joules, start.elapsed().as_secs_f64()))
            }
        }
    }
}

/// The counters now, in microjoules.
fn read(counters: &[Counter]) -> Result<Vec<u64>, String> {
    counters.iter().map(|counter| number(&counter.file)).collect()
}

fn number(file: &Path) -> Result<u64, String> {
    let text = fs::read_to_string(file).map_err(|error| format!("no RAPL: {}: {error}", file.display()))?;
    text.trim().parse().map_err(|_| format!("no RAPL: {} holds no number", file.display()))
}

/// Measures `render` over and over for at least `shortest`, and the idle machine as long before it where `idle` is
/// asked for. Without a meter the figures are `null`.
///
/// # Errors
/// What `render` says.
pub fn measure(
    meter: &Result<Meter, String>,
    [scene, engine]: [&str; 2],
    idle: bool,
    shortest: Duration,
    mut render: impl FnMut() -> Result<(), Failure>,
) -> Result<Energy, Failure> {
    let (scene, engine) = (scene.to_owned(), engine.to_owned());
    let meter = match meter {
        Ok(meter) => meter,
        Err(reason) => {
            let reason = Some(reason.clone());
            return Ok(Energy { scene, engine, joules: None, watts: None, idle_watts: None, reason });
        }
    };
    let mut idle_watts = None;
    if idle {
        let (joules, seconds) = meter.during(|| {
            std::thread::sleep(shortest);
            Ok(())
        })?;
        idle_watts = Some(joules / seconds);
    }
    let mut pictures = 0_u32;
    let (joules, seconds) = meter.during(|| {
        let start = Instant::now();
        while pictures == 0 || start.elapsed() < shortest {
            render()?;
            pictures += 1;
        }
        Ok(())
    })?;
    let joules = joules - idle_watts.unwrap_or(0.0) * seconds;
    let (per_picture, watts) = (joules / f64::from(pictures), joules / seconds);
    Ok(Energy { scene, engine, joules: Some(per_picture), watts: Some(watts), idle_watts, reason: None })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A folder like Linux', with a package of two cores whose counter stands at `energy`.
    fn powercap(energy: &str) -> tempfile::TempDir {
        let folder = tempfile::tempdir().expect("the temporary folder is writable");
        for (zone, name) in [("intel-rapl:0", "package-0\n"), ("intel-rapl:0:0", "core\n")] {
            let zone = folder.path().join(zone);
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
            // Two joules, across the end of the counter's range; the core's own counter stands still.
            count = (count + 2_000_000) % 1_000_000_000;
            Ok(fs::write(folder.path().join("intel-rapl:0/energy_uj"), format!("{count}\n"))?)
        };
        let energy = measure(&meter, ["s", "e"], false, Duration::ZERO, render).expect("nothing fails");
        assert_eq!((energy.joules, energy.idle_watts, energy.reason), (Some(2.0), None, None));
        assert!(energy.watts.is_some_and(|watts| watts > 0.0));
    }

    #[test]
    fn idle_power_is_subtracted_on_request() {
        let folder = powercap("5\n");
        let energy = measure(&Meter::open(folder.path()), ["s", "e"], true, Duration::from_millis(5), || Ok(()));
        // The counter stands still: nothing idle, nothing for the picture.
        let energy = energy.expect("nothing fails");
        assert_eq!((energy.joules, energy.idle_watts), (Some(0.0), Some(0.0)));
    }

    #[test]
    fn without_a_meter_there_is_no_figure_but_a_reason() {
        let folder = powercap("unreadable\n");
        for meter in [Meter::open(Path::new("/nowhere")), Meter::open(folder.path())] {
            let energy = measure(&meter, ["s", "e"], true, Duration::ZERO, || panic!("nothing to measure"));
            let energy = energy.expect("nothing fails");
            assert_eq!((energy.joules, energy.watts), (None, None));
            assert!(energy.reason.is_some_and(|reason| reason.starts_with("no RAPL: ")));
        }
    }
}
