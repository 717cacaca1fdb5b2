//! Holds `constants.txt` against the code: it has every numeric constant of the code that decides about hits and bytes,
//! with its row in docs/margins.md, or with the reason why it is no bound.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// The files of `cpu/src` whose constants are listed: those whose paths begin like this.
const PLACES: [&str; 10] = [
    "exact",
    "accel",
    "render/frustum",
    "render/background_",
    "render/ray_error",
    "render/hit_lanes",
    "image/quantize",
    "math/power",
    "math/tangent",
    "math/fixed_point",
];

/// A file, and one of its constants.
type Entry = (String, String);

/// Literals that are not listed.
const TRIVIAL: [&str; 4] = ["0.0", "1.0", "2.0", "0.5"];

/// Returns the code of a file, without comments, in one line, up to the tests.
fn code(text: &str) -> String {
    let text = text.split("#[cfg(test)]\nmod tests").next().unwrap_or_default();
    let words = text.lines().flat_map(|line| line.split("//").next().unwrap_or_default().split_whitespace());
    words.collect::<Vec<_>>().join(" ")
}

fn is_numeric(kind: &str) -> bool {
    ["f32", "f64", "u8", "u16", "u32", "u64", "usize", "i64", "i128"].contains(&kind)
}

/// Returns the literal at the beginning of a word, if it has a fraction or an exponent.
fn literal(word: &str) -> Option<&str> {
    let digits =
        |from: usize| from + word[from..].bytes().take_while(|byte| byte.is_ascii_digit() || *byte == b'_').count();
    let is_digit = |at: usize| word.as_bytes().get(at).is_some_and(u8::is_ascii_digit);
    let integer = digits(0);
    let mut end = integer;
    if word[end..].starts_with('.') && is_digit(end + 1) {
        end = digits(end + 1);
    }
    if word[end..].starts_with("e-") && is_digit(end + 2) || word[end..].starts_with('e') && is_digit(end + 1) {
        end = digits(end + 2);
    }
    (is_digit(0) && end > integer).then(|| word[..end].trim_end_matches('_'))
}

/// Returns the constants of a file: `NAME = value` if it has a name, and otherwise the literal.
fn constants(text: &str) -> BTreeSet<String> {
    let (code, mut found) = (code(text), BTreeSet::new());
    let (mut rest, mut items) = (String::new(), code.split("const "));
    rest += items.next().unwrap_or_default();
    for item in items {
        let named = item.split_once(';').and_then(|(item, after)| {
            let (name, kind, value) = item
                .split_once(": ")
                .map(|(name, item)| (name, item.split_once(" = ")))
                .and_then(|(name, item)| item.map(|(kind, value)| (name, kind, value)))?;
            is_numeric(kind).then(|| (format!("{name} = {value}"), after))
        });
        let (name, after) = named.unzip();
        found.extend(name);
        rest += after.unwrap_or(item);
    }
    let words = rest.split(|letter: char| !(letter.is_ascii_alphanumeric() || "._-".contains(letter)));
    let words = words.map(|word| word.trim_start_matches('-'));
    found.extend(words.filter_map(literal).filter(|word| !TRIVIAL.contains(word)).map(str::to_owned));
    found
}

/// Adds the files of a folder whose constants are listed, with the constants of each.
fn collect(source: &Path, folder: &Path, found: &mut BTreeSet<Entry>) {
    for entry in fs::read_dir(folder).expect("the folder can be read") {
        let path = entry.expect("it can be read").path();
        let file = path.strip_prefix(source).expect("it is inside").to_str().expect("it is ASCII");
        if path.is_dir() {
            collect(source, &path, found);
        } else if PLACES.iter().any(|place| file.starts_with(place)) && !file.contains("/tests") {
            let text = fs::read_to_string(&path).expect("the file can be read");
            found.extend(constants(&text).into_iter().map(|constant| (file.to_owned(), constant)));
        }
    }
}

#[test]
fn every_constant_has_a_row_or_is_no_bound() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cpu/src");
    let (mut found, mut listed) = (BTreeSet::new(), BTreeSet::new());
    collect(&source, &source, &mut found);
    let page = include_str!("../../../../docs/margins.md");
    for line in include_str!("constants.txt").lines() {
        let [file, constants, what] = line.split(" | ").collect::<Vec<_>>()[..] else { panic!("{line}") };
        listed.extend(constants.split("; ").map(|constant| (file.to_owned(), constant.to_owned())));
        let has_row = page.contains(&format!("\n| {what} | `"));
        assert!(has_row || what.starts_with("no bound: "), "docs/margins.md has no row: {line}");
    }
    let missing: Vec<_> = found.difference(&listed).collect();
    assert!(missing.is_empty(), "constants.txt lacks {missing:?}");
    let gone: Vec<_> = listed.difference(&found).collect();
    assert!(gone.is_empty(), "the code has no more {gone:?}");
}

#[test]
fn constants_are_found() {
    let text = "const A: f64 = 3.0 * B; // 4.0\nfn f(x: f64) { x * 1e-9 + 0.5 - x.0.1 * -7.25_f64 + a[0..3] }\n\
                const C: [f64; 2] = [0x1e5, 8.5];\n#[cfg(test)]\nmod tests { 9.0 }";
    assert_eq!(constants(text).into_iter().collect::<Vec<_>>(), ["1e-9", "7.25", "8.5", "A = 3.0 * B"]);
}
