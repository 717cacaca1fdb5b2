//! Tests that a new picture gives no user more rights than the access list of the old one.

use std::ffi::CStr;

use rustix::fs::{XattrFlags, getxattr, setxattr};

use super::*;

/// The attribute with the access list of a file, and the one with the list that a folder gives its new files.
const LIST: &CStr = c"system.posix_acl_access";
const DEFAULT_LIST: &CStr = c"system.posix_acl_default";

/// A user whom some lists name.
const NAMED: u32 = 1234;

/// A line of an access list: what it is about, the rights as one octal digit, and the number of the user.
type Entry = (u16, u16, u32);

const fn owner(rights: u16) -> Entry {
    (1, rights, u32::MAX)
}
const fn named(rights: u16) -> Entry {
    (2, rights, NAMED)
}
const fn group(rights: u16) -> Entry {
    (4, rights, u32::MAX)
}
/// The limit of the rights of named users, named groups and the file's group.
const fn mask(rights: u16) -> Entry {
    (16, rights, u32::MAX)
}
const fn others(rights: u16) -> Entry {
    (32, rights, u32::MAX)
}

pub fn trials(root: Option<&'static str>) -> Vec<Trial> {
    let known = set(Folder::new().path(), LIST, &[owner(7), group(0), mask(0), others(0)]).is_ok();
    let lists = (!known).then_some("needs access lists");
    vec![
        trial("a_new_picture_keeps_the_access_list", lists, kept),
        trial("a_folder_adds_no_rights_to_an_old_picture", lists, folders),
        trial("a_list_of_another_owner_leaves_the_owner_alone", lists.or(root), narrowed),
    ]
}

/// Gives the file at `path` an access list in the form of the kernel's header `posix_acl_xattr.h`.
fn set(path: &Path, name: &CStr, entries: &[Entry]) -> std::io::Result<()> {
    let mut list = 2_u32.to_le_bytes().to_vec();
    for (tag, rights, number) in entries {
        list.extend(tag.to_le_bytes());
        list.extend(rights.to_le_bytes());
        list.extend(number.to_le_bytes());
    }
    Ok(setxattr(path, name, &list, XattrFlags::empty())?)
}

/// Returns the access list of the file at `path`, or `None` if it has none.
fn get(path: &Path) -> Option<Vec<u8>> {
    let mut list = vec![0_u8; 1 << 10];
    let size = getxattr(path, LIST, &mut list).ok()?;
    list.truncate(size);
    Some(list)
}

/// Renders into `out`, and returns the permission bits of the new picture.
fn render(place: &Place, program: &str, out: &Path, as_nobody: bool) -> Result<u32, Failed> {
    let output = without_rights(place.render(program, out), as_nobody).output()?;
    if !output.status.success() || fs::read(out)? == b"old" {
        return Err(format!("{output:?}").into());
    }
    Ok(fs::metadata(out)?.mode() & 0o7777)
}

fn kept() -> Result<(), Failed> {
    let place = Place::new()?;
    let out = place.file("out.ppm");
    for program in PROGRAMS {
        fs::write(&out, "old")?;
        // Only the named user may read and write. The bits of the group are the limit, and not the group's rights.
        set(&out, LIST, &[owner(6), named(6), group(0), mask(6), others(0)])?;
        let old = get(&out);
        let mode = render(&place, program, &out, false)?;
        if old.is_none() || get(&out) != old || mode != 0o660 {
            return Err(format!("{mode:o}, {:?} instead of {old:?}", get(&out)).into());
        }
        fs::remove_file(&out)?;
    }
    Ok(())
}

fn folders() -> Result<(), Failed> {
    let place = Place::new()?;
    let out = place.folder("d", 0o755)?.join("out.ppm");
    for program in PROGRAMS {
        fs::write(&out, "old")?;
        set_mode(&out, 0o640)?;
        // A file that is created from now on gets this list, but the old picture has none.
        set(&place.file("d"), DEFAULT_LIST, &[owner(7), named(7), group(0), mask(7), others(0)])?;
        let mode = render(&place, program, &out, false)?;
        if get(&out).is_some() || mode != 0o640 {
            return Err(format!("{mode:o}, {:?}", get(&out)).into());
        }
        fs::remove_dir_all(place.file("d"))?;
        fs::create_dir(place.file("d"))?;
    }
    Ok(())
}

fn narrowed() -> Result<(), Failed> {
    let place = Place::new()?;
    let out = place.folder("d", 0o777)?.join("out.ppm");
    for program in PROGRAMS {
        let _ = fs::remove_file(&out);
        fs::write(&out, "old")?;
        // The named user may do nothing, but all others may read and write.
        set(&out, LIST, &[owner(6), named(0), group(6), mask(6), others(6)])?;
        let mode = render(&place, program, &out, true)?;
        if mode != 0o600 {
            return Err(format!("{mode:o}, {:?}", get(&out)).into());
        }
    }
    Ok(())
}
