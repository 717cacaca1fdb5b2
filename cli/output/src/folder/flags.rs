//! The values of the flags that system calls take.

use std::ffi::c_int;

/// Values of the flags of `openat` and similar calls. They differ from system to system.
pub struct Flags {
    pub write: c_int,
    pub create: c_int,
    pub exclusive: c_int,
    pub close_on_exec: c_int,
    pub no_follow: c_int,
    pub nonblocking: c_int,
    /// For `openat`: opens a folder only to look up names. The process needs no right to read it.
    pub path: c_int,
    /// For `openat`: creates a file without a name.
    pub unnamed: c_int,
    /// For `linkat`: follows the link that names the file.
    pub follow: c_int,
    /// For `unlinkat`: removes a folder.
    pub folder: c_int,
    /// For `faccessat`: checks the rights of the effective user.
    pub effective: c_int,
    /// The descriptor that stands for the working folder, in calls that take a folder.
    pub here: c_int,
}

/// The flags of Linux on x86-64, ARM and RISC-V, from its header `asm-generic/fcntl.h`. On other systems this is
/// `None`: [`super::Folder`] opens files by their paths, and temporary files have names.
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
