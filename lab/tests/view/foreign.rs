//! Tests that `render-lab view` serves its own page, whatever lies in the current folder.

use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::process::Command;

use test_support::folder::Folder;

use crate::Server;

/// A page that names its owner.
fn page(owner: &str) -> String {
    format!("<!doctype html><meta name=\"served-by\" content=\"\">{owner}")
}

/// Installs the program in a folder, with its page if there is one. Returns the program's path.
fn install(prefix: &Path, page: Option<&str>) -> PathBuf {
    let (program, site) = (prefix.join("bin/render-lab"), prefix.join("share/exact-renderer/site"));
    fs::create_dir_all(prefix.join("bin")).expect("the folder is writable");
    if let Some(page) = page {
        fs::create_dir_all(&site).expect("the folder is writable");
        fs::write(site.join("index.html"), page).expect("the folder is writable");
    }
    let built = Path::new(env!("CARGO_BIN_EXE_render-lab"));
    // A second name is enough, if both folders are on one file system.
    fs::hard_link(built, &program).or_else(|_| fs::copy(built, &program).map(drop)).expect("there is room");
    program
}

/// A folder as a stranger may have made it: two texts, and pages wherever a program may look for one.
fn downloaded() -> Folder {
    let folder = Folder::with_scene("image_width: 8\n", "");
    for place in ["out/site", "share/exact-renderer/site", "site", "web/site", "target/debug/../../out/site"] {
        fs::create_dir_all(folder.file(place)).expect("the folder is writable");
        folder.write(&format!("{place}/index.html"), page("a stranger"));
    }
    folder
}

#[test]
fn a_page_in_the_current_folder_is_not_served() {
    let prefix = Folder::new();
    let program = install(prefix.path(), Some(&page("the program")));
    let server = Server::run(&program, downloaded(), &[]);
    let mut answer = String::new();
    server.ask("/").read_to_string(&mut answer).expect("it answers in text");
    assert!(answer.ends_with("the program") && !answer.contains("stranger"), "{answer}");
}

#[test]
fn a_program_without_its_page_takes_none_from_the_current_folder() {
    let (prefix, folder) = (Folder::new(), downloaded());
    let program = install(prefix.path(), None);
    let mut view = Command::new(program);
    let output = view.current_dir(folder.path()).args(["view", "config.txt", "scene.txt", "--port", "0"]).output();
    let output = output.expect("the program starts");
    let message = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.code() == Some(2) && output.stdout.is_empty(), "{output:?}");
    assert!(message.contains("does not have the page; build it with web/build"), "{message}");
}
