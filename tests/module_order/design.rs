//! Reads the folders and their uses from the page on the design.

use crate::uses::{Module, Uses};

/// Returns the names of the folders and files in a table of the page: the first cells in the section `## Folders of`.
pub fn folders_of_page(page: &str) -> Vec<&str> {
    let (_, section) = page.split_once("\n## Folders of").expect("the page has the section");
    let section = section.split_once("\n## ").map_or(section, |(section, _)| section);
    let cells = section.lines().filter_map(|line| line.strip_prefix("| `")?.split_once("` |"));
    cells.map(|(folder, _)| folder.trim_end_matches('/')).collect()
}

/// Returns the dotted arrows of the page's diagram. Each arrow leads from a folder to a folder that uses it. The line
/// `a[title] -.-> b & c` has two arrows.
pub fn dotted_arrows(page: &str) -> Vec<(&str, &str)> {
    let arrows = page.lines().filter_map(|line| line.split_once(" -.-> "));
    let ends = arrows.flat_map(|(from, to)| to.split(" & ").map(move |to| (from, to)));
    ends.map(|(from, to)| (from.split('[').next().unwrap_or(from).trim(), to.trim())).collect()
}

/// Returns the arrows that are wrong, because their second folder does not use the first.
pub fn arrows_without_a_use<'a>(arrows: &[(&'a str, &'a str)], uses: &Uses) -> Vec<(&'a str, &'a str)> {
    let is_in = |module: &Module, folder: &str| module.first().is_some_and(|first| first == folder);
    let is_use = |(from, to): &(&str, &str)| {
        let mut users = uses.iter().filter(|(module, _)| is_in(module, to));
        users.any(|(_, used)| used.iter().any(|target| is_in(target, from)))
    };
    arrows.iter().filter(|arrow| !is_use(arrow)).copied().collect()
}
