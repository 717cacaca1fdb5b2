//! Tests with files that are neither pictures nor text, in an address space of 200 MB.

use std::fs::File;
use std::io::Write;

use test_support::folder::Folder;

use crate::bash_complaint;

#[test]
fn endless_and_empty_files_are_refused_in_little_memory() {
    let folder = Folder::new();
    File::create(folder.file("holes.ppm")).and_then(|file| file.set_len(4 << 30)).expect("holes take no place");
    // This file begins like a picture and is 5 GiB long. Reading it must end with an error about memory or about its
    // size.
    let mut long = File::create(folder.file("long.ppm")).expect("the folder is writable");
    long.write_all(b"P6 9 9 255\n").and_then(|()| long.set_len(5 << 30)).expect("holes take no place");
    let neither = "neither PPM (P3 or P6), PNG, PFM, NPY nor EXR";
    let too_long = "[/dev/zero]: line 1 is longer than 1048576 bytes";
    for (line, message) in [
        ("compare /dev/zero /dev/zero", &format!("/dev/zero: {neither}")[..]),
        ("compare /dev/null /dev/null", &format!("/dev/null: {neither}")),
        ("compare holes.ppm holes.ppm", &format!("holes.ppm: {neither}")),
        ("compare long.ppm long.ppm", "long.ppm: "),
        ("render /dev/zero $root/scenes/grid/scene.txt o.ppm", too_long),
        ("render /dev/zero $root/scenes/grid/scene.txt o.ppm --set gamma=1", too_long),
    ] {
        let said = bash_complaint(&folder, &format!("ulimit -v 200000; $lab {line}"));
        assert!(said.contains(message) && folder.names() == ["holes.ppm", "long.ppm"], "{line}: {said}");
    }
}
