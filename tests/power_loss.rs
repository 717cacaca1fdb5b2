//! Simulates a loss of power at any moment. The system calls of a process that writes a file are recorded. A model of a
//! file system returns which contents POSIX allows if the power fails after each call. With [`Options::sync`] these are
//! the old file and the new one.
//!
//! If `strace` cannot run, these tests are shown as ignored.

#[cfg(target_os = "linux")]
#[path = "power_loss/linux.rs"]
mod linux;

fn main() {
    #[cfg(target_os = "linux")]
    {
        linux::write_if_asked();
        libtest_mimic::run(&libtest_mimic::Arguments::from_args(), linux::trials()).exit();
    }
}
