//! The two files of a rendering, with values of the configuration replaced on the command line.

use std::path::Path;

use cpu::{Config, Error, Scene};

/// Reads the configuration at `path` and then `settings`, each `key=value` as in `gamma=1` or
/// `camera_position=0 0 -5`. The last of a repeated key counts, so a setting is one more line.
///
/// # Errors
/// What [`Config::parse`] says about the file or a setting.
pub fn config(path: &Path, settings: &[String]) -> Result<Config, Error> {
    // The file alone first, so that its own errors are told before those of a setting.
    let mut config = Config::read(path)?;
    for setting in settings {
        config.set(line(setting).as_bytes())?;
    }
    Ok(config)
}

/// The scene at `path`.
///
/// # Errors
/// What [`Scene::read`] says about it.
pub fn scene(path: &Path) -> Result<Scene, Error> {
    Scene::read(path)
}

/// A setting as a line of a configuration file. One line: a line end inside it would smuggle in another.
fn line(setting: &str) -> String {
    let setting = setting.replace(['\n', '\r'], " ");
    match setting.split_once('=') {
        Some((key, value)) => format!("{}: {value}", key.trim().trim_end_matches(':')),
        None => setting,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    #[test]
    fn settings_become_lines() {
        assert_eq!(line("gamma=1"), "gamma: 1");
        assert_eq!(line("camera_position: = 0 0 -5"), "camera_position:  0 0 -5");
        assert_eq!(line("gamma"), "gamma");
        assert_eq!(line("gamma=1\nimage_width: 3"), "gamma: 1 image_width: 3");
    }

    #[test]
    fn settings_replace_what_the_file_says() {
        let folder = tempfile::tempdir().expect("the temporary folder is writable");
        let path = folder.path().join("config.txt");
        // Without a line end, where an appended line could run into the last.
        fs::write(&path, "image_width: 8\ngamma: 2").expect("the folder is writable");
        let settings = ["gamma=1".to_owned(), "camera_north=1 0 0".to_owned()];
        let config = config(&path, &settings).expect("all is valid");
        assert_eq!((config.image_width, config.gamma, config.camera_north.x), (8, 1.0, 1.0));
        let error = super::config(&path, &["gamma=nan".to_owned()]).expect_err("it is not a number");
        assert!(error.to_string().starts_with("Invalid value for key: [gamma:]"), "{error}");
        let error = super::config(&path, &["width=3".to_owned()]).expect_err("there is no such key");
        assert_eq!(error.to_string(), "Unknown configuration key: [width:]");
    }
}
