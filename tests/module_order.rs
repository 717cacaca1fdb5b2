//! The order of the modules of `cpu`: a folder uses only folders before it, and no files use each other in a circle.
//!
//! docs/design.md says what each folder holds, in the same order. Tests are left out: they may use anything.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use syn::visit::{self, Visit};
use syn::{Attribute, Item, ItemMod, ItemUse, Macro, UseTree, Visibility};

/// The folders and files at the top of `cpu/src`. Each uses only those before it.
const ORDER: [&str; 16] = [
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
    "output",
    "program",
];

/// The path of a module below the crate's root: `["accel", "bvh"]`.
type Module = Vec<String>;

/// The sources of a crate by module.
type Sources = BTreeMap<Module, String>;

/// Which modules each module uses.
type Uses = BTreeMap<Module, BTreeSet<Module>>;

/// Whether an item is compiled for tests alone.
fn is_for_tests(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|attribute| {
        attribute.path().is_ident("cfg")
            && attribute.meta.require_list().is_ok_and(|list| list.tokens.to_string() == "test")
    })
}

/// Collects the paths that a file writes: in `use` lines, in code and in the arguments of macros.
#[derive(Default)]
struct Paths {
    paths: Vec<Vec<String>>,
    /// Child modules that are for tests alone.
    test_modules: Vec<String>,
    /// How deep in modules within the file: `super` there is the file itself.
    depth: usize,
}

impl<'ast> Visit<'ast> for Paths {
    fn visit_item(&mut self, item: &'ast Item) {
        let attributes = match item {
            Item::Fn(item) => &item.attrs,
            Item::Impl(item) => &item.attrs,
            Item::Use(item) => &item.attrs,
            _ => &[][..],
        };
        if !is_for_tests(attributes) {
            visit::visit_item(self, item);
        }
    }

    fn visit_item_mod(&mut self, module: &'ast ItemMod) {
        if is_for_tests(&module.attrs) {
            self.test_modules.push(module.ident.to_string());
        } else {
            self.depth += 1;
            visit::visit_item_mod(self, module);
            self.depth -= 1;
        }
    }

    /// `pub(super)` uses nothing.
    fn visit_visibility(&mut self, _: &'ast Visibility) {}

    fn visit_item_use(&mut self, item: &'ast ItemUse) {
        self.expand(Vec::new(), &item.tree);
    }

    fn visit_path(&mut self, path: &'ast syn::Path) {
        self.add(path.segments.iter().map(|segment| segment.ident.to_string()).collect());
        visit::visit_path(self, path);
    }

    fn visit_macro(&mut self, found: &'ast Macro) {
        let tokens = found.tokens.to_string();
        let mut words = tokens.split(|letter: char| !(letter.is_alphanumeric() || letter == '_' || letter == ':'));
        let mut path: Vec<String> = Vec::new();
        // Tokens are parted by blanks: `crate :: math :: vec3`.
        for word in words.by_ref().filter(|word| !word.is_empty()) {
            match path.last().map(String::as_str) {
                Some("::") if word != "::" => {
                    path.pop();
                    path.push(word.into());
                }
                Some(_) if word == "::" => path.push(word.into()),
                _ => {
                    self.paths.push(std::mem::take(&mut path));
                    path.push(word.into());
                }
            }
        }
        self.paths.push(path);
    }
}

impl Paths {
    /// The paths of a `use` line, braces taken apart.
    fn expand(&mut self, mut before: Vec<String>, tree: &UseTree) {
        match tree {
            UseTree::Path(path) => {
                before.push(path.ident.to_string());
                self.expand(before, &path.tree);
            }
            UseTree::Group(group) => group.items.iter().for_each(|tree| self.expand(before.clone(), tree)),
            UseTree::Name(name) => {
                before.push(name.ident.to_string());
                self.add(before);
            }
            UseTree::Rename(rename) => {
                before.push(rename.ident.to_string());
                self.add(before);
            }
            UseTree::Glob(_) => self.add(before),
        }
    }

    fn add(&mut self, path: Vec<String>) {
        if self.depth == 0 || path.first().is_none_or(|first| first != "super") {
            self.paths.push(path);
        }
    }
}

/// Which modules each module uses outside of its tests.
fn uses(sources: &Sources) -> Uses {
    let read: BTreeMap<&Module, Paths> = sources
        .iter()
        .map(|(module, source)| {
            let mut paths = Paths::default();
            paths.visit_file(&syn::parse_file(source).unwrap_or_else(|error| panic!("{module:?}: {error}")));
            (module, paths)
        })
        .collect();
    let is_test = |module: &Module| {
        let (child, parent) = (module.last(), &module[..module.len().saturating_sub(1)]);
        child.is_some_and(|child| {
            child == "tests" || read.get(&parent.to_vec()).is_some_and(|paths| paths.test_modules.contains(child))
        })
    };
    let mut uses = Uses::new();
    for (&module, paths) in read.iter().filter(|(module, _)| !is_test(module)) {
        let used = uses.entry(module.clone()).or_default();
        for path in &paths.paths {
            let absolute = match path.first().map(String::as_str) {
                Some("crate") => path[1..].to_vec(),
                // A child by its name alone; whatever else has one is not in this crate.
                _ => [module.clone(), path.clone()].concat(),
            };
            assert!(path.first().is_none_or(|first| first != "super"), "{module:?}: begin {path:?} with `crate`");
            let target = (1..=absolute.len())
                .rev()
                .map(|length| absolute[..length].to_vec())
                .find(|it| sources.contains_key(it));
            used.extend(target.filter(|target| target != module));
        }
    }
    uses
}

/// Uses of a folder by one that stands before it, or by a folder that has no place in the order.
fn against_the_order(uses: &Uses, order: &[&str]) -> Vec<String> {
    let place = |module: &Module| order.iter().position(|&folder| Some(folder) == module.first().map(String::as_str));
    let mut found = Vec::new();
    for (module, used) in uses.iter().filter(|(module, _)| !module.is_empty()) {
        for target in used {
            if place(module).is_none() || place(module) < place(target) {
                found.push(format!("{} uses {}", module.join("::"), target.join("::")));
            }
        }
    }
    found
}

/// Returns the modules that use each other in circles. A module that uses no other one, or that no other one uses, is
/// in no circle, so such modules are removed until none is left to remove.
fn in_circles(uses: &Uses) -> Vec<String> {
    let mut left: Uses = uses.clone();
    left.remove(&Vec::new());
    loop {
        let used: BTreeSet<Module> = left.values().flatten().cloned().collect();
        let before = left.len();
        let names: BTreeSet<Module> = left.keys().cloned().collect();
        left.retain(|module, targets| used.contains(module) && targets.iter().any(|target| names.contains(target)));
        if left.len() == before {
            return left.keys().map(|module| module.join("::")).collect();
        }
    }
}

/// The sources below a folder.
fn read(folder: &Path, module: &Module, sources: &mut Sources) {
    for entry in std::fs::read_dir(folder).expect("the folder is there") {
        let path = entry.expect("the folder can be read").path();
        let name = path.file_stem().and_then(|name| name.to_str()).expect("names are plain").to_owned();
        let below = [module.clone(), vec![name.clone()]].concat();
        if path.is_dir() {
            read(&path, &below, sources);
        } else {
            let key = if name == "lib" && module.is_empty() { Vec::new() } else { below };
            sources.insert(key, std::fs::read_to_string(&path).expect("a source is text"));
        }
    }
}

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

/// The folders and files that the table of a page lists: the first cell of each row of the section `## Folders of`.
fn folders_of_page(page: &str) -> Vec<&str> {
    let (_, section) = page.split_once("\n## Folders of").expect("the page has the section");
    let section = section.split_once("\n## ").map_or(section, |(section, _)| section);
    let cells = section.lines().filter_map(|line| line.strip_prefix("| `")?.split_once("` |"));
    cells.map(|(folder, _)| folder.trim_end_matches('/')).collect()
}

/// The dotted arrows of a page's diagram, each from a folder to one that uses it: `a[title] -.-> b & c` are two.
fn dotted_arrows(page: &str) -> Vec<(&str, &str)> {
    let arrows = page.lines().filter_map(|line| line.split_once(" -.-> "));
    let ends = arrows.flat_map(|(from, to)| to.split(" & ").map(move |to| (from, to)));
    ends.map(|(from, to)| (from.split('[').next().unwrap_or(from).trim(), to.trim())).collect()
}

/// The arrows whose second folder does not use the first.
fn arrows_without_a_use<'a>(arrows: &[(&'a str, &'a str)], uses: &Uses) -> Vec<(&'a str, &'a str)> {
    let is_in = |module: &Module, folder: &str| module.first().is_some_and(|first| first == folder);
    let is_use = |(from, to): &(&str, &str)| {
        let mut users = uses.iter().filter(|(module, _)| is_in(module, to));
        users.any(|(_, used)| used.iter().any(|target| is_in(target, from)))
    };
    arrows.iter().filter(|arrow| !is_use(arrow)).copied().collect()
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
