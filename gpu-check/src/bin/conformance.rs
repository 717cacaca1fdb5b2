//! Holds drivers to IEEE 754 and WGSL with small programs. `conformance --help` lists all options.

use std::process::ExitCode;

use clap::Parser;
use gpu_check::conformance::args::{Arguments, choose};
use gpu_check::conformance::probe::Probe;
use gpu_check::conformance::report::{self, Run};
use gpu_check::conformance::{browser, isolated, native, probes};
use gpu_check::web::chromium;
use gpu_check::{Form, Gpu, terminal};
use output::{Options, Output, stop};

/// Exit status if a driver fails a probe.
const FAILS: u8 = 1;
/// Exit status for an error.
const TROUBLE: u8 = 2;
/// Exit status if a signal has interrupted the program.
const INTERRUPTED: u8 = 130;

fn main() -> ExitCode {
    gpu_check::runtime::ensure_folder();
    let mut arguments = std::env::args_os().skip(1);
    if arguments.next().is_some_and(|first| first == isolated::FLAG) {
        return status(isolated::report(arguments).map(|()| ExitCode::SUCCESS));
    }
    // After a first signal the program ends the browser and removes its folder.
    stop::note_first_request();
    let result = match Arguments::try_parse() {
        Ok(arguments) => run(&arguments),
        Err(message) if message.use_stderr() => {
            // The message repeats the arguments, so its control characters must be escaped for the terminal.
            terminal::note(message.render().to_string().trim_end());
            return ExitCode::from(TROUBLE);
        }
        Err(help) => terminal::print(&help.render().to_string()).map(|()| ExitCode::SUCCESS).map_err(|e| e.to_string()),
    };
    if stop::requested() { ExitCode::from(INTERRUPTED) } else { status(result) }
}

/// Returns the exit status for a result. An error is written to standard error.
fn status(result: Result<ExitCode, String>) -> ExitCode {
    match result {
        Ok(status) => status,
        Err(message) => {
            terminal::note(&format!("Error: {message}"));
            ExitCode::from(TROUBLE)
        }
    }
}

fn run(arguments: &Arguments) -> Result<ExitCode, String> {
    let all = probes::all();
    let names: Vec<_> = all.iter().map(|probe| probe.name.as_str()).collect();
    let chosen = choose(&names, &arguments.probe)?;
    let probes: Vec<Probe> =
        all.into_iter().enumerate().filter(|(index, _)| chosen.contains(index)).map(|(_, probe)| probe).collect();
    if arguments.list {
        terminal::print(&report::list(&probes)).map_err(|error| error.to_string())?;
        return Ok(ExitCode::SUCCESS);
    }
    // The file is opened before the run, so that a name that cannot be written is reported at once.
    let file = arguments.json.as_ref().map(|path| Output::open(path, Options { sync: true }));
    let file = file.transpose().map_err(|error| gpu_check::Error::from(error).to_string())?;
    let runs = runs(arguments, &probes)?;
    let text = match (arguments.probe.is_empty(), arguments.csv) {
        (false, _) => {
            let text = |(index, probe)| report::details(probe, &runs, index);
            probes.iter().enumerate().map(text).collect::<Vec<_>>().join("\n")
        }
        (true, true) => report::csv(&probes, &runs),
        (true, false) => report::table(&probes, &runs),
    };
    terminal::print(&text).map_err(|error| error.to_string())?;
    if let Some(file) = file {
        let json = report::json(&probes, &runs);
        file.fill(|file| file.write_all(json.as_bytes())).map_err(|error| gpu_check::Error::from(error).to_string())?;
    }
    let fails = runs.iter().any(|run| run.verdicts(&probes).iter().any(|verdict| verdict.is_failure()));
    Ok(if fails { ExitCode::from(FAILS) } else { ExitCode::SUCCESS })
}

/// Runs the probes on all drivers that the arguments ask for.
fn runs(arguments: &Arguments, probes: &[Probe]) -> Result<Vec<Run>, String> {
    let mut runs = Vec::new();
    let gpus = match (arguments.no_native, arguments.all) {
        (true, _) => Ok(Vec::new()),
        (false, true) => Gpu::open_all(),
        (false, false) => Gpu::open().map(|gpu| vec![gpu]),
    };
    let form = if arguments.as_driver_likes { Form::AsDriverLikes } else { Form::AsWritten };
    let gpus = gpus.map_err(|error| error.to_string())?.into_iter().map(|gpu| gpu.with_form(form));
    let drivers: Vec<_> = gpus.map(|gpu| native::driver(&gpu)).collect();
    let program = std::env::current_exe().map_err(|error| format!("this program: {error}"))?;
    for (device, driver) in drivers.into_iter().enumerate() {
        let device = arguments.all.then_some(device);
        let outcomes = isolated::run(probes, |rest| isolated::command(&program, device, form, rest))?;
        runs.push(Run { driver, outcomes });
    }
    if arguments.browser {
        let chromium = chromium::find().ok_or("there is no Chromium in PATH; on Debian: apt-get install chromium")?;
        let (driver, outcomes) = browser::run(&chromium, probes)?;
        runs.push(Run { driver, outcomes });
    }
    Ok(runs)
}
