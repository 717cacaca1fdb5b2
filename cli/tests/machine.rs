//! Outputs that fail for reasons of the machine: a full disk, a folder that takes no file.
//!
//! Some need rights that a test may lack; without them they are shown as ignored.

#[cfg(unix)]
#[path = "machine/unix.rs"]
mod unix;

fn main() {
    let mut arguments = libtest_mimic::Arguments::from_args();
    // One at a time: a program that was just copied is busy while another test is starting a process.
    arguments.test_threads = Some(1);
    #[cfg(unix)]
    let trials = unix::trials();
    #[cfg(not(unix))]
    let trials = Vec::new();
    libtest_mimic::run(&arguments, trials).exit();
}
