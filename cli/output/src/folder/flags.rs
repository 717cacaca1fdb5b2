//! The values of the flags of system calls.

use std::ffi::c_int;

/// Flags of `openat` and similar calls. Their values differ from system to system.
pub struct Flags {
    pub write: c_int,
    pub create: c_int,
    pub exclusive: c_int,
    pub close_on_exec: c_int,
    pub no_follow: c_int,
    pub nonblocking: c_int,
    /// A folder in which names are only looked up. Opening it needs no right to read it.
    pub path: c_int,
    /// A file without a name.
    pub unnamed: c_int,
    /// For `linkat`: follow the link.
    pub follow: c_int,
    /// For `unlinkat`: remove a folder.
    pub folder: c_int,
    /// For `faccessat`: check the rights of the effective user.
    pub effective: c_int,
    /// A descriptor that stands for the working folder.
    pub here: c_int,
}

/// The values for Linux on these processors, from its header `asm-generic/fcntl.h`. On other systems this is `None`:
/// files are opened by their paths, and temporary files have names.
pub const FLAGS: Option<Flags> = {
    const KNOWN: bool =
        cfg!(all(target_os = "linux", any(target_arch = "x86_64", target_arch = "aarch64", target_arch = "riscv64")));
    // On ARM these two values differ from those of the common header.
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
