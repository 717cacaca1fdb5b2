//! Finds the calls about files in the output of `strace`.

use std::collections::HashMap;

/// Names of the system calls of Linux about files. Other calls are about memory, signals and time, and are not
/// disturbed.
const CALLS: &str = "access close dup faccessat faccessat2 fchmod fchown fcntl fstat fsync ftruncate getcwd linkat lseek \
    mkdir newfstatat open openat read readlink rename renameat statx unlinkat write";

/// A system call: its thread, its name, its number among the calls with this name in this thread (from 1), and its text
/// in the output of strace.
#[derive(Debug)]
pub struct Call {
    thread: String,
    pub name: String,
    pub number: usize,
    pub text: String,
}

/// Returns the calls in the output of strace, beginning with the first one whose text contains `folder`. With
/// `only_folder`, returns only calls whose text contains `folder`. A call is left out if another thread makes a call
/// with its name and number, because strace would disturb both.
pub fn calls(text: &str, folder: &str, only_folder: bool) -> Vec<Call> {
    let mut counts: HashMap<(&str, &str), usize> = HashMap::new();
    let mut found: Vec<Call> = Vec::new();
    for line in text.lines() {
        // strace writes no thread number if it watches only one thread.
        let starts_with_number = line.starts_with(|c: char| c.is_ascii_digit());
        let (thread, text) = line.split_once(' ').filter(|_| starts_with_number).unwrap_or(("", line));
        let Some((name, _)) = text.trim_start().split_once('(') else { continue };
        let Some(name) = CALLS.split(' ').find(|known| *known == name) else { continue };
        let number = counts.entry((thread, name)).or_default();
        *number += 1;
        let is_about_folder = text.contains(folder);
        if is_about_folder || !only_folder && !found.is_empty() {
            let [thread, name, text] = [thread, name, text].map(str::to_owned);
            found.push(Call { thread, name, number: *number, text });
        }
    }
    found.retain(|call| {
        let is_of_another = |(&(thread, name), &most): (&(&str, &str), &usize)| {
            name == call.name && thread != call.thread && most >= call.number
        };
        !counts.iter().any(is_of_another)
    });
    found
}

/// Returns at most `most` calls of each name: the last one, the first one if `most` is at least 2, and others evenly
/// between them.
pub fn spread(mut calls: Vec<Call>, most: usize) -> Vec<Call> {
    let mut totals: HashMap<String, usize> = HashMap::new();
    calls.iter().for_each(|call| *totals.entry(call.name.clone()).or_default() += 1);
    let mut seen: HashMap<String, usize> = HashMap::new();
    calls.retain(|call| {
        let last = totals[&call.name] - 1;
        let index = seen.entry(call.name.clone()).or_default();
        *index += 1;
        is_chosen(*index - 1, last, most)
    });
    calls
}

/// Whether call number `index` is chosen, if `most` of the calls from 0 to `last` are chosen.
fn is_chosen(index: usize, last: usize, most: usize) -> bool {
    match most.saturating_sub(1).min(last) {
        0 => most > 0 && index == last,
        gaps => (0..=gaps).any(|gap| gap * last / gaps == index),
    }
}
