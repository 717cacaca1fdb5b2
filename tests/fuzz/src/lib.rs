//! The bodies of the fuzz targets, with their oracles.
//!
//! Each function of [`TARGETS`] takes any bytes, and panics if the code under test breaks a promise. The folder
//! `targets` hands the functions to libFuzzer. `tests/smoke.rs` calls them on any toolchain, with the committed seeds
//! and thousands of seeded [mutations](mutate) of the seeds.
//!
//! An oracle is never the code under test. The parsers are compared with [`plain`] ones, written from
//! docs/specification.md alone, and the fast renderer with `cpu::reference`. The reader of pictures is compared with a
//! plain reader, and must read back what the writers write.

pub mod config;
pub mod mutate;
pub mod picture;
pub mod plain;
pub mod render;
pub mod scene;
pub mod wgsl;

use std::fs;
use std::path::PathBuf;

/// A fuzz target: its name, and the function that checks an input.
pub type Target = (&'static str, fn(&[u8]));

/// All fuzz targets.
pub const TARGETS: [Target; 5] = [
    ("config", config::check),
    ("scene", scene::check),
    ("render", render::check),
    ("picture", picture::check),
    ("wgsl", wgsl::check),
];

/// Reads the inputs of a target from the folder `seeds` or `regressions`, sorted by name.
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

/// Reads the tokens of a target's dictionary. Its format is libFuzzer's: one quoted text a line, with `\xNN` for a
/// byte.
///
/// # Panics
/// If the dictionary does not exist, or a line of it is wrong.
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
