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

/// Returns an access list in the form of the kernel's header `posix_acl_xattr.h`.
fn list(entries: &[Entry]) -> Vec<u8> {
    let mut list = 2_u32.to_le_bytes().to_vec();
    for (tag, rights, number) in entries {
        list.extend(tag.to_le_bytes());
        list.extend(rights.to_le_bytes());
        list.extend(number.to_le_bytes());
    }
    list
}

/// Gives the file at `path` an access list.
fn set(path: &Path, name: &CStr, entries: &[Entry]) -> Result<(), Failed> {
    Ok(setxattr(path, name, &list(entries), XattrFlags::empty())?)
}

/// Returns the access list of the file at `path`, or `None` if it has none.
fn get(path: &Path) -> Option<Vec<u8>> {
    let mut list = vec![0_u8; 1 << 10];
    let size = getxattr(path, LIST, &mut list).ok()?;
    list.truncate(size);
    Some(list)
}

fn kept() -> Result<(), Failed> {
    // Only the named user may read and write. The bits of the group are the limit, and not the group's rights.
    let old = [owner(6), named(6), group(0), mask(6), others(0)];
    let is_kept = |out: &Path, new: &Metadata| get(out) == Some(list(&old)) && permissions(new) == 0o660;
    replaces_with_rights(false, |out| set(out, LIST, &old), is_kept)
}

fn folders() -> Result<(), Failed> {
    let give_list_to_new_files = |out: &Path| {
        set_mode(out, 0o640)?;
        // A file that is created from now on gets this list, but the old picture has none.
        let folder = out.parent().ok_or("it lies in a folder")?;
        set(folder, DEFAULT_LIST, &[owner(7), named(7), group(0), mask(7), others(0)])
    };
    let has_no_list = |out: &Path, new: &Metadata| get(out).is_none() && permissions(new) == 0o640;
    replaces_with_rights(false, give_list_to_new_files, has_no_list)
}

fn narrowed() -> Result<(), Failed> {
    // The named user may do nothing, but all others may read and write.
    let old = [owner(6), named(0), group(6), mask(6), others(6)];
    replaces_with_rights(true, |out| set(out, LIST, &old), |_, new| permissions(new) == 0o600)
}
