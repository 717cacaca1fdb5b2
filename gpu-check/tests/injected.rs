//! Tests `shader-lab` while it writes its pictures: a system call fails, or a signal comes during a call.
//!
//! The driver needs much time to start. So only two calls of each name that concern the pictures are disturbed, and no
//! calls of the driver. With `RENDER_INJECTIONS=all`, every call that concerns the pictures is disturbed. If `strace`
//! cannot run, these tests are shown as ignored.

#[cfg(target_os = "linux")]
#[path = "injected/linux.rs"]
mod linux;

fn main() {
    #[cfg(target_os = "linux")]
    test_support::injection::run(linux::trials());
}
