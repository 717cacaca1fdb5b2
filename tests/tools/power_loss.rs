//! Simulates a loss of power at any moment. The tests record the system calls of a process that writes a file. After
//! each call, a model of a file system gives the contents that POSIX allows if the power fails then. With
//! [`Options::sync`] these must be the old file or the new one.

#[path = "file_system.rs"]
mod file_system;

use std::collections::{BTreeSet, HashMap};
use std::path::Path;
use std::process::Command;

use libtest_mimic::{Failed, Trial};
use output::{Options, Output};
use test_support::folder::Folder;
use test_support::injection::{Disturbance, unavailable};
use test_support::trial;

use file_system::{Event, outcomes};

/// The first argument of the process that writes. The file's path follows, and [`SYNC`] if the file must be synced.
const WRITE: &str = "write-a-file";
const SYNC: &str = "sync";

/// The pieces of the file, each of which is written by its own call.
const PIECES: [&[u8]; 3] = [b"the first piece, ", b"the second, ", b"and the last"];

pub fn trials() -> Vec<Trial> {
    let missing = unavailable(Disturbance::Errors);
    vec![
        trial("power_loss: a_synced_file_is_the_old_one_or_the_new_one_at_any_moment", missing, synced),
        trial("power_loss: without_syncing_an_empty_file_may_stand", missing, not_synced),
    ]
}

/// If a test has started this process to write a file, writes the file and ends the process. Otherwise does nothing.
pub fn write_if_asked() {
    let mut arguments = std::env::args_os().skip(1);
    let Some(path) = arguments.next().filter(|first| first == WRITE).and_then(|_| arguments.next()) else { return };
    let sync = arguments.next().is_some_and(|word| word == SYNC);
    let written = Output::open(Path::new(&path), Options { sync })
        .and_then(|output| output.fill(|file| PIECES.iter().try_for_each(|piece| file.write_all(piece))));
    std::process::exit(i32::from(written.is_err()));
}

/// The cases: whether the new file has a temporary name, and the content of the old file (`None` if there is no old
/// file).
const CASES: [(bool, Option<&[u8]>); 4] = [(false, None), (false, Some(b"old")), (true, None), (true, Some(b"old"))];

fn synced() -> Result<(), Failed> {
    for (named, old) in CASES {
        let events = record(named, old, true)?;
        let (old, new) = (old.map(<[u8]>::to_vec), Some(PIECES.concat()));
        let allowed = BTreeSet::from([old.clone(), new.clone()]);
        for count in 0..=events.len() {
            let found = outcomes(&events[..count], "out", &old);
            assert!(found.is_subset(&allowed), "after {:?}: {found:?}", &events[..count]);
        }
        assert_eq!(outcomes(&events, "out", &old), BTreeSet::from([new]), "{events:?}");
    }
    Ok(())
}

/// Checks that without syncing an empty file may remain. The evaluated programs accept this risk, because syncing takes
/// longer than writing.
fn not_synced() -> Result<(), Failed> {
    for (named, old) in CASES {
        let events = record(named, old, false)?;
        let old = old.map(<[u8]>::to_vec);
        let found = outcomes(&events, "out", &old);
        assert!(found.contains(&old) && found.contains(&Some(PIECES.concat())));
        assert!(found.contains(&Some(Vec::new())), "nothing forces the bytes onto the disk before the name: {found:?}");
    }
    Ok(())
}

/// Runs a process that writes the file `out` in a folder. Returns the events in that folder. `old` is the content of
/// `out` before; `named` makes the new file have a temporary name.
fn record(named: bool, old: Option<&[u8]>, sync: bool) -> Result<Vec<Event>, Failed> {
    let run = |more: &[&str]| {
        let folder = Folder::new();
        let out = folder.file("out");
        old.into_iter().try_for_each(|old| std::fs::write(&out, old))?;
        let mut strace = Command::new("strace");
        strace.args(["-f", "-qq", "-o", "/dev/stdout", "-s", "4096"]).args(more).arg(std::env::current_exe()?);
        strace.arg(WRITE).arg(&out).args(sync.then_some(SYNC));
        let output = strace.output()?;
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        if output.status.success() { Ok((folder, text)) } else { Err(Failed::from(format!("{output:?}"))) }
    };
    let (folder, text) = run(&[])?;
    if !named {
        return events(&text, folder.path());
    }
    // The call that creates a file without a name is made to fail, as on a file system that does not support such
    // files.
    let opened = text.lines().filter(|line| line.contains(" openat("));
    let number = 1 + opened.take_while(|line| !line.contains("O_TMPFILE")).count();
    let (folder, text) = run(&["-e", &format!("inject=openat:error=EOPNOTSUPP:when={number}")])?;
    assert!(text.contains("O_EXCL"), "no file with a name was made");
    events(&text, folder.path())
}

/// Returns the events in `folder` that the output of strace contains.
fn events(text: &str, folder: &Path) -> Result<Vec<Event>, Failed> {
    const FOLDER: usize = 0;
    let mut open: HashMap<String, usize> = HashMap::new();
    let (mut events, mut files) = (Vec::new(), FOLDER);
    for line in text.lines() {
        let call = line.split_once(' ').map_or("", |(_, call)| call.trim_start());
        let (Some((name, rest)), Some((_, result))) = (call.split_once('('), call.rsplit_once(" = ")) else { continue };
        if result.starts_with('-') {
            continue;
        }
        let first = rest.split([',', ')']).next().unwrap_or_default();
        let quoted: Vec<&str> = rest.split('"').skip(1).step_by(2).collect();
        match name {
            "openat" if Path::new(quoted[0]) == folder => drop(open.insert(result.to_owned(), FOLDER)),
            "openat" if open.get(first) == Some(&FOLDER) && (rest.contains("O_TMPFILE") || rest.contains("O_EXCL")) => {
                files += 1;
                open.insert(result.to_owned(), files);
                if rest.contains("O_EXCL") {
                    events.push(Event::Name { name: quoted[0].to_owned(), file: files });
                }
            }
            "close" => drop(open.remove(first)),
            "write" if open.contains_key(first) => {
                let bytes = quoted[0].as_bytes().to_vec();
                assert_eq!(result, bytes.len().to_string(), "all of a piece is written at once: {line}");
                events.push(Event::Write { file: open[first], bytes });
            }
            "linkat" => {
                let file = quoted[0].strip_prefix("/proc/self/fd/").and_then(|number| open.get(number));
                let file = *file.ok_or_else(|| format!("a link to another file: {line}"))?;
                events.push(Event::Name { name: quoted[1].to_owned(), file });
            }
            "renameat" => events.push(Event::Rename { from: quoted[0].to_owned(), to: quoted[1].to_owned() }),
            "fsync" | "fdatasync" if open.get(first) == Some(&FOLDER) => events.push(Event::SyncFolder),
            "fsync" | "fdatasync" => events.push(Event::SyncFile(open[first])),
            "rename" | "renameat2" | "link" | "ftruncate" | "pwrite64" | "writev" => {
                return Err(format!("the model does not know this: {line}").into());
            }
            _ => {}
        }
    }
    let written: usize = events.iter().filter(|event| matches!(event, Event::Write { .. })).count();
    assert_eq!(written, PIECES.len(), "{events:?}");
    Ok(events)
}
