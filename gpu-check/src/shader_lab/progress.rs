//! Progress reports for long renderings.

use std::time::{Duration, Instant};

use cpu::internals::input::size::Size;

use crate::terminal;

/// Shortest time between two reports, and before the first report.
const PATIENCE: Duration = Duration::from_secs(2);

/// Reports the progress of work that consists of many parts.
#[derive(Debug)]
pub struct Progress {
    /// The words at the start of a report, such as `WGSL renders`.
    words: &'static str,
    start: Instant,
    last: Instant,
}

impl Progress {
    /// Returns the progress of work that begins now. `words` are the start of each report.
    #[must_use]
    pub fn start(words: &'static str) -> Self {
        let now = Instant::now();
        Self { words, start: now, last: now }
    }

    /// Writes a report to the terminal, if one is due, when `pixels` pixels of a picture are done and end a row.
    pub fn note_row(&mut self, pixels: usize, size: Size) {
        if pixels.is_multiple_of(size.width())
            && let Some(text) = self.tell((pixels / size.width()) as u64, size.height() as u64)
        {
            terminal::note(&text);
        }
    }

    /// Returns the report when `done` of `of` parts are finished. Returns `None` if no part or all parts are finished,
    /// or if the last report is less than two seconds old.
    pub fn tell(&mut self, done: u64, of: u64) -> Option<String> {
        if done == 0 || done >= of || self.last.elapsed() < PATIENCE {
            return None;
        }
        self.last = Instant::now();
        let left = self.start.elapsed().mul_f64((of - done) as f64 / done as f64);
        Some(format!("{}: {} %, about {} s left", self.words, 100 * done / of, left.as_secs()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_work_is_reported_at_intervals() {
        let mut progress = Progress::start("WGSL renders");
        assert_eq!(progress.tell(1, 4), None, "it began just now");
        let earlier = Instant::now().checked_sub(Duration::from_secs(30)).expect("the clock has run that long");
        let mut progress = Progress { words: "the CPU renders", start: earlier, last: earlier };
        assert_eq!(progress.tell(1, 4).as_deref(), Some("the CPU renders: 25 %, about 90 s left"));
        assert_eq!(progress.tell(2, 4), None, "it was reported just now");
        progress.last = earlier;
        assert_eq!(progress.tell(4, 4), None, "it is done");
    }
}
