//! Reads the user's modules, and finds out which of the crate's modules each of them replaces.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use shaders::diagnostic::Place;
use shaders::{Diagnostic, Library, module};

use crate::Error;
use crate::hierarchy::WORTHWHILE;

/// The start of a first line that names the module which the file replaces.
const MARK: &str = "// module:";

/// What ends a line in WGSL, besides LF.
const LINE_ENDS: [char; 6] = ['\r', '\u{b}', '\u{c}', '\u{85}', '\u{2028}', '\u{2029}'];

/// Largest size of a module that is read, in bytes. A text of this size usually has more tokens than
/// [`shaders::limits`] allows.
pub const MAX_BYTES: u64 = 1 << 20;

/// Largest number of WGSL files that are read from a folder and its subfolder `kernels`.
pub const MAX_FILES: usize = 256;

/// A WGSL module that the user has written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UserModule {
    /// The name of the crate's module that this module replaces.
    pub name: String,
    /// The path of the file, as the user named it.
    pub path: PathBuf,
    /// The text of the module.
    pub text: String,
}

/// Returns the module in a file, or the modules in a folder and its subfolder `kernels`.
///
/// # Errors
/// [`Error::File`]. If a file replaces no module, the message tells what to do.
pub fn read(path: &Path) -> Result<Vec<UserModule>, Error> {
    if !path.is_dir() {
        return Ok(vec![read_one(path)?]);
    }
    let mut files = Vec::new();
    for folder in [path.to_owned(), path.join("kernels")] {
        if folder.is_dir() {
            let entries = fs::read_dir(&folder).map_err(|cause| Error::File { path: folder.clone(), cause })?;
            let paths = entries.filter_map(Result::ok).map(|entry| entry.path());
            let modules = paths.filter(|path| path.extension().is_some_and(|ending| ending == "wgsl"));
            // One more file than allowed is enough to find out that there are too many.
            files.extend(modules.take(MAX_FILES + 1));
        }
    }
    files.sort();
    if files.is_empty() {
        return Err(fault(path, "there is no WGSL file here; shader-lab --template FILE writes one".to_owned()));
    }
    if files.len() > MAX_FILES {
        return Err(fault(path, format!("it holds more than {MAX_FILES} WGSL files; move the modules elsewhere")));
    }
    files.iter().map(|path| read_one(path)).collect()
}

fn read_one(path: &Path) -> Result<UserModule, Error> {
    let text = read_text(path).map_err(|cause| Error::File { path: path.to_owned(), cause })?;
    let name = name(path, &text);
    if module::find(&name).is_none() {
        return Err(unknown(path, &text, &name));
    }
    Ok(UserModule { name, path: path.to_owned(), text })
}

/// Returns the text of the module at `path`, with LF as every line end, and without the byte order marks that some
/// editors put before the first character.
///
/// # Errors
/// The file cannot be read, has more than [`MAX_BYTES`], or is not UTF-8.
pub fn read_text(path: &Path) -> io::Result<String> {
    let text = cpu::internals::input::reader::read_text(path, MAX_BYTES)?;
    Ok(text.trim_start_matches('\u{feff}').replace("\r\n", "\n").replace(LINE_ENDS, "\n"))
}

/// Returns the name in the first line `line` of a file, after [`MARK`], in which blanks may differ.
fn marked(line: &str) -> Option<&str> {
    line.trim_start().strip_prefix("//")?.trim_start().strip_prefix("module:")
}

/// Returns the error for a module name that does not exist. The message lists all names. If the name is in the first
/// line of the file, the message shows its place there.
fn unknown(path: &Path, text: &str, name: &str) -> Error {
    let known: Vec<_> = module::MODULES.iter().chain(module::REALS).map(|module| module.name).collect();
    let known = known.join(", ");
    match text.lines().next().and_then(|line| Some((line, marked(line)?))) {
        Some((line, rest)) => {
            let (column, length) = (line.len() - rest.trim_start().len() + 1, name.chars().count().max(1));
            let place = Place { file: shown(path), line: 1, column, length, text: line.trim_end().to_owned() };
            // A character that is not seen would hide what is wrong.
            let message = format!("no module is called [{}]; there are: {known}", name.escape_default());
            shaders::Error::Invalid(Box::new(Diagnostic { message, place: Some(place) })).into()
        }
        None => {
            let advice = format!("its first line may say which it is, as in [{MARK} kernels/image]");
            fault(path, format!("no module is called [{name}], as the file is; {advice}; there are: {known}"))
        }
    }
}

/// Returns the name of the module that a file replaces: the name in its first line, or else the file's name without its
/// ending. If the file is in a folder `kernels`, `kernels/` is put before the file's name.
fn name(path: &Path, text: &str) -> String {
    if let Some(name) = text.lines().next().and_then(marked) {
        return name.trim().to_owned();
    }
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let in_kernels = path.parent().and_then(Path::file_name).is_some_and(|folder| folder == "kernels");
    if in_kernels { format!("kernels/{stem}") } else { stem.into_owned() }
}

/// Returns the name of a file for messages, with control characters escaped.
#[must_use]
pub fn shown(path: &Path) -> String {
    cpu::internals::input::text::escape(path.as_os_str().as_encoded_bytes())
}

fn fault(path: &Path, message: String) -> Error {
    Error::File { path: path.to_owned(), cause: io::Error::other(message) }
}

/// Whether a scene of `objects` objects gets a hierarchy: if it has many, and the user does not replace the loop over
/// all objects.
#[must_use]
pub fn has_hierarchy(modules: &[UserModule], objects: usize) -> bool {
    objects >= WORTHWHILE && !modules.iter().any(|module| module.name == "closest_hit")
}

/// Returns the crate's modules for a scene of `objects` objects, in which `modules` replace some.
///
/// # Errors
/// [`Error::Shader`] if a name is not that of a module.
pub fn library(modules: &[UserModule], objects: usize) -> Result<Library, Error> {
    let mut library = Library::standard();
    for module in modules {
        library.replace(&module.name, &shown(&module.path), module.text.as_str())?;
    }
    Ok(if has_hierarchy(modules, objects) { library.in_hierarchy() } else { library })
}

#[cfg(test)]
mod tests {
    use test_support::folder::Folder;

    use super::*;

    #[test]
    fn a_file_is_the_module_of_its_name_unless_its_first_line_names_another() {
        for (path, text, module) in [
            ("mine/sphere.wgsl", "// Mine.\n", "sphere"),
            ("mine/kernels/sphere.wgsl", "", "kernels/sphere"),
            ("mine/normals.wgsl", "// module: kernels/image\n", "kernels/image"),
            ("anything.wgsl", super::super::TEMPLATE, "kernels/image"),
        ] {
            assert_eq!(name(Path::new(path), text), module);
        }
    }

    #[test]
    fn byte_order_marks_line_ends_and_blanks_are_those_of_any_editor() {
        let folder = Folder::new();
        for text in ["\u{feff}\u{feff}// module: sphere\n", "// module: sphere\r", " //module:\u{a0}sphere\r\n"] {
            let modules = read(&folder.write("my.wgsl", text)).expect("the first line names the module");
            assert!(modules[0].name == "sphere" && modules[0].text.ends_with("sphere\n"), "{text:?}: {modules:?}");
        }
        let path = folder.write("my.wgsl", "// module: \u{200b}sphere\n");
        let message = read(&path).expect_err("the name has one more character").to_string();
        assert!(message.contains(r"no module is called [\u{200b}sphere]"), "{message}");
    }

    #[test]
    fn a_module_of_exactly_the_limit_is_read_and_one_byte_more_refused() {
        let folder = Folder::new();
        let read_bytes = |count: usize| read(&folder.write("sphere.wgsl", " ".repeat(count)));
        assert_eq!(read_bytes(MAX_BYTES as usize).expect("it is as large as may be").len(), 1);
        let error = read_bytes(MAX_BYTES as usize + 1).expect_err("it is larger").to_string();
        assert!(error.ends_with("larger than 1048576 bytes"), "{error}");
    }

    #[test]
    fn a_folder_may_hold_a_limited_number_of_modules() {
        let folder = Folder::new();
        let put = |index: usize| folder.write(&format!("{index}.wgsl"), "// module: sphere\n");
        (0..MAX_FILES).for_each(|index| drop(put(index)));
        assert_eq!(read(folder.path()).expect("they are as many as may be").len(), MAX_FILES);
        put(MAX_FILES);
        let message = read(folder.path()).expect_err("it is one too many").to_string();
        assert!(message.contains("more than 256 WGSL files"), "{message}");
    }

    #[test]
    fn many_objects_get_a_hierarchy_unless_the_user_replaces_the_loop() {
        let module = |name: &str| UserModule { name: name.to_owned(), path: PathBuf::new(), text: String::new() };
        let hierarchy = |name, objects| library(&[module(name)], objects).expect("it exists").has_hierarchy();
        assert!(!hierarchy("background", WORTHWHILE - 1));
        assert!(hierarchy("background", WORTHWHILE));
        assert!(hierarchy("hierarchy", 10_000));
        assert!(!hierarchy("closest_hit", 10_000));
    }
}
