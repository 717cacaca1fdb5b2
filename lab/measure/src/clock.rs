//! The user time of this process and of those that it has started, and the largest memory of this process.

use nix::sys::resource::{UsageWho, getrusage};

fn user(who: UsageWho) -> f64 {
    // `getrusage` fails only for an unknown `who`.
    let time = getrusage(who).expect("a process may ask about itself").user_time();
    time.tv_sec() as f64 + time.tv_usec() as f64 * 1e-6
}

/// Returns the user time of this process since its start, in seconds.
#[must_use]
pub fn own_seconds() -> f64 {
    user(UsageWho::RUSAGE_SELF)
}

/// Returns the user time of all processes that this process has started and waited for, in seconds.
#[must_use]
pub fn seconds_of_children() -> f64 {
    user(UsageWho::RUSAGE_CHILDREN)
}

fn memory(who: UsageWho) -> u64 {
    let usage = getrusage(who).expect("a process may ask about itself");
    u64::try_from(usage.max_rss()).unwrap_or(0) * 1024
}

/// Returns the largest resident memory of this process since its start, in bytes.
#[must_use]
pub fn peak_memory() -> u64 {
    memory(UsageWho::RUSAGE_SELF)
}

/// Returns the largest resident memory that one of the processes had that this process has started and waited for, in
/// bytes. It is at least the memory that this process had when it started them.
#[must_use]
pub fn peak_memory_of_children() -> u64 {
    memory(UsageWho::RUSAGE_CHILDREN)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn work_and_a_process_take_user_time() {
        let before = [own_seconds(), seconds_of_children()];
        let mut value = 1.0_f64;
        while own_seconds() <= before[0] {
            value = std::hint::black_box(value * 1.000_001);
        }
        let script = "i=0; while [ $i -lt 200000 ]; do i=$((i+1)); done";
        let status = std::process::Command::new("sh").args(["-c", script]).status();
        assert!(status.is_ok_and(|status| status.success()) && seconds_of_children() > before[1]);
        assert!(peak_memory() > 100_000 && peak_memory_of_children() > 100_000, "{} bytes", peak_memory());
    }
}
