//! Each system call of `render-lab` on the way of its files fails once, and a signal meets it in each of them.
//!
//! Where `strace` cannot run, these tests are shown as ignored.

#[cfg(target_os = "linux")]
#[path = "injected/linux.rs"]
mod linux;

fn main() {
    #[cfg(target_os = "linux")]
    libtest_mimic::run(&libtest_mimic::Arguments::from_args(), linux::trials()).exit();
}
