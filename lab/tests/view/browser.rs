//! Tests what `render-lab view --open` says if no browser can be opened.

use std::fs;
use std::io::{BufRead, BufReader};
use std::os::unix::fs::PermissionsExt;
use std::process::{Command, Stdio};

use test_support::folder::Folder;
use test_support::running::Running;

#[test]
fn a_browser_that_cannot_be_opened_is_a_message_with_the_reason() {
    for (script, reason) in
        [(None, "No such file or directory (os error 2)"), (Some("exit 3"), "xdg-open ended with exit status: 3")]
    {
        let folder = Folder::with_scene("", "");
        folder.write("index.html", "<!doctype html><meta name=\"served-by\" content=\"\">");
        if let Some(script) = script {
            let path = folder.write("xdg-open", format!("#!/bin/sh\n{script}\n"));
            fs::set_permissions(path, fs::Permissions::from_mode(0o755)).expect("it is ours");
        }
        let mut command = Command::new(env!("CARGO_BIN_EXE_render-lab"));
        command.current_dir(folder.path()).env("PATH", folder.path()).stdout(Stdio::null()).stderr(Stdio::piped());
        command.args(["view", "config.txt", "scene.txt", "--port", "0", "--site", ".", "--open"]);
        let mut child = Running::start(&mut command).expect("the program starts");
        let mut line = String::new();
        BufReader::new(child.stderr.take().expect("it is a pipe")).read_line(&mut line).expect("it is text");
        assert!(line.contains(&format!("cannot open the browser: {reason}; open the address yourself")), "{line}");
    }
}
