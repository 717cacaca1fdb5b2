//! Reads the files on which a rendering depends. For each rendering, every file is opened and read once.
//!
//! With `--watch`, every file is read again to find out whether it has changed. A pipe or a device is not read again;
//! its first content is kept.

use std::path::Path;

use cpu::{Config, Scene};
use format::hint::Kind;
use format::located;

use super::args::Options;
use super::files::{self, UserModule};
use crate::Error;

/// Largest size of a configuration or a scene that is read, in bytes.
pub const MAX_BYTES: u64 = 1 << 24;

/// The contents of all files on which a rendering depends.
#[derive(Clone, Debug, PartialEq)]
pub struct Sources {
    /// The user's modules, or the reason why they cannot be read.
    pub modules: Result<Vec<UserModule>, String>,
    /// The contents of the configuration (first) and of the scene (second).
    pub texts: [Text; 2],
}

/// The bytes of a file, or the reason why it cannot be read.
pub type Text = Result<Vec<u8>, String>;

impl Sources {
    /// Reads all files. If `before` is given, the contents of pipes and devices are taken from it.
    #[must_use]
    pub fn read(options: &Options, before: Option<&Self>) -> Self {
        let modules = match before {
            Some(before) if gives_once(&options.modules) => before.modules.clone(),
            _ => files::read(&options.modules).map_err(|error| error.to_string()),
        };
        let paths = [&options.config, &options.scene];
        let texts = [0, 1].map(|index| match before {
            Some(before) if gives_once(paths[index]) => before.texts[index].clone(),
            _ => text(paths[index]),
        });
        Self { modules, texts }
    }

    /// Returns the parsed configuration and scene.
    ///
    /// # Errors
    /// The reason why a file cannot be read, or the error in its text.
    pub fn parse(&self, options: &Options) -> Result<(Config, Scene), Error> {
        parse([&options.config, &options.scene], &self.texts)
    }
}

/// Parses a configuration and a scene. The paths are for messages.
fn parse(paths: [&Path; 2], texts: &[Text; 2]) -> Result<(Config, Scene), Error> {
    let [config, scene] =
        texts.each_ref().map(|text| text.as_deref().map_err(|message| Error::Request { message: message.clone() }));
    let (config, scene) = (config?, scene?);
    let checked = |parsed: Config| parsed.check_picture().map(|()| parsed);
    let config = located::read(config, Kind::Config, paths[0], |text| Config::parse(text).and_then(checked));
    let scene = located::read(scene, Kind::Scene, paths[1], |text| Scene::parse(text));
    Ok((config.map_err(|error| explain(paths[0], error))?, scene.map_err(|error| explain(paths[1], error))?))
}

/// Returns the error of a file: the message about its wrong lines, if the error belongs to a line.
fn explain(path: &Path, (error, lines): (cpu::Error, Option<String>)) -> Error {
    lines.map_or_else(|| error.in_file(path).into(), |message| Error::Request { message })
}

/// Whether `path` is neither a file nor a folder. Then it is a pipe, a terminal or another device, which is read only
/// once.
fn gives_once(path: &Path) -> bool {
    path.metadata().is_ok_and(|metadata| !metadata.is_file() && !metadata.is_dir())
}

fn text(path: &Path) -> Text {
    cpu::internals::input::reader::read(path, MAX_BYTES).map_err(|cause| {
        let error = cpu::internals::input::error::Error::Read { path: path.to_owned(), cause };
        String::from_utf8_lossy(&error.message_for_terminal()).into_owned()
    })
}

#[cfg(test)]
mod tests {
    use std::fs;
    use test_support::folder::Folder;

    use super::super::args::Arguments;
    use super::*;

    #[test]
    fn files_of_exactly_the_limit_are_read_and_one_byte_more_refused() {
        let folder = Folder::new();
        let path = folder.file("config");
        for (bytes, is_read) in [(MAX_BYTES, true), (MAX_BYTES + 1, false)] {
            fs::File::create(&path).and_then(|file| file.set_len(bytes)).expect("the folder is writable");
            assert_eq!(text(&path).is_ok(), is_read, "{bytes}");
        }
    }

    #[test]
    fn a_wrong_text_is_named_with_its_file() {
        let parsed = |config: &[u8], scene: &[u8]| {
            let texts = [config, scene].map(|text| Ok(text.to_vec()));
            parse(["c", "s"].map(Path::new), &texts).expect_err("one is wrong").to_string()
        };
        let comma = parsed(b"\ngamma: 2,2\ngama: 1\n", b"");
        assert!(comma.starts_with("c:2:8: ") && comma.contains("\n2 | gamma: 2,2\n           ^^^\n"), "{comma}");
        assert!(comma.contains("write a decimal point") && comma.contains("\n\nc:3:1: "), "{comma}");
        assert!(parsed(b"camera_position: 0 0 0", b"").starts_with("Invalid configuration [c]: camera_position"));
        assert!(parsed(b"", b"sphere: 0").starts_with("s:1:10: "), "{}", parsed(b"", b"sphere: 0"));
    }

    #[cfg(unix)]
    #[test]
    fn endless_devices_are_refused_and_not_read_again() {
        let line =
            "shader-lab m.wgsl --config /dev/zero --scene s --out o.png".split(' ').map(std::ffi::OsString::from);
        let options = Arguments::read(line).expect("it is a command line").options.expect("it has options");
        let first = Sources::read(&options, None);
        let message = first.parse(&options).expect_err("it has no end").to_string();
        assert_eq!(message, "Cannot read file [/dev/zero]: it is larger than 16777216 bytes");
        assert_eq!(Sources::read(&options, Some(&first)), first);
    }
}
