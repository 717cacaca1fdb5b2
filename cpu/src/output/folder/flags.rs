//! The numbers by which a system knows the flags of its calls.

use std::ffi::c_int;

/// Flags of `openat` and their like, which differ from system to system.
pub struct Flags {
    pub write: c_int,
    pub create: c_int,
    pub exclusive: c_int,
    pub close_on_exec: c_int,
    pub no_follow: c_int,
    pub nonblocking: c_int,
    /// A folder that is only looked up in: needs no right to read it.
    pub path: c_int,
    /// A file without a name.
    pub unnamed: c_int,
    /// Follow the link, for `linkat`.
    pub follow: c_int,
    /// Remove a folder, for `unlinkat`.
    pub folder: c_int,
    /// Ask for the rights of the effective user, for `faccessat`.
    pub effective: c_int,
    /// Stands for the working folder.
    pub here: c_int,
}

/// Known for Linux on these processors, from its header `asm-generic/fcntl.h`. Elsewhere files are opened by their
/// path, and all have a name.
pub const FLAGS: Option<Flags> = {
    const KNOWN: bool =
        cfg!(all(target_os = "linux", any(target_arch = "x86_64", target_arch = "aarch64", target_arch = "riscv64")));
    // On ARM these two are other numbers than in the common header.
    let (directory, no_follow) =
        if cfg!(target_arch = "aarch64") { (0o40_000, 0o100_000) } else { (0o200_000, 0o400_000) };
    if KNOWN {
        Some(Flags {
            write: 1,
            create: 0o100,
            exclusive: 0o200,
            close_on_exec: 0o2_000_000,
            no_follow,
            nonblocking: 0o4_000,
            path: 0o10_000_000,
            unnamed: 0o20_000_000 | directory | 1,
            follow: 0x400,
            folder: 0x200,
            effective: 0x200,
            here: -100,
        })
    } else {
        None
    }
};
