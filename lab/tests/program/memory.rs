//! Tests the memory of commands on pictures, by the table of limits in `docs/testing.md`: so many bytes a pixel are
//! enough, and with less there is a message and no abort.

use test_support::folder::Folder;

use crate::bash;

/// Returns the width and the height of the pictures. With `RENDER_ALL=1` they have the most pixels that are read.
fn side() -> usize {
    if test_support::everything() { 8192 } else { 768 }
}

/// Address space in KiB that a command on a tiny picture takes, and half as much: the program, its stack, its heap and
/// the spare memory. A picture of one pixel took 39,257 KiB.
const BASE: usize = 60_000;

/// Commands, with the bytes a pixel that they take.
const COMMANDS: [(&str, usize); 20] = [
    ("convert a.ppm o.png", 3),
    ("convert text.ppm o.png", 3),
    ("convert a.png o.ppm", 3),
    ("convert u1.npy o.png", 3),
    ("convert a.ppm o.npy", 15),
    ("convert a.pfm o.npy", 12),
    ("convert a.pfm o.png", 15),
    ("convert a.pfm o.exr", 12),
    ("convert f8.npy o.pfm", 12),
    ("convert a.exr o.pfm", 12),
    ("convert colours.exr o.pfm --layer R", 4),
    ("compare a.ppm a.png", 6),
    ("compare a.ppm a.png --heatmap o.png", 12),
    ("compare a.pfm a.exr", 27),
    ("compare a.pfm a.exr --as numbers", 24),
    ("compare a.ppm a.png --html o.html", 6 + 64),
    ("compare one.pfm one.pfm --html o.html", 8 + 112),
    ("compare a.pfm a.exr --as numbers --html o.html", 24 + 208),
    ("render memory.txt /dev/null o.png --quiet", 6),
    ("render memory.txt /dev/null o.exr --quiet", 12),
];

#[test]
fn the_memory_of_the_table_is_enough_and_with_less_there_is_a_message() {
    let folder = Folder::new();
    let side = side();
    let pixels = side * side;
    folder.write("memory.txt", format!("image_width: {side}\naspect_ratio: 1 1\nsamples_per_pixel: 1\n"));
    let prepare = format!(
        "printf 'P6 {side} {side} 255\n' > a.ppm; truncate -s +{0} a.ppm; printf 'PF\n{side} {side}\n-1\n' > a.pfm; \
         truncate -s +{1} a.pfm; printf 'Pf\n{side} {side}\n-1\n' > one.pfm; truncate -s +{2} one.pfm; \
         {{ echo P3 {side} {side} 255; yes '0 0 0' | head -n {pixels}; }} > text.ppm; \
         $lab convert a.ppm a.png --no-sync && $lab convert a.pfm a.exr --no-sync && cp a.exr colours.exr",
        3 * pixels,
        12 * pixels,
        4 * pixels,
    );
    assert!(bash(&folder, &prepare).status.success());
    for (name, kind, bytes) in [("u1.npy", "|u1", 3), ("f8.npy", "<f8", 24)] {
        let header = format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': ({side}, {side}, 3), }}\n");
        let length = (header.len() as u16).to_le_bytes();
        let path = folder.write(name, [b"\x93NUMPY\x01\0", &length[..], header.as_bytes()].concat());
        let file = std::fs::File::options().write(true).open(path).expect("it was written");
        file.set_len((10 + header.len() + bytes * pixels) as u64).expect("holes take no place");
    }
    // With `RENDER_ALL=1` a file of so many numbers of eight bytes is too large, and so are the pictures for a page.
    let is_read =
        |command: &str| !(test_support::everything() && ["f8.npy", "--html"].iter().any(|part| command.contains(part)));
    for (command, bytes) in COMMANDS.into_iter().filter(|(command, _)| is_read(command)) {
        let enough = BASE + bytes * pixels / 1024;
        // With more arenas, the C library reserves 64 MiB of address space for a thread where there is room, which the
        // pictures then lack.
        let run = |kib: usize| bash(&folder, &format!("ulimit -v {kib}; MALLOC_ARENA_MAX=1 $lab {command} --no-sync"));
        let output = run(enough);
        assert_eq!(output.status.code(), Some(0), "{command} in {enough} KiB: {output:?}");
        let mut refused = 0;
        for step in [1, 3, 5] {
            let kib = enough - step * (enough - BASE / 2) / 6;
            let output = run(kib);
            let said = String::from_utf8_lossy(&output.stderr).into_owned();
            let has_message = said.contains("memory");
            assert!(
                output.status.code() == Some(0) || output.status.code() == Some(2) && has_message,
                "{command} in {kib} KiB: {output:?}"
            );
            refused += usize::from(has_message);
        }
        assert!(refused > 0, "{command}: {bytes} bytes a pixel are far more than it takes");
    }
}

#[test]
fn a_picture_that_announces_more_than_a_block_or_a_file_may_hold_is_refused_in_little_memory() {
    let folder = Folder::new();
    let write = |name: &str, change: &dyn Fn(&mut Vec<u8>)| {
        let path = test_support::project_root().join("lab/tests/program/pictures/w1c.exr");
        let mut bytes = std::fs::read(path).expect("it is committed");
        change(&mut bytes);
        folder.write(name, bytes);
    };
    // The windows of the data and of the display follow their names and types.
    let at = |bytes: &[u8], name: &str| {
        bytes.windows(name.len()).position(|part| part == name.as_bytes()).expect("it is there") + name.len()
    };
    write("wide.exr", &|bytes| {
        let place = at(bytes, "displayWindow\0box2i\0") + 4;
        bytes[place + 8..place + 12].copy_from_slice(&(1_i32 << 28).to_le_bytes());
    });
    write("large.exr", &|bytes| {
        let place = at(bytes, "dataWindow\0box2i\0") + 4;
        bytes[place + 8..place + 16].copy_from_slice(&[0xff, 0x1f, 0, 0, 0xff, 0x1f, 0, 0]);
    });
    for (name, words) in [("wide.exr", "it has more than 67108864 pixels"), ("large.exr", "cannot hold them")] {
        let output = bash(&folder, &format!("ulimit -v {BASE}; $lab convert {name} o.png"));
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(output.status.code() == Some(2) && said.contains(words), "{name}: {said}");
    }
}
