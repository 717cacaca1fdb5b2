//! The functions of the fuzz targets, with their oracles.
//!
//! Each function of [`TARGETS`] takes any bytes, and panics if the code under test breaks a promise. The program in the
//! folder `targets` passes the functions to libFuzzer. `tests/smoke.rs` calls them with any toolchain. It uses the
//! [`inputs`] of a target, and thousands of seeded [mutations](test_support::mutate) of them.
//!
//! An oracle is never the code under test. The parsers are compared with the [`plain`] parsers, which are written from
//! docs/specification.md alone. The fast renderer is compared with `cpu::reference`. The reader of pictures is compared
//! with a plain reader, and must read what the writers have written.

pub mod picture;
pub mod plain;
pub mod render;
pub mod texts;
pub mod wgsl;

use std::fs;
use std::path::{Path, PathBuf};

use cpu::internals::sampling::uniform::Uniform;

/// A fuzz target: its name, and the function that checks an input and panics if it finds an error.
pub type Target = (&'static str, fn(&[u8]));

/// All fuzz targets, with their names.
pub const TARGETS: [Target; 5] = [
    ("config", texts::config),
    ("scene", texts::scene),
    ("render", render::check),
    ("picture", picture::check),
    ("wgsl", wgsl::check),
];

/// The most bytes of an input of `tests/extensive fuzz`. Longer inputs find nothing more.
const LONGEST: usize = 8192;

/// Checks an input of the target `target`.
///
/// # Panics
/// If a check fails, or there is no such target.
pub fn check(target: &str, bytes: &[u8]) {
    let found = TARGETS.into_iter().find(|(name, _)| *name == target);
    found.unwrap_or_else(|| panic!("there is no target {target}")).1(bytes);
}

/// Returns the inputs that a target begins with: the empty input, its seeds, and the inputs that once failed.
///
/// The seeds of `config` and `scene` are the files of `tests/cases` and `scenes`, those of `render` are random bytes,
/// and the others are in the folder `seeds`.
///
/// # Panics
/// If a file cannot be read.
#[must_use]
pub fn inputs(target: &str) -> Vec<Vec<u8>> {
    let mut inputs = vec![Vec::new()];
    match target {
        "config" | "scene" => {
            let root = test_support::project_root();
            let folders = ["tests/cases", "scenes"].map(|folder| paths(&root.join(folder))).concat();
            let files = folders.iter().map(|folder| folder.join(format!("{target}.txt"))).filter(|file| file.exists());
            inputs.extend(files.map(|file| read(&file)).filter(|text| text.len() <= LONGEST));
        }
        "render" => {
            let mut random = Uniform::new(1);
            let lengths = [40, 60, 90, 130, 200, 260, 400];
            inputs.extend(
                lengths
                    .map(|length| (0..length).map(|_| test_support::mutate::below(&mut random, 256) as u8).collect()),
            );
        }
        _ => inputs.extend(paths(&fuzz_folder().join("seeds").join(target)).iter().map(|path| read(path))),
    }
    let failed = fuzz_folder().join("regressions").join(target);
    if failed.is_dir() {
        inputs.extend(paths(&failed).iter().map(|path| read(path)));
    }
    inputs
}

/// Returns the paths of what is in a folder, sorted.
fn paths(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let mut paths: Vec<_> = entries.map(|entry| entry.expect("the folder is readable").path()).collect();
    paths.sort();
    paths
}

fn read(path: &Path) -> Vec<u8> {
    fs::read(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Returns the tokens of a target's dictionary. The dictionary has libFuzzer's format: one quoted text on each line, in
/// which `\xNN` stands for a byte.
///
/// # Panics
/// If the dictionary does not exist, or a line in it is wrong.
#[must_use]
pub fn dictionary(target: &str) -> Vec<Vec<u8>> {
    let path = fuzz_folder().join("dictionaries").join(format!("{target}.dict"));
    let text = String::from_utf8(read(&path)).expect("a dictionary is text");
    let lines = text.lines().filter(|line| !line.trim().is_empty() && !line.starts_with('#'));
    lines.map(|line| unquote(line).unwrap_or_else(|| panic!("{}: {line}", path.display()))).collect()
}

fn fuzz_folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

fn unquote(line: &str) -> Option<Vec<u8>> {
    let mut parts = line.trim().strip_prefix('"')?.strip_suffix('"')?.split('\\');
    let mut token = parts.next()?.as_bytes().to_vec();
    for part in parts {
        let (digits, rest) = part.strip_prefix('x')?.split_at_checked(2)?;
        token.push(u8::from_str_radix(digits, 16).ok()?);
        token.extend(rest.as_bytes());
    }
    Some(token)
}

#[cfg(test)]
mod unit {
    use super::*;

    #[test]
    fn tokens_of_dictionaries_are_unquoted() {
        assert_eq!(unquote(r#""a\x0d\x5c b""#), Some(b"a\r\\ b".to_vec()));
        for line in ["a", "\"", r#""\n""#, r#""\x1""#, r#""\xg0""#] {
            assert_eq!(unquote(line), None, "{line}");
        }
    }
}
