//! Runs probes in a separate process, so that a driver that crashes does not end the program.
//!
//! The process writes a line for each outcome, which begins with the name of the probe. A driver that crashes, hangs or
//! loses the device ends the process. Then this is the outcome of the probe that the process was running, and a new
//! process runs the probes after it.

use std::ffi::OsString;
use std::io::{self, BufRead, BufReader};
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::time::Duration;

use super::outcome::Outcome;
use super::probe::Probe;
use super::{native, probes};
use crate::{Form, Gpu, gpu, guard};

/// The first argument of the separate process. With this argument the program only runs probes and writes outcomes.
pub const FLAG: &str = "--report-outcomes";

/// Time limit for the next outcome. It is longer than that of a run, whose message is more precise.
const PATIENCE: Duration = gpu::PATIENCE.saturating_add(Duration::from_secs(30));

/// Returns the command that runs `probes` in a process of `program` (which is `conformance`), in the form `form`.
#[must_use]
pub fn command(program: &Path, form: Form, probes: &[Probe]) -> Command {
    let mut command = Command::new(program);
    command.args([FLAG, &form.to_string()]);
    command.args(probes.iter().map(|probe| &probe.name));
    command
}

/// Does the work of the separate process: runs the probes of [`command`], and writes each outcome to standard output.
/// It ends after an outcome without results, because the device may be lost.
///
/// # Errors
/// A message for the user: there is no device, or standard output cannot be written.
pub fn report(arguments: impl Iterator<Item = OsString>) -> Result<(), String> {
    let arguments: Vec<_> = arguments.map(|argument| argument.to_string_lossy().into_owned()).collect();
    let form = arguments.first().map_or("", String::as_str).parse()?;
    let gpu = Gpu::open().map_err(|error| error.to_string())?.with_form(form);
    for probe in probes::all().iter().filter(|probe| arguments.contains(&probe.name)) {
        let outcome = native::run(&gpu, probe);
        output::print(format!("{} {}\n", probe.name, outcome.to_line()).as_bytes())
            .map_err(|error| error.to_string())?;
        if matches!(outcome, Outcome::Ended(_)) {
            break;
        }
    }
    Ok(())
}

/// Returns the outcome of each probe. `start` makes the command that runs the probes from one of them on.
///
/// # Errors
/// A message for the user: a process cannot be started, or the user interrupted the program.
pub fn run(probes: &[Probe], start: impl Fn(&[Probe]) -> Command) -> Result<Vec<Outcome>, String> {
    let mut outcomes = Vec::new();
    while outcomes.len() < probes.len() {
        let rest = &probes[outcomes.len()..];
        let failed = |error: io::Error| format!("the process that runs the probes: {error}");
        outcomes.extend(first_outcomes(start(rest), rest, PATIENCE).map_err(failed)?);
    }
    Ok(outcomes)
}

/// Runs the process of `probes`. Returns the outcomes until all are there or one is [`Outcome::Ended`]. It returns at
/// least one outcome.
fn first_outcomes(mut command: Command, probes: &[Probe], patience: Duration) -> io::Result<Vec<Outcome>> {
    let mut child = command.stdin(Stdio::null()).stdout(Stdio::piped()).spawn()?;
    let (sender, receiver) = mpsc::channel();
    let lines = child.stdout.take().into_iter().flat_map(|stdout| BufReader::new(stdout).lines());
    // The thread ends when the process has ended.
    std::thread::spawn(move || lines.map_while(Result::ok).try_for_each(|line| sender.send(line)));
    let late = || Outcome::Ended(format!("there was no result within {} s", patience.as_secs()));
    let mut outcomes = Vec::new();
    while let Some(probe) = probes.get(outcomes.len()).filter(|_| !matches!(outcomes.last(), Some(Outcome::Ended(_)))) {
        match receiver.recv_timeout(patience) {
            // Other lines are ignored, because a driver may write them.
            Ok(line) => outcomes.extend(line.strip_prefix(&probe.name).and_then(Outcome::of_line)),
            Err(RecvTimeoutError::Timeout) => outcomes.push(late()),
            Err(RecvTimeoutError::Disconnected) => outcomes.push(match guard::wait(&mut child, patience)? {
                Some(status) => Outcome::Ended(format!("the process ended by {status}")),
                None => late(),
            }),
        }
    }
    // A process that hangs is ended. If it has ended already, the call fails, which is no error.
    let _ = child.kill();
    child.wait()?;
    Ok(outcomes)
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    /// Returns the outcomes of a shell script that runs the first three probes.
    fn outcomes_of(script: &str) -> Vec<Outcome> {
        outcomes_within(PATIENCE, script)
    }

    fn outcomes_within(patience: Duration, script: &str) -> Vec<Outcome> {
        let mut command = Command::new("sh");
        command.args(["-c", script]);
        first_outcomes(command, &probes::all()[..3], patience).expect("every Unix has a shell")
    }

    /// Returns the command of the shell that writes the outcome of the probe at this place.
    fn echo(place: usize, outcome: &Outcome) -> String {
        format!("echo '{} {}'; ", probes::all()[place].name, outcome.to_line())
    }

    #[test]
    fn a_process_that_crashes_or_hangs_gives_an_outcome() {
        let ended = |cause: &str| Outcome::Ended(cause.to_owned());
        let unwritten = Outcome::Unwritten(1);
        assert_eq!(outcomes_of("kill -9 $$"), [ended("the process ended by signal: 9 (SIGKILL)")]);
        let crash = echo(0, &unwritten) + &echo(2, &unwritten) + "echo a driver writes; exit 7";
        assert_eq!(outcomes_of(&crash), [unwritten, ended("the process ended by exit status: 7")]);
        let hang = outcomes_within(Duration::from_millis(500), "exec sleep 1000");
        assert_eq!(hang, [ended("there was no result within 0 s")]);
    }

    #[test]
    fn a_process_is_ended_after_a_lost_device_and_after_the_last_outcome() {
        let [lost, unwritten] = [Outcome::Ended("lost".to_owned()), Outcome::Unwritten(1)];
        assert_eq!(outcomes_of(&(echo(0, &lost) + "exec sleep 1000")), [lost]);
        let all = (0..3).map(|place| echo(place, &unwritten)).collect::<String>();
        assert_eq!(outcomes_of(&(all + "exec sleep 1000")), vec![unwritten; 3]);
    }
}
