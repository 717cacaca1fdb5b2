//! Holds drivers to IEEE 754 and WGSL with small programs. `conformance --help` lists all options.

use std::path::Path;
use std::process::ExitCode;

use clap::Parser;
use cpu::internals::input::reader::read_text;
use gpu_check::conformance::args::Arguments;
use gpu_check::conformance::csv::Table;
use gpu_check::conformance::probe::Probe;
use gpu_check::conformance::report::{self, Run};
use gpu_check::conformance::{isolated, native, probes};
use gpu_check::shader_lab::files::shown;
use gpu_check::{Form, Gpu, terminal};
use output::{Options, Output, stop};

/// Exit status if a driver fails a probe.
const FAILS: u8 = 1;
/// Largest size of a table in bytes that is read.
const MAX_TABLE: u64 = 1 << 20;

fn main() -> ExitCode {
    gpu_check::runtime::ensure_folder();
    let mut arguments = std::env::args_os().skip(1);
    if arguments.next().is_some_and(|first| first == isolated::FLAG) {
        return status(isolated::report(arguments).map(|()| ExitCode::SUCCESS));
    }
    stop::remove_temporary_when_stopped();
    match Arguments::try_parse() {
        Ok(arguments) => status(run(&arguments)),
        Err(answer) => terminal::answer(&answer),
    }
}

/// Returns the exit status for a result. An error is written to standard error.
fn status(result: Result<ExitCode, String>) -> ExitCode {
    result.unwrap_or_else(|message| terminal::failed(&message))
}

fn run(arguments: &Arguments) -> Result<ExitCode, String> {
    let mut probes = probes::all();
    probes.retain(|probe| arguments.probe.is_empty() || arguments.probe.contains(&probe.name));
    if arguments.list {
        terminal::print(&report::list(&probes)).map_err(|error| error.to_string())?;
        return Ok(ExitCode::SUCCESS);
    }
    // The file is read and opened before the run, so that a mistake in its name is reported at once.
    let file = arguments.csv.as_deref().map(open).transpose()?;
    let run = outcomes(arguments, &probes)?;
    let text = if arguments.probe.is_empty() {
        report::table(&probes, &run)
    } else {
        let text = |(index, probe)| report::details(probe, &run, index);
        probes.iter().enumerate().map(text).collect::<Vec<_>>().join("\n")
    };
    terminal::print(&text).map_err(|error| error.to_string())?;
    if let Some((old, file)) = file {
        let text = old.with(&probes, &run).to_string();
        file.fill(|file| file.write_all(text.as_bytes())).map_err(|error| gpu_check::Error::from(error).to_string())?;
    }
    let fails = run.verdicts(&probes).iter().any(|verdict| verdict.is_failure());
    Ok(if fails { ExitCode::from(FAILS) } else { ExitCode::SUCCESS })
}

/// Opens a file for a table, and returns the table that it has already.
fn open(path: &Path) -> Result<(Table, Output), String> {
    let old = if path.is_file() {
        let text = read_text(path, MAX_TABLE).map_err(|error| format!("{}: {error}", shown(path)))?;
        Table::parse(&text).map_err(|error| format!("{}: {error}", shown(path)))?
    } else {
        Table::default()
    };
    let file = Output::open(path, Options { sync: true });
    file.map(|file| (old, file)).map_err(|error| gpu_check::Error::from(error).to_string())
}

/// Runs the probes on the adapter that the environment names.
fn outcomes(arguments: &Arguments, probes: &[Probe]) -> Result<Run, String> {
    let form = if arguments.as_driver_likes { Form::AsDriverLikes } else { Form::AsWritten };
    let gpu = Gpu::open().map_err(|error| error.to_string())?.with_form(form);
    let driver = native::driver(&gpu);
    let program = std::env::current_exe().map_err(|error| format!("this program: {error}"))?;
    let outcomes = isolated::run(probes, |rest| isolated::command(&program, form, rest))?;
    Ok(Run { driver, outcomes })
}
