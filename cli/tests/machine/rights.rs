//! Tests of outputs that only root or a user with special rights can create. The programs refuse such an output before
//! rendering, or keep its owner and permissions.

use std::ffi::OsStr;
use std::os::unix::fs::{chown, symlink};

use rustix::fs::{XattrFlags, getxattr, setxattr};

use super::*;

/// A configuration whose rendering takes much longer than one minute, the time limit of these tests. So the output must
/// be refused before rendering.
const ENDLESS: &str = "samples_per_pixel: 4000000000\n";

pub fn trials(root: Option<&str>) -> Vec<Trial> {
    let lists = (!knows_access_lists()).then_some("needs access lists");
    vec![
        trial("another_users_file_in_a_sticky_folder_is_refused_at_once", root, sticky),
        trial("a_link_in_a_sticky_folder_is_refused_at_once", None, sticky_link),
        trial("a_device_or_pipe_without_permission_is_refused_at_once", root, special),
        trial("another_users_set_user_id_bit_goes", root, set_user_id),
        trial("root_leaves_a_file_its_owner", root, owner),
        trial("an_access_list_leaves_the_owner_alone", lists, list),
        trial("a_folder_adds_no_rights_to_an_old_picture", lists, folder_list),
    ]
}

/// Runs a program for at most one minute. If `as_nobody` is true, the user nobody runs it.
fn promptly(command: &Command, as_nobody: bool) -> std::io::Result<Output> {
    let mut limited = Command::new("timeout");
    limited.arg("60").arg(command.get_program()).args(command.get_args());
    without_rights(limited, as_nobody).output()
}

/// Checks that the programs refuse `out` for `reason` before rendering. If `as_nobody` is true, the user nobody runs
/// them.
fn refuse_at_once(place: &Place, out: &Path, reason: &str, as_nobody: bool) -> Result<(), Failed> {
    fs::write(place.file("config.txt"), ENDLESS)?;
    for program in PROGRAMS {
        check_refusal(&promptly(&place.render(program, out), as_nobody)?, out, reason)?;
    }
    Ok(())
}

fn sticky() -> Result<(), Failed> {
    let place = Place::new()?;
    let out = place.folder("d", 0o1777)?.join("out.ppm");
    fs::write(&out, "old")?;
    // All users may write to the file, but in this folder only its owner may replace it.
    set_mode(&out, 0o666)?;
    refuse_at_once(&place, &out, "it is another user's file in a folder of all users", true)?;
    check_old(&place, "d")?;
    fs::write(place.file("config.txt"), CONFIG)?;
    let output = place.render(PROGRAMS[0], &out).output()?;
    if output.status.success() && fs::read(&out)? != b"old" { Ok(()) } else { Err(format!("{output:?}").into()) }
}

fn sticky_link() -> Result<(), Failed> {
    let place = Place::new()?;
    let link = place.folder("d", 0o1777)?.join("link.ppm");
    place.folder("own", 0o755)?;
    for target in ["out.ppm", "missing.ppm"] {
        fs::write(place.file("own/out.ppm"), "old")?;
        symlink(place.file("own").join(target), &link)?;
        refuse_at_once(&place, &link, "it leads through a link in a folder of all users", false)?;
        check_old(&place, "own")?;
        fs::remove_file(&link)?;
    }
    Ok(())
}

/// Tries the device of `/dev/null` under another name, and a named pipe. Only root may write to them.
fn special() -> Result<(), Failed> {
    let place = Place::new()?;
    for (name, arguments) in [("null", &["c", "1", "3"][..]), ("pipe", &["p"])] {
        let out = place.file(name);
        run("mknod", [out.as_os_str()].into_iter().chain(arguments.iter().map(OsStr::new)))?;
        set_mode(&out, 0o600)?;
        refuse_at_once(&place, &out, "Permission denied", true)?;
    }
    Ok(())
}

fn set_user_id() -> Result<(), Failed> {
    // The new file has another owner and another group than the old one. So it has no set-user-ID bit, and its group
    // and all other users have only the permissions that both had.
    let is_narrowed = |_: &Path, new: &Metadata| new.uid() == NOBODY && permissions(new) == 0o755;
    replaces_with_rights(true, |out| Ok(set_mode(out, 0o6757)?), is_narrowed)
}

fn owner() -> Result<(), Failed> {
    let give_away = |out: &Path| {
        chown(out, Some(NOBODY), Some(NOBODY))?;
        Ok(set_mode(out, 0o4750)?)
    };
    let is_kept = |_: &Path, new: &Metadata| (new.uid(), new.gid(), permissions(new)) == (NOBODY, NOBODY, 0o4750);
    replaces_with_rights(false, give_away, is_kept)
}

/// Runs a command of the system, and returns an error if the command fails.
fn run<S: AsRef<OsStr>>(program: &str, arguments: impl IntoIterator<Item = S>) -> Result<(), Failed> {
    let output = Command::new(program).args(arguments).output()?;
    if output.status.success() { Ok(()) } else { Err(format!("{program}: {output:?}").into()) }
}

/// The attribute with the access list of a file, and the one with the list that a folder gives its new files.
const LIST: &str = "system.posix_acl_access";
const DEFAULT_LIST: &str = "system.posix_acl_default";

/// Gives the file at `path` an access list, in the form of the kernel's header `posix_acl_xattr.h`. User 1234 and the
/// owner may read, write and execute; `others` are the rights of all others.
fn set_list(path: &Path, name: &str, others: u16) -> Result<(), Failed> {
    const ALL: u32 = u32::MAX;

    let mut list = 2_u32.to_le_bytes().to_vec();
    // What each entry is about, its rights, and the number of its user.
    for (tag, rights, number) in [(1_u16, 7, ALL), (2, 7, 1234), (4, 0, ALL), (16, 7, ALL), (32, others, ALL)] {
        list.extend(tag.to_le_bytes());
        list.extend(u16::to_le_bytes(rights));
        list.extend(u32::to_le_bytes(number));
    }
    Ok(setxattr(path, name, &list, XattrFlags::empty())?)
}

fn knows_access_lists() -> bool {
    set_list(Folder::new().path(), LIST, 0).is_ok()
}

/// Whether the file at `path` has no access list, and these permissions.
fn is_plain(path: &Path, new: &Metadata, mode: u32) -> bool {
    getxattr(path, LIST, &mut [0_u8; 0][..]).is_err() && permissions(new) == mode
}

fn list() -> Result<(), Failed> {
    // All others may read the file, but with the list's limit the bits of the group would give it all rights.
    replaces_with_rights(false, |out| set_list(out, LIST, 4), |out, new| is_plain(out, new, 0o700))
}

fn folder_list() -> Result<(), Failed> {
    let give_list_to_new_files = |out: &Path| {
        set_mode(out, 0o640)?;
        // A file that is created from now on gets this list, but the old picture has none.
        set_list(out.parent().ok_or("it lies in a folder")?, DEFAULT_LIST, 0)
    };
    replaces_with_rights(false, give_list_to_new_files, |out, new| is_plain(out, new, 0o640))
}
