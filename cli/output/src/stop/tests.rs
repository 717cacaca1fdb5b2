//! Tests with processes that get a signal while they write a file.

use crate::stop::*;
use std::fs::File;
use std::os::fd::AsRawFd;
use std::os::unix::ffi::OsStrExt;
use std::os::unix::process::ExitStatusExt;
use std::path::Path;
use std::process::Command;

use test_support::folder::Folder;

/// Registers a file as temporary. Its folder stays open until the process ends.
fn remember(path: &Path) -> Remembered {
    let folder = File::open(path.parent().expect("it lies in a folder")).expect("it is readable");
    let name = CString::new(path.file_name().expect("it is a file").as_bytes()).expect("it has no NUL");
    let remembered = Remembered::new(folder.as_raw_fd(), &name).expect("there are slots enough");
    std::mem::forget(folder);
    remembered
}

#[test]
fn a_file_that_is_dropped_is_removed_and_a_forgotten_one_is_not() {
    let folder = Folder::new();
    let [dropped, forgotten] = ["dropped", "forgotten"].map(|name| remember(&folder.write(name, "")));
    drop(dropped);
    forgotten.forget();
    assert_eq!(folder.names(), ["forgotten"]);
}

/// The code of the child processes that the tests below start. It registers files and raises a signal in itself.
/// Environment variables name the files and the signal.
#[test]
#[ignore = "ends its process: other tests start it"]
fn a_process_raises_a_signal() {
    let variable = |name| std::env::var(name).expect("another test started this one");
    let number: c_int = variable("RENDER_STOP_SIGNAL").parse().expect("it is a number");
    let before = variable("RENDER_STOP_BEFORE");
    // Set explicitly, because the signal is inherited as ignored when the tests run under nohup.
    // SAFETY: neither value runs any code of this process.
    unsafe { signal(number, if before == "ignored" { IGNORE } else { DEFAULT }) };
    match &before[..] {
        "unhandled" => {}
        "noted" => note_first_request(),
        _ => remove_temporary_when_stopped(),
    }
    let files: Vec<Remembered> =
        variable("RENDER_STOP_FILES").split(':').map(|path| remember(Path::new(path))).collect();
    if before == "forgotten" {
        files.into_iter().for_each(Remembered::forget);
    } else {
        // Never dropped, so that only the signal handler can remove the files.
        std::mem::forget(files);
    }
    // SAFETY: the handler of the signal may run at any time.
    assert_eq!(unsafe { raise(number) }, 0);
    assert_eq!(requested(), before == "noted");
    println!("it goes on");
    if before == "noted" {
        // SAFETY: the handler of the signal may run at any time.
        assert_eq!(unsafe { raise(number) }, 0);
    }
}

/// Runs a process that registers two files as temporary and raises the signal `number`. Returns the signal that ended
/// it, whether it continued after the first signal, and the number of files that are left.
fn signalled(number: c_int, before: &str) -> (Option<c_int>, bool, usize) {
    let folder = Folder::new();
    let files = ["one", "other"].map(|name| folder.write(name, "text").display().to_string());
    let output = Command::new(std::env::current_exe().expect("this process has a program"))
        .args(["--exact", "--ignored", "--nocapture", "stop::tests::a_process_raises_a_signal"])
        .env("RENDER_STOP_SIGNAL", number.to_string())
        .env("RENDER_STOP_BEFORE", before)
        .env("RENDER_STOP_FILES", files.join(":"))
        .output()
        .expect("the program runs");
    let went_on = String::from_utf8_lossy(&output.stdout).contains("it goes on");
    let signal = output.status.signal();
    assert!(signal.is_some() || (went_on && output.status.success()), "{output:?}");
    (signal, went_on, folder.names().len())
}

/// The signals that end a process, and whose handler removes its files.
fn listed() -> impl Iterator<Item = c_int> {
    REQUESTS.iter().chain(&FATAL).chain(MORE).copied()
}

#[test]
fn every_signal_that_ends_a_process_removes_its_files() {
    for number in listed() {
        assert_eq!(signalled(number, ""), (Some(number), false, 0));
    }
}

/// Raises every signal to learn which ones end a process, and checks that the lists above have all of them.
#[cfg(target_os = "linux")]
#[test]
fn the_lists_have_every_signal_that_ends_a_process() {
    // Not in the lists: SIGKILL, faults of memory, the limit on file sizes, signals that only stop a process, and two
    // that the C library reserves for itself.
    let left_out = [7, 9, 11, 19, 20, 21, 22, 25, 32, 33];
    for number in (1..=64).filter(|number| !left_out.contains(number)) {
        let ends = signalled(number, "unhandled").0 == Some(number);
        assert_eq!(listed().any(|listed| listed == number), ends, "signal {number}");
    }
}

#[test]
fn a_file_that_has_its_final_name_stays() {
    assert_eq!(signalled(15, "forgotten"), (Some(15), false, 2));
}

#[test]
fn signals_that_were_ignored_stay_ignored() {
    assert_eq!(signalled(1, "ignored"), (None, true, 2));
}

#[test]
fn a_first_request_may_be_noted_and_a_second_ends_the_process() {
    for number in REQUESTS {
        assert_eq!(signalled(number, "noted"), (Some(number), true, 0));
    }
}

#[cfg(any(target_os = "linux", target_os = "macos"))]
#[test]
fn the_limit_on_file_sizes_ends_no_process() {
    assert_eq!(signalled(FILE_SIZE.expect("it has one"), ""), (None, true, 2));
}
