//! The calls about files in what `strace` wrote.

use std::collections::HashMap;

/// Calls about files, by the names that Linux gives them. The others are about memory, signals and time.
const CALLS: [&str; 25] = [
    "access",
    "close",
    "dup",
    "faccessat",
    "faccessat2",
    "fchmod",
    "fchown",
    "fcntl",
    "fstat",
    "fsync",
    "ftruncate",
    "getcwd",
    "linkat",
    "lseek",
    "mkdir",
    "newfstatat",
    "open",
    "openat",
    "read",
    "readlink",
    "rename",
    "renameat",
    "statx",
    "unlinkat",
    "write",
];

/// A call: its thread, its name, the how-many-th of this name it is in its thread, and how strace writes it.
#[derive(Debug)]
pub struct Call {
    thread: String,
    pub name: String,
    pub number: usize,
    pub text: String,
}

/// The calls from the first on whose text contains `folder`, or only those whose text does. Left out are calls whose
/// name and number another thread makes too: disturbing one would disturb both.
pub fn calls(text: &str, folder: &str, only_folder: bool) -> Vec<Call> {
    let mut counts: HashMap<(&str, &str), usize> = HashMap::new();
    let mut found: Vec<Call> = Vec::new();
    for line in text.lines() {
        // The number of the thread is missing where there is only one.
        let starts_with_number = line.starts_with(|c: char| c.is_ascii_digit());
        let (thread, text) = line.split_once(' ').filter(|_| starts_with_number).unwrap_or(("", line));
        let Some((name, _)) = text.trim_start().split_once('(') else { continue };
        let Some(name) = CALLS.iter().find(|known| **known == name) else { continue };
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

/// At most `most` calls of each name, spread evenly over all of them: the last one, the first one if there may be two,
/// and others between them.
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

/// Whether the call number `index`, of calls from 0 to `last`, is among the `most` chosen ones.
fn is_chosen(index: usize, last: usize, most: usize) -> bool {
    match most.saturating_sub(1).min(last) {
        0 => most > 0 && index == last,
        gaps => (0..=gaps).any(|gap| gap * last / gaps == index),
    }
}
