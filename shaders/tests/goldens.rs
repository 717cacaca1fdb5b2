//! Compares the translations of all kernels with the digests in `goldens/SHA256SUMS`, and those of one kernel with
//! whole texts, which show a reader what a translation looks like.
//!
//! Any change of a module, of naga or of its options changes the digests. If the change is intended, run the test with
//! `BLESS=1` and commit the files that it writes. With `TRANSLATIONS=FOLDER` the test also writes all translations into
//! that folder, to be compared with those of another commit.

use std::collections::BTreeMap;
use std::env::var_os;
use std::fs;
use std::path::{Path, PathBuf};

use format::digest::sha256;
use rspirv::binary::Disassemble;
use shaders::module::MODULES;
use shaders::{Error, Features, Library, Precision, Target, Translation, translate};

/// The kernel whose translations are committed as whole texts.
const SHOWN: &str = "camera";

/// The first lines of the list of digests.
const HEAD: &str = "# Digests of the translations of all kernels; TRANSLATIONS=FOLDER writes them.\n";

/// Returns the names of all kernel modules that are compared. Modules of reports are left out.
fn kernels() -> Vec<&'static str> {
    let names = MODULES.iter().map(|module| module.name);
    names.filter(|name| name.starts_with("kernels/") && !name.ends_with("_report")).collect()
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("goldens")
}

/// Returns the translation, or `None` if the target lacks the precision.
fn text(library: &Library, kernel: &str, precision: Precision, target: Target) -> Option<String> {
    let composition = library.compose(kernel, precision).expect("it exists");
    let shader = composition.validate().expect("it is valid");
    match translate(&shader, target, &Features::all(5)) {
        Ok(Translation::Text(text)) => Some(text),
        // SPIR-V is shown as assembly text, so that a difference can be read.
        Ok(Translation::Words(words)) => {
            Some(rspirv::dr::load_words(words).expect("naga writes valid words").disassemble())
        }
        Err(Error::Unsupported { .. }) => None,
        Err(error) => panic!("{kernel}: {error}"),
    }
}

/// Returns all translations by the names of their files.
fn translations(library: &Library) -> BTreeMap<String, String> {
    let mut texts = BTreeMap::new();
    for kernel in kernels() {
        for (precision, name) in [(Precision::F32, "f32"), (Precision::F64, "f64")] {
            for target in Target::ALL {
                if let Some(text) = text(library, kernel, precision, target) {
                    let kernel = kernel.trim_start_matches("kernels/");
                    texts.insert(format!("{kernel}.{name}.{}", target.extension()), text);
                }
            }
        }
    }
    texts
}

/// Returns the names of the files in `folder`, and their texts.
fn files(folder: &Path) -> BTreeMap<String, String> {
    let entries = fs::read_dir(folder).expect("the folder is there");
    let file = |path: PathBuf| {
        let name = path.file_name().and_then(|name| name.to_str()).expect("names are ASCII").to_owned();
        (name, fs::read_to_string(&path).expect("it is a text"))
    };
    entries.map(|entry| file(entry.expect("the folder is readable").path())).collect()
}

fn write(folder: &Path, files: &BTreeMap<String, String>) {
    fs::create_dir_all(folder).expect("the folder is writable");
    for (name, text) in files {
        fs::write(folder.join(name), text).expect("the folder is writable");
    }
}

#[test]
fn translations_are_those_of_the_digests() {
    let translations = translations(&Library::standard());
    if let Some(folder) = var_os("TRANSLATIONS") {
        write(Path::new(&folder), &translations);
    }
    for (name, text) in &translations {
        assert!(text.lines().count() > 20, "{name} is all but empty:\n{text}");
    }
    assert!(translations.len() >= 140, "{} translations", translations.len());
    let digest = |(name, text): (&String, &String)| format!("{}  {name}\n", sha256(text.as_bytes()));
    let list: String = translations.iter().map(digest).collect();
    let mut expected: BTreeMap<_, _> =
        translations.into_iter().filter(|(name, _)| name.split('.').next() == Some(SHOWN)).collect();
    assert_eq!(expected.len(), 7, "five languages in f32 and two in f64");
    expected.insert("SHA256SUMS".to_owned(), format!("{HEAD}{list}"));
    if var_os("BLESS").is_some_and(|value| value == "1") {
        fs::remove_dir_all(folder()).expect("goldens/ is there");
        write(&folder(), &expected);
    }
    let goldens = files(&folder());
    assert!(goldens.keys().eq(expected.keys()), "goldens/ has exactly the translations of {SHOWN}, and their digests");
    let changed = goldens.iter().filter(|(name, golden)| expected[*name] != **golden);
    let fault = |(name, golden): (&String, &String)| {
        let new: Vec<_> = expected[name].lines().filter(|line| !golden.contains(line)).take(3).collect();
        format!("{name} has other lines, such as\n  {}", new.join("\n  "))
    };
    let faults: Vec<_> = changed.map(fault).collect();
    assert!(
        faults.is_empty(),
        "{}\nWith TRANSLATIONS=FOLDER, here and at another commit, this test writes what differs. \
         If it is meant: BLESS=1 cargo test -p shaders --test goldens",
        faults.join("\n")
    );
}
