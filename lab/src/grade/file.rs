//! The file `grade.toml`, and the programs of a folder.

use std::collections::HashSet;
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};

use cpu::internals::input::reader::read_text;
use serde::{Deserialize, Serialize};

use crate::bench::commands::Job;
use crate::sources::regular;
use crate::{Failure, terminal};

/// Largest size of `grade.toml`, in bytes.
const MAX_BYTES: u64 = 1 << 20;

/// The contents of `grade.toml`. Everything in it may be left out.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct File {
    /// The weights of the points.
    pub points: Weights,
    /// The scenes whose time is measured.
    pub scene: Vec<Timed>,
    /// The programs. Without them, each folder with an executable of a known name is one.
    pub program: Vec<Program>,
}

/// How much each part counts in the points of a program.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Weights {
    /// Arguments and messages.
    pub messages: f64,
    /// Pictures.
    pub pictures: f64,
    /// User time.
    pub time: f64,
    /// Energy. Without a meter, it does not count.
    pub energy: f64,
}

/// The statement's percentages of performance and energy; its 10 for unit and functional tests are divided among
/// pictures and messages.
impl Default for Weights {
    fn default() -> Self {
        Self { messages: 3.0, pictures: 7.0, time: 20.0, energy: 20.0 }
    }
}

/// A scene whose time is measured.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Timed {
    /// Its name.
    pub name: String,
    /// The configuration, from the folder of `grade.toml`.
    pub config: PathBuf,
    /// The scene file.
    pub scene: PathBuf,
    /// The time in seconds with 5 points of 10. Without it, the median of all programs.
    pub reference: Option<f64>,
    /// The time in seconds from which there are no points. Without it, four times the reference.
    pub zero: Option<f64>,
}

/// A program.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Program {
    /// Its name.
    pub name: String,
    /// The folder in which its commands run. Without it, the folder of its name.
    pub folder: Option<PathBuf>,
    /// The line of shell that builds the program.
    pub build: Option<String>,
    /// The words of the command that runs it, before the three names of files.
    pub command: Vec<String>,
}

impl File {
    /// Reads `grade.toml` in `folder`, and looks for programs if it names none.
    ///
    /// # Errors
    /// The file is wrong, or there are no programs.
    pub fn read(folder: &Path) -> Result<Self, Failure> {
        let path = folder.join("grade.toml");
        let explain = |error: String| format!("{}: {error}", terminal::name(&path));
        let text =
            if path.exists() { regular(&path).and_then(|path| read_text(path, MAX_BYTES)) } else { Ok(String::new()) };
        let text = text.map_err(|error| explain(error.to_string()))?;
        let mut file: Self = toml::from_str(&text).map_err(|error| explain(error.to_string()))?;
        let name = terminal::name(folder);
        if file.program.is_empty() {
            file.program = found(folder).map_err(|error| format!("{name}: {error}"))?;
        }
        file.check().map_err(explain)?;
        if file.program.is_empty() {
            let names = NAMES.join(", ");
            return Err(format!("{name}: no folder in it has a program {names}, and no grade.toml names one").into());
        }
        Ok(file)
    }

    fn check(&self) -> Result<(), String> {
        let Weights { messages, pictures, time, energy } = self.points;
        let weights = [messages, pictures, time, energy];
        if !weights.iter().all(|&weight| (0.0..1e9).contains(&weight)) || messages + pictures + time <= 0.0 {
            return Err("[points]: the weights must not be negative, and one besides energy above 0".to_owned());
        }
        for Timed { name, reference, zero, .. } in &self.scene {
            let ordered = [Some(0.0), *reference, *zero, Some(1e9)].into_iter().flatten().is_sorted_by(|a, b| a < b);
            if !ordered || (zero.is_some() && reference.is_none()) {
                let advice = "reference must be above 0, and zero above reference, which it needs";
                return Err(format!("scene [{}]: {advice}", terminal::name(Path::new(name))));
            }
        }
        // The names are names of folders too.
        let programs = self.program.iter().map(|program| ("program", &program.name));
        let mut known = HashSet::new();
        for (what, name) in programs.chain(self.scene.iter().map(|scene| ("scene", &scene.name))) {
            if name.is_empty() || name.contains('/') || name.starts_with('.') || !known.insert((what, name)) {
                let advice = "a name must be unique, not empty, without / and without a point at its start";
                return Err(format!("{what} [{}]: {advice}", terminal::name(Path::new(name))));
            }
        }
        let empty = self.program.iter().find(|program| program.command.is_empty());
        empty.map_or(Ok(()), |program| Err(format!("program [{}]: its command is empty", program.name)))
    }
}

/// Names of programs that are looked for.
const NAMES: [&str; 3] = ["render-aos", "render-soa", "render"];
/// Folders, within the folder of each student, in which they are looked for.
const PLACES: [&str; 4] = ["", "build", "bin", "target/release"];

fn found(folder: &Path) -> std::io::Result<Vec<Program>> {
    let is_shown = |name: &OsString| !name.as_encoded_bytes().starts_with(b".");
    let mut folders: Vec<_> = fs::read_dir(folder)?.flatten().map(|entry| entry.file_name()).filter(is_shown).collect();
    folders.sort();
    let program = |(student, name): (&OsString, &str)| {
        let command = PLACES.iter().map(|place| Path::new(place).join(name));
        let command = command.into_iter().find(|path| folder.join(student).join(path).is_file())?;
        let command = vec![Path::new(".").join(command).to_string_lossy().into_owned()];
        let name = format!("{} {name}", terminal::name(Path::new(student)));
        Some(Program { name, folder: Some(student.into()), build: None, command })
    };
    Ok(folders.iter().flat_map(|student| NAMES.map(|name| (student, name))).filter_map(program).collect())
}

impl Program {
    /// Returns the job that runs the program. `all` is the folder of `grade.toml`.
    pub fn job(&self, all: &Path) -> Job {
        let place = all.join(self.folder.as_deref().unwrap_or(Path::new(&self.name)));
        Job { name: self.name.clone(), words: self.command.iter().map(Into::into).collect(), place }
    }

    /// Returns the job that builds the program, if there is one.
    pub fn build_job(&self, all: &Path) -> Option<Job> {
        let build = self.build.as_ref()?;
        Some(Job { words: ["sh", "-c", build].map(Into::into).to_vec(), ..self.job(all) })
    }
}

#[cfg(test)]
mod tests {
    use test_support::folder::Folder;

    use super::*;

    #[test]
    fn a_file_without_sense_is_refused_with_the_reason() {
        let folder = Folder::new();
        let program = "[[program]]\nname = 'a'\ncommand = ['x']\n";
        let scene = "[[scene]]\nname = 'a'\nconfig = 'c'\nscene = 's'\n";
        for (text, reason) in [
            (program.replace("'a'", "'a/b'"), "program [a/b]: a name must be unique"),
            (program.replace("'a'", "''"), "program []: a name must be unique"),
            (program.repeat(2), "program [a]: a name must be unique"),
            (program.replace("'x'", ""), "its command is empty"),
            (format!("{program}{scene}zero = 1"), "scene [a]: reference must be above 0"),
            (format!("{program}{scene}reference = nan"), "scene [a]: reference must be above 0"),
            (format!("{program}{scene}reference = 2\nzero = 1"), "zero above reference"),
            ("[points]\ntime = -1".to_owned(), "must not be negative"),
            (String::new(), "no folder in it has a program"),
        ] {
            folder.write("grade.toml", &text);
            let message = File::read(folder.path()).expect_err(&text).message();
            assert!(message.as_ref().is_some_and(|message| message.contains(reason)), "{text}: {message:?}");
        }
        folder.write("grade.toml", format!("{program}{scene}reference = 1\nzero = 2"));
        assert!(File::read(folder.path()).is_ok(), "a program and a scene may have one name");
    }
}
