//! System calls of `render-lab` on the way of its files fail once, and a signal meets it in them.
//!
//! Of each name of a call a few are disturbed, spread evenly over the run; with `RENDER_INJECTIONS=all` every one is.
//! Where `strace` cannot run, these tests are shown as ignored.

#[cfg(target_os = "linux")]
#[path = "injected/linux.rs"]
mod linux;

fn main() {
    #[cfg(target_os = "linux")]
    linux::run();
}
