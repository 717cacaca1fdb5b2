//! Sets the folder of the user's session, which Mesa's drivers look for.

/// Starts the program again with the variable `XDG_RUNTIME_DIR` if that variable is not set; the new start replaces
/// this process. Without the variable, Mesa writes a warning to standard error before every run. Setting a variable in
/// a running process is unsafe.
pub fn ensure_folder() {
    #[cfg(unix)]
    {
        use std::os::unix::process::CommandExt;
        use std::path::Path;

        use output::{Options, Output};

        const NAME: &str = "XDG_RUNTIME_DIR";
        // A new start would hide that standard output is closed, because the standard library opens /dev/null in its
        // place.
        if Output::open(Path::new("/dev/stdout"), Options::default()).is_err() {
            return;
        }
        if std::env::var_os(NAME).is_some_and(|folder| !folder.is_empty()) {
            return;
        }
        if let Ok(program) = std::env::current_exe() {
            let mut command = std::process::Command::new(program);
            // `exec` returns only if it fails. Then the program continues, and Mesa writes its warning.
            let _ = command.args(std::env::args_os().skip(1)).env(NAME, std::env::temp_dir()).exec();
        }
    }
}
