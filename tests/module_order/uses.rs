//! Finds out which modules of a crate use which other modules.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use syn::visit::Visit;

use crate::paths::Paths;

/// The path of a module from the crate's root, such as `["accel", "bvh"]`.
pub type Module = Vec<String>;

/// The source text of each module of a crate.
pub type Sources = BTreeMap<Module, String>;

/// The modules that each module uses.
pub type Uses = BTreeMap<Module, BTreeSet<Module>>;

/// Returns the modules that each module uses outside of its tests.
pub fn uses(sources: &Sources) -> Uses {
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
            let supers = path.iter().take_while(|part| *part == "super").count();
            let absolute = match path.first().map(String::as_str) {
                Some("crate") => path[1..].to_vec(),
                // A path without `crate` leads to a child module, or out of this crate. For the latter, no source is
                // found.
                _ => [&module[..module.len().saturating_sub(supers)], &path[supers..]].concat(),
            };
            let target = (1..=absolute.len())
                .rev()
                .map(|length| absolute[..length].to_vec())
                .find(|it| sources.contains_key(it));
            used.extend(target.filter(|target| target != module));
        }
    }
    uses
}

/// Returns the uses that the order forbids: a folder uses a folder after it, or has no place in the order. Each is a
/// text.
pub fn against_the_order(uses: &Uses, order: &[&str]) -> Vec<String> {
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

/// Returns the uses of the folders and files whose paths have `depth` parts. What is deeper counts as its folder.
pub fn at_depth(uses: &Uses, depth: usize) -> Uses {
    let folder = |module: &Module| module[..module.len().min(depth)].to_vec();
    let mut folded = Uses::new();
    for (module, used) in uses {
        let targets = used.iter().map(folder).filter(|target| *target != folder(module));
        folded.entry(folder(module)).or_default().extend(targets);
    }
    folded
}

/// Returns the modules that use each other in a circle. A module is in no circle if it uses no module, or if no module
/// uses it. Such modules are removed repeatedly, until only circles and modules between circles are left.
pub fn in_circles(uses: &Uses) -> Vec<String> {
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

/// Returns the uses without those of a file that the file is a part of: `exact/rays.rs` may use `exact.rs`.
pub fn without_parents(mut uses: Uses) -> Uses {
    for (module, used) in &mut uses {
        used.retain(|target| !module.starts_with(target));
    }
    uses
}

/// Returns all sources below `folder`, the folder of a crate's root.
pub fn read(folder: &Path) -> Sources {
    let is_source = |path: &PathBuf| path.extension().is_some_and(|ending| ending == "rs");
    let source = |path: PathBuf| {
        let own = path.strip_prefix(folder).expect("it is below the folder").with_extension("");
        let module: Module = own.iter().map(|part| part.to_str().expect("names are plain").to_owned()).collect();
        let is_root = module == ["lib"] || module == ["main"];
        (if is_root { Vec::new() } else { module }, std::fs::read_to_string(&path).expect("a source is text"))
    };
    test_support::files_below(folder).into_iter().filter(is_source).map(source).collect()
}
