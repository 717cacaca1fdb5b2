//! System calls of `shader-lab` on the way of its pictures fail once, and a signal meets it in them.
//!
//! The driver starts slowly. So of each kind of call about the pictures two are disturbed, and no calls of the driver.
//! With `RENDER_INJECTIONS=all` every call about the pictures is.
//! Where `strace` cannot run, these tests are shown as ignored.

#[cfg(target_os = "linux")]
#[path = "injected/linux.rs"]
mod linux;

fn main() {
    #[cfg(target_os = "linux")]
    linux::run();
}
