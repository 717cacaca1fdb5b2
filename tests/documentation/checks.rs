//! The checks of the documentation. Each check returns a report, so that a test can show that it finds an error.

use std::collections::{BTreeMap, BTreeSet};

use crate::markdown::{Link, Page};
use crate::project::{self, Project};
use crate::words;

/// Largest number of columns of a line of prose or of a comment.
const MOST_COLUMNS: usize = 120;

/// Paths that texts may name although they are not in this project, or exist only after a command.
const NOT_OURS: [&str; 3] = ["my.wgsl", "mia.wgsl", "my/background.wgsl"];

/// The result of a check: the number of places that it compared, and a message for each fault.
#[derive(Debug, Default)]
pub struct Report {
    pub checked: usize,
    pub faults: Vec<String>,
}

impl Report {
    /// Counts a place. If `holds` is false, adds the message of `fault`.
    fn check(&mut self, holds: bool, fault: impl FnOnce() -> String) {
        self.checked += 1;
        if !holds {
            self.faults.push(fault());
        }
    }

    /// Panics if there is a fault, or if fewer than `least` places were compared.
    pub fn conclude(self, least: usize) {
        assert!(self.faults.is_empty(), "{} faults:\n{}", self.faults.len(), self.faults.join("\n"));
        assert!(self.checked >= least, "only {} places were compared", self.checked);
    }
}

/// Checks that every link leads to an existing file and heading.
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

/// Checks that every path in `texts` exists in the project. An entry of `texts` has the file, the line number and the
/// text.
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

/// Checks that every section of the specification that `texts` cite exists. An entry of `texts` has the file and the
/// text.
pub fn check_sections<'a>(specification: &Page, texts: impl Iterator<Item = (&'a str, String)>) -> Report {
    let mut report = Report::default();
    let numbers: BTreeSet<_> =
        specification.titles.iter().filter_map(|title| Some(title.split(' ').next()?.trim_end_matches('.'))).collect();
    for (path, text) in texts {
        for cited in words::sections(&text) {
            report.check(numbers.contains(&*cited), || format!("{path}: the specification has no section [{cited}]"));
        }
    }
    report
}

/// Checks that no line has more than [`MOST_COLUMNS`] columns. An entry of `lines` has the file, the line number and
/// the text.
pub fn check_columns<'a>(lines: impl Iterator<Item = (&'a str, usize, String)>) -> Report {
    let mut report = Report::default();
    for (path, line, text) in lines {
        let columns = text.chars().count();
        report.check(columns <= MOST_COLUMNS, || format!("{path}:{line}: {columns} columns"));
    }
    report
}

/// Checks links whose text is the name of a function or a type: the linked source file must define it.
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

/// Checks that every term of the glossary is used in `text`, which is all text of the project except the glossary.
pub fn check_terms(glossary: &Page, text: &str) -> Report {
    let mut report = Report::default();
    for term in glossary.rows.iter().filter_map(|row| row.first()).flat_map(|cell| cell.split(", ")) {
        report.check(words::holds(text, &term.to_lowercase()), || {
            format!("the glossary has [{term}], which is not used")
        });
    }
    report
}
