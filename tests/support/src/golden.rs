//! Lists the pictures whose digests come from other programs than the renderer.
//!
//! There are two sets. `tests/cases` has 16 small scenes, whose digests come from the literal program in C++. The
//! reference folder has the course's four cases. It is not part of this project: it is beside the project, or at the
//! path in the environment variable `RENDER_REFERENCE_DIR`.

use std::fs;
use std::path::{Path, PathBuf};

use cpu::Scatter;

use format::digest::read_sums;

/// The two conventions to scatter light (specification, section 11), with their names in the lists of digests.
const CONVENTIONS: [(&str, Scatter); 2] = [("statement", Scatter::Statement), ("published", Scatter::Published)];

/// A picture with a known digest: its input files, and the list that has its digest.
#[derive(Clone, Debug)]
pub struct Golden {
    /// Name of the picture in the list of digests, such as `statement/07.ppm`.
    pub name: String,
    /// The way in which surfaces scatter light in the picture.
    pub scatter: Scatter,
    /// Path of the configuration file.
    pub config: PathBuf,
    /// Path of the scene file.
    pub scene: PathBuf,
    /// Path of the list that has the picture's digest.
    pub sums: PathBuf,
}

impl Golden {
    /// Returns the digest of the picture's whole PPM file.
    ///
    /// # Errors
    /// A message, if the list of digests cannot be read or does not have the picture.
    pub fn digest(&self) -> Result<String, String> {
        let sums = sums(&self.sums)?;
        let found = sums.into_iter().find(|(name, _)| *name == self.name);
        found.map(|(_, digest)| digest).ok_or(format!("{} has no {}", self.sums.display(), self.name))
    }
}

/// Returns the pictures of the 16 scenes in `tests/cases`, in both conventions.
#[must_use]
pub fn cases() -> Vec<Golden> {
    let folder = crate::project_root().join("tests/cases");
    let names = (1..=16).map(|number| format!("{number:02}"));
    goldens(&folder, names, |case, file| format!("{case}/{file}.txt"))
}

/// Returns the pictures of the four cases in the reference folder, in both conventions.
#[must_use]
pub fn reference(folder: &Path) -> Vec<Golden> {
    let names = (1..=4).map(|number: u32| number.to_string());
    goldens(folder, names, |case, file| format!("{file}{case}.txt"))
}

fn goldens(
    folder: &Path,
    names: impl Iterator<Item = String>,
    file_name: impl Fn(&str, &str) -> String,
) -> Vec<Golden> {
    let both = |case: String| CONVENTIONS.map(|convention| (case.clone(), convention));
    let golden = |(case, (convention, scatter)): (String, (&str, Scatter))| Golden {
        name: format!("{convention}/{case}.ppm"),
        scatter,
        config: folder.join(file_name(&case, "config")),
        scene: folder.join(file_name(&case, "scene")),
        sums: folder.join("SHA256SUMS"),
    };
    names.flat_map(both).map(golden).collect()
}

/// Returns the names and digests in the list at `path`.
///
/// # Errors
/// A message, if the list cannot be read or has a wrong line.
pub fn sums(path: &Path) -> Result<Vec<(String, String)>, String> {
    let text = fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))?;
    read_sums(&text)
}

/// Returns the path of the reference folder, which need not exist: `RENDER_REFERENCE_DIR` or `../shared/reference`. A
/// relative path begins at the project's root.
#[must_use]
pub fn reference_folder() -> PathBuf {
    let named = std::env::var_os("RENDER_REFERENCE_DIR").unwrap_or("../shared/reference".into());
    crate::project_root().join(named)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_reference_cases_are_named_as_in_their_folder() {
        let goldens = reference(Path::new("r"));
        assert_eq!(goldens.len(), 8);
        assert_eq!(goldens[7].name, "published/4.ppm");
        assert_eq!((&*goldens[7].config, &*goldens[7].scene), (Path::new("r/config4.txt"), Path::new("r/scene4.txt")));
        assert!(goldens[7].digest().is_err(), "there is no such folder");
    }
}
