//! Tests that each check of the documentation finds an error.

use std::collections::BTreeMap;

use crate::checks::*;
use crate::markdown::Page;
use crate::project::Project;

#[test]
fn links_and_paths_that_lead_nowhere_are_found() {
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
}

#[test]
fn a_section_that_does_not_exist_is_found() {
    let specification = Page::parse("## 1. A\n\n### 1.2 B\n");
    let text = "(specification, sections 1 and 1.2), docs/specification.md, section 3.4.".to_owned();
    let report = check_sections(&specification, [("x.rs", text)].into_iter());
    assert_eq!((report.checked, report.faults), (3, vec!["x.rs: the specification has no section [3.4]".to_owned()]));
}

#[test]
fn long_lines_are_found() {
    let long = "word ".repeat(36);
    let page = Page::parse(&format!("Short one. {long}.\n\n| {long} |\n|---|\n\n    {long}\n\n- {long}\n"));
    let report = check_columns(page.prose.into_iter().map(|(line, text)| ("page.md", line, text)));
    assert_eq!(report.faults, ["page.md:1: 192 columns", "page.md:8: 182 columns"], "no table and no code");
}

#[test]
fn a_function_that_is_not_in_its_file_is_found() {
    let project = Project::read();
    let page = Page::parse("[`read`](tests/documentation/project.rs), [`gone`](tests/documentation/project.rs)\n");
    let report = check_named_items(&project, &BTreeMap::from([("page.md", page)]));
    let fault = "page.md:1: [tests/documentation/project.rs] does not define [gone]";
    assert_eq!((report.checked, report.faults), (2, vec![fault.to_owned()]));
}

#[test]
fn unused_terms_are_found() {
    let glossary = Page::parse("| Term | Meaning |\n|---|---|\n| BVH, tree | a TREE of boxes |\n");
    let unused = ["Term", "tree"].map(|term| format!("the glossary has [{term}], which is not used"));
    assert_eq!(check_terms(&glossary, "the bvh, and trees").faults, unused);
}
