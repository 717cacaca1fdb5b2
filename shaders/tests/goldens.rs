//! Compares the translations of all kernels in f32, into five languages, with the files in `goldens/`.
//!
//! Any change of a module, of naga or of its options changes these files. If the change is intended, run the test with
//! `BLESS=1` and commit the files that it writes.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use rspirv::binary::Disassemble;
use shaders::module::MODULES;
use shaders::{Features, Library, Precision, Target, Translation, translate};

/// Returns the names of all kernel modules that are compared. Modules of reports are left out.
fn kernels() -> Vec<&'static str> {
    let names = MODULES.iter().map(|module| module.name);
    names.filter(|name| name.starts_with("kernels/") && !name.ends_with("_report")).collect()
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("goldens")
}

fn text(library: &Library, kernel: &str, target: Target) -> String {
    let composition = library.compose(kernel, Precision::F32).expect("it exists");
    let shader = composition.validate().expect("it is valid");
    match translate(&shader, target, &Features::all(5)).unwrap_or_else(|error| panic!("{kernel}: {error}")) {
        Translation::Text(text) => text,
        // SPIR-V is stored as assembly text, so that a difference can be read.
        Translation::Words(words) => rspirv::dr::load_words(words).expect("naga writes valid words").disassemble(),
    }
}

/// Returns a description of the first line in which two texts differ.
fn first_difference(expected: &str, actual: &str) -> String {
    let (mut old, mut new) = (expected.lines(), actual.lines());
    for line in 1.. {
        match (old.next(), new.next()) {
            (None, None) => break,
            (old, new) if old == new => {}
            (old, new) => return format!("line {line}:\n  golden: {}\n  now:    {}", show(old), show(new)),
        }
    }
    "only line ends differ".to_owned()
}

fn show(line: Option<&str>) -> &str {
    line.unwrap_or("(the text ends here)")
}

#[test]
fn translations_are_the_goldens() {
    let bless = std::env::var_os("BLESS").is_some_and(|value| value == "1");
    let mut expected_files = BTreeSet::new();
    let mut faults = Vec::new();
    for kernel in kernels() {
        for target in Target::ALL {
            let name = format!("{}.{}", kernel.trim_start_matches("kernels/"), target.extension());
            let path = folder().join(&name);
            let actual = text(&Library::standard(), kernel, target);
            assert!(actual.lines().count() > 20, "{name} is all but empty:\n{actual}");
            if bless {
                fs::write(&path, &actual).expect("goldens/ is writable");
            }
            match fs::read_to_string(&path) {
                Ok(golden) if golden == actual => {}
                Ok(golden) => faults.push(format!("{name}, {}", first_difference(&golden, &actual))),
                Err(error) => faults.push(format!("{name}: {error}")),
            }
            expected_files.insert(name);
        }
    }
    assert!(faults.is_empty(), "{}\nWhen this is meant: BLESS=1 cargo test -p shaders", faults.join("\n"));
    println!("{} translations compared", expected_files.len());
    let found: BTreeSet<_> = fs::read_dir(folder())
        .expect("goldens/ is there")
        .map(|entry| entry.expect("goldens/ is readable").file_name().into_string().expect("names are ASCII"))
        .collect();
    assert_eq!(found, expected_files, "goldens/ holds exactly the translations");
    assert!(expected_files.len() >= 55);
}

#[test]
fn a_changed_formula_changes_every_translation() {
    let mut library = Library::standard();
    let source = library.source("sphere").expect("it exists");
    assert_eq!(source.matches("h * h - a * view.c").count(), 1);
    let changed = source.replace("h * h - a * view.c", "h * h + a * view.c");
    library.replace("sphere", "changed.wgsl", changed).expect("it exists");
    for target in Target::ALL {
        assert!(text(&library, "kernels/sphere", target) != text(&Library::standard(), "kernels/sphere", target));
    }
}
