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

use clap::error::{ContextKind, ContextValue, ErrorKind};
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
    // The system gives namespaces only to a process with one thread.
    if std::env::args_os().nth(1).is_some_and(|command| command == "supervise") {
        return run();
    }
    interrupt::block_wish();
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

/// Adds a tip to the error for an unknown option: the key of `--set` that it names, or the command that has it.
fn advise(error: &mut clap::Error, arguments: &[OsString]) {
    let Some(ContextValue::String(option)) = error.get(ContextKind::InvalidArg) else { return };
    if error.kind() != ErrorKind::UnknownArgument {
        return;
    }
    let (option, name) = (option.clone(), option.trim_start_matches('-').replace('-', "_"));
    let keys = format::CONFIG.iter().map(|line| line.tag.trim_end_matches(':'));
    let is_meant =
        |key: &&str| *key == name || key.starts_with(&format!("{name}_")) || key.ends_with(&format!("_{name}"));
    let command = arguments.get(1).and_then(|name| name.to_str()).unwrap_or_default();
    let has_keys = ["render", "animate"].contains(&command);
    let tip = if let (true, Some(key)) = (has_keys && !name.is_empty(), { keys }.find(is_meant)) {
        let words: Vec<_> = arguments.iter().filter_map(|word| word.to_str()).collect();
        let joined = words.iter().find_map(|word| word.strip_prefix(&*option)?.strip_prefix('='));
        let next = words.iter().skip_while(|word| **word != option).nth(1).filter(|next| !next.starts_with('-'));
        let value = joined.or(next.copied());
        format!("write '--set {key}={}'", value.unwrap_or("VALUE"))
    } else {
        let cli = cli::Cli::command();
        let options = cli.get_subcommands().filter(|other| !other.is_hide_set()).flat_map(|other| {
            other.get_opts().filter_map(|option| option.get_long()).map(|long| (long.as_bytes(), other.get_name()))
        });
        let all: Vec<_> = options.collect();
        let word = option.trim_start_matches('-').as_bytes();
        let Some(near) = format::hint::nearest(word, all.iter().map(|(long, _)| *long)) else { return };
        let near = String::from_utf8_lossy(near);
        // The suggested option is one of this command. It is the better one only if no other command has a nearer one.
        if error.get(ContextKind::SuggestedArg) == Some(&ContextValue::String(format!("--{near}"))) {
            return;
        }
        error.insert(ContextKind::SuggestedArg, ContextValue::None);
        let commands: Vec<_> = all.iter().filter(|(long, _)| *long == near.as_bytes()).map(|(_, name)| *name).collect();
        format!("'--{near}' is an option of {}", commands.join(", "))
    };
    error.insert(ContextKind::Suggested, ContextValue::StyledStrs(vec![tip.into()]));
}

/// Parses the command line. Prints the message of an error, or the help.
fn command_line() -> Result<cli::Cli, Failure> {
    let arguments: Vec<OsString> = std::env::args_os().collect();
    let matches = with_negative_numbers(cli::Cli::command()).try_get_matches_from(&arguments);
    matches.and_then(|matches| cli::Cli::from_arg_matches(&matches)).map_err(|mut error| {
        advise(&mut error, &arguments);
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
