//! System calls of `shader-lab` on the way of its pictures fail once, and a signal meets it in them.
//!
//! The driver starts slowly. So of each kind of call about the pictures two are disturbed, and no calls of the driver.
//! Where `strace` cannot run, these tests are shown as ignored.

#[cfg(target_os = "linux")]
#[path = "injected/linux.rs"]
mod linux;

fn main() {
    #[cfg(target_os = "linux")]
    libtest_mimic::run(&libtest_mimic::Arguments::from_args(), linux::trials()).exit();
}
