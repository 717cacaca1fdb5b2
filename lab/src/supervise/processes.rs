//! The processes below this one: those that it has started, and what they have started in turn.

use std::fs;
use std::time::Duration;

use nix::sys::signal::{Signal, kill};
use nix::sys::wait::{WaitPidFlag, WaitStatus, waitpid};
use nix::unistd::Pid;

/// Returns the processes that the process `id` has started or adopted, where the system tells them.
fn children(id: Pid) -> Vec<Pid> {
    let threads = fs::read_dir(format!("/proc/{id}/task")).into_iter().flatten().flatten();
    let lists = threads.filter_map(|thread| fs::read_to_string(thread.path().join("children")).ok());
    lists
        .flat_map(|list| list.split(' ').filter_map(|id| id.parse().ok().map(Pid::from_raw)).collect::<Vec<_>>())
        .collect()
}

/// Returns the resident memory of all processes below the process `id`, in MB.
pub fn memory_below(id: Pid) -> f64 {
    let memory = |id: Pid| {
        let text = fs::read_to_string(format!("/proc/{id}/status")).unwrap_or_default();
        let own = text.lines().find_map(|line| line.strip_prefix("VmRSS:")?.strip_suffix("kB")?.trim().parse().ok());
        own.map_or(0.0, |kilobytes: f64| kilobytes * 1024e-6) + memory_below(id)
    };
    children(id).into_iter().map(memory).sum()
}

/// Ends all processes below this one, and waits for them.
pub fn end_all() {
    while let Ok(status) = waitpid(None, Some(WaitPidFlag::WNOHANG)) {
        if status == WaitStatus::StillAlive {
            for id in children(Pid::this()) {
                let _ = kill(id, Signal::SIGKILL);
            }
            std::thread::sleep(Duration::from_millis(1));
        }
    }
}
