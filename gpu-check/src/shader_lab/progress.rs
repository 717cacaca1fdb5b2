//! What is said while a rendering takes long, on standard error.

use std::time::{Duration, Instant};

/// How long nothing is said.
const PATIENCE: Duration = Duration::from_secs(2);

/// Tells of a work in many parts, now and then.
#[derive(Debug)]
pub struct Progress {
    start: Instant,
    last: Instant,
}

impl Progress {
    /// A work that begins.
    #[must_use]
    pub fn start() -> Self {
        let now = Instant::now();
        Self { start: now, last: now }
    }

    /// What to say after `done` of `of` parts: nothing at the end, or where the last line is fresh.
    pub fn tell(&mut self, done: u64, of: u64) -> Option<String> {
        if done == 0 || done >= of || self.last.elapsed() < PATIENCE {
            return None;
        }
        self.last = Instant::now();
        let left = self.start.elapsed().mul_f64((of - done) as f64 / done as f64);
        Some(format!("WGSL renders: {} %, about {} s left", 100 * done / of, left.as_secs()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_work_is_told_of_now_and_then() {
        let mut progress = Progress::start();
        assert_eq!(progress.tell(1, 4), None, "it began just now");
        let earlier = Instant::now().checked_sub(Duration::from_secs(30)).expect("the clock has run that long");
        let mut progress = Progress { start: earlier, last: earlier };
        assert_eq!(progress.tell(1, 4).as_deref(), Some("WGSL renders: 25 %, about 90 s left"));
        assert_eq!(progress.tell(2, 4), None, "it was told just now");
        progress.last = earlier;
        assert_eq!(progress.tell(4, 4), None, "it is done");
    }
}
