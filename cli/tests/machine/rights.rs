//! Tests of outputs that only root or a user with special rights can create. The programs refuse such an output before
//! rendering, or keep its owner and permissions.

use std::ffi::OsStr;

use std::os::unix::fs::{chown, lchown, symlink};

use super::*;

/// A configuration whose rendering takes much longer than one minute, the time limit of these tests. So the output must
/// be refused before rendering.
const ENDLESS: &str = "samples_per_pixel: 4000000000\n";

pub fn trials(root: Option<&str>, mount: Option<&str>) -> Vec<Trial> {
    let append = root.or_else(|| (!append_only_is_known()).then_some("needs chattr +a"));
    vec![
        trial("another_users_file_in_a_sticky_folder_is_refused_at_once", root, sticky),
        trial("another_users_link_in_a_sticky_folder_is_refused_at_once", root, sticky_link),
        trial("a_mounted_file_is_refused_at_once", mount, mounted),
        trial("a_device_or_pipe_without_permission_is_refused_at_once", root, special),
        trial("in_a_folder_for_appends_only_nothing_but_a_new_picture_is_left", append, appends),
        trial("another_users_set_user_id_bit_goes", root, set_user_id),
        trial("root_leaves_a_file_its_owner", root, owner),
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
    refuse_at_once(&place, &out, "Operation not permitted", true)?;
    check_old(&place, "d")
}

/// Checks that no link of another user in a sticky folder is followed, whether the file at its end exists or not. Linux
/// refuses to open such a link only if the setting `fs.protected_symlinks` is on.
fn sticky_link() -> Result<(), Failed> {
    let place = Place::new()?;
    let link = place.folder("d", 0o1777)?.join("link.ppm");
    place.folder("own", 0o755)?;
    for target in ["out.ppm", "missing.ppm"] {
        let target = place.file("own").join(target);
        fs::write(place.file("own/out.ppm"), "old")?;
        symlink(&target, &link)?;
        lchown(&link, Some(NOBODY), Some(NOBODY))?;
        refuse_at_once(&place, &link, "", false)?;
        check_old(&place, "own")?;
        // The owner of the folder made this link, so it is followed.
        lchown(&link, Some(0), Some(0))?;
        fs::write(place.file("config.txt"), CONFIG)?;
        let output = place.render(PROGRAMS[0], &link).output()?;
        if !output.status.success() || fs::read(&target)? == b"old" {
            return Err(format!("{output:?}").into());
        }
        fs::remove_file(&target)?;
        fs::remove_file(&link)?;
    }
    Ok(())
}

fn mounted() -> Result<(), Failed> {
    let place = Place::new()?;
    let out = place.folder("d", 0o755)?.join("out.ppm");
    // Two mounts are tested over the output: a file of this file system, and a file of another file system.
    let disk = Disk::mount(place.file("disk"))?;
    for source in [place.file("source"), disk.0.join("source")] {
        fs::write(&source, "old")?;
        fs::write(&out, "")?;
        let bound = Mount::bind(&source, &out)?;
        refuse_at_once(&place, &out, "a file is mounted here", false)?;
        check_old(&place, "d")?;
        drop(bound);
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

/// Checks an output in an append-only folder: a new file can be created there, but no file can be replaced, renamed or
/// removed.
fn appends() -> Result<(), Failed> {
    let place = Place::new()?;
    fs::create_dir(place.file("d"))?;
    for program in PROGRAMS {
        let out = place.file("d/out.ppm");
        {
            let _appends = AppendOnly::new(place.file("d"))?;
            let output = place.render(program, &out).output()?;
            if !output.status.success() {
                return Err(format!("{output:?}").into());
            }
            check_names(&place, "d", &["out.ppm"])?;
            let output = promptly(&place.render(program, &out), false)?;
            check_refusal(&output, &out, "Operation not permitted")?;
            check_names(&place, "d", &["out.ppm"])?;
        }
        fs::remove_file(&out)?;
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

/// A mount over the file at this path. It ends when this value is dropped.
struct Mount<'a>(&'a Path);

impl<'a> Mount<'a> {
    fn bind(source: &Path, target: &'a Path) -> Result<Self, Failed> {
        run("mount", [OsStr::new("--bind"), source.as_ref(), target.as_ref()])?;
        Ok(Self(target))
    }
}

impl Drop for Mount<'_> {
    fn drop(&mut self) {
        // An error is ignored here. If the unmounting fails, removing the test's temporary folder fails too.
        let _ = run("umount", [self.0]);
    }
}

/// A folder that is append-only until this value is dropped.
struct AppendOnly(PathBuf);

impl AppendOnly {
    fn new(folder: PathBuf) -> Result<Self, Failed> {
        run("chattr", [OsStr::new("+a"), folder.as_os_str()])?;
        Ok(Self(folder))
    }
}

impl Drop for AppendOnly {
    fn drop(&mut self) {
        // An error is ignored here. If the folder stays append-only, removing the test's temporary folder fails.
        let _ = run("chattr", [OsStr::new("-a"), self.0.as_os_str()]);
    }
}

/// Whether the file system of the temporary folder supports append-only folders.
fn append_only_is_known() -> bool {
    AppendOnly::new(Folder::new().path().to_owned()).is_ok()
}
