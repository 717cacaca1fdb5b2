//! Reads the configuration and the scene, and applies the settings of `--set`.

use std::collections::HashSet;
use std::fs;
use std::io::{self, BufReader};
use std::os::unix::fs::{FileTypeExt, MetadataExt};
use std::path::{Path, PathBuf};

use cpu::internals::input::error::Picture;
use cpu::internals::input::reader::LimitedFile;
use cpu::internals::input::text::MAX_FILE_BYTES;
use cpu::{Config, Error, Scene};
use output::{Options, Output};

use crate::format::hint::{Hint, Kind, Language};
use crate::format::located;
use crate::format::recorder::Recorder;
use crate::{Failure, terminal};

/// Returns the configuration in the file `path`, changed by `settings`. Each setting is `key=value`, such as `gamma=1`
/// or `camera_position=0 0 -5`. It counts as one more line of the file, and the last line with a key is used.
///
/// # Errors
/// The error of [`Config::parse`], with its place in the file, or with the option whose setting is wrong.
pub fn config(path: &Path, settings: &[String]) -> Result<Config, Failure> {
    // The file is read first, so that its errors are reported before those of a setting.
    let mut config = read(path, Kind::Config, |input| Config::parse(input))?;
    for setting in settings {
        let (key, value) = setting.split_once('=').unwrap_or((setting, ""));
        if value.trim().is_empty() {
            let needed = match setting.split_once(':') {
                // A line of the file was given, as in `image_width: 10`.
                Some((key, value)) if !setting.contains('=') && !value.trim().is_empty() => {
                    format!("KEY=VALUE is needed, as in {}", option(key.trim(), value.trim()))
                }
                _ => format!("a value is missing, as in --set {key}={}", example(key)),
            };
            return Err(format!("--set {setting}: {needed}").into());
        }
        // Line ends become spaces, because they would begin another line.
        let line = format!("{}: {value}", bare(key)).replace(['\n', '\r'], " ");
        if let Err(error) = config.set(line.as_bytes()) {
            let hint = Hint::new(&error, Kind::Config, line.as_bytes(), &[], Language::English);
            let words = hint.map_or_else(|| error.to_string(), |hint| hint.to_string());
            // The corrected line becomes an option. Other remedies name the format of the line.
            let corrected = words.rsplit_once(&format!(": {}: ", bare(key)));
            let corrected = corrected.filter(|(remedy, _)| !remedy.ends_with("the line is"));
            let words = match corrected {
                Some((remedy, values)) => format!("{remedy}: {}", option(bare(key), values)),
                None => words,
            };
            return Err(format!("--set {setting}: {words}").into());
        }
    }
    Ok(config)
}

/// Returns the scene in the file `path`.
///
/// # Errors
/// The error of [`Scene::parse`], with its place in the file.
pub fn scene(path: &Path) -> Result<Scene, Failure> {
    read(path, Kind::Scene, |input| Scene::parse(input))
}

/// Returns the path to read from: `/dev/stdin` if `path` is `-`, and otherwise `path`.
pub fn input(path: &Path) -> PathBuf {
    if path == Path::new("-") { PathBuf::from("/dev/stdin") } else { path.to_owned() }
}

/// Returns the path to write to: `/dev/stdout` if `path` is `-`, and otherwise `path`.
fn output(path: &Path) -> PathBuf {
    if path == Path::new("-") { PathBuf::from("/dev/stdout") } else { path.to_owned() }
}

/// Opens an output. `-` is standard output.
///
/// # Errors
/// The errors of [`Output::open`].
pub fn open(path: &Path, options: Options) -> Result<Output, output::Error> {
    Output::open(&output(path), options)
}

/// Whether the output `path` is standard output.
pub fn is_stdout(path: &Path) -> bool {
    output::is_stdout(&output(path))
}

/// Refuses standard output for `what`, which needs a file or a folder.
///
/// # Errors
/// A message with the remedy.
pub fn refuse_stdout(what: &str, path: &Path) -> Result<(), Failure> {
    if is_stdout(path) { Err(format!("{what} has no standard output (-); name it").into()) } else { Ok(()) }
}

/// Refuses outputs of which two are one file, or one is a file of `inputs`. If `json` is true, JSON is written to
/// standard output, so no output may be standard output. Call this before the inputs are read.
///
/// # Errors
/// A message that names the outputs.
pub fn check_outputs(outs: &[&Path], inputs: &[&Path], json: bool) -> Result<(), Failure> {
    if json && outs.iter().any(|out| is_stdout(out)) {
        return Err("--json and an output - both write to standard output; choose a file".into());
    }
    let outs: Vec<_> = outs.iter().map(|out| output(out)).collect();
    refuse_one_file(&outs)?;
    Ok(outs.iter().try_for_each(|out| output::refuse_inputs(out, inputs))?)
}

/// Refuses outputs of which two are one file, even if their paths differ. `/dev/null` may be several outputs.
///
/// # Errors
/// A message that names both outputs.
fn refuse_one_file(outs: &[PathBuf]) -> Result<(), output::Error> {
    let targets: Vec<_> = outs.iter().map(|out| target(out)).collect();
    for (index, out) in outs.iter().enumerate().filter(|(index, _)| targets[*index] != Path::new("/dev/null")) {
        if let Some(other) = targets[..index].iter().position(|other| *other == targets[index]) {
            return Err(output::Error::same_file(out, "output", &outs[other], "the outputs need a file each"));
        }
    }
    Ok(())
}

/// Returns the path that an output to `path` gets, without links: `/dev/stdout` for all names of standard output. The
/// file need not exist.
fn target(path: &Path) -> PathBuf {
    if output::is_stdout(path) {
        return PathBuf::from("/dev/stdout");
    }
    let path = output::follow(path).unwrap_or_else(|_| path.to_owned());
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    match (fs::canonicalize(folder), path.file_name()) {
        (Ok(folder), Some(name)) => folder.join(name),
        _ => path,
    }
}

/// Returns the numbers of the device and of the file, if the input is a pipe or standard input. Such an input gives its
/// content only once. Returns `None` for every other input.
pub fn read_once(path: &Path) -> Option<(u64, u64)> {
    const STDIN: [&str; 3] = ["/dev/stdin", "/dev/fd/0", "/proc/self/fd/0"];
    let path = input(path);
    let metadata = fs::metadata(&path).ok()?;
    let is_once = STDIN.map(Path::new).contains(&&*path) || metadata.file_type().is_fifo();
    is_once.then(|| (metadata.dev(), metadata.ino()))
}

/// Refuses a pipe or standard input as more than one of the files `paths`.
///
/// # Errors
/// A message that names the file.
pub fn refuse_inputs_in_one(paths: &[&Path]) -> Result<(), Failure> {
    let mut known = HashSet::new();
    let is_again = |path: &&&Path| read_once(path).is_some_and(|once| !known.insert(once));
    paths.iter().find(is_again).map_or(Ok(()), |path| {
        Err(format!("{}: a pipe or standard input (-) can be only one of the files", terminal::name(path)).into())
    })
}

/// Returns `path` if it leads to a regular file. A file that the user has not named may be a pipe that never gives
/// anything.
///
/// # Errors
/// The error of the system, or that it is no regular file.
pub fn regular(path: &Path) -> io::Result<&Path> {
    if fs::metadata(path)?.is_file() { Ok(path) } else { Err(io::Error::other("it is not a regular file")) }
}

/// Makes the folder `path` and those above it, if they are not there.
///
/// # Errors
/// A message with the name of the folder.
pub fn make_folder(path: &Path) -> Result<(), Failure> {
    refuse_stdout("a folder", path)?;
    fs::create_dir_all(path).map_err(|error| {
        let is_file = error.kind() == io::ErrorKind::AlreadyExists;
        let cause = if is_file { "it is a file, and a folder is needed".to_owned() } else { error.to_string() };
        format!("{}: {cause}", terminal::name(path)).into()
    })
}

/// Returns the name of an output for messages: "standard output" if `path` is `-`.
pub fn output_name(path: &Path) -> String {
    if path == Path::new("-") { "standard output".to_owned() } else { terminal::name(path) }
}

/// Returns the failure for an error in the values of the picture. The message names the `--set` options that may have
/// caused the error, or the file `path` if no option may have caused it.
pub fn about_picture(error: Error, path: &Path, settings: &[String]) -> Failure {
    let Error::Picture(cause) = error else { return error.in_file(path).into() };
    let keys: &[&str] = match cause {
        Picture::TooLarge { .. } => &["image_width", "aspect_ratio"],
        Picture::CameraAtTarget => &["camera_position", "camera_target"],
        Picture::NorthParallel => &["camera_position", "camera_target", "camera_north"],
        _ => &["camera_position", "camera_target", "camera_north", "field_of_view", "image_width", "aspect_ratio"],
    };
    let is_involved = |setting: &&String| setting.split_once('=').is_some_and(|(key, _)| keys.contains(&bare(key)));
    let involved: Vec<_> = settings.iter().filter(is_involved).map(|setting| format!("--set {setting}")).collect();
    if involved.is_empty() {
        Error::Picture(cause).in_file(path).into()
    } else {
        format!("{}: {cause}", involved.join(" ")).into()
    }
}

/// Reads a file with the function `parse`. The message about wrong lines is that of [`located::read`].
fn read<T>(
    path: &Path,
    kind: Kind,
    parse: impl FnOnce(&mut Recorder<BufReader<LimitedFile>>) -> Result<T, Error>,
) -> Result<T, Failure> {
    let path = input(path);
    let file = LimitedFile::open(&path, MAX_FILE_BYTES).map_err(|error| Error::from(error).in_file(&path))?;
    let input = BufReader::with_capacity(1 << 16, file);
    located::read(input, kind, &path, parse)
        .map_err(|(error, lines)| lines.map_or_else(|| error.in_file(&path).into(), Failure::from))
}

fn bare(key: &str) -> &str {
    key.trim().trim_end_matches(':')
}

/// Returns the option that sets `key`, as a shell needs it.
fn option(key: &str, value: &str) -> String {
    let quote = if value.contains(' ') { "\"" } else { "" };
    format!("--set {quote}{key}={value}{quote}")
}

/// Returns an example of a valid value of `key`: its default.
fn example(key: &str) -> &'static str {
    format::CONFIG
        .iter()
        .find(|line| line.tag.strip_suffix(':') == Some(bare(key)))
        .map_or("VALUE", |line| line.default)
}

#[cfg(test)]
mod tests {
    use test_support::folder::Folder;

    use super::*;

    #[test]
    fn settings_replace_what_the_file_says() {
        let folder = Folder::new();
        // The file has no line end. If settings were appended to its text, the first setting would join the last line.
        let path = folder.write("config.txt", "image_width: 8\ngamma: 2");
        let settings = ["gamma=1", "camera_north=1 0 0", "camera_position: = 0 0 -5"].map(str::to_owned);
        let config = config(&path, &settings).expect("all is valid");
        assert_eq!((config.image_width, config.gamma, config.camera_north.x), (8, 1.0, 1.0));
        assert_eq!(config.camera_position.z, -5.0);
        let complaint = |setting: &str| match super::config(&path, &[setting.to_owned()]) {
            Err(Failure::Other(message)) => message,
            other => panic!("{setting}: {other:?}"),
        };
        for (setting, end) in [
            ("gamma=nan", "--set gamma=nan: gamma: [nan] is not a number above 0; the line is: gamma: number > 0"),
            ("gama=3", "--set gama=3: there is no configuration key [gama:]; did you mean [gamma:]?"),
            ("samples_per_pixel", "samples_per_pixel: a value is missing, as in --set samples_per_pixel=20"),
            ("image_width: 10", "--set image_width: 10: KEY=VALUE is needed, as in --set image_width=10"),
            ("camera_north: 1 0 0", "as in --set \"camera_north=1 0 0\""),
            ("gamma=2,2", "write a decimal point, not a comma: --set gamma=2.2"),
            ("camera_north=0,1,0", "by blanks alone: --set \"camera_north=0 1 0\""),
            ("gamma=", "a value is missing, as in --set gamma=2.2"),
        ] {
            assert!(complaint(setting).ends_with(end), "{setting}: {}", complaint(setting));
        }
        assert!(complaint("gamma=1\nimage_width: 3").contains("gamma"), "a line end is a blank");
    }

    fn about(file: &str, kind: Kind) -> String {
        let folder = Folder::new();
        let path = folder.write("file", file);
        let result = match kind {
            Kind::Config => config(&path, &[]).map(drop),
            Kind::Scene => scene(&path).map(drop),
        };
        match result {
            Err(Failure::Other(message)) => message.replace(&format!("{}:", path.display()), "F:"),
            other => panic!("{file}: {other:?}"),
        }
    }

    #[test]
    fn a_wrong_line_is_shown_with_its_place_a_caret_and_a_remedy() {
        // A text, the start of the message, and a part of its last line.
        let cases: Vec<[String; 3]> = serde_json::from_str(include_str!("sources/cases.json")).expect("it is JSON");
        for [text, start, end] in &cases {
            let is_scene = text.starts_with("matte") || text.starts_with("sphere");
            let message = about(text, if is_scene { Kind::Scene } else { Kind::Config });
            let last = message.lines().next_back().unwrap_or_default();
            assert!(message.starts_with(start) && last.contains(end), "{text}: {message}");
        }
        let swapped = about("sphere: 0 0 0 1 m", Kind::Config);
        assert!(swapped.ends_with("a line of the other file; the order is: CONFIG SCENE"), "{swapped}");
        let many = about(&"sphere: 0 0 0 1 m\n".repeat(30), Kind::Config);
        assert_eq!(many.matches("the order is").count(), 1, "{many}");
    }

    #[test]
    fn all_wrong_lines_are_shown_and_long_lines_are_cut() {
        let scene = |text: &str| about(&format!("matte: grey 1 1 1\n{text}\n"), Kind::Scene);
        // An object whose material is wrongly defined, or missing again, is no more error.
        let lines =
            ["metal: a 1 1 1", "metl: b 1 1 1 0", "sphere: 0 0 0 1 a", "sphere: 0 0 0 1 b", "sphere: 0 0 0 1 zzz"];
        let all = scene(&format!("{}\nsphere: 0 0 0 2 zzz\n\nsphere: x\n", lines.join("\n")));
        let places: Vec<_> = all.split("\n\n").map(|one| one.split(": ").next().unwrap_or_default()).collect();
        assert_eq!(places, ["F:2:15", "F:3:1", "F:6:17", "F:9:9"], "{all}");
        let many = about(&"gama: 1\n".repeat(22), Kind::Config);
        assert!(
            many.contains("\n\nF:20:1: ")
                && many.ends_with("\n\nthese are the first 20 errors of the file, and there are more")
        );
        assert!(about(&"gama: 1\n".repeat(20), Kind::Config).ends_with("did you mean [gamma:]?"));
        // A long line is cut, and control characters are not printed.
        let long = scene(&format!("sphere: 0{}\u{1b}x", " ".repeat(500)));
        assert!(long.lines().all(|line| line.chars().count() < 200) && !long.contains('\u{1b}'), "{long}");
    }
}
