//! Progress reports for long renderings.

use std::time::{Duration, Instant};

/// Shortest time between two reports, and before the first report.
const PATIENCE: Duration = Duration::from_secs(2);

/// Reports the progress of work that consists of many parts.
#[derive(Debug)]
pub struct Progress {
    start: Instant,
    last: Instant,
}

impl Progress {
    /// Returns the progress of work that begins now.
    #[must_use]
    pub fn start() -> Self {
        let now = Instant::now();
        Self { start: now, last: now }
    }

    /// Returns the report when `done` of `of` parts are finished. Returns `None` if no part or all parts are finished,
    /// or if the last report is less than two seconds old.
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
    fn long_work_is_reported_at_intervals() {
        let mut progress = Progress::start();
        assert_eq!(progress.tell(1, 4), None, "it began just now");
        let earlier = Instant::now().checked_sub(Duration::from_secs(30)).expect("the clock has run that long");
        let mut progress = Progress { start: earlier, last: earlier };
        assert_eq!(progress.tell(1, 4).as_deref(), Some("WGSL renders: 25 %, about 90 s left"));
        assert_eq!(progress.tell(2, 4), None, "it was reported just now");
        progress.last = earlier;
        assert_eq!(progress.tell(4, 4), None, "it is done");
    }
}
