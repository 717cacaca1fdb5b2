//! Reads the RAPL counters through `perf stat`. Some machines allow this although only root may read the powercap
//! files.

use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};

use nix::sys::signal::{Signal, kill};
use nix::unistd::Pid;

/// Why `perf` counts no energy on a machine without the counter.
pub const NO_COUNTER: &str = "no counter power/energy-pkg/";

/// The path of a `perf` program that has been tried and can read the energy counters of the processors.
#[derive(Debug)]
pub struct Perf(PathBuf);

/// A running `perf stat` process that counts energy.
#[derive(Debug)]
pub struct Counting(Child);

impl Perf {
    /// Returns the `perf` at the path `program`. To test that it can count energy, it is started and stopped once.
    ///
    /// # Errors
    /// The reason why it cannot count, as text.
    pub fn open(program: &Path) -> Result<Self, String> {
        let perf = Self(program.to_owned());
        perf.start()?.stop()?;
        Ok(perf)
    }

    /// Starts `perf stat`, which counts the energy of all processors. Returns after 100 ms, when its counters run.
    ///
    /// # Errors
    /// The program does not start; the reason as text.
    pub fn start(&self) -> Result<Counting, String> {
        // `perf` counts until SIGINT ends it, and then writes the count to standard error. LC_ALL=C makes the decimal
        // separator a point.
        let child = Command::new(&self.0)
            .args(["stat", "-a", "-x", ",", "-e", "power/energy-pkg/", "sleep", "86400"])
            .env("LC_ALL", "C")
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .spawn()
            .map_err(|error| format!("no perf: {error}"))?;
        // `perf` does not tell when its counters start, so this waits 100 ms for them.
        std::thread::sleep(std::time::Duration::from_millis(100));
        Ok(Counting(child))
    }
}

impl Counting {
    /// Stops `perf` and returns the joules since its start.
    ///
    /// # Errors
    /// The message that `perf` wrote instead of a count.
    pub fn stop(self) -> Result<f64, String> {
        let process = i32::try_from(self.0.id()).map(Pid::from_raw).map_err(|error| error.to_string())?;
        // `kill` fails if `perf` has ended already. The output of `perf` then says why.
        let _ = kill(process, Signal::SIGINT);
        let output = self.0.wait_with_output().map_err(|error| format!("no perf: {error}"))?;
        joules(&String::from_utf8_lossy(&output.stderr))
    }
}

/// Returns the sum of the joules in the output of `perf stat`. There is one line for each package, such as
/// `12.34,Joules,power/energy-pkg/,1000000,100.00,,`.
fn joules(text: &str) -> Result<f64, String> {
    let lines: Vec<_> = text.lines().filter(|line| line.contains("power/energy-pkg/")).collect();
    let value = |line: &&str| line.split_once(",Joules,").and_then(|(number, _)| number.trim().parse::<f64>().ok());
    let values: Option<Vec<f64>> = lines.iter().map(value).collect();
    match values {
        Some(values) if !values.is_empty() => Ok(values.iter().sum()),
        // The message of `perf` for a counter that the machine lacks quotes the event and points into it.
        _ if text.contains("event syntax error") => Err(format!("no perf: {NO_COUNTER}")),
        _ => Err(format!(
            "no perf: {}",
            lines.first().copied().or(text.lines().next()).unwrap_or("it says nothing").trim()
        )),
    }
}

#[cfg(test)]
mod tests {
    use std::os::unix::fs::PermissionsExt;

    use test_support::folder::Folder;

    use super::*;

    #[test]
    fn joules_are_those_of_all_packages() {
        assert_eq!(joules("1.5,Joules,power/energy-pkg/,9,100.00,,\n2,Joules,power/energy-pkg/,9,100.00,,\n"), Ok(3.5));
        for text in
            ["", "<not supported>,Joules,power/energy-pkg/,0,100.00,,", "event syntax error: 'power/energy-pkg/'"]
        {
            assert!(joules(text).is_err_and(|reason| reason.starts_with("no perf: ")), "{text}");
        }
        let without = "event syntax error: 'power/energy-pkg/'\n                     \\___ Cannot find PMU `power'.";
        assert_eq!(joules(without), Err("no perf: no counter power/energy-pkg/".to_owned()));
    }

    #[test]
    fn counting_ends_with_what_was_counted() {
        let folder = Folder::new();
        let program = folder.file("perf");
        // A shell in the background starts its jobs with SIGINT ignored, and a script cannot trap a signal that was
        // ignored at its start. So `env` restores the default action first.
        let script = "#!/usr/bin/env -S --default-signal=INT sh\ntrap 'echo 7.25,Joules,power/energy-pkg/,1,100.00,, >&2; exit 0' INT\n\
                      while true; do sleep 0.01; done\n";
        std::fs::write(&program, script).expect("the folder is writable");
        std::fs::set_permissions(&program, std::fs::Permissions::from_mode(0o755)).expect("it is ours");
        let perf = Perf::open(&program).expect("it counts");
        assert_eq!(perf.start().and_then(Counting::stop), Ok(7.25));
        assert!(Perf::open(Path::new("/nowhere/perf")).is_err_and(|reason| reason.starts_with("no perf: ")));
    }
}
