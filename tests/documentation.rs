//! Checks that the documentation names only what exists: links, paths, sections of the specification, terms and types.
//! Also checks the width of lines.
//!
//! Every check counts the places that it compared, and fails if they are too few. The module `faults` shows that each
//! check finds an error.

#[path = "documentation/checks.rs"]
mod checks;
#[path = "documentation/faults.rs"]
mod faults;
#[path = "documentation/markdown.rs"]
mod markdown;
#[path = "documentation/project.rs"]
mod project;
#[path = "documentation/words.rs"]
mod words;

use std::collections::{BTreeMap, BTreeSet};

use checks::{
    Report, check_abbreviations, check_columns, check_links, check_named_items, check_paths, check_sections,
    check_terms, check_type_names, terms,
};
use markdown::Page;
use project::Project;

/// Returns every Markdown file by its path, parsed.
fn pages(project: &Project) -> BTreeMap<&str, Page> {
    project.with_endings(&["md"]).map(|path| (path, Page::parse(&project.text(path)))).collect()
}

/// Returns the comments of every source in Rust and WGSL: path, line number and text.
fn comments(project: &Project) -> Vec<(&str, usize, String)> {
    let sources = project.with_endings(&["rs", "wgsl"]);
    let of = |path| words::comments(&project.text(path)).into_iter().map(move |(line, text)| (path, line, text));
    sources.flat_map(of).collect()
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
    let spans =
        pages.iter().flat_map(|(path, page)| page.code.iter().map(|(line, text)| (*path, *line, text.as_str())));
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

/// Runs a check on every page, and returns the joined reports.
fn check_pages(pages: &BTreeMap<&str, Page>, check: impl Fn(&str, &Page) -> Report) -> Report {
    let mut all = Report::default();
    pages.iter().for_each(|(path, page)| all.add(check(path, page)));
    all
}

#[test]
fn every_function_that_a_link_names_is_in_its_file() {
    let project = Project::read();
    check_named_items(&project, &pages(&project)).conclude(20);
}

#[test]
fn every_abbreviation_is_in_the_glossary_or_common() {
    let project = Project::read();
    let glossary = Page::parse(&project.text("docs/glossary.md"));
    let terms = terms(&glossary);
    check_pages(&pages(&project), |path, page| check_abbreviations(&terms, path, page)).conclude(200);
}

#[test]
fn every_term_of_the_glossary_is_used() {
    let project = Project::read();
    let paths = project.with_endings(&["md", "rs", "wgsl", "sh"]).filter(|path| *path != "docs/glossary.md");
    let text: String = paths.map(|path| project.text(path).to_lowercase() + " ").collect();
    check_terms(&Page::parse(&project.text("docs/glossary.md")), &text).conclude(100);
}

#[test]
fn every_type_that_a_page_names_is_in_the_sources() {
    let project = Project::read();
    let sources: Vec<String> = project.with_endings(&["rs", "wgsl", "cpp"]).map(|path| project.text(path)).collect();
    let known: BTreeSet<String> = sources.iter().flat_map(|text| words::names(text)).map(str::to_owned).collect();
    check_pages(&pages(&project), |path, page| check_type_names(&known, path, page)).conclude(30);
}
