//! Checks that the documentation names only what exists: links, paths, sections of the specification and terms.
//! Also checks the width of lines, and writes the blocks of figures.
//!
//! Every check counts the places that it compared, and fails if they are too few. The module `faults` shows that each
//! check finds an error.

#[path = "documentation/blocks.rs"]
mod blocks;
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

use std::collections::BTreeMap;

use checks::{check_columns, check_links, check_named_items, check_paths, check_sections, check_terms};
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
fn every_link_leads_to_a_file_and_a_heading_and_names_what_is_there() {
    let project = Project::read();
    let pages = pages(&project);
    check_links(&project, &pages).conclude(100);
    check_named_items(&project, &pages).conclude(20);
}

#[test]
fn every_path_that_a_page_or_a_comment_names_exists() {
    let project = Project::read();
    let (pages, comments) = (pages(&project), comments(&project));
    let spans = pages.iter().flat_map(|(path, page)| page.code.iter().map(|(line, text)| (*path, *line, &text[..])));
    check_paths(&project, spans).conclude(300);
    check_paths(&project, comments.iter().map(|(path, line, text)| (*path, *line, &text[..]))).conclude(60);
}

#[test]
fn every_section_of_the_specification_that_is_cited_exists() {
    let project = Project::read();
    let specification = Page::parse(&project.text("docs/specification.md"));
    let mut texts: BTreeMap<&str, String> = BTreeMap::new();
    for (path, _, text) in comments(&project) {
        *texts.entry(path).or_default() += &(text + " ");
    }
    texts.extend(project.with_endings(&["md"]).map(|path| (path, project.text(path).replace('\n', " "))));
    check_sections(&specification, texts.into_iter()).conclude(40);
}

#[test]
fn git_ignores_what_the_commands_of_the_readme_write() {
    let project = Project::read();
    let page = project.text("README.md") + &project.text("docs/guide.md");
    let ignored = project.text(".gitignore");
    let is_ignored = |name: &str| {
        ignored.lines().map(|line| line.trim_start_matches('/')).any(|pattern| match pattern.split_once('*') {
            Some((start, end)) => name.starts_with(start) && name.ends_with(end),
            None => name == pattern,
        })
    };
    let endings = ["ppm", "png", "html", "csv", "json", "wgsl", "rlc"];
    let is_file =
        |word: &&str| !word.contains('/') && word.rsplit_once('.').is_some_and(|(_, it)| endings.contains(&it));
    let commands = page.lines().filter(|line| line.starts_with("    "));
    let written: Vec<_> = commands.flat_map(str::split_whitespace).filter(is_file).collect();
    assert!(written.len() > 15, "{written:?}");
    assert!(written.iter().all(|name| is_ignored(name)), "{written:?}");
}

#[test]
fn no_line_of_prose_and_no_comment_is_longer_than_the_limit() {
    let project = Project::read();
    let pages = pages(&project);
    let prose =
        pages.iter().flat_map(|(path, page)| page.prose.iter().map(|(line, text)| (*path, *line, text.clone())));
    check_columns(prose).conclude(1000);
    let sources = project.with_endings(&["rs", "wgsl"]);
    let lines = sources.flat_map(|path| {
        let text = project.text(path);
        let comments = text.lines().enumerate().filter(|(_, line)| line.trim_start().starts_with("//"));
        comments.map(|(index, line)| (path, index + 1, line.to_owned())).collect::<Vec<_>>()
    });
    check_columns(lines).conclude(5000);
}

#[test]
fn every_term_of_the_glossary_is_used() {
    let project = Project::read();
    let paths = project.with_endings(&["md", "rs", "wgsl", "sh"]).filter(|path| *path != "docs/glossary.md");
    let text: String = paths.map(|path| project.text(path).to_lowercase() + " ").collect();
    check_terms(&Page::parse(&project.text("docs/glossary.md")), &text).conclude(100);
}
