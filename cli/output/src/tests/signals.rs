//! Tests with processes that get a signal while a temporary file has its hidden name.

use std::ffi::c_int;
use std::os::unix::process::ExitStatusExt;
use std::process::Command;

use crate::stop::{Name, note_first_request, remove_temporary_when_stopped, requested};
use crate::tests::*;

/// Registers a name and creates its file in `folder`, which stays open until the process ends.
fn make(folder: &Folder) -> &'static Name {
    let open = Box::leak(Box::new(File::open(folder.path()).expect("it is readable")));
    let create = |name: &std::ffi::CStr| {
        fs::write(folder.file(name.to_str().expect("it is text")), "half").expect("the folder is writable");
        Ok(())
    };
    Name::new(open, create).expect("the folder is writable").0.expect("it has a name")
}

#[test]
fn a_temporary_file_is_removed_once_and_a_forgotten_or_foreign_one_is_not() {
    let folder = Folder::new();
    let names = [(); 40].map(|()| make(&folder));
    assert_eq!(folder.names().len(), 40, "the names differ");
    names[1..].iter().for_each(|name| name.remove());
    names[0].forget();
    names[0].remove();
    assert_eq!(folder.names(), [names[0].name.to_str().expect("it is text")]);
    let open = File::open(folder.path()).expect("it is readable");
    assert!(Name::new::<()>(&open, |_| Err(rustix::io::Errno::EXIST)).is_err());
    assert_eq!(folder.names().len(), 1);
}

/// The code of the child processes that the tests below start: it makes two files and gets a signal from itself.
/// Environment variables name the folder, the signal, and the handler.
#[test]
#[ignore = "ends its process: other tests start it"]
fn a_process_gets_a_signal() {
    let variable = |name| std::env::var(name).expect("another test started this one");
    let number: c_int = variable("RENDER_STOP_SIGNAL").parse().expect("it is a number");
    let before = variable("RENDER_STOP_BEFORE");
    if before == "noted" {
        note_first_request()
    } else {
        remove_temporary_when_stopped()
    }
    let folder = std::mem::ManuallyDrop::new(Folder::new());
    fs::write(variable("RENDER_STOP_FOLDER"), folder.name("")).expect("the folder is writable");
    let _files = [make(&folder), make(&folder)];
    let send = || Command::new("kill").args([format!("-{number}"), std::process::id().to_string()]).status();
    assert!(send().expect("every Unix has kill").success());
    std::thread::sleep(std::time::Duration::from_millis(if before.is_empty() { 60_000 } else { 50 }));
    assert_eq!(requested(), before == "noted");
    println!("it goes on");
    if before == "noted" {
        send().expect("every Unix has kill");
        std::thread::sleep(std::time::Duration::from_secs(60));
    }
}

/// Runs a process that makes two temporary files and gets the signal `number`. Returns the signal that ended it,
/// whether it continued after the first signal, and the number of files that are left.
fn signalled(number: c_int, before: &str) -> (Option<c_int>, bool, usize) {
    let folder = Folder::new();
    let program = std::env::current_exe().expect("this process has a program");
    // `env` sets the action of the signal, because a test under nohup inherits it as ignored, which a shell cannot
    // undo.
    let action = if before == "ignored" { "ignore" } else { "default" };
    let output = Command::new("env")
        .arg(format!("--{action}-signal={number}"))
        .arg(program)
        .args(["--exact", "--ignored", "--nocapture", "tests::signals::a_process_gets_a_signal"])
        .env("RENDER_STOP_SIGNAL", number.to_string())
        .env("RENDER_STOP_BEFORE", before)
        .env("RENDER_STOP_FOLDER", folder.file("name"))
        .output()
        .expect("the program runs");
    let went_on = String::from_utf8_lossy(&output.stdout).contains("it goes on");
    let signal = output.status.signal();
    assert!(signal.is_some() || (went_on && output.status.success()), "{output:?}");
    let own = PathBuf::from(fs::read_to_string(folder.file("name")).expect("it was written"));
    let left = fs::read_dir(&own).expect("it is there").count();
    fs::remove_dir_all(own).expect("it is ours");
    (signal, went_on, left)
}

#[test]
fn every_signal_that_ends_a_process_from_outside_removes_its_files() {
    for number in [1, 2, 3, 6, 10, 12, 14, 15, 24] {
        assert_eq!(signalled(number, ""), (Some(number), false, 0));
    }
}

#[test]
fn signals_that_were_ignored_stay_ignored_and_the_limit_on_file_sizes_ends_no_process() {
    for number in [1, 2] {
        assert_eq!(signalled(number, "ignored"), (None, true, 2));
    }
    assert_eq!(signalled(25, "limit"), (None, true, 2));
}

#[test]
fn a_first_request_may_be_noted_and_a_second_ends_the_process() {
    for number in [1, 2, 15] {
        assert_eq!(signalled(number, "noted"), (Some(number), true, 0));
    }
}
