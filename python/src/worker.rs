//! Runs the renderer without the interpreter's lock, so that other threads of Python go on and Ctrl-C works.

use std::panic::resume_unwind;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

use pyo3::prelude::*;

use crate::fault::Fault;

/// How long a signal may wait.
const PERIOD: Duration = Duration::from_millis(50);

/// Stack of the thread in bytes. The renderer needs 256 KiB in builds without optimisation.
const STACK: usize = 2 << 20;

/// Runs `work` in a thread, without the interpreter's lock. If a signal raises an exception meanwhile, sets `stop`,
/// waits for the end of `work`, and returns the exception. `work` must end soon after `stop` is set.
///
/// # Errors
/// The fault of `work`, the exception of a signal, or an `OSError` if there is no thread.
pub fn run<T: Send>(py: Python<'_>, stop: &AtomicBool, work: impl FnOnce() -> Result<T, Fault> + Send) -> PyResult<T> {
    py.detach(|| {
        thread::scope(|scope| {
            // The worker drops its end of the channel when it ends, which wakes this thread.
            let (working, ended) = channel::<()>();
            let worker = thread::Builder::new().name("exact_renderer".to_owned()).stack_size(STACK);
            let worker = worker.spawn_scoped(scope, move || {
                let _working = working;
                work()
            })?;
            let mut signal = Ok(());
            while signal.is_ok() && ended.recv_timeout(PERIOD) == Err(RecvTimeoutError::Timeout) {
                signal = Python::attach(|py| py.check_signals());
            }
            stop.store(signal.is_err(), Ordering::Relaxed);
            let result = worker.join().unwrap_or_else(|panic| resume_unwind(panic));
            signal?;
            Ok(result?)
        })
    })
}
