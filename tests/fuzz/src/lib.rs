//! The functions of the fuzz targets, with their oracles.
//!
//! Each function of [`TARGETS`] takes any bytes, and panics if the code under test breaks a promise. The programs in
//! the folder `targets` pass the functions to libFuzzer. `tests/smoke.rs` calls them with any toolchain. It uses the
//! committed seeds, and thousands of seeded [mutations](mutate) of the seeds.
//!
//! An oracle is never the code under test. The parsers are compared with the [`plain`] parsers, which are written from
//! docs/specification.md alone. The fast renderer is compared with `cpu::reference`. The reader of pictures is compared
//! with a plain reader, and must read what the writers have written.

pub mod config;
pub mod mutate;
pub mod picture;
pub mod plain;
pub mod render;
pub mod scene;
pub mod wgsl;

use std::fs;
use std::path::PathBuf;

/// A fuzz target: its name, and the function that checks an input and panics if it finds an error.
pub type Target = (&'static str, fn(&[u8]));

/// All fuzz targets, with their names.
pub const TARGETS: [Target; 5] = [
    ("config", config::check),
    ("scene", scene::check),
    ("render", render::check),
    ("picture", picture::check),
    ("wgsl", wgsl::check),
];

/// Returns the inputs of a target in the folder `seeds` or `regressions`: path and content, sorted by path.
///
/// # Panics
/// If the folder, or a file in it, cannot be read.
#[must_use]
pub fn inputs(folder: &str, target: &str) -> Vec<(PathBuf, Vec<u8>)> {
    let folder = fuzz_folder().join(folder).join(target);
    let Ok(entries) = fs::read_dir(&folder) else { panic!("{} cannot be read", folder.display()) };
    let mut paths: Vec<_> = entries.map(|entry| entry.expect("the folder is readable").path()).collect();
    paths.sort();
    paths.into_iter().map(|path| (path.clone(), fs::read(path).expect("it is readable"))).collect()
}

/// Returns the tokens of a target's dictionary. The dictionary has libFuzzer's format: one quoted text on each line, in
/// which `\xNN` stands for a byte.
///
/// # Panics
/// If the dictionary does not exist, or a line in it is wrong.
#[must_use]
pub fn dictionary(target: &str) -> Vec<Vec<u8>> {
    let path = fuzz_folder().join("dictionaries").join(format!("{target}.dict"));
    let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let lines = text.lines().filter(|line| !line.trim().is_empty() && !line.starts_with('#'));
    lines.map(|line| unquote(line).unwrap_or_else(|| panic!("{}: {line}", path.display()))).collect()
}

fn fuzz_folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

fn unquote(line: &str) -> Option<Vec<u8>> {
    let mut rest = line.trim().strip_prefix('"')?.strip_suffix('"')?.as_bytes();
    let mut token = Vec::new();
    while let Some((&byte, after)) = rest.split_first() {
        rest = after;
        if byte != b'\\' {
            token.push(byte);
            continue;
        }
        match rest {
            [b'x', digits @ ..] if digits.len() >= 2 => {
                let digits = std::str::from_utf8(&rest[1..3]).ok()?;
                token.push(u8::from_str_radix(digits, 16).ok()?);
                rest = &rest[3..];
            }
            [escaped @ (b'\\' | b'"'), after @ ..] => {
                token.push(*escaped);
                rest = after;
            }
            _ => return None,
        }
    }
    Some(token)
}

#[cfg(test)]
mod unit {
    use super::*;

    #[test]
    fn tokens_of_dictionaries_are_unquoted() {
        assert_eq!(unquote(r#""a\x0d\"\\ b""#), Some(b"a\r\"\\ b".to_vec()));
        for line in ["a", "\"", r#""\n""#, r#""\x1""#, r#""\xg0""#] {
            assert_eq!(unquote(line), None, "{line}");
        }
    }

    #[test]
    fn every_target_has_seeds_and_a_dictionary() {
        for (name, _) in TARGETS {
            assert!(inputs("seeds", name).len() >= 3, "{name}");
            assert!(dictionary(name).len() >= 10, "{name}");
        }
    }
}
