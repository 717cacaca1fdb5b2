//! Processes that signals meet while they write a file.

use crate::output::stop::*;
use std::fs::File;
use std::os::fd::AsRawFd;
use std::os::unix::ffi::OsStrExt;
use std::os::unix::process::ExitStatusExt;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitStatus};

/// A file that a test may lose, under a name of its own.
fn file(name: &str) -> PathBuf {
    let path = std::env::temp_dir().join(format!("render-stop-{name}-{}", std::process::id()));
    std::fs::write(&path, "text").expect("the temporary folder is writable");
    path
}

/// Remembers a file. Its folder stays open for ever.
fn remember(path: &Path) -> Remembered {
    let folder = File::open(path.parent().expect("it lies in a folder")).expect("it is readable");
    let name = CString::new(path.file_name().expect("it is a file").as_bytes()).expect("it has no NUL");
    let remembered = Remembered::new(folder.as_raw_fd(), &name).expect("there are slots enough");
    std::mem::forget(folder);
    remembered
}

#[test]
fn a_file_that_is_dropped_is_removed_and_a_forgotten_one_is_not() {
    let [dropped, forgotten] = ["dropped", "forgotten-2"].map(file);
    let (one, other) = (remember(&dropped), remember(&forgotten));
    drop(one);
    other.forget();
    assert!(!dropped.exists());
    assert!(forgotten.exists());
    std::fs::remove_file(forgotten).expect("it is there");
}

/// What a child of the tests below does with the files and the signal that its environment names.
#[test]
#[ignore = "ends its process: other tests start it"]
fn a_signal_meets_the_process() {
    let variable = |name| std::env::var(name).expect("another test started this one");
    let number: c_int = variable("RENDER_STOP_SIGNAL").parse().expect("it is a number");
    let before = variable("RENDER_STOP_BEFORE");
    // Set, not taken as it is: whoever runs the tests under nohup hands on an ignored signal.
    // SAFETY: neither runs any code of this process.
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
        // Kept until the process ends, which is not by their drop.
        std::mem::forget(files);
    }
    // SAFETY: whatever handles the signal may run now.
    assert_eq!(unsafe { raise(number) }, 0);
    assert_eq!(requested(), before == "noted");
    println!("it goes on");
    if before == "noted" {
        // SAFETY: as above.
        assert_eq!(unsafe { raise(number) }, 0);
    }
}

/// How a process ended that was writing `files` when the signal came, and whether it went on at first.
fn met(number: c_int, before: &str, files: &[&Path]) -> (ExitStatus, bool) {
    let files: Vec<_> = files.iter().map(|file| file.to_str().expect("the name is ours")).collect();
    let output = Command::new(std::env::current_exe().expect("this process has a program"))
        .args(["--exact", "--ignored", "--nocapture", "output::stop::tests::a_signal_meets_the_process"])
        .env("RENDER_STOP_SIGNAL", number.to_string())
        .env("RENDER_STOP_BEFORE", before)
        .env("RENDER_STOP_FILES", files.join(":"))
        .output()
        .expect("the program runs");
    let went_on = String::from_utf8_lossy(&output.stdout).contains("it goes on");
    assert!(went_on || !output.status.success(), "{output:?}");
    (output.status, went_on)
}

#[test]
fn every_signal_that_ends_a_process_takes_its_files_along() {
    for &number in REQUESTS.iter().chain(&FATAL).chain(MORE) {
        let [one, other] = ["one", "other"].map(|name| file(&format!("{name}-{number}")));
        let (status, went_on) = met(number, "", &[&one, &other]);
        assert_eq!((status.signal(), went_on), (Some(number), false));
        assert!(!one.exists() && !other.exists(), "signal {number}");
    }
}

/// Asks the system which signals end a process, so that the lists above miss none.
#[cfg(target_os = "linux")]
#[test]
fn the_lists_have_every_signal_that_ends_a_process() {
    // Left to others: killing, faults of memory, the limit on file sizes, what stops and does not end, and two that are
    // the C library's own.
    let left_out = [7, 9, 11, 19, 20, 21, 22, 25, 32, 33];
    for number in (1..=64).filter(|number| !left_out.contains(number)) {
        let file = file(&format!("unhandled-{number}"));
        let ends = met(number, "unhandled", &[&file]).0.signal() == Some(number);
        let listed = REQUESTS.iter().chain(&FATAL).chain(MORE).any(|&listed| listed == number);
        assert_eq!(listed, ends, "signal {number}");
        std::fs::remove_file(file).expect("it is there");
    }
}

#[test]
fn a_file_that_has_its_place_stays() {
    let file = file("forgotten");
    assert_eq!(met(15, "forgotten", &[&file]).0.signal(), Some(15));
    std::fs::remove_file(file).expect("it is there");
}

#[test]
fn signals_that_were_ignored_stay_ignored() {
    let file = file("ignored");
    assert!(met(1, "ignored", &[&file]).0.success());
    std::fs::remove_file(file).expect("it is there");
}

#[test]
fn a_first_request_may_be_noted_and_a_second_ends_the_process() {
    for number in REQUESTS {
        let file = file(&format!("noted-{number}"));
        let (status, went_on) = met(number, "noted", &[&file]);
        assert_eq!((status.signal(), went_on), (Some(number), true));
        assert!(!file.exists());
    }
}

#[cfg(any(target_os = "linux", target_os = "macos"))]
#[test]
fn the_limit_on_file_sizes_ends_no_process() {
    let file = file("size");
    assert!(met(FILE_SIZE.expect("it has one"), "", &[&file]).0.success());
    std::fs::remove_file(file).expect("it is there");
}
