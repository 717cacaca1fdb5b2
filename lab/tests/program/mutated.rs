//! Files of all formats that are read, with random changes. No change crashes a command, or lets it take more than
//! little memory.

use std::fs;

use cpu::internals::sampling::uniform::Uniform;
use sha2::{Digest, Sha256};
use test_support::folder::Folder;
use test_support::mutate::{below, mutate};
use test_support::number_of;

use crate::bash;

/// Bytes that mean something in one of the formats: sizes, types and names.
const TOKENS: [&[u8]; 12] = [
    b"\0\0\0\0",
    b"\xff\xff\xff\xff",
    b"\xff\xff\xff\x7f",
    b"\0\0\0\x80",
    b"99999999999999999999 ",
    b"-1 nan 1e999 ",
    b"'descr': '<f8'",
    b"(4294967295, 4294967295, 3)",
    b"IDAT\0\0\0\0IEND",
    b"channels\0chlist\0",
    b"dataWindow\0box2i\0\x10\0\0\0",
    b"\r\n",
];

/// Statuses that a command may end with: 0 and 1 for pictures that are equal and not, 2 and 3 for errors and a picture
/// that is not finished, and 130 after a signal.
const STATUSES: [i32; 5] = [0, 1, 2, 3, 130];

/// Completes a changed file.
type Complete = fn(Vec<u8>) -> Vec<u8>;

/// Runs `line` on changed and completed copies of `files`, each of which is the file `$f`. Returns how often the line
/// ended with each of [`STATUSES`]. `RENDER_CASES` sets the number of changes, instead of `cases`.
fn mutated(folder: &Folder, files: &[Vec<u8>], cases: u64, complete: Complete, line: &str) -> [usize; 5] {
    let seed = number_of("RENDER_SEED").unwrap_or(1);
    let mut random = Uniform::new(seed);
    let tokens = TOKENS.map(<[u8]>::to_vec);
    let mut counts = [0; 5];
    // A shell that runs many commands takes less time than a shell for each.
    let mut left = number_of("RENDER_CASES").unwrap_or(cases);
    while left > 0 {
        let some = left.min(50);
        for number in 0..some {
            let file = &files[below(&mut random, files.len())];
            folder.write(&format!("changed-{number}"), complete(mutate(&mut random, file, files, &tokens)));
        }
        let each = format!(
            "ulimit -v 400000; for i in {{0..{}}}; do f=changed-$i; {line} >/dev/null 2>said; echo $?; done",
            some - 1
        );
        let output = bash(folder, &each);
        let statuses = String::from_utf8_lossy(&output.stdout).into_owned();
        assert_eq!(statuses.lines().count() as u64, some, "{output:?}");
        for (number, status) in statuses.lines().enumerate() {
            let known = STATUSES.iter().position(|known| known.to_string() == status);
            let bytes = || folder.read(&format!("changed-{number}")).escape_ascii().to_string();
            counts[known.unwrap_or_else(|| panic!("status {status}, seed {seed}: {}", bytes()))] += 1;
        }
        left -= some;
    }
    println!("{line}: {counts:?} with the statuses {STATUSES:?}");
    counts
}

#[test]
fn no_change_of_a_picture_crashes_a_command() {
    let folder = Folder::new();
    let pictures = test_support::project_root().join("lab/tests/program/pictures");
    let entries = fs::read_dir(pictures).expect("it is committed").map(|entry| entry.expect("it is there").path());
    let mut files: Vec<_> = entries.map(|path| fs::read(path).expect("it is committed")).collect();
    // Formats that the folder lacks, and files of ours.
    for (name, make) in [
        ("a.ppm", "$lab convert $root/lab/tests/program/pictures/u8.npy a.ppm"),
        ("b.ppm", "printf 'P6 3 1 255\n123456789' >b.ppm"),
        ("c.exr", "$lab convert $root/lab/tests/program/pictures/f2.npy c.exr"),
        ("d.pfm", "$lab convert $root/lab/tests/program/pictures/f2.npy d.pfm"),
    ] {
        assert!(bash(&folder, make).status.success(), "{make}");
        files.push(folder.read(name));
    }
    let lines = [
        "$lab convert $f o.npy --no-sync",
        "$lab convert $f o.png --no-sync",
        "$lab compare $f $f --heatmap o.png --no-sync",
    ];
    for line in lines {
        let counts = mutated(&folder, &files, 300, |bytes| bytes, line);
        assert!(counts[0] > 0 && counts[2] > 0, "some changes are read, and some are refused: {counts:?}");
    }
}

#[test]
fn no_change_of_a_checkpoint_crashes_a_command() {
    let folder = Folder::new();
    let render = "$lab render $root/scenes/grid/config.txt $root/scenes/grid/scene.txt o.ppm --quiet --no-sync --set image_width=16";
    let made = bash(&folder, &format!("{render} --checkpoint keep --rows ..4"));
    assert_eq!(made.status.code(), Some(3), "{made:?}");
    let mut file = folder.read("keep");
    let resume = format!("rm -f o.ppm; cp $f keep; {render} --resume keep --rows ..5");
    let counts = mutated(&folder, &[file.clone()], 100, |bytes| bytes, &resume);
    assert!(counts[2] > 0, "{counts:?}");
    // With the digest of its content, the header and the words of a file are looked at too.
    file.truncate(file.len() - 32);
    let with_digest = |mut bytes: Vec<u8>| {
        let digest = Sha256::digest(&bytes);
        bytes.extend(digest);
        bytes
    };
    let counts = mutated(&folder, &[file], 100, with_digest, &resume);
    assert!(counts[2] > 0 && counts[3] > 0, "some are refused, and some go on: {counts:?}");
}
