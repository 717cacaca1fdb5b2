//! `render-lab`: renders with progress, compares pictures, inspects scenes, and measures the renderer.
//!
//! Each command has its own module in [`commands`]. The other modules hold what several commands use: [`picture`] reads
//! and writes pictures, [`difference`] compares two of them, [`engine`] lists the implementations. [`mod@bench`]
//! measures, and [`report`] converts the data into charts and pages. [`check`] holds other programs to the
//! specification, and [`grade`] grades many of them; [`supervise`] runs them. [`convert`] writes scenes for pbrt and
//! Mitsuba. [`view`] answers the requests of the page in `web/site`.
//!
//! `cpu` does all rendering, on one thread.

pub mod bench;
pub mod check;
pub mod checkpoint;
pub mod cli;
pub mod commands;
pub mod convert;
pub mod difference;
pub mod engine;
pub mod failure;
pub mod grade;
pub mod heatmap;
pub mod interrupt;
pub mod numbers;
pub mod picture;
pub mod report;
pub mod show;
pub mod sources;
pub mod supervise;
pub mod template;
pub mod terminal;
pub mod view;

use std::ffi::OsString;
use std::io::IsTerminal;
use std::process::ExitCode;

use clap::{Arg, Command, CommandFactory, FromArgMatches};

pub use failure::Failure;
pub use format;

/// Size in bytes of the stack of the thread that does all work.
const STACK_BYTES: usize = 8 << 20;

/// Runs the command that the arguments of this process name, and returns the exit status. The message of an error goes
/// to standard error.
pub fn main() -> ExitCode {
    // From here on, a signal that ends the process first removes the temporary files.
    output::stop::remove_temporary_when_stopped();
    // A debug build needs about 300 kB of stack. The main thread's stack may be smaller, so another thread does all
    // work.
    let thread = std::thread::Builder::new().name("main".to_owned()).stack_size(STACK_BYTES);
    match thread.spawn(run).map(std::thread::JoinHandle::join) {
        Ok(Ok(status)) => status,
        // The thread panicked, and the panic has printed its message.
        Ok(Err(_)) => ExitCode::from(2),
        // There is too little memory for another stack, so the main thread does the work.
        Err(_) => run(),
    }
}

fn run() -> ExitCode {
    match command_line().and_then(|cli| cli.run()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            if let Some(message) = failure.message() {
                let kind = if matches!(failure, Failure::Kept { .. }) { "Not finished" } else { "Error" };
                terminal::note(&format!("{kind}: {message}"));
            }
            ExitCode::from(failure.status())
        }
    }
}

/// Returns the command whose options take negative numbers. So the message for one tells which numbers are allowed.
fn with_negative_numbers(command: Command) -> Command {
    let takes_value = |option: &Arg| !option.is_positional() && option.get_action().takes_values();
    let option = |option: Arg| if takes_value(&option) { option.allow_negative_numbers(true) } else { option };
    command.mut_args(option).mut_subcommands(with_negative_numbers)
}

/// Parses the command line. Prints the message of an error, or the help.
fn command_line() -> Result<cli::Cli, Failure> {
    let arguments: Vec<OsString> = std::env::args_os().collect();
    let matches = with_negative_numbers(cli::Cli::command()).try_get_matches_from(&arguments);
    matches.and_then(|matches| cli::Cli::from_arg_matches(&matches)).map_err(|error| {
        let is_clean = |argument: &OsString| {
            cpu::internals::input::text::escape(argument.as_encoded_bytes()).as_bytes() == argument.as_encoded_bytes()
        };
        if error.use_stderr() {
            if arguments.iter().all(is_clean) {
                let _ = error.print();
            } else {
                // The message repeats the arguments. Their control characters must be escaped before they reach the
                // terminal.
                terminal::note(&error.render().to_string());
            }
            return Failure::Printed(2);
        }
        let written = if std::io::stdout().is_terminal() {
            error.print().map_err(Failure::from)
        } else {
            terminal::write(error.render().to_string().as_bytes())
        };
        written.err().unwrap_or(Failure::Printed(0))
    })
}
