//! Tests with files that are neither pictures nor text.

use std::fs::File;
use std::io::Write;
use std::process::Command;

use test_support::folder::Folder;

const GRID: [&str; 2] = ["scenes/grid/config.txt", "scenes/grid/scene.txt"];

/// Runs `render-lab` in an address space of 200 MB, and returns its error message. Checks that the program ends with
/// status 2, and not by a signal.
fn complaint_in_little_memory(arguments: &[&str]) -> String {
    let mut shell = Command::new("bash");
    shell.args(["-c", "ulimit -v 200000; exec \"$@\"", "limited", env!("CARGO_BIN_EXE_render-lab")]).args(arguments);
    let output = shell.current_dir(test_support::project_root()).output().expect("the program runs");
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {output:?}");
    String::from_utf8(output.stderr).expect("it complains in text")
}

#[test]
fn endless_and_empty_pictures_are_refused_in_little_memory() {
    let folder = Folder::new();
    let holes = folder.name("holes.ppm");
    File::create(&holes).and_then(|file| file.set_len(4 << 30)).expect("holes take no place");
    for name in ["/dev/zero", "/dev/null", &holes] {
        let message = complaint_in_little_memory(&["compare", name, name]);
        assert!(message.contains(&format!("{name}: neither PPM (P3 or P6), PNG, PFM, NPY nor EXR")), "{message}");
    }
    // This file begins like a picture and is 5 GiB long. Reading it must end with an error about memory or about its
    // size.
    let mut file = File::create(folder.file("long.ppm")).expect("the folder is writable");
    file.write_all(b"P6 9 9 255\n").and_then(|()| file.set_len(5 << 30)).expect("holes take no place");
    let message = complaint_in_little_memory(&["compare", &folder.name("long.ppm"), &folder.name("long.ppm")]);
    assert!(message.contains("long.ppm: "), "{message}");
}

#[test]
fn endless_configurations_are_refused_with_and_without_settings() {
    let folder = Folder::new();
    let out = folder.name("out.ppm");
    for settings in [&[][..], &["--set", "gamma=1"]] {
        let arguments = [&["render", "/dev/zero", GRID[1], &out], settings].concat();
        let message = complaint_in_little_memory(&arguments);
        assert!(message.contains("[/dev/zero]: line 1 is longer than 1048576 bytes"), "{message}");
        assert!(folder.names().is_empty());
    }
}
