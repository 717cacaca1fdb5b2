//! Makes one system call of `render-lab` fail in each run, or sends a signal during the call, and checks the files
//! afterwards.
//!
//! Of the system calls with one name, only a few are disturbed, spread evenly over the run. With
//! `RENDER_INJECTIONS=all` all are disturbed. If `strace` cannot run, these tests are shown as ignored.

#[cfg(target_os = "linux")]
#[path = "injected/linux.rs"]
mod linux;

fn main() {
    #[cfg(target_os = "linux")]
    test_support::injection::run(linux::trials());
}
