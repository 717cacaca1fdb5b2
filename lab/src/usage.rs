//! The time and the memory that this process has used so far.

use nix::sys::resource::{UsageWho, getrusage};
use nix::sys::time::TimeVal;

/// A time in seconds.
pub type Seconds = f64;

/// The processor time of this process, and its largest use of memory.
#[derive(Clone, Copy, Debug)]
pub struct Usage {
    /// User time: the time spent in the program's own instructions.
    pub user: Seconds,
    /// System time: the time that the kernel spent for this process.
    pub system: Seconds,
    /// The largest resident memory in bytes since the start of the process.
    pub peak_memory: u64,
}

impl Usage {
    /// Returns the usage of this process from its start until now.
    #[must_use]
    pub fn now() -> Self {
        // `getrusage` fails only for an unknown `who`.
        let usage = getrusage(UsageWho::RUSAGE_SELF).expect("a process may ask about itself");
        let kibibytes = u64::try_from(usage.max_rss()).unwrap_or(0);
        Self { user: seconds(usage.user_time()), system: seconds(usage.system_time()), peak_memory: kibibytes * 1024 }
    }
}

fn seconds(time: TimeVal) -> Seconds {
    time.tv_sec() as f64 + time.tv_usec() as f64 * 1e-6
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn computing_takes_user_time_and_memory() {
        let before = Usage::now();
        let mut value = 1.0_f64;
        while Usage::now().user <= before.user {
            value = std::hint::black_box(value * 1.000_001);
        }
        let after = Usage::now();
        assert!(after.user > before.user && after.system >= before.system);
        assert!(after.peak_memory > 100_000, "{} bytes", after.peak_memory);
    }
}
