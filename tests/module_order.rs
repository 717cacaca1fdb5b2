//! Checks the order of the modules of `cpu`: a folder uses only folders before it. In all crates, files do not use each
//! other in a circle, and no crate needs one in a later top folder.

#[path = "module_order/crates.rs"]
mod crates;
#[path = "module_order/design.rs"]
mod design;
#[path = "module_order/paths.rs"]
mod paths;
#[path = "module_order/uses.rs"]
mod uses;

use std::collections::BTreeSet;

use crates::{crates, faults, sources};
use design::{arrows_without_a_use, dotted_arrows, folders_of_page};
use uses::{Sources, against_the_order, in_circles, read, uses, within, without_parents};

/// Names of the folders and files at the top of `cpu/src`. Each uses only those before it.
const ORDER: [&str; 14] = [
    "counters",
    "math",
    "simd",
    "input",
    "geometry",
    "exact",
    "intersect",
    "image",
    "layout",
    "accel",
    "sampling",
    "materials",
    "render",
    "reference",
];

/// Names of the files and folders of `cpu/src/accel`. Each uses only those before it.
const ORDER_OF_ACCEL: [&str; 15] = [
    "object",
    "extent",
    "bounds",
    "closest_hit",
    "stack",
    "accelerator",
    "may_hit",
    "isolated",
    "dominant_sphere",
    "every_object",
    "small_scene",
    "inside",
    "flat_filter",
    "bvh",
    "choice",
];

#[test]
fn folders_use_only_those_before_them_and_no_files_use_each_other_in_a_circle() {
    let mut sources = Sources::new();
    read(&test_support::project_root().join("cpu/src"), &Vec::new(), &mut sources);
    let uses = uses(&sources);
    let links: usize = uses.values().map(BTreeSet::len).sum();
    assert!(uses.len() > 80 && links > 300, "only {links} uses by {} files were found", uses.len());
    assert_eq!(against_the_order(&uses, &ORDER), [""; 0]);
    assert_eq!(against_the_order(&within(&uses, "accel"), &ORDER_OF_ACCEL), [""; 0]);
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
        source("e::f", "use crate::e::g::G; use crate::d::D;"),
        source("e::g", "use crate::d::D;"),
    ]);
    let all = uses(&sources);
    let inner = within(&all, "e");
    assert_eq!(against_the_order(&inner, &["f", "g"]), ["f uses g"]);
    assert_eq!(against_the_order(&inner, &["g", "f"]), [""; 0]);
    let uses = all.into_iter().filter(|(module, _)| module[0] != "e").collect();
    assert_eq!(against_the_order(&uses, &["a", "b", "d"]), ["a uses b", "a uses b::c"]);
    assert_eq!(against_the_order(&uses, &["b", "a"]), ["b::c uses a", "d uses a"]);
    assert_eq!(in_circles(&uses), ["a", "b", "b::c"]);
    // A part may use the file that it is a part of, but not a file beside that one, by `super` neither.
    let mut sources = Sources::from([
        source("a", "mod b; use crate::a::b::B; use crate::d::D;"),
        source("a::b", "use super::A;"),
        source("d", "fn f() {}"),
    ]);
    assert_eq!(in_circles(&without_parents(self::uses(&sources))), [""; 0]);
    sources.extend([source("d", "use crate::a::b::B;"), source("a::b", "use super::super::d::D;")]);
    assert_eq!(in_circles(&without_parents(self::uses(&sources))), ["a::b", "d"]);
}

/// The top folders that have crates. A crate needs only crates in its own folder and in those before it, so no product
/// is built from tests or benchmarks.
const FOLDERS: [&str; 8] = ["cpu", "cli", "shaders", "web", "gpu-check", "lab", "tests", "bench"];

#[test]
fn no_crate_needs_one_in_a_later_folder() {
    let mut crates = crates(&test_support::project_root());
    assert!(crates.len() > 15 && crates["lab"].needs.len() > 5, "{crates:?}");
    assert_eq!(faults(&crates, &FOLDERS), [""; 0]);
    crates.get_mut("cpu").expect("it is a crate").needs.insert("tests/support".into());
    assert_eq!(faults(&crates, &FOLDERS), ["cpu in cpu needs tests/support"]);
}

#[test]
fn the_laboratory_and_the_shaders_programs_do_not_need_each_other() {
    let crates = crates(&test_support::project_root());
    for (name, other) in [("lab", "gpu-check"), ("gpu-check", "lab")] {
        assert!(crates[name].needs.iter().all(|need| !need.starts_with(other)), "{name} needs {other}");
    }
}

#[test]
fn no_files_of_a_crate_use_each_other_in_a_circle() {
    let root = test_support::project_root();
    let (mut files, mut circles) = (0, Vec::new());
    for (name, one) in crates(&root) {
        for sources in sources(&root.join(one.folder).join("src")) {
            let uses = uses(&sources);
            files += uses.len();
            circles
                .extend(in_circles(&without_parents(uses.clone())).into_iter().map(|file| format!("{name}: {file}")));
        }
    }
    assert_eq!(circles, [""; 0]);
    assert!(files > 300, "only {files} files were found");
}
