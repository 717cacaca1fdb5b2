//! A folder with the three files of a call, and what every call must keep to.

use std::fs;
use std::path::PathBuf;
use std::process::{Command, Output};

/// The two programs.
pub const PROGRAMS: [&str; 2] = [env!("CARGO_BIN_EXE_render-aos"), env!("CARGO_BIN_EXE_render-soa")];

/// A configuration that is rendered in no time.
pub const SMALL: &str = "image_width: 8\naspect_ratio: 2 1\nsamples_per_pixel: 2\n";

/// `config.txt`, `scene.txt` and `out.ppm` in a folder of their own, removed at the end.
pub struct Bench(tempfile::TempDir);

impl Bench {
    /// Files with this content.
    pub fn new(config: impl AsRef<[u8]>, scene: impl AsRef<[u8]>) -> Self {
        let bench = Self(tempfile::tempdir().expect("the temporary folder is writable"));
        fs::write(bench.path("config.txt"), config).expect("the folder is writable");
        fs::write(bench.path("scene.txt"), scene).expect("the folder is writable");
        bench
    }

    /// The name of a file in the folder.
    pub fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    /// The names of all files in the folder but the input files.
    pub fn outputs(&self) -> Vec<String> {
        let entries = fs::read_dir(self.0.path()).expect("the folder is readable");
        let mut names: Vec<_> =
            entries.map(|entry| entry.expect("it is readable").file_name().to_string_lossy().into_owned()).collect();
        names.retain(|name| name != "config.txt" && name != "scene.txt");
        names.sort();
        names
    }

    /// `program config.txt scene.txt OUT`, run in the folder, so that messages show short names.
    pub fn command(&self, program: &str, out: &str) -> Command {
        let mut command = Command::new(program);
        command.current_dir(self.0.path()).args(["config.txt", "scene.txt", out]);
        command
    }

    /// The picture that both programs make of the files, which must be the same.
    pub fn render(&self) -> Vec<u8> {
        let [first, second] = PROGRAMS.map(|program| {
            let output = self.command(program, "out.ppm").output().expect("the program runs");
            assert_succeeded(&output);
            assert_eq!(self.outputs(), ["out.ppm"]);
            let picture = fs::read(self.path("out.ppm")).expect("it was written");
            fs::remove_file(self.path("out.ppm")).expect("it is ours");
            picture
        });
        assert!(first == second, "the two programs make different pictures");
        first
    }

    /// What both programs say on standard error when they refuse the files, which must be the same.
    pub fn message(&self) -> String {
        let [first, second] = PROGRAMS.map(|program| {
            let output = self.command(program, "out.ppm").output().expect("the program runs");
            assert_failed(&output);
            String::from_utf8(output.stderr).expect("the message is text")
        });
        assert_eq!(first, second);
        first
    }

    /// Checks that both programs refuse the files with `Error: ` and this message, and that the output stays as it
    /// was: absent where it was absent, old where it was old.
    pub fn refuses(&self, message: &[u8]) {
        let stderr = [b"Error: ", message, b"\n"].concat();
        for program in PROGRAMS {
            for old in [None, Some("old")] {
                if let Some(content) = old {
                    fs::write(self.path("out.ppm"), content).expect("the folder is writable");
                }
                let output = self.command(program, "out.ppm").output().expect("the program runs");
                assert_failed(&output);
                assert_eq!(
                    String::from_utf8_lossy(&output.stderr),
                    String::from_utf8_lossy(&stderr),
                    "{program}, and byte for byte"
                );
                assert_eq!(output.stderr, stderr);
                assert_eq!(self.outputs().len(), usize::from(old.is_some()));
                if let Some(content) = old {
                    assert_eq!(fs::read(self.path("out.ppm")).expect("it is still there"), content.as_bytes());
                    fs::remove_file(self.path("out.ppm")).expect("it is ours");
                }
            }
        }
    }
}

/// Checks that a program ended well and said nothing.
#[track_caller]
pub fn assert_succeeded(output: &Output) {
    assert!(output.status.success() && output.stdout.is_empty() && output.stderr.is_empty(), "{output:?}");
}

/// Checks that a program failed as all failures should: status 1, an error on standard error, nothing elsewhere.
#[track_caller]
pub fn assert_failed(output: &Output) {
    assert_eq!(output.status.code(), Some(1), "{output:?}");
    assert!(output.stdout.is_empty() && output.stderr.starts_with(b"Error: "), "{output:?}");
    assert!(output.stderr.ends_with(b"\n"), "{output:?}");
}
