//! Keeps a program away from all other processes, with what Linux gives to every user: namespaces.

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::Failure;

/// The argument after `supervise` of a process that is the first one of its own table of processes.
pub const INSIDE: &str = "--inside";

/// Starts this program again with the arguments `arguments` and [`INSIDE`], as the first process of a new table of
/// processes, and waits for it. Returns its exit status, or `None` if the system gives no such table. Then the program
/// is watched without it. Of the folders `hidden`, nothing but the folders `shown` can be seen there.
///
/// A program that is started there can send no signal to a process outside, and mostly sees none. No process of the
/// table can end its first process, which watches the program. When the first process ends, the system ends all others.
/// A user without rights becomes the same user of a new user namespace, in which nobody has rights over a process
/// outside.
///
/// # Errors
/// This program cannot start itself.
#[cfg(target_os = "linux")]
pub fn inside(arguments: &[OsString], hidden: &[PathBuf], shown: [&Path; 2]) -> Result<Option<u8>, Failure> {
    use nix::sched::{CloneFlags, unshare};
    use std::os::unix::fs::MetadataExt;

    let own = std::fs::metadata("/proc/self")?;
    let (user, group) = (own.uid(), own.gid());
    let table = CloneFlags::CLONE_NEWPID | CloneFlags::CLONE_NEWNS | CloneFlags::CLONE_NEWIPC;
    if unshare(table).is_err() {
        if unshare(table | CloneFlags::CLONE_NEWUSER).is_err() {
            return Ok(None);
        }
        std::fs::write("/proc/self/setgroups", "deny")?;
        std::fs::write("/proc/self/uid_map", format!("{user} {user} 1"))?;
        std::fs::write("/proc/self/gid_map", format!("{group} {group} 1"))?;
    }
    hide(hidden, shown);
    let status = Command::new(super::OWN_PROGRAM).args(["supervise", INSIDE]).args(arguments).status()?;
    Ok(Some(status.code().and_then(|code| u8::try_from(code).ok()).unwrap_or(2)))
}

/// Hides the folders `hidden` from this process, but not the folders `shown`. If a folder to be shown cannot be shown
/// again, nothing is hidden.
#[cfg(target_os = "linux")]
fn hide(hidden: &[PathBuf], shown: [&Path; 2]) {
    use std::fs::{File, create_dir_all};
    use std::os::fd::AsRawFd;

    use nix::mount::{MntFlags, MsFlags, mount, umount2};

    const NOTHING: Option<&str> = None;
    // Without this, the folders would be hidden from all processes.
    if mount(NOTHING, Path::new("/"), NOTHING, MsFlags::MS_REC | MsFlags::MS_PRIVATE, NOTHING).is_err() {
        return;
    }
    for folder in hidden {
        let is_within = |path: &&Path| path.starts_with(folder) && *path != folder;
        let open = |path: &Path| Some((path.to_owned(), File::open(path).ok()?));
        let Some(kept) = shown.into_iter().filter(is_within).map(open).collect::<Option<Vec<_>>>() else { return };
        if shown.contains(&folder.as_path())
            || mount(Some("none"), folder, Some("tmpfs"), MsFlags::empty(), NOTHING).is_err()
        {
            continue;
        }
        let show = |(path, file): &(PathBuf, File)| {
            let from = PathBuf::from(format!("/proc/self/fd/{}", file.as_raw_fd()));
            create_dir_all(path).is_ok()
                && mount(Some(&from), path, NOTHING, MsFlags::MS_BIND | MsFlags::MS_REC, NOTHING).is_ok()
        };
        if !kept.iter().all(show) {
            let _ = umount2(folder, MntFlags::MNT_DETACH);
        }
    }
}

/// Only Linux has namespaces.
///
/// # Errors
/// None.
#[cfg(not(target_os = "linux"))]
pub fn inside(_: &[OsString], _: &[PathBuf], _: [&Path; 2]) -> Result<Option<u8>, Failure> {
    Ok(None)
}

/// Prepares this process to watch a program that must not read or change it. With `is_first`, it is the first process
/// of its table, ends with its parent, and shows only its own table in `/proc`, where it has the rights for that.
pub fn protect(is_first: bool) {
    #[cfg(target_os = "linux")]
    {
        use nix::mount::{MsFlags, mount};
        use nix::sys::{prctl, signal::Signal};

        const NOTHING: Option<&str> = None;
        let _ = prctl::set_dumpable(false);
        let mode = MsFlags::MS_REC | MsFlags::MS_PRIVATE;
        if is_first {
            let _ = prctl::set_pdeathsig(Signal::SIGKILL);
            if mount(NOTHING, Path::new("/"), NOTHING, mode, NOTHING).is_ok() {
                let _ = mount(Some("proc"), Path::new("/proc"), Some("proc"), MsFlags::empty(), NOTHING);
            }
        }
    }
}
