//! The teams of a folder, and their programs.

use std::collections::VecDeque;
use std::fs;
use std::io;
use std::os::unix::fs::PermissionsExt;
use std::path::{Path, PathBuf};

use serde::Deserialize;

use crate::bench::commands::Job;
use crate::terminal;

/// A program that `grade.toml` names.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Program {
    /// Its name.
    pub name: String,
    /// The team that it belongs to. Without it, the program's name.
    pub team: Option<String>,
    /// The folder in which its commands run. Without it, the folder of its name.
    pub folder: Option<PathBuf>,
    /// The line of shell that builds the program.
    pub build: Option<String>,
    /// The words of the command that runs it, before the three names of files.
    pub command: Vec<String>,
}

/// A team, which is one row of the results.
#[derive(Clone, Debug)]
pub struct Team {
    /// Its name, as it is shown. No two teams have the same.
    pub name: String,
    /// The name of the folder for its files: a number, and the letters and digits of its name.
    pub folder: String,
    /// Its programs.
    pub programs: Vec<Entry>,
    /// What is missing, and where it was looked for.
    pub missing: Option<String>,
}

/// A program of a team.
#[derive(Clone, Debug)]
pub struct Entry {
    /// The job that runs the program.
    pub job: Job,
    /// The job that builds it.
    pub build: Option<Job>,
}

/// Names of programs that are looked for. The last one counts only if the others are not there.
const NAMES: [&str; 3] = ["render-aos", "render-soa", "render"];
/// How deep, and in how many files and folders, programs of one team are looked for.
const DEPTH: usize = 8;
const MOST_ENTRIES: usize = 50_000;
/// Folders in which no program is looked for.
const PASSED_OVER: [&str; 4] = [".git", "CMakeFiles", "_deps", "node_modules"];

impl Team {
    fn new(index: usize, name: String, programs: Vec<Entry>, missing: Option<String>) -> Self {
        let letters: String = name.chars().filter(|letter| letter.is_ascii_alphanumeric()).take(40).collect();
        Self { folder: format!("{:03}-{letters}", index + 1), name, programs, missing }
    }
}

/// Returns the teams of the programs that `grade.toml` names, in the order of their first programs.
pub fn named(folder: &Path, programs: &[Program]) -> Vec<Team> {
    let mut teams: Vec<Team> = Vec::new();
    for program in programs {
        let name = terminal::name(Path::new(program.team.as_ref().unwrap_or(&program.name)));
        let place = folder.join(program.folder.as_deref().unwrap_or(Path::new(&program.name)));
        let words = |words: &[&str]| words.iter().map(Into::into).collect();
        let job = |words| Job {
            name: terminal::name(Path::new(&program.name)),
            words,
            place: place.clone(),
            hidden: Vec::new(),
        };
        let build = program.build.as_ref().map(|build| job(words(&["sh", "-c", build])));
        let entry = Entry { job: job(program.command.iter().map(Into::into).collect()), build };
        match teams.iter_mut().find(|team| team.name == name) {
            Some(team) => team.programs.push(entry),
            None => teams.push(Team::new(teams.len(), name, vec![entry], None)),
        }
    }
    teams
}

/// Returns a team for each folder in `folder`, in the order of their names.
///
/// # Errors
/// The folder cannot be read.
pub fn found(folder: &Path) -> io::Result<Vec<Team>> {
    let entries = fs::read_dir(folder)?.collect::<io::Result<Vec<_>>>()?;
    let is_team = |path: &PathBuf| {
        path.is_dir() && !path.file_name().is_some_and(|name| name.as_encoded_bytes().starts_with(b"."))
    };
    let mut folders: Vec<_> = entries.into_iter().map(|entry| entry.path()).filter(is_team).collect();
    folders.sort();
    let mut teams: Vec<Team> = Vec::new();
    for place in folders {
        let shown = place.file_name().map(|name| terminal::name(Path::new(name))).unwrap_or_default();
        // Two names with different control characters may be shown alike.
        let alike = (2..).map(|number| format!("{shown} ({number})"));
        let is_free = |name: &String| !teams.iter().any(|team| team.name == *name);
        let name = std::iter::once(shown.clone()).chain(alike).find(is_free).unwrap_or_default();
        let (files, looked) = search(&place);
        let best = |name: &str| files.iter().filter(|file| file.ends_with(name)).min_by_key(|file| rank(&place, file));
        let [aos, soa, other] = NAMES.map(best);
        let programs: Vec<_> =
            [aos, soa].into_iter().chain([other.filter(|_| aos.or(soa).is_none())]).flatten().collect();
        let lacks: Vec<_> = match (aos, soa, other) {
            (None, None, None) => NAMES.to_vec(),
            (None, None, Some(_)) => Vec::new(),
            _ => [(NAMES[0], aos), (NAMES[1], soa)]
                .into_iter()
                .filter(|(_, file)| file.is_none())
                .map(|(name, _)| name)
                .collect(),
        };
        let missing = (!lacks.is_empty()).then(|| {
            format!("no program {} in the {looked} files and folders of {}", lacks.join(", "), terminal::name(&place))
        });
        let entry = |file: &PathBuf| {
            let name = file.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
            let hidden = vec![folder.to_owned()];
            let job =
                Job { name, words: vec![Path::new(".").join(file).into_os_string()], place: place.clone(), hidden };
            Entry { job, build: None }
        };
        let programs = programs.into_iter().map(entry).collect();
        teams.push(Team::new(teams.len(), name, programs, missing));
    }
    Ok(teams)
}

/// Returns the files in `place` with the names of programs, by their paths within it, and the number of files and
/// folders that were looked at. Links are not followed.
fn search(place: &Path) -> (Vec<PathBuf>, usize) {
    let (mut files, mut looked) = (Vec::new(), 0);
    let mut folders = VecDeque::from([(PathBuf::new(), 0)]);
    while let Some((within, depth)) = folders.pop_front() {
        for entry in fs::read_dir(place.join(&within)).into_iter().flatten().flatten() {
            looked += 1;
            if looked > MOST_ENTRIES {
                return (files, looked - 1);
            }
            let (name, path) = (entry.file_name(), within.join(entry.file_name()));
            let Ok(kind) = entry.file_type() else { continue };
            if kind.is_dir() && depth < DEPTH && !PASSED_OVER.iter().any(|other| name == *other) {
                folders.push_back((path, depth + 1));
            } else if NAMES.iter().any(|other| name == *other) && place.join(&path).is_file() {
                files.push(path);
            }
        }
    }
    (files, looked)
}

/// Returns the key by which the best of several programs comes first: it can be executed, it is optimised, it lies near
/// the top.
fn rank(place: &Path, file: &Path) -> (bool, bool, usize, PathBuf) {
    let is_executable = place.join(file).metadata().is_ok_and(|it| it.permissions().mode() & 0o111 != 0);
    let is_debug = file.iter().any(|part| part.to_string_lossy().to_lowercase().contains("debug"));
    (!is_executable, is_debug, file.iter().count(), file.to_owned())
}

#[cfg(test)]
mod tests {
    use test_support::folder::Folder;

    use super::*;

    #[test]
    fn every_folder_is_a_team_and_the_best_program_is_taken() {
        let folder = Folder::new();
        let write = |path: &str, mode| {
            fs::create_dir_all(folder.file(path).parent().expect("it has one")).expect("the folder is writable");
            let file = folder.write(path, "");
            fs::set_permissions(file, fs::Permissions::from_mode(mode)).expect("it is ours");
        };
        write("ana/out/build/default/aos/Debug/render-aos", 0o755);
        write("ana/out/build/default/aos/Release/render-aos", 0o755);
        write("ana/render-aos", 0o644);
        write("ana/out/build/default/soa/Release/render-soa", 0o755);
        write("ana/render", 0o755);
        write("bea/render", 0o755);
        write("a\nb/.git/render", 0o755);
        write("a\\nb/notes.txt", 0o644);
        write("a file", 0o644);
        fs::create_dir(folder.file("none")).expect("the folder is writable");
        let teams = found(folder.path()).expect("it can be read");
        let names: Vec<_> = teams.iter().map(|team| team.name.as_str()).collect();
        assert_eq!(names, ["a\\nb", "a\\nb (2)", "ana", "bea", "none"]);
        let programs = |team: usize| {
            teams[team].programs.iter().map(|entry| entry.job.words[0].to_string_lossy()).collect::<Vec<_>>()
        };
        assert_eq!(
            programs(2),
            ["./out/build/default/aos/Release/render-aos", "./out/build/default/soa/Release/render-soa"]
        );
        assert_eq!((programs(3), programs(0).len(), programs(4).len()), (vec!["./render".into()], 0, 0));
        let missing = teams[4].missing.as_deref().unwrap_or_default();
        assert!(
            missing.starts_with("no program render-aos, render-soa, render in the 0 files and folders of "),
            "{missing}"
        );
        assert_eq!((&teams[2].missing, &teams[3].missing), (&None, &None));
    }
}
