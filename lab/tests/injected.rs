//! Lets one system call of `render-lab` fail in each run, or sends a signal during the call, and checks the files.
//!
//! Of the calls with one name a few are disturbed, spread evenly over the run; with `RENDER_INJECTIONS=all` all are. If
//! `strace` cannot run, these tests are shown as ignored.

#[cfg(target_os = "linux")]
#[path = "injected/linux.rs"]
mod linux;

fn main() {
    #[cfg(target_os = "linux")]
    test_support::injection::run(linux::trials());
}
