//! The folder that drivers expect a session to have.

/// Starts the program again, in its own place, with `XDG_RUNTIME_DIR` set where it is not: without it Mesa writes a
/// complaint to standard error before every run. The variable of a running process cannot be set safely.
pub fn ensure_folder() {
    #[cfg(unix)]
    {
        use std::os::unix::process::CommandExt;
        use std::path::Path;

        use cpu::internals::output::{Options, Output};

        const NAME: &str = "XDG_RUNTIME_DIR";
        // A new start would hide that standard output is closed: the standard library opens /dev/null in its place.
        if Output::open(Path::new("/dev/stdout"), Options::default()).is_err() {
            return;
        }
        if std::env::var_os(NAME).is_some_and(|folder| !folder.is_empty()) {
            return;
        }
        if let Ok(program) = std::env::current_exe() {
            let mut command = std::process::Command::new(program);
            // It comes back only where it fails; then the complaint is all that is lost.
            let _ = command.args(std::env::args_os().skip(1)).env(NAME, std::env::temp_dir()).exec();
        }
    }
}
