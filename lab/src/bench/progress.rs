//! The messages about the progress of a long measurement.

use std::fmt::Display;
use std::time::{Duration, Instant};

use super::results::Results;

/// Returns the message that announces the next of `of` tasks after the first `done`, with an estimate of the time left.
/// The estimate gives each remaining task the mean time of the tasks since `since`. The times of tasks differ, so it is
/// rough.
pub fn announcement(done: usize, of: usize, task: &impl Display, since: Instant) -> String {
    let left = match done {
        0 => String::new(),
        _ => format!(", about {} left", rough(since.elapsed().div_f64(done as f64).mul_f64((of - done) as f64))),
    };
    format!("task {} of {of}: {task}{left}", done + 1)
}

fn rough(time: Duration) -> String {
    match time.as_secs() {
        seconds @ 0..=99 => format!("{seconds} s"),
        seconds @ 100..=5999 => format!("{} min", seconds.div_ceil(60)),
        seconds => format!("{:.1} h", seconds as f64 / 3600.0),
    }
}

/// Returns a warning if the repeats of some settings differ much from each other, and otherwise `None`.
pub fn spread_warning(results: &Results) -> Option<String> {
    /// The largest spread without a warning. The spread is the distance between the bounds, divided by the median.
    const MOST_SPREAD: f64 = 0.1;
    let of = results.timings.len();
    let wide = results.timings.iter().filter(|timing| timing.median.spread() > MOST_SPREAD).count();
    (wide > 0).then(|| {
        format!(
            "warning: in {wide} of {of} settings the bounds of the median are more than {:.0} % of it apart: the machine was \
             busy or its clock changed. More --repeats on a quiet machine narrow them.",
            100.0 * MOST_SPREAD
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_task_is_announced_with_its_number_and_the_time_left() {
        let now = Instant::now();
        assert_eq!(announcement(0, 21, &"scale width", now), "task 1 of 21: scale width");
        let earlier = now.checked_sub(Duration::from_secs(20)).expect("the clock has run that long");
        let text = announcement(2, 4, &"x", earlier);
        assert!(text.starts_with("task 3 of 4: x, about 20 s left"), "{text}");
        assert_eq!([5, 100, 6000].map(|seconds| rough(Duration::from_secs(seconds))), ["5 s", "2 min", "1.7 h"]);
    }
}
