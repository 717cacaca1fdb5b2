//! Finds names in a text.

use std::collections::BTreeSet;

/// Endings of the names of files that must exist wherever a text names them.
const ENDINGS: [&str; 3] = ["rs", "md", "wgsl"];

/// Returns the lines of a source that are comments, with their line numbers and without slashes.
pub fn comments(source: &str) -> Vec<(usize, String)> {
    let comments = source.lines().enumerate().filter_map(|(index, line)| {
        let text = line.trim_start().strip_prefix("//")?;
        Some((index + 1, text.trim_start_matches(['/', '!']).trim().to_owned()))
    });
    comments.collect()
}

/// Returns the paths of the project that a text names. These are paths that begin with one of the `folders` at the
/// root, and names of files with one of the [`ENDINGS`]. A path with a placeholder such as `*` is left out.
pub fn paths<'a>(text: &'a str, folders: &BTreeSet<String>) -> impl Iterator<Item = &'a str> {
    let is_apart = |letter: char| letter.is_whitespace() || "`()[],;\"'|=<>".contains(letter);
    let words = text.split(is_apart).map(|word| {
        let word = word.split('#').next().unwrap_or_default();
        word.trim_start_matches("./").trim_end_matches(['.', ':', '!', '?'])
    });
    words.filter(|word| {
        let is_plain = word.chars().all(|letter| letter.is_ascii_alphanumeric() || "_-./".contains(letter));
        let begins = word.split_once('/').is_some_and(|(first, rest)| folders.contains(first) && !rest.is_empty());
        let ends = word.rsplit_once('.').is_some_and(|(stem, end)| {
            ENDINGS.contains(&end) && stem.ends_with(|letter: char| letter.is_ascii_alphanumeric() || letter == '_')
        });
        is_plain && !word.starts_with(['/', '.']) && (begins || ends)
    })
}

/// Returns the sections of the specification that a text cites, as in "specification, section 4.2" or "sections 4.2 and
/// 5". A citation without a number gives the section "".
pub fn sections(text: &str) -> Vec<String> {
    const BEFORE: [&str; 2] = ["specification, section", "specification.md, section"];
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    let mut found = Vec::new();
    for before in BEFORE {
        for (start, _) in text.match_indices(before) {
            let mut rest = text[start + before.len()..].trim_start_matches('s').trim_start();
            loop {
                let end = rest.find(|letter: char| !letter.is_ascii_digit() && letter != '.').unwrap_or(rest.len());
                found.push(rest[..end].trim_end_matches('.').to_owned());
                let next = [" and ", " to ", ", "].iter().find_map(|between| rest[end..].strip_prefix(between));
                match next {
                    Some(next) if next.starts_with(|letter: char| letter.is_ascii_digit()) => rest = next,
                    _ => break,
                }
            }
        }
    }
    found
}

/// Whether `text`, which must be in lower case, contains `words` as whole words one after the other.
pub fn holds(text: &str, words: &str) -> bool {
    let is_apart = |letter: Option<char>| letter.is_none_or(|letter| !letter.is_alphanumeric() && letter != '_');
    text.match_indices(words).any(|(start, _)| {
        is_apart(text[..start].chars().next_back()) && is_apart(text[start + words.len()..].chars().next())
    })
}

/// Whether a code span is a single name of Rust.
pub fn is_name(code: &str) -> bool {
    !code.is_empty() && code.chars().all(|letter| letter.is_ascii_alphanumeric() || letter == '_')
}

/// Whether a Rust source defines a function, a type, a trait, a module or a constant with this name.
pub fn defines(source: &str, name: &str) -> bool {
    let kinds = ["fn", "struct", "enum", "trait", "type", "mod", "const"];
    source.lines().any(|line| {
        let words: Vec<&str> = line.split(|letter: char| !letter.is_alphanumeric() && letter != '_').collect();
        words.windows(2).any(|pair| kinds.contains(&pair[0]) && pair[1] == name)
    })
}
