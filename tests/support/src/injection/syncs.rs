//! Checks which files and folders a program syncs.

use std::ffi::OsString;
use std::fs;
use std::path::Path;
use std::process::Command;

/// The calls that wait until data are on the disk.
const CALLS: &str = "trace=fsync,fdatasync,sync,syncfs,sync_file_range";

/// Checks that `program` writes `count` files into `folder`, and syncs each of them and then the folder. With the
/// further argument `--no-sync` it must sync nothing.
///
/// # Errors
/// `strace` does not run, the program fails, or it syncs other files than it should.
pub fn check_syncs(program: &Path, arguments: &[OsString], folder: &Path, count: usize) -> Result<(), String> {
    let folder = fs::canonicalize(folder).map_err(|error| error.to_string())?;
    let synced = synced(program, arguments, &folder)?;
    let is_right = |pair: &[String]| {
        // A file without a name has a path in its folder too, as the system shows it.
        matches!(pair, [file, after] if Path::new(file).parent() == Some(&folder) && Path::new(after) == folder)
    };
    if synced.len() != 2 * count || !synced.chunks(2).all(is_right) {
        return Err(format!("{count} files and their folder {folder:?} should be synced, but it syncs {synced:?}"));
    }
    let unsynced = self::synced(program, &[arguments, &["--no-sync".into()]].concat(), &folder)?;
    if unsynced.is_empty() { Ok(()) } else { Err(format!("with --no-sync it syncs {unsynced:?}")) }
}

/// Runs the program and returns the paths that it syncs, in order. `strace` writes its log beside `folder`.
fn synced(program: &Path, arguments: &[OsString], folder: &Path) -> Result<Vec<String>, String> {
    let log = folder.with_file_name("syncs.log");
    let mut strace = Command::new("strace");
    strace.args(["-f", "-y", "-qq", "-e", CALLS, "-e", "signal=none", "-o"]).arg(&log).arg(program).args(arguments);
    let output = strace.output().map_err(|error| error.to_string())?;
    if !output.status.success() {
        return Err(format!("{output:?}"));
    }
    let text = fs::read(&log).map_err(|error| error.to_string())?;
    Ok(paths(&String::from_utf8_lossy(&text)))
}

/// Returns the paths in the output of `strace -f -y`. A call of the whole system has no path, and gives an empty one.
fn paths(text: &str) -> Vec<String> {
    let calls = text.lines().filter_map(|line| Some(line.split_once("sync")?.1.split_once('(')?.1));
    let path = |call: &str| Some(call.split_once('<')?.1.split_once('>')?.0.to_owned());
    calls.map(|call| path(call).unwrap_or_default()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_paths_of_all_calls_are_found() {
        let text = "7 fsync(3</t/d/#5 (deleted)>) = 0\n8 fdatasync(4</t/d> <unfinished ...>\n7 sync() = 0\n\
                    8 <... fdatasync resumed>) = 0\n";
        assert_eq!(paths(text), ["/t/d/#5 (deleted)", "/t/d", ""]);
    }
}
