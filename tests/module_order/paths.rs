//! Finds the paths that a source file contains.

use syn::visit::{self, Visit};
use syn::{Attribute, Item, ItemMod, ItemUse, Macro, UseName, UseRename, UseTree, Visibility};

/// Whether an item is compiled only for tests.
pub fn is_for_tests(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|attribute| {
        attribute.path().is_ident("cfg")
            && attribute.meta.require_list().is_ok_and(|list| list.tokens.to_string() == "test")
    })
}

/// Collects the paths that a file contains: in `use` lines, in code and in the arguments of macros.
#[derive(Default)]
pub struct Paths {
    pub paths: Vec<Vec<String>>,
    /// Names of child modules that are compiled only for tests.
    pub test_modules: Vec<String>,
    /// Number of modules inside this file that contain the current item. If it is not 0, `super` does not lead out of
    /// the file.
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

    /// Skips a visibility: `pub(super)` contains a path, but uses nothing.
    fn visit_visibility(&mut self, _: &'ast Visibility) {}

    fn visit_item_use(&mut self, item: &'ast ItemUse) {
        self.expand(Vec::new(), &item.tree);
    }

    fn visit_path(&mut self, path: &'ast syn::Path) {
        self.add(path.segments.iter().map(|segment| segment.ident.to_string()).collect());
        visit::visit_path(self, path);
    }

    fn visit_macro(&mut self, found: &'ast Macro) {
        // `to_string` puts blanks between the tokens of a path: `crate :: math :: vec3`.
        let tokens = found.tokens.to_string().replace(" :: ", "::");
        for word in tokens.split(|letter: char| !(letter.is_alphanumeric() || "_:".contains(letter))) {
            self.add(word.split("::").map(str::to_owned).collect());
        }
    }
}

impl Paths {
    /// Adds the paths of a `use` line. If it has braces, each name in them gives a path.
    fn expand(&mut self, mut before: Vec<String>, tree: &UseTree) {
        match tree {
            UseTree::Path(path) => {
                before.push(path.ident.to_string());
                self.expand(before, &path.tree);
            }
            UseTree::Group(group) => group.items.iter().for_each(|tree| self.expand(before.clone(), tree)),
            UseTree::Name(UseName { ident }) | UseTree::Rename(UseRename { ident, .. }) => {
                before.push(ident.to_string());
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
