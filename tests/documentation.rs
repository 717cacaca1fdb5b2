//! What the documentation names exists, and what it says can be read: links, paths, sections of the specification, the
//! length of lines and of sentences.
//!
//! Every check counts what it looked at, and fails where that is too little. The tests at the end show that each check
//! finds a fault.

#[path = "documentation/markdown.rs"]
mod markdown;
#[path = "documentation/project.rs"]
mod project;
#[path = "documentation/words.rs"]
mod words;

use std::collections::BTreeMap;

use markdown::Page;
use project::Project;

/// Columns of a line of prose or of a comment.
const MOST_COLUMNS: usize = 120;

/// Words of a sentence.
const MOST_WORDS: usize = 35;

/// Paths in texts that are not of this project, or that a command makes.
const NOT_OURS: [&str; 4] = ["my.wgsl", "mia.wgsl", "my/background.wgsl", "bench/record"];

/// Pages that keep the names of older commits, and say so.
const OF_OLDER_COMMITS: [&str; 1] = ["docs/ablations.md"];

/// The faults that a check has found, and how much it looked at.
#[derive(Debug, Default)]
struct Report {
    checked: usize,
    faults: Vec<String>,
}

impl Report {
    fn check(&mut self, holds: bool, fault: impl FnOnce() -> String) {
        self.checked += 1;
        if !holds {
            self.faults.push(fault());
        }
    }

    /// Fails where a fault was found, or where fewer than `least` places were looked at.
    fn conclude(self, least: usize) {
        assert!(self.faults.is_empty(), "{} faults:\n{}", self.faults.len(), self.faults.join("\n"));
        assert!(self.checked >= least, "only {} places were looked at", self.checked);
    }
}

/// Every Markdown file, parsed.
fn pages(project: &Project) -> BTreeMap<&str, Page> {
    project.with_endings(&["md"]).map(|path| (path, Page::parse(&project.text(path)))).collect()
}

/// The comments of every source in Rust and WGSL: file, line and text.
fn comments(project: &Project) -> Vec<(&str, usize, String)> {
    let sources = project.with_endings(&["rs", "wgsl"]);
    let of = |path| words::comments(&project.text(path)).into_iter().map(move |(line, text)| (path, line, text));
    sources.flat_map(of).collect()
}

fn check_links(project: &Project, pages: &BTreeMap<&str, Page>) -> Report {
    let mut report = Report::default();
    for (path, page) in pages {
        for (line, link) in page.links.iter().filter(|(_, link)| !link.contains(':')) {
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
fn check_paths<'a>(project: &Project, texts: impl Iterator<Item = (&'a str, usize, &'a str)>) -> Report {
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
fn check_sections<'a>(specification: &Page, texts: impl Iterator<Item = (&'a str, String)>) -> Report {
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

fn check_sentences(path: &str, page: &Page) -> Report {
    let mut report = Report::default();
    for (line, sentence) in &page.sentences {
        let count = words::count(sentence);
        report.check(count <= MOST_WORDS, || format!("{path}:{line}: {count} words: {sentence}"));
    }
    report
}

/// Checks the length of lines: file, line and text.
fn check_columns<'a>(lines: impl Iterator<Item = (&'a str, usize, String)>) -> Report {
    let mut report = Report::default();
    for (path, line, text) in lines {
        let columns = text.chars().count();
        report.check(columns <= MOST_COLUMNS, || format!("{path}:{line}: {columns} columns"));
    }
    report
}

#[test]
fn every_link_leads_to_a_file_and_a_heading() {
    let project = Project::read();
    check_links(&project, &pages(&project)).conclude(100);
}

#[test]
fn every_path_that_a_page_names_exists() {
    let project = Project::read();
    let pages = pages(&project);
    let current = pages.iter().filter(|(path, _)| !OF_OLDER_COMMITS.contains(path));
    let spans = current.flat_map(|(path, page)| page.code.iter().map(|(line, text)| (*path, *line, text.as_str())));
    check_paths(&project, spans).conclude(300);
}

#[test]
fn every_path_that_a_comment_names_exists() {
    let project = Project::read();
    let comments = comments(&project);
    check_paths(&project, comments.iter().map(|(path, line, text)| (*path, *line, text.as_str()))).conclude(60);
}

#[test]
fn every_section_of_the_specification_that_is_cited_exists() {
    let project = Project::read();
    let specification = Page::parse(&project.text("docs/specification.md"));
    let mut texts: BTreeMap<&str, String> = BTreeMap::new();
    for (path, _, text) in comments(&project) {
        let all = texts.entry(path).or_default();
        all.push_str(&text);
        all.push(' ');
    }
    texts.extend(project.with_endings(&["md"]).map(|path| (path, project.text(path).replace('\n', " "))));
    check_sections(&specification, texts.into_iter()).conclude(40);
}

#[test]
fn no_line_of_prose_is_longer_than_the_limit() {
    let project = Project::read();
    let pages = pages(&project);
    let lines =
        pages.iter().flat_map(|(path, page)| page.prose.iter().map(|(line, text)| (*path, *line, text.clone())));
    check_columns(lines).conclude(1000);
}

#[test]
fn no_comment_is_longer_than_the_limit() {
    let project = Project::read();
    let sources = project.with_endings(&["rs", "wgsl"]);
    let lines = sources.flat_map(|path| {
        let text = project.text(path);
        let comments = text.lines().enumerate().filter(|(_, line)| line.trim_start().starts_with("//"));
        comments.map(|(index, line)| (path, index + 1, line.to_owned())).collect::<Vec<_>>()
    });
    check_columns(lines).conclude(5000);
}

#[test]
fn no_sentence_is_longer_than_the_limit() {
    let project = Project::read();
    let mut all = Report::default();
    for (path, page) in pages(&project).iter().filter(|(path, _)| path.starts_with("docs/") || **path == "README.md") {
        let report = check_sentences(path, page);
        all.checked += report.checked;
        all.faults.extend(report.faults);
    }
    all.conclude(500);
}

#[test]
fn each_check_finds_a_fault() {
    let project = Project::read();
    let page = Page::parse("# One\n\nSee [a](#one), [b](#two), [c](README.md), [d](nowhere.md#x).\n");
    let report = check_links(&project, &BTreeMap::from([("page.md", page)]));
    assert_eq!(report.checked, 8);
    assert_eq!(
        report.faults,
        [
            "page.md:3: there is no heading [#two]",
            "page.md:3: there is no file [nowhere.md]",
            "page.md:3: there is no heading [nowhere.md#x]",
        ]
    );

    let text = "Read docs/design.md, docs/nowhere.md, `render.rs` and `gone.rs`; either/or is no path.";
    let report = check_paths(&project, [("x.rs", 1, text)].into_iter());
    assert_eq!(report.checked, 4);
    assert_eq!(
        report.faults,
        ["x.rs:1: there is no [docs/nowhere.md] in this project", "x.rs:1: there is no [gone.rs] in this project"]
    );

    let specification = Page::parse("## 1. A\n\n### 1.2 B\n");
    let text = "(specification, sections 1 and 1.2), docs/specification.md, section 3.4.".to_owned();
    let report = check_sections(&specification, [("x.rs", text)].into_iter());
    assert_eq!((report.checked, report.faults), (3, vec!["x.rs: the specification has no section [3.4]".to_owned()]));

    let long = "word ".repeat(36);
    let page = Page::parse(&format!("Short one. {long}.\n\n| {long} |\n|---|\n| {long} |\n\n    {long}\n"));
    assert_eq!(page.prose.len(), 1, "a paragraph, no table and no code");
    let report = check_sentences("page.md", &page);
    assert_eq!((report.checked, report.faults.len()), (2, 1));
    let report = check_columns(page.prose.into_iter().map(|(line, text)| ("page.md", line, text)));
    assert_eq!((report.checked, report.faults), (1, vec!["page.md:1: 192 columns".to_owned()]));
}
