//! The folder of the session, which Mesa's drivers look for.

/// If `XDG_RUNTIME_DIR` is not set, replaces this process by a new start of the program with the variable set. Without
/// it Mesa writes a warning to standard error before every run. Setting the variable in a running process is unsafe.
pub fn ensure_folder() {
    #[cfg(unix)]
    {
        use std::os::unix::process::CommandExt;
        use std::path::Path;

        use output::{Options, Output};

        const NAME: &str = "XDG_RUNTIME_DIR";
        // If standard output is closed, a new start would hide that, because the standard library then opens /dev/null
        // in its place.
        if Output::open(Path::new("/dev/stdout"), Options::default()).is_err() {
            return;
        }
        if std::env::var_os(NAME).is_some_and(|folder| !folder.is_empty()) {
            return;
        }
        if let Ok(program) = std::env::current_exe() {
            let mut command = std::process::Command::new(program);
            // `exec` returns only when it fails. Then the program goes on, and Mesa writes its warning.
            let _ = command.args(std::env::args_os().skip(1)).env(NAME, std::env::temp_dir()).exec();
        }
    }
}
