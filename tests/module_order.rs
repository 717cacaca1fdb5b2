//! Checks the order of the modules of `cpu`: a folder uses only folders before it, and files do not use each other in a
//! circle.

#[path = "module_order/design.rs"]
mod design;
#[path = "module_order/paths.rs"]
mod paths;
#[path = "module_order/uses.rs"]
mod uses;

use std::collections::BTreeSet;

use design::{arrows_without_a_use, dotted_arrows, folders_of_page};
use uses::{Sources, against_the_order, in_circles, read, uses};

/// Names of the folders and files at the top of `cpu/src`. Each uses only those before it.
const ORDER: [&str; 14] = [
    "counters",
    "math",
    "simd",
    "input",
    "geometry",
    "exact",
    "intersect",
    "sampling",
    "materials",
    "image",
    "layout",
    "accel",
    "render",
    "reference",
];

#[test]
fn folders_use_only_those_before_them_and_no_files_use_each_other_in_a_circle() {
    let mut sources = Sources::new();
    read(&test_support::project_root().join("cpu/src"), &Vec::new(), &mut sources);
    let uses = uses(&sources);
    let links: usize = uses.values().map(BTreeSet::len).sum();
    assert!(uses.len() > 80 && links > 300, "only {links} uses by {} files were found", uses.len());
    assert_eq!(against_the_order(&uses, &ORDER), [""; 0]);
    assert_eq!(in_circles(&uses), [""; 0]);
}

#[test]
fn the_dotted_arrows_of_the_design_are_uses() {
    let root = test_support::project_root();
    let page = std::fs::read_to_string(root.join("docs/design.md")).expect("it is committed");
    let mut sources = Sources::new();
    read(&root.join("cpu/src"), &Vec::new(), &mut sources);
    let (arrows, uses) = (dotted_arrows(&page), uses(&sources));
    assert!(arrows.len() >= 8, "{arrows:?}");
    assert_eq!(arrows_without_a_use(&arrows, &uses), []);
    assert_eq!(arrows_without_a_use(&[("render", "accel")], &uses), [("render", "accel")]);
}

#[test]
fn the_page_on_the_design_lists_the_folders_in_this_order() {
    let page = std::fs::read_to_string(test_support::project_root().join("docs/design.md")).expect("it is committed");
    assert_eq!(folders_of_page(&page), ORDER);
    let changed = page.replacen("| `math/` |", "| `maths/` |", 1);
    assert_ne!(folders_of_page(&changed), ORDER, "a change of the table is noticed");
}

#[test]
fn circles_and_uses_against_the_order_are_found() {
    let source = |module: &str, text: &str| (module.split("::").map(str::to_owned).collect(), text.to_owned());
    let sources = Sources::from([
        source("a", "use crate::b::{c::C, D};"),
        source("b", "mod c; #[cfg(test)] mod tests { use crate::a::A; } fn f() { c::g(); }"),
        source("b::c", "fn g() { assert!(crate::a::is_so()); }"),
        source("d", "use crate::a::A; use std::fmt;"),
    ]);
    let uses = uses(&sources);
    assert_eq!(against_the_order(&uses, &["a", "b", "d"]), ["a uses b", "a uses b::c"]);
    assert_eq!(against_the_order(&uses, &["b", "a"]), ["b::c uses a", "d uses a"]);
    assert_eq!(in_circles(&uses), ["a", "b", "b::c"]);
}
