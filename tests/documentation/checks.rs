//! The checks of the documentation. Each one returns a report, so that a test can show that it finds a fault.

use std::collections::{BTreeMap, BTreeSet};

use crate::markdown::{Link, Page};
use crate::project::{self, Project};
use crate::words;

/// Columns of a line of prose or of a comment.
const MOST_COLUMNS: usize = 120;

/// Words of a sentence.
const MOST_WORDS: usize = 35;

/// Paths in texts that are not of this project, or that a command makes.
const NOT_OURS: [&str; 4] = ["my.wgsl", "mia.wgsl", "my/background.wgsl", "bench/record"];

/// Pages that name the files of older commits, and say so.
pub const OF_OLDER_COMMITS: [&str; 1] = ["docs/ablations.md"];

/// Pages that keep the words of older commits, and say so.
const WITH_OLD_WORDS: [&str; 3] = ["CHANGELOG.md", "docs/ablations.md", "docs/experiments.md"];

/// The section of docs/design.md that translates the names of older commits.
const OLD_NAMES: &str = "Old and new names of the modules";

/// Prose lines of a page before its second heading.
const MOST_SUMMARY_LINES: usize = 10;

/// Abbreviations that every programmer knows, and pages. The glossary has all others.
const COMMON_ABBREVIATIONS: [&str; 32] = [
    "AMD",
    "ARM",
    "CI",
    "CONTRIBUTING",
    "CPU",
    "CRLF",
    "FOLDER",
    "GB",
    "GCC",
    "GLSL",
    "GPU",
    "HLSL",
    "ID",
    "IEEE",
    "JSON",
    "KB",
    "LF",
    "LLVM",
    "MB",
    "MIT",
    "PDF",
    "PNG",
    "POSIX",
    "PPM",
    "README",
    "RISC",
    "SECURITY",
    "SHA",
    "SIGKILL",
    "SIGSEGV",
    "SIGTERM",
    "UTF",
];

/// Private words of older versions of this project. They have been replaced by the field's terms of docs/glossary.md.
const FORBIDDEN_WORDS: [&str; 20] = [
    "textbook",
    "textbook's",
    "certified",
    "certify",
    "certifies",
    "certification",
    "certificate",
    "certificates",
    "doubtful",
    "in doubt",
    "leap",
    "leaps",
    "sunk",
    "box ray",
    "judge",
    "judged",
    "judges",
    "sky",
    "way on",
    "reconsider",
];

/// The faults that a check has found, and the number of places that it compared.
#[derive(Debug, Default)]
pub struct Report {
    pub checked: usize,
    pub faults: Vec<String>,
}

impl Report {
    /// Counts a place, and keeps its fault if the promise does not hold.
    fn check(&mut self, holds: bool, fault: impl FnOnce() -> String) {
        self.checked += 1;
        if !holds {
            self.faults.push(fault());
        }
    }

    /// Adds the places and the faults of another report.
    pub fn add(&mut self, other: Self) {
        self.checked += other.checked;
        self.faults.extend(other.faults);
    }

    /// Fails if there is a fault, or if fewer than `least` places were compared.
    pub fn conclude(self, least: usize) {
        assert!(self.faults.is_empty(), "{} faults:\n{}", self.faults.len(), self.faults.join("\n"));
        assert!(self.checked >= least, "only {} places were compared", self.checked);
    }
}

/// Checks that links lead to files and headings.
pub fn check_links(project: &Project, pages: &BTreeMap<&str, Page>) -> Report {
    let mut report = Report::default();
    for (path, page) in pages {
        for Link { line, to: link, .. } in page.links.iter().filter(|link| !link.to.contains(':')) {
            let (file, anchor) = link.split_once('#').unwrap_or((link, ""));
            let target = if file.is_empty() { (*path).to_owned() } else { project::join(path, file) };
            report.check(file.is_empty() || project.has(&target), || {
                format!("{path}:{line}: there is no file [{target}]")
            });
            let headings = pages.get(target.as_str()).map(|page| &page.headings);
            let is_heading = anchor.is_empty() || headings.is_some_and(|known| known.iter().any(|it| it == anchor));
            report.check(is_heading, || format!("{path}:{line}: there is no heading [{link}]"));
        }
    }
    report
}

/// Checks the paths that pieces of text name: file, line and text.
pub fn check_paths<'a>(project: &Project, texts: impl Iterator<Item = (&'a str, usize, &'a str)>) -> Report {
    let mut report = Report::default();
    for (path, line, text) in texts {
        for named in words::paths(text, &project.folders).filter(|named| !NOT_OURS.contains(named)) {
            let is_known = project.has_ending_with(named);
            report.check(is_known, || format!("{path}:{line}: there is no [{named}] in this project"));
        }
    }
    report
}

/// Checks that the sections of the specification that texts cite exist: file and text.
pub fn check_sections<'a>(specification: &Page, texts: impl Iterator<Item = (&'a str, String)>) -> Report {
    let mut report = Report::default();
    let is_section = |number: &str| {
        specification
            .titles
            .iter()
            .any(|title| title.split(' ').next().map(|it| it.trim_end_matches('.')) == Some(number))
    };
    for (path, text) in texts {
        for cited in words::sections(&text) {
            report.check(is_section(&cited), || format!("{path}: the specification has no section [{cited}]"));
        }
    }
    report
}

/// Checks the length of sentences.
pub fn check_sentences(path: &str, page: &Page) -> Report {
    let mut report = Report::default();
    for (line, sentence) in &page.sentences {
        let count = words::count(sentence);
        report.check(count <= MOST_WORDS, || format!("{path}:{line}: {count} words: {sentence}"));
    }
    report
}

/// Checks the length of lines: file, line and text.
pub fn check_columns<'a>(lines: impl Iterator<Item = (&'a str, usize, String)>) -> Report {
    let mut report = Report::default();
    for (path, line, text) in lines {
        let columns = text.chars().count();
        report.check(columns <= MOST_COLUMNS, || format!("{path}:{line}: {columns} columns"));
    }
    report
}

/// Checks that links whose text is the name of a function or of a type lead to its source.
pub fn check_named_items(project: &Project, pages: &BTreeMap<&str, Page>) -> Report {
    let mut report = Report::default();
    for (path, page) in pages {
        for Link { line, to, code } in page.links.iter().filter(|link| link.to.ends_with(".rs")) {
            let source = project::join(path, to);
            if words::is_name(code) && project.has(&source) {
                let has_item = words::defines(&project.text(&source), code);
                report.check(has_item, || format!("{path}:{line}: [{source}] does not define [{code}]"));
            }
        }
    }
    report
}

/// Checks that the summary of a page is there and short.
pub fn check_summary(path: &str, page: &Page) -> Report {
    let mut report = Report::default();
    let lines = page.summary().count();
    report.check((1..=MOST_SUMMARY_LINES).contains(&lines), || format!("{path}: the summary has {lines} lines"));
    report
}

/// The single words of all terms in the glossary, which stand in the first column of its tables.
pub fn terms(glossary: &Page) -> BTreeSet<&str> {
    let terms = glossary.rows.iter().filter_map(|row| row.first());
    terms.flat_map(|term| term.split(|letter: char| !letter.is_alphanumeric() && letter != '_')).collect()
}

/// Checks that every term of the glossary is used in `text`, which is all other text of the project.
pub fn check_terms(glossary: &Page, text: &str) -> Report {
    let mut report = Report::default();
    for term in glossary.rows.iter().filter_map(|row| row.first()).flat_map(|cell| cell.split(", ")) {
        report.check(words::holds(text, &term.to_lowercase()), || {
            format!("the glossary has [{term}], which is not used")
        });
    }
    report
}

/// Checks that every abbreviation of a page is in the glossary, or is one that every programmer knows.
pub fn check_abbreviations(terms: &BTreeSet<&str>, path: &str, page: &Page) -> Report {
    let mut report = Report::default();
    for (line, text) in &page.text {
        for word in words::abbreviations(text) {
            let is_known = COMMON_ABBREVIATIONS.contains(&word) || terms.contains(word);
            report.check(is_known, || format!("{path}:{line}: the glossary lacks [{word}]"));
        }
    }
    report
}

/// Checks that every type that a page names is in the sources or in the glossary.
pub fn check_type_names(known: &BTreeSet<String>, path: &str, page: &Page) -> Report {
    let mut report = Report::default();
    for (line, code) in page.code.iter().filter(|(line, _)| !keeps_old_names(path, page, *line)) {
        for name in words::type_names(code) {
            report.check(known.contains(name), || format!("{path}:{line}: no source has the name [{name}]"));
        }
    }
    report
}

/// Checks that a page has none of the forbidden words.
pub fn check_words(path: &str, page: &Page) -> Report {
    let mut report = Report::default();
    for (line, text) in page.text.iter().chain(&page.sentences).chain(&page.code) {
        if !keeps_old_names(path, page, *line) {
            let lower = text.to_lowercase();
            let found = FORBIDDEN_WORDS.iter().find(|word| words::holds(&lower, word));
            report.check(found.is_none(), || format!("{path}:{line}: private word {found:?}: {text}"));
        }
    }
    report
}

/// Whether a line may name what older commits had.
fn keeps_old_names(path: &str, page: &Page, line: usize) -> bool {
    WITH_OLD_WORDS.contains(&path) || path == "docs/design.md" && page.is_below(line, OLD_NAMES)
}
