//! Tests of outputs that cannot be written because of the machine: a full disk, or a folder in which no file may be
//! created.
//!
//! Some tests need rights that the user may lack. They are then shown as ignored.

#[cfg(unix)]
#[path = "machine/unix.rs"]
mod unix;

fn main() {
    let mut arguments = libtest_mimic::Arguments::from_args();
    // One test at a time. A process that another test starts may hold a copied program open for writing for a moment,
    // and then the copy cannot be started.
    arguments.test_threads = Some(1);
    #[cfg(unix)]
    let trials = unix::trials();
    #[cfg(not(unix))]
    let trials = Vec::new();
    libtest_mimic::run(&arguments, trials).exit();
}
