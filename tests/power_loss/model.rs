//! A file system that forgets: what a process did to one folder, and what of it may be there after a loss of power.
//!
//! POSIX promises that what was done to a file before `fsync` of the file is on the disk, and what was done to the
//! names in a folder before `fsync` of the folder. All else may be there or not, in any combination. A renaming happens
//! as a whole or not at all, on which every file system with a journal agrees.

use std::collections::{BTreeSet, HashMap};

/// What a process did.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Event {
    /// The name leads to the file from now on.
    Name { name: String, file: usize },
    /// The file of one name gets the other.
    Rename { from: String, to: String },
    /// These bytes are added to the file.
    Write { file: usize, bytes: Vec<u8> },
    /// The file is on the disk.
    SyncFile(usize),
    /// The names are on the disk.
    SyncFolder,
}

/// What a file of the folder may hold: nothing is there, or these bytes.
type Content = Option<Vec<u8>>;

/// All that may stand under `name` when the power goes after these events. Before them `old` stood there, whole.
pub fn outcomes(events: &[Event], name: &str, old: &Content) -> BTreeSet<Content> {
    let last_sync = events.iter().rposition(|event| *event == Event::SyncFolder);
    // Names first: which files may the name lead to?
    let changes: Vec<_> = events
        .iter()
        .enumerate()
        .filter(|(_, event)| matches!(event, Event::Name { .. } | Event::Rename { .. }))
        .collect();
    let sure = changes.iter().filter(|(index, _)| Some(*index) < last_sync).count();
    let mut leads_to = BTreeSet::new();
    for chosen in 0..1_u32 << (changes.len() - sure) {
        // Where a file is renamed, what had its name is known whether or not that name is on the disk.
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

/// All that the file may hold: each write since the last sync is there, or half of it, or nothing but the room for it.
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

/// The model itself: what is known of a careless program and of a careful one.
pub fn is_right() -> Result<(), libtest_mimic::Failed> {
    let write = Event::Write { file: 1, bytes: b"new!".to_vec() };
    let (make, rename) =
        (Event::Name { name: "t".to_owned(), file: 1 }, Event::Rename { from: "t".to_owned(), to: "out".to_owned() });
    let old = Some(b"old".to_vec());
    let after = |events: &[Event]| outcomes(events, "out", &old);
    let [whole, half, room, empty] = [&b"new!"[..], b"ne\0\0", b"\0\0\0\0", b""].map(|text| Some(text.to_vec()));
    let careless = after(&[make.clone(), write.clone(), rename.clone()]);
    assert_eq!(careless, BTreeSet::from([old.clone(), whole.clone(), half, room, empty]));
    let synced = [make, write, Event::SyncFile(1), rename, Event::SyncFolder];
    assert_eq!(after(&synced[..3]), BTreeSet::from([old.clone()]));
    assert_eq!(after(&synced[..4]), BTreeSet::from([old.clone(), whole.clone()]));
    assert_eq!(after(&synced), BTreeSet::from([whole]));
    Ok(())
}
