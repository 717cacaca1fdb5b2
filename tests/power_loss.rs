//! A loss of power at any moment, simulated: the calls of a process that writes a file are recorded, and a model of a
//! file system says what POSIX lets stand after each of them. With [`Options::sync`] it is the old file or the new one.
//!
//! Where `strace` cannot run, these tests are shown as ignored.

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
