//! A model of a file system that may lose all changes that are not synced. It computes the possible contents of a
//! folder after a loss of power.
//!
//! POSIX promises that changes of a file are on the disk if `fsync` of the file follows them. It promises the same for
//! changes of the names in a folder and `fsync` of the folder. Each later change may be lost or not, in any
//! combination. A renaming is done completely or not at all, as in every file system with a journal.

use std::collections::{BTreeSet, HashMap};

/// A change that a process makes in a folder.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Event {
    /// The file `file` gets the name `name`.
    Name { name: String, file: usize },
    /// The file that has the name `from` gets the name `to`.
    Rename { from: String, to: String },
    /// The bytes are appended to the file `file`.
    Write { file: usize, bytes: Vec<u8> },
    /// `fsync` of this file: its bytes written so far are on the disk.
    SyncFile(usize),
    /// `fsync` of the folder: its names are on the disk.
    SyncFolder,
}

/// The content of a file: its bytes, or `None` if there is no file.
type Content = Option<Vec<u8>>;

/// Returns all contents that the file `name` may have if the power fails after these events. Before the events its
/// content was `old`, which was on the disk.
pub fn outcomes(events: &[Event], name: &str, old: &Content) -> BTreeSet<Content> {
    let last_sync = events.iter().rposition(|event| *event == Event::SyncFolder);
    // The files that may have the name are found first.
    let changes: Vec<_> = events
        .iter()
        .enumerate()
        .filter(|(_, event)| matches!(event, Event::Name { .. } | Event::Rename { .. }))
        .collect();
    let sure = changes.iter().filter(|(index, _)| Some(*index) < last_sync).count();
    let mut leads_to = BTreeSet::new();
    for chosen in 0..1_u32 << (changes.len() - sure) {
        // `known` follows all changes, because a renaming moves the file that has the name at that moment, even if that
        // name is not on the disk.
        let (mut known, mut on_disk) = (HashMap::new(), None);
        for (number, (_, event)) in changes.iter().enumerate() {
            let happens = number < sure || chosen >> (number - sure) & 1 == 1;
            let (target, file) = match event {
                Event::Name { name, file } => (name, *file),
                Event::Rename { from, to } => (to, known[from]),
                _ => unreachable!("only names are changed here"),
            };
            known.insert(target.clone(), file);
            if happens && target == name {
                on_disk = Some(file);
            }
        }
        leads_to.insert(on_disk);
    }
    leads_to
        .into_iter()
        .flat_map(|file| file.map_or_else(|| BTreeSet::from([old.clone()]), |file| contents(events, file)))
        .collect()
}

/// Returns all contents that the file number `file` may have. Each write after the last sync may have left all of its
/// bytes, half of them followed by zeros, only zeros, or nothing.
fn contents(events: &[Event], file: usize) -> BTreeSet<Content> {
    let last_sync = events.iter().rposition(|event| *event == Event::SyncFile(file));
    let mut contents = BTreeSet::from([Vec::new()]);
    for (index, event) in events.iter().enumerate() {
        let Event::Write { file: written, bytes } = event else { continue };
        if *written != file {
            continue;
        }
        let half = [&bytes[..bytes.len() / 2], &vec![0; bytes.len() - bytes.len() / 2]].concat();
        let lost = vec![0; bytes.len()];
        let may_be =
            if Some(index) < last_sync { vec![bytes.clone()] } else { vec![bytes.clone(), half, lost, Vec::new()] };
        contents = contents.iter().flat_map(|before| may_be.iter().map(|more| [&before[..], more].concat())).collect();
    }
    contents.into_iter().map(Some).collect()
}
