//! Simulates a loss of power at any moment. The tests record the system calls of a process that writes a file. After
//! each call, a model of a file system gives the contents that POSIX allows if the power fails then. With
//! [`Options::sync`] these must be the old file or the new one.
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
