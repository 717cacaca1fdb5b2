//! Tests of the permissions that a new file gets from the file it replaces.

use super::*;

/// Returns the permissions of a new file of `user` and `group`, which replaces a file of user 1 and group 1 with the
/// permissions `mode`.
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
