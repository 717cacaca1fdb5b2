//! Checks the order of the modules of `cpu`: a folder uses only folders before it in the table of docs/design.md. In
//! all crates, files do not use each other in a circle, and no crate needs one in a later top folder.

#[path = "module_order/crates.rs"]
mod crates;
#[path = "module_order/paths.rs"]
mod paths;
#[path = "module_order/uses.rs"]
mod uses;

use std::collections::BTreeSet;
use std::path::Path;

use crates::{crates, faults, sources};
use uses::{Uses, against_the_order, at_depth, in_circles, read, uses, without_parents};

/// Returns the uses of the modules of `cpu`.
fn uses_of_cpu() -> Uses {
    uses(&read(&test_support::project_root().join("cpu/src")))
}

fn page_on_the_design() -> String {
    std::fs::read_to_string(test_support::project_root().join("docs/design.md")).expect("it is committed")
}

/// Returns the names of the folders and files in a table of the page: the first cells in the section `## Folders of`.
fn folders_of_page(page: &str) -> Vec<&str> {
    let (_, section) = page.split_once("\n## Folders of").expect("the page has the section");
    let section = section.split_once("\n## ").map_or(section, |(section, _)| section);
    let cells = section.lines().filter_map(|line| line.strip_prefix("| `")?.split_once("` |"));
    cells.map(|(folder, _)| folder.trim_end_matches('/')).collect()
}

#[test]
fn folders_use_only_those_before_them_in_the_table() {
    let (uses, page) = (uses_of_cpu(), page_on_the_design());
    let links: usize = uses.values().map(BTreeSet::len).sum();
    assert!(uses.len() > 80 && links > 300, "only {links} uses by {} files were found", uses.len());
    let order = folders_of_page(&page);
    assert_eq!(against_the_order(&uses, &order), [""; 0]);
    let found: BTreeSet<_> = uses.keys().filter_map(|module| module.first()).map(String::as_str).collect();
    assert_eq!(order.into_iter().collect::<BTreeSet<_>>(), found, "the table has every folder");
}

#[test]
fn no_files_and_no_folders_of_the_renderer_use_each_other_in_a_circle() {
    let uses = uses_of_cpu();
    assert_eq!(in_circles(&uses), [""; 0]);
    for depth in 1..=3 {
        assert_eq!(in_circles(&without_parents(at_depth(&uses, depth))), [""; 0], "folders of {depth} parts");
    }
}

#[test]
fn circles_and_uses_against_the_order_are_found() {
    let uses_in = |sources: &[(&str, &str)]| {
        let source =
            |(module, text): &(&str, &str)| (module.split("::").map(str::to_owned).collect(), (*text).to_owned());
        uses(&sources.iter().map(source).collect())
    };
    let found = uses_in(&[
        ("a", "use crate::b::{c::C, D};"),
        ("b", "mod c; #[cfg(test)] mod tests { use crate::a::A; } fn f() { c::g(); }"),
        ("b::c", "fn g() { assert!(crate::a::is_so()); }"),
        ("d", "use crate::a::A; use std::fmt;"),
    ]);
    assert_eq!(against_the_order(&found, &["a", "b", "d"]), ["a uses b", "a uses b::c"]);
    assert_eq!(against_the_order(&found, &["b", "a"]), ["b::c uses a", "d uses a"]);
    assert_eq!(in_circles(&found), ["a", "b", "b::c"]);
    // A part may use the file that it is a part of, but not a file beside that one, by `super` neither.
    let a = ("a", "mod b; use crate::a::b::B; use crate::d::D;");
    let found = uses_in(&[a, ("a::b", "use super::A;"), ("d", "fn f() {}")]);
    assert_eq!(in_circles(&without_parents(found)), [""; 0]);
    let found = uses_in(&[a, ("a::b", "use super::super::d::D;"), ("d", "use crate::a::b::B;")]);
    assert_eq!(in_circles(&without_parents(found)), ["a::b", "d"]);
    // Two folders use each other, but no two files do.
    let files = [("a::b", "use crate::d::e::E;"), ("a::c", ""), ("d::e", ""), ("d::f", "use crate::a::c::C;")];
    let found = uses_in(&files);
    assert_eq!((in_circles(&found), in_circles(&at_depth(&found, 1))), (vec![], vec!["a".to_owned(), "d".to_owned()]));
}

/// The top folders that have crates. A crate needs only crates in its own folder and in those before it, so no product
/// is built from tests or benchmarks.
const FOLDERS: [&str; 8] = ["cpu", "cli", "shaders", "web", "gpu-check", "lab", "tests", "bench"];

#[test]
fn no_crate_needs_one_in_a_later_folder() {
    let mut crates = crates(&test_support::project_root());
    assert!(crates.len() > 15 && crates["lab"].needs.len() > 5, "{crates:?}");
    // gpu-check is a check too: its program `stress` holds the WGSL to the exact oracle of `stability`.
    let needs = &mut crates.get_mut("gpu-check").expect("it is a crate").needs;
    assert!(needs.remove(Path::new("tests/stability")), "the exception goes with the need");
    assert_eq!(faults(&crates, &FOLDERS), [""; 0]);
    for (name, other) in [("lab", "gpu-check"), ("gpu-check", "lab")] {
        assert!(crates[name].needs.iter().all(|need| !need.starts_with(other)), "{name} needs {other}");
    }
    crates.get_mut("cpu").expect("it is a crate").needs.insert("tests/support".into());
    assert_eq!(faults(&crates, &FOLDERS), ["cpu in cpu needs tests/support"]);
}

#[test]
fn no_files_of_a_crate_use_each_other_in_a_circle() {
    let root = test_support::project_root();
    let (mut files, mut circles) = (0, Vec::new());
    for (name, one) in crates(&root) {
        for sources in sources(&root.join(one.folder).join("src")) {
            let uses = uses(&sources);
            files += uses.len();
            circles.extend(in_circles(&without_parents(uses)).into_iter().map(|file| format!("{name}: {file}")));
        }
    }
    assert_eq!(circles, [""; 0]);
    assert!(files > 300, "only {files} files were found");
}
