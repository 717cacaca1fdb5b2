//! Runs `shader-lab --watch` while the test changes the module.

use std::io::{BufRead, BufReader, Read};
use std::process::Stdio;
use std::sync::mpsc::{self, Receiver};
use std::time::Duration;

use test_support::running::Running;

use super::*;

/// Time limit for the program to notice a change.
const PATIENCE: Duration = Duration::from_secs(600);

/// A running program, and the lines that it writes. It is killed when this value is dropped.
struct Watched(Running, Receiver<String>);

impl Watched {
    fn start(mut command: Command) -> Self {
        let command = command.stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut child = Running::start(command).expect("the program starts");
        let (sender, receiver) = mpsc::channel();
        let (stdout, stderr) = (child.stdout.take().expect("a pipe"), child.stderr.take().expect("a pipe"));
        let pipes: [Box<dyn Read + Send>; 2] = [Box::new(stdout), Box::new(stderr)];
        for pipe in pipes {
            let sender = sender.clone();
            std::thread::spawn(move || {
                BufReader::new(pipe).lines().map_while(Result::ok).all(|line| sender.send(line).is_ok())
            });
        }
        Self(child, receiver)
    }

    fn wait_for(&self, start: &str) -> String {
        loop {
            let line = self.1.recv_timeout(PATIENCE).unwrap_or_else(|_| panic!("no line starts with [{start}]"));
            if line.starts_with(start) {
                return line;
            }
        }
    }
}

#[test]
fn watching_survives_a_broken_shader_and_keeps_the_last_good_picture() {
    let folder = Folder::new();
    let path = folder.write("my.wgsl", TEMPLATE);
    let mut watched = Watched::start(command(&folder, "my.wgsl --watch"));
    watched.wait_for("wrote out-difference.png");
    let good = folder.read("out.png");

    folder.write("my.wgsl", format!("{TEMPLATE}nonsense\n"));
    let line = TEMPLATE.lines().count() + 1;
    watched.wait_for(&format!("Error: my.wgsl:{line}:1: "));
    fs::remove_file(&path).expect("it is there");
    watched.wait_for("Error: my.wgsl: ");
    assert!(watched.0.try_wait().expect("it can be asked").is_none(), "the program goes on");
    assert_eq!(folder.read("out.png"), good);

    folder.write("my.wgsl", TEMPLATE.replace("return n *", "return n.zyx *"));
    watched.wait_for("wrote out-difference.png");
    assert!(folder.read("out.png") != good, "the new picture is another");
}
