//! Tests of the commands that write files or describe scenes: `generate`, `inspect`, `man`; and `help`.

use std::fs;

use test_support::folder::Folder;

use crate::{complaint, printed};

#[test]
fn generated_files_are_the_committed_ones_and_may_go_to_standard_output() {
    let folder = Folder::new();
    let [config, scene] = ["config.txt", "scene.txt"].map(|name| folder.name(name));
    let options = ["--arrangement=grid", "--matte=3", "--metal=2", "--refractive=1", "--seed=4", "--objects=101"];
    let command = [&["generate", &config, &scene], &options[..]].concat();
    printed(&command);
    let again = complaint(&command);
    assert!(
        again.contains("config.txt: a file of this name exists; choose another, or replace it by --force"),
        "{again}"
    );
    printed(&[&command[..], &["--force"]].concat());
    for name in ["config.txt", "scene.txt"] {
        let committed = test_support::project_root().join("scenes/grid").join(name);
        let (made, committed) = (fs::read(folder.file(name)), fs::read(committed));
        assert!(made.expect("it was written") == committed.expect("it is committed"), "{name}");
    }
    let text = printed(&[&["generate", &folder.name("other.txt"), "-"], &options[..]].concat());
    assert!(text.as_bytes() == folder.read("scene.txt"));
    assert_eq!(folder.names(), ["config.txt", "other.txt", "scene.txt"]);
    printed(&["generate", "/dev/null", "/dev/null"]);
}

#[test]
fn a_scene_is_told_in_words_and_in_json() {
    let text = printed(&["inspect", "scenes/ten-thousand/config.txt", "scenes/ten-thousand/scene.txt"]);
    assert!(text.contains("structure   BVH: ") && text.contains("picture     400 x 225"), "{text}");
    for words in
        ["materials   25, 0 of them without objects", "from 0: the largest coordinate", "sizes       moderate: "]
    {
        assert!(text.contains(words), "{text}");
    }
    let json = printed(&["inspect", "scenes/spheres/scene.txt", "--json"]);
    let value: serde_json::Value = serde_json::from_str(&json).expect("it is JSON");
    assert_eq!((&value["spheres"], &value["cylinders"]), (&15.into(), &0.into()));
    assert!(complaint(&["inspect", "README.md"]).starts_with("Error: README.md:1:1: there is no scene entity [#]\n"));
    let swapped = complaint(&["inspect", "scenes/grid/scene.txt", "scenes/grid/config.txt"]);
    assert!(swapped.contains("a line of the other file; the order is: CONFIG SCENE"), "{swapped}");
}

#[test]
fn manual_pages_and_help_explain_files_and_commands() {
    let folder = Folder::new();
    printed(&["man", &folder.name("man1")]);
    let page = fs::read_to_string(folder.file("man1/render-lab-compare.1")).expect("it was written");
    assert!(page.contains(".TH render") && page.contains("heatmap"), "{page}");
    assert!(printed(&["help", "config"]).contains("| `samples_per_pixel:`      | whole number > 0      | 20 "));
    assert!(printed(&["help", "scene"]).contains("| `cylinder:`   | x y z radius ax ay az material |"));
    assert!(printed(&["help", "bench", "scale"]).contains("Usage: render-lab bench scale"));
    assert!(printed(&["help"]).contains("Exit status:") && printed(&["--help"]).contains("  130  interrupted"));
}

#[test]
fn shader_becomes_shader_lab() {
    let folder = Folder::new();
    let line = "printf '#!/bin/sh\\necho \"$@\"; exit 1' > shader-lab; chmod +x shader-lab
        PATH=$PWD:$PATH $lab shader my.wgsl --watch; echo $?; PATH=$PWD/none $lab shader x";
    let output = crate::bash(&folder, line);
    assert_eq!(String::from_utf8_lossy(&output.stdout), "my.wgsl --watch\n1\n");
    let message = String::from_utf8_lossy(&output.stderr);
    assert!(
        message.starts_with("Error: shader-lab is not installed") && message.contains("cargo install"),
        "{message}"
    );
    let version = printed(&["--version"]);
    assert!(version.starts_with("render-lab ") && version.contains("(commit "), "{version}");
}
