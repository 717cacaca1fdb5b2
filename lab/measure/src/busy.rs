//! The warning of a busy machine.

/// The smallest load with a warning. A measurement uses one core, so this is one process for that core.
const BUSY_LOAD: f64 = 1.0;

/// Returns the average number of runnable processes in the last minute, or `None` if the system does not say it.
#[must_use]
pub fn load() -> Option<f64> {
    std::fs::read_to_string("/proc/loadavg").ok()?.split(' ').next()?.parse().ok()
}

/// Returns a warning if a machine with this load is too busy to measure on it, and otherwise `None`.
#[must_use]
pub fn warning(load: Option<f64>) -> Option<String> {
    let load = load.filter(|&load| load >= BUSY_LOAD)?;
    let processors = std::thread::available_parallelism().map_or(1, usize::from);
    Some(format!(
        "warning: this machine is busy: {load:.1} processes wanted to run on {processors} processors in the last minute. \
         Times will spread; stop other programs and start again for figures to keep."
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_busy_machine_is_warned_about() {
        assert_eq!([warning(Some(0.99)), warning(None)], [None, None]);
        assert!(warning(Some(1.0)).is_some());
        let warning = warning(Some(3.0)).expect("it is busy");
        assert!(warning.starts_with("warning: this machine is busy: 3.0 processes"), "{warning}");
    }
}
