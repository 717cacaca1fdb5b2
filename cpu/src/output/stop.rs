//! A process that is asked to stop takes its temporary file with it.
//!
//! A picture under a temporary name is half a picture: nobody wants it, and nobody would ever remove it. The name of the
//! one file that is being written is kept where a signal handler may look; the programs install such a handler, the
//! library alone changes nothing about signals. Against SIGKILL nothing helps: the old picture stands, and a hidden
//! `.render-*.tmp` may stay beside it.

#![allow(unsafe_code)]

use std::ffi::{CString, c_char, c_int};
use std::os::unix::ffi::OsStrExt;
use std::path::Path;
use std::ptr;
use std::sync::atomic::{AtomicPtr, Ordering};

/// The file that is being written.
static TEMPORARY: Slot = Slot(AtomicPtr::new(ptr::null_mut()));

/// A place for one path, as `unlink` takes it, or null. Whoever swaps it out owns it.
struct Slot(AtomicPtr<c_char>);

/// Hangup, interruption, quit and termination have these numbers on every Unix.
const STOPS: [c_int; 4] = [1, 2, 3, 15];
/// The limit on processor time, and the one on file sizes, whose signal is better an error of the write.
#[cfg(any(target_os = "linux", target_os = "macos"))]
const LIMITS: Option<[c_int; 2]> = Some([24, 25]);
#[cfg(not(any(target_os = "linux", target_os = "macos")))]
const LIMITS: Option<[c_int; 2]> = None;

/// What a signal may be set to beside the address of a function.
const DEFAULT: usize = 0;
const IGNORE: usize = 1;

// SAFETY: the C library of every Unix has these, with these types; the standard library links it already.
unsafe extern "C" {
    fn signal(number: c_int, handler: usize) -> usize;
    fn raise(number: c_int) -> c_int;
    fn unlink(path: *const c_char) -> c_int;
}

impl Slot {
    fn remember(&self, path: &Path) {
        // A path with a NUL byte names no file that could be there.
        let name = CString::new(path.as_os_str().as_bytes()).map_or(ptr::null_mut(), CString::into_raw);
        free(self.0.swap(name, Ordering::SeqCst));
    }

    fn forget(&self) {
        free(self.0.swap(ptr::null_mut(), Ordering::SeqCst));
    }

    /// Calls nothing but what a signal handler may call.
    fn remove(&self) {
        // Not freed: the process ends, and a signal handler may not free.
        let name = self.0.swap(ptr::null_mut(), Ordering::SeqCst);
        if !name.is_null() {
            // SAFETY: it is a C string from `remember` that only this swap took out, and it is never freed.
            unsafe { unlink(name) };
        }
    }
}

fn free(name: *mut c_char) {
    if !name.is_null() {
        // SAFETY: it comes from `CString::into_raw` in `remember`, and having swapped it out nobody else has it.
        drop(unsafe { CString::from_raw(name) });
    }
}

/// From now on the file at `path` is removed when the process is asked to stop. One file at a time: a second takes the
/// place of the first.
pub(super) fn remember(path: &Path) {
    TEMPORARY.remember(path);
}

/// The file has its place or is gone.
pub(super) fn forget() {
    TEMPORARY.forget();
}

/// Removes the file that is being written, if any: for whoever is about to end the process. Does nothing that a signal
/// handler may not do.
pub fn remove_temporary() {
    TEMPORARY.remove();
}

/// From now on a signal that asks this process to stop removes the temporary file first; the process then ends by the
/// signal, as it would have. Signals that are ignored stay ignored, as `nohup` wants it. A write beyond the limit on file
/// sizes becomes an error and not a signal.
pub fn remove_temporary_when_stopped() {
    let [processor_time, file_size] = LIMITS.map_or([None; 2], |limits| limits.map(Some));
    for number in STOPS.into_iter().chain(processor_time) {
        // SAFETY: `stop` has the type of a handler, and calls nothing but what a handler may call.
        unsafe {
            if signal(number, stop as extern "C" fn(c_int) as usize) == IGNORE {
                signal(number, IGNORE);
            }
        }
    }
    if let Some(number) = file_size {
        // SAFETY: ignoring a signal runs no code.
        unsafe { signal(number, IGNORE) };
    }
}

extern "C" fn stop(number: c_int) {
    remove_temporary();
    // SAFETY: both may be called in a handler. The signal waits until the handler returns, and then ends the process.
    unsafe {
        signal(number, DEFAULT);
        raise(number);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::os::unix::process::ExitStatusExt;
    use std::path::PathBuf;
    use std::process::{Command, ExitStatus};

    /// A file that a test may lose, under a name of its own.
    fn file(name: &str) -> PathBuf {
        let path = std::env::temp_dir().join(format!("render-stop-{name}-{}", std::process::id()));
        std::fs::write(&path, "text").expect("the temporary folder is writable");
        path
    }

    #[test]
    fn the_last_file_that_is_remembered_is_removed_and_no_other() {
        // A slot of its own: other tests write files, and what they remember is not to be removed.
        let slot = Slot(AtomicPtr::new(ptr::null_mut()));
        let [first, second, third] = ["first", "second", "third"].map(file);
        slot.remove();
        slot.remember(&first);
        slot.remember(&second);
        slot.remove();
        assert!(first.exists(), "it was forgotten for the second");
        assert!(!second.exists());
        slot.remember(&third);
        slot.forget();
        slot.remove();
        assert!(third.exists(), "it was forgotten");
        for path in [first, third] {
            std::fs::remove_file(path).expect("it is there");
        }
    }

    /// What a child of the tests below does with the file and the signal that its environment names.
    #[test]
    #[ignore = "ends its process: other tests start it"]
    fn a_signal_meets_the_process() {
        let variable = |name| std::env::var(name).expect("another test started this one");
        let number: c_int = variable("RENDER_STOP_SIGNAL").parse().expect("it is a number");
        let before = variable("RENDER_STOP_BEFORE");
        // Set, not taken as it is: whoever runs the tests under nohup hands on an ignored signal.
        // SAFETY: neither runs any code of this process.
        unsafe { signal(number, if before == "ignored" { IGNORE } else { DEFAULT }) };
        remove_temporary_when_stopped();
        remember(Path::new(&variable("RENDER_STOP_FILE")));
        if before == "forgotten" {
            forget();
        }
        // SAFETY: whatever handles the signal may run now.
        assert_eq!(unsafe { raise(number) }, 0);
        println!("it goes on");
    }

    /// How a process ended that was writing `file` when the signal came.
    fn met(number: c_int, before: &str, file: &Path) -> ExitStatus {
        let output = Command::new(std::env::current_exe().expect("this process has a program"))
            .args(["--exact", "--ignored", "--nocapture", "output::stop::tests::a_signal_meets_the_process"])
            .env("RENDER_STOP_SIGNAL", number.to_string())
            .env("RENDER_STOP_BEFORE", before)
            .env("RENDER_STOP_FILE", file)
            .output()
            .expect("the program runs");
        let went_on = String::from_utf8_lossy(&output.stdout).contains("it goes on");
        assert_eq!(went_on, output.status.success(), "{output:?}");
        output.status
    }

    #[test]
    fn a_process_that_is_asked_to_stop_ends_by_the_signal_and_takes_its_file_along() {
        for number in STOPS.into_iter().chain(LIMITS.map(|[processor_time, _]| processor_time)) {
            let file = file(&format!("asked-{number}"));
            assert_eq!(met(number, "", &file).signal(), Some(number));
            assert!(!file.exists(), "signal {number}");
        }
    }

    #[test]
    fn a_file_that_has_its_place_stays() {
        let file = file("forgotten");
        assert_eq!(met(STOPS[3], "forgotten", &file).signal(), Some(STOPS[3]));
        std::fs::remove_file(file).expect("it is there");
    }

    #[test]
    fn signals_that_were_ignored_stay_ignored() {
        let file = file("ignored");
        assert!(met(STOPS[0], "ignored", &file).success());
        std::fs::remove_file(file).expect("it is there");
    }

    #[cfg(any(target_os = "linux", target_os = "macos"))]
    #[test]
    fn the_limit_on_file_sizes_ends_no_process() {
        let file = file("size");
        assert!(met(LIMITS.expect("it has limits")[1], "", &file).success());
        std::fs::remove_file(file).expect("it is there");
    }
}
