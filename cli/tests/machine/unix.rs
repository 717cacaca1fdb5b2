//! The tests of `machine.rs` for systems with users, permissions and mounts.

use std::fs::{self, Metadata, Permissions};
use std::ops::Deref;
use std::os::unix::fs::{MetadataExt, PermissionsExt};
use std::os::unix::process::CommandExt;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use libtest_mimic::{Failed, Trial};
use test_support::folder::Folder;
use test_support::trial;

mod rights;

const PROGRAMS: [&str; 2] = [env!("CARGO_BIN_EXE_render-aos"), env!("CARGO_BIN_EXE_render-soa")];

/// A configuration for a picture of 40,000 pixels. Its file is larger than 64 kB.
const CONFIG: &str = "image_width: 200\naspect_ratio: 1 1\nsamples_per_pixel: 1\n";

/// The ID of the user `nobody` and of its group, which have no rights.
const NOBODY: u32 = 65_534;

pub fn trials() -> Vec<Trial> {
    let is_root = fs::metadata("/proc/self").is_ok_and(|metadata| metadata.uid() == 0);
    let mount = (!is_root || !mounts()).then_some("needs the right to mount");
    let mut trials = vec![
        trial("a_limit_on_file_sizes_leaves_the_old_file", None, a_limit_on_file_sizes_leaves_the_old_file),
        trial("a_read_only_place_takes_no_picture", None, move || a_read_only_place_takes_no_picture(is_root)),
        trial("a_full_disk_leaves_the_old_file", mount, a_full_disk_leaves_the_old_file),
    ];
    let root = (!is_root).then_some("needs root");
    trials.extend(rights::trials(root));
    trials
}

/// A folder that all users can enter, with a configuration, an empty scene, and copies of the programs. The original
/// programs may lie in a folder that [`NOBODY`] cannot enter.
struct Place(Folder);

impl Deref for Place {
    type Target = Folder;

    fn deref(&self) -> &Folder {
        &self.0
    }
}

impl Place {
    fn new() -> Result<Self, Failed> {
        let place = Self(Folder::with_scene(CONFIG, ""));
        set_mode(place.path(), 0o755)?;
        for program in PROGRAMS {
            fs::copy(program, place.file(Self::name(program)))?;
        }
        Ok(place)
    }

    /// Creates a folder with these permissions, and returns its path.
    fn folder(&self, name: &str, mode: u32) -> std::io::Result<PathBuf> {
        fs::create_dir(self.file(name))?;
        set_mode(&self.file(name), mode)?;
        Ok(self.file(name))
    }

    fn name(program: &str) -> &str {
        program.rsplit('/').next().unwrap_or(program)
    }

    /// Returns the command that renders the scene into `out`.
    fn render(&self, program: &str, out: &Path) -> Command {
        let mut command = Command::new(self.file(Self::name(program)));
        command.args([self.file("config.txt"), self.file("scene.txt"), out.to_owned()]);
        command
    }
}

fn set_mode(path: &Path, mode: u32) -> std::io::Result<()> {
    fs::set_permissions(path, Permissions::from_mode(mode))
}

/// Checks that the output of a program has status 1 and the message that `out` cannot be written because of `reason`.
fn check_refusal(output: &Output, out: &Path, reason: &str) -> Result<(), Failed> {
    let expected = format!("Error: Cannot write file [{}]: {reason}", out.display());
    let stderr = String::from_utf8_lossy(&output.stderr);
    let as_it_should = output.status.code() == Some(1) && output.stdout.is_empty() && stderr.starts_with(&expected);
    if as_it_should { Ok(()) } else { Err(format!("{output:?} instead of {expected}").into()) }
}

/// Checks that the folder named `folder` holds exactly the files `names`.
fn check_names(place: &Place, folder: &str, names: &[&str]) -> Result<(), Failed> {
    let found = place.names_in(folder);
    if found == names { Ok(()) } else { Err(format!("{found:?} instead of {names:?}").into()) }
}

/// Checks that the picture in the folder named `folder` still has its old content, and that the folder holds no other
/// file.
fn check_old(place: &Place, folder: &str) -> Result<(), Failed> {
    check_names(place, folder, &["out.ppm"])?;
    if fs::read(place.file(folder).join("out.ppm"))? == b"old" { Ok(()) } else { Err("the old content is gone".into()) }
}

/// Returns the permission bits of a file.
fn permissions(file: &Metadata) -> u32 {
    file.mode() & 0o7777
}

/// Renders over an old picture with each program, as the user nobody if `as_nobody` is true. `prepare` gives the old
/// picture its rights, and `check` tells whether the new one has those that it should have.
fn replaces_with_rights(
    as_nobody: bool,
    prepare: impl Fn(&Path) -> Result<(), Failed>,
    check: impl Fn(&Path, &Metadata) -> bool,
) -> Result<(), Failed> {
    for program in PROGRAMS {
        let place = Place::new()?;
        let out = place.folder("d", 0o777)?.join("out.ppm");
        fs::write(&out, "old")?;
        prepare(&out)?;
        let output = without_rights(place.render(program, &out), as_nobody).output()?;
        let new = fs::metadata(&out)?;
        if !output.status.success() || fs::read(&out)? == b"old" || !check(&out, &new) {
            return Err(format!("{output:?}, {new:?}").into());
        }
    }
    Ok(())
}

/// Checks a write that fails in the middle of the file, as on a full disk. This test needs no right to mount a disk.
fn a_limit_on_file_sizes_leaves_the_old_file() -> Result<(), Failed> {
    let place = Place::new()?;
    let out = place.folder("d", 0o755)?.join("out.ppm");
    fs::write(&out, "old")?;
    for program in PROGRAMS {
        let command = place.render(program, &out);
        let mut shell = test_support::running::bash();
        // The limit is 16 blocks. Its signal is ignored, so the write returns an error as on a full disk.
        shell.args(["-c", "trap '' XFSZ; ulimit -f 16; exec \"$@\"", "limited"]).arg(command.get_program());
        check_refusal(&shell.args(command.get_args()).output()?, &out, "File too large")?;
        check_old(&place, "d")?;
    }
    Ok(())
}

fn a_full_disk_leaves_the_old_file() -> Result<(), Failed> {
    let place = Place::new()?;
    let disk = Disk::mount(place.file("disk"))?;
    let out = disk.0.join("out.ppm");
    fs::write(&out, "old")?;
    for program in PROGRAMS {
        let output = place.render(program, &out).output()?;
        check_refusal(&output, &out, "No space left on device")?;
        check_old(&place, "disk")?;
    }
    Ok(())
}

/// Tries a folder that is read-only, and a file that is read-only in a folder that is not.
fn a_read_only_place_takes_no_picture(is_root: bool) -> Result<(), Failed> {
    let place = Place::new()?;
    for (name, mode, old) in [("closed", 0o555, None), ("open", 0o777, Some("old"))] {
        let out = place.folder(name, mode)?.join("out.ppm");
        if let Some(old) = old {
            fs::write(&out, old)?;
            set_mode(&out, 0o444)?;
        }
        for program in PROGRAMS {
            let output = without_rights(place.render(program, &out), is_root).output()?;
            check_refusal(&output, &out, "Permission denied")?;
            if old.is_some() { check_old(&place, name)? } else { check_names(&place, name, &[])? }
        }
    }
    Ok(())
}

/// Returns `command`, changed to run as the user nobody if `is_root` is true. Permissions do not restrict root.
fn without_rights(mut command: Command, is_root: bool) -> Command {
    if is_root {
        command.uid(NOBODY).gid(NOBODY);
    }
    command
}

/// Whether this process can mount a file system. Root in a container may lack that right.
fn mounts() -> bool {
    Disk::mount(Folder::new().file("disk")).is_ok()
}

/// A mounted file system of 64 kB at this path. It is unmounted when this value is dropped.
struct Disk(PathBuf);

impl Disk {
    fn mount(folder: PathBuf) -> Result<Self, Failed> {
        fs::create_dir(&folder)?;
        let output = Command::new("mount").args(["-t", "tmpfs", "-o", "size=64k", "tmpfs"]).arg(&folder).output()?;
        if output.status.success() { Ok(Self(folder)) } else { Err(format!("{output:?}").into()) }
    }
}

impl Drop for Disk {
    fn drop(&mut self) {
        // An error is ignored here. If the unmounting fails, removing the test's temporary folder fails too.
        let _ = Command::new("umount").arg(&self.0).status();
    }
}
