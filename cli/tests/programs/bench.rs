//! A folder with the three files of a run, and checks that apply to every run.

use std::fs;
use std::ops::Deref;
use std::process::{Command, Output};

pub use format::refused::SMALL;
use test_support::folder::Folder;

/// Paths of the two programs.
pub const PROGRAMS: [&str; 2] = [env!("CARGO_BIN_EXE_render-aos"), env!("CARGO_BIN_EXE_render-soa")];

/// A temporary folder for `config.txt`, `scene.txt` and `out.ppm`. It is removed when this value is dropped.
pub struct Bench(Folder);

impl Deref for Bench {
    type Target = Folder;

    fn deref(&self) -> &Folder {
        &self.0
    }
}

impl Bench {
    /// Creates a folder whose `config.txt` and `scene.txt` have these contents.
    pub fn new(config: impl AsRef<[u8]>, scene: impl AsRef<[u8]>) -> Self {
        Self(Folder::with_scene(config, scene))
    }

    /// Returns the names of all files in the folder except the two input files.
    pub fn outputs(&self) -> Vec<String> {
        let mut names = self.names();
        names.retain(|name| name != "config.txt" && name != "scene.txt");
        names
    }

    /// Returns the command `program config.txt scene.txt OUT`, with `out` in place of OUT. It runs in the folder, so
    /// that messages show short names.
    pub fn command(&self, program: &str, out: &str) -> Command {
        let mut command = test_support::running::program(program);
        command.current_dir(self.path()).args(["config.txt", "scene.txt", out]);
        command
    }

    /// Renders the files with both programs, checks that the two pictures are equal, and returns the picture's bytes.
    pub fn render(&self) -> Vec<u8> {
        let [first, second] = PROGRAMS.map(|program| {
            let output = self.command(program, "out.ppm").output().expect("the program runs");
            assert_succeeded(&output);
            assert_eq!(self.outputs(), ["out.ppm"]);
            let picture = self.read("out.ppm");
            fs::remove_file(self.file("out.ppm")).expect("it is ours");
            picture
        });
        assert!(first == second, "the two programs make different pictures");
        first
    }

    /// Runs both programs on files that they must refuse, checks that the two messages are equal, and returns the
    /// message.
    pub fn message(&self) -> String {
        let [first, second] = PROGRAMS.map(|program| {
            let output = self.command(program, "out.ppm").output().expect("the program runs");
            assert_failed(&output);
            String::from_utf8(output.stderr).expect("the message is text")
        });
        assert_eq!(first, second);
        first
    }

    /// Checks that both programs refuse the files with `Error: ` and `message`, and do not change the output: no file
    /// is created, and an old file keeps its content.
    pub fn refuses(&self, message: &[u8]) {
        let stderr = [b"Error: ", message, b"\n"].concat();
        for program in PROGRAMS {
            for old in [None, Some("old")] {
                old.into_iter().for_each(|old| drop(self.write("out.ppm", old)));
                let output = self.command(program, "out.ppm").output().expect("the program runs");
                assert_failed(&output);
                let [actual, expected] = [&output.stderr, &stderr].map(|bytes| bytes.escape_ascii().to_string());
                assert_eq!(actual, expected, "{program}");
                assert_eq!(fs::read(self.file("out.ppm")).ok(), old.map(Vec::from));
                assert_eq!(self.outputs().len(), usize::from(old.is_some()));
            }
            fs::remove_file(self.file("out.ppm")).expect("it is ours");
        }
    }
}

/// Checks that a program succeeded and wrote nothing to standard output and standard error.
#[track_caller]
pub fn assert_succeeded(output: &Output) {
    assert!(output.status.success() && output.stdout.is_empty() && output.stderr.is_empty(), "{output:?}");
}

/// Checks that a program failed in the specified way: with status 1, a message on standard error, and nothing on
/// standard output.
#[track_caller]
pub fn assert_failed(output: &Output) {
    assert_eq!(output.status.code(), Some(1), "{output:?}");
    assert!(output.stdout.is_empty() && output.stderr.starts_with(b"Error: "), "{output:?}");
    assert!(output.stderr.ends_with(b"\n"), "{output:?}");
}
