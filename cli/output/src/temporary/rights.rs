//! The rights of a file, which the file that replaces it gets as far as possible.

mod access_list;

use std::fs::File;
use std::io;
use std::os::unix::fs::{MetadataExt, fchown};

/// Permission bits that make a program run with the rights of its owner (set-user-ID) or its group (set-group-ID).
const SET_USER: u32 = 0o4000;
const SET_GROUP: u32 = 0o2000;

/// The permissions of a file that only its owner may use.
const OWNER: u32 = 0o700;

/// Owner, group, permissions and access list of a file.
#[derive(Clone, Debug)]
pub struct Rights {
    user: u32,
    group: u32,
    mode: u32,
    /// The access list as the system encodes it; `None` if the file has none.
    list: Option<Vec<u8>>,
}

impl Rights {
    /// Returns the rights of `file`.
    ///
    /// # Errors
    /// The error of the system.
    pub fn of(file: &File) -> io::Result<Self> {
        let metadata = file.metadata()?;
        let list = access_list::of(file)?;
        Ok(Self { user: metadata.uid(), group: metadata.gid(), mode: metadata.mode(), list })
    }

    /// Gives the new file `file` the owner, the group and the access list of the old file, if this process may do so.
    /// Returns the permissions that must be set on the complete file.
    ///
    /// If the access list cannot be kept, these permissions are the owner's alone. Then no user has more rights than
    /// before, even one whom the list denied what others had.
    ///
    /// # Errors
    /// The error of the system, if the owner of `file` cannot be read.
    pub fn give(&self, file: &File) -> io::Result<u32> {
        let new = || file.metadata().map(|metadata| (metadata.uid(), metadata.gid()));
        if new()? != (self.user, self.group) {
            // Root may change the owner. Other users may change only the group, to one that they belong to. If both
            // calls fail, the new file keeps its owner and group.
            let _ = fchown(file, Some(self.user), Some(self.group)).or_else(|_| fchown(file, None, Some(self.group)));
        }
        let (user, group) = new()?;
        let mode = self.mode_for(user, group);
        // The list belongs to its owner and group. Without a list the new file loses the one that its folder gave it.
        let is_kept = match &self.list {
            Some(list) => (user, group) == (self.user, self.group) && access_list::set(file, list).is_ok(),
            None => access_list::remove(file).is_ok(),
        };
        Ok(if is_kept { mode } else { mode & OWNER })
    }

    /// Returns the permissions of a new file with the owner `user` and the group `group`, which replaces a file with
    /// the rights `self`. If the owners differ, the set-user-ID bit is removed, and no other user
    /// keeps a permission that the old owner lacked. If the groups differ, the set-group-ID
    /// bit is removed, and the new group and all other users get only the permissions that both the old group and all
    /// other users had. A member of the old group is now one of the other users.
    fn mode_for(&self, user: u32, group: u32) -> u32 {
        let mut mode = self.mode & 0o7777;
        if user != self.user {
            let owner = mode >> 6 & 0o007;
            mode &= !SET_USER & (!0o077 | owner << 3 | owner);
        }
        if group != self.group {
            let common = mode >> 3 & mode & 0o007;
            mode = mode & !SET_GROUP & !0o077 | common << 3 | common;
        }
        mode
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the permissions of a new file of `user` and `group`, which replaces a file of user 1 and group 1 with
    /// the permissions `mode`.
    fn mode(mode: u32, user: u32, group: u32) -> u32 {
        const REGULAR_FILE: u32 = 0o100_000;

        Rights { user: 1, group: 1, mode: REGULAR_FILE | mode, list: None }.mode_for(user, group)
    }

    #[test]
    fn the_same_owner_keeps_all_permissions() {
        for kept in [0o644, 0o600, 0o7777, 0o4755, 0o2070] {
            assert_eq!(mode(kept, 1, 1), kept);
        }
    }

    #[test]
    fn another_user_does_not_get_the_set_user_id_bit() {
        assert_eq!(mode(0o7775, 2, 1), 0o3775);
        assert_eq!(mode(0o640, 2, 1), 0o640);
        assert_eq!(mode(0o477, 2, 1), 0o444, "the old owner is now one of the others, and could not write");
    }

    #[test]
    fn another_group_and_all_users_get_only_the_permissions_that_both_had() {
        for (old, new) in [(0o7775, 0o5755), (0o2674, 0o644), (0o640, 0o600), (0o607, 0o600), (0o671, 0o611)] {
            assert_eq!(mode(old, 1, 2), new, "{old:o}");
        }
    }
}
