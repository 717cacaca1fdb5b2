//! The file `grade.toml`: programs, scenes, cases and weights.

use std::collections::HashSet;
use std::path::{Path, PathBuf};

use cpu::internals::input::reader::read_text;
use serde::{Deserialize, Serialize};

use super::teams::{self, Program, Team};
use crate::sources::regular;
use crate::{Failure, terminal};

/// Largest size of `grade.toml`, in bytes.
const MAX_BYTES: u64 = 1 << 20;

/// The shortest reference of a scene, in seconds. Below it, the clock of user time decides.
pub const LEAST_REFERENCE: f64 = 0.02;

/// The contents of `grade.toml`. Everything in it may be left out.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct File {
    /// The weights of the points.
    pub points: Weights,
    /// The points of 10 for messages and pictures below which time and energy have none.
    pub gates: Gates,
    /// The scenes whose time is measured.
    pub scene: Vec<Timed>,
    /// Cases beside those of `check`.
    pub case: Vec<Own>,
    /// Names of cases that are left out.
    pub skip: Vec<String>,
    /// Points that are taken from a team.
    pub penalty: Vec<Penalty>,
    /// The programs. Without them, each folder is a team.
    pub program: Vec<Program>,
}

/// How much each part counts in the points of a team.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Weights {
    /// Arguments, messages and input files.
    pub messages: f64,
    /// Pictures.
    pub pictures: f64,
    /// User time.
    pub time: f64,
    /// Energy. Without a meter, it does not count.
    pub energy: f64,
}

/// The statement's percentages of performance and energy. Its 10 for unit and functional tests, which are marks for a
/// team's own tests, are the weight of messages and pictures here, because nothing else of it can be measured.
impl Default for Weights {
    fn default() -> Self {
        Self { messages: 3.0, pictures: 7.0, time: 20.0, energy: 20.0 }
    }
}

/// The least points of 10.
#[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Gates {
    /// For messages.
    pub messages: f64,
    /// For pictures.
    pub pictures: f64,
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
    /// The energy in joules with 5 points of 10. Without it, the median of all programs.
    pub joules: Option<f64>,
    /// The energy in joules from which there are no points. Without it, four times the reference.
    pub joules_zero: Option<f64>,
}

/// A case of a teacher: a picture.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Own {
    /// Its name.
    pub name: String,
    /// The configuration, from the folder of `grade.toml`.
    pub config: PathBuf,
    /// The scene file.
    pub scene: PathBuf,
    /// How much it counts, where a case of `check` counts 1.
    #[serde(default = "one")]
    pub weight: f64,
    /// The bound of the largest pixel difference.
    pub maximum: Option<f64>,
    /// The bound of the RMSE.
    pub rmse: Option<f64>,
}

const fn one() -> f64 {
    1.0
}

/// Points that are taken from a team.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Penalty {
    /// The team.
    pub team: String,
    /// The points of 10.
    pub points: f64,
    /// Why.
    pub reason: String,
}

impl File {
    /// Reads `grade.toml` in `folder`, and looks for programs if it names none. Returns the file and the teams.
    ///
    /// # Errors
    /// The file is wrong, or there are no teams.
    pub fn read(folder: &Path) -> Result<(Self, Vec<Team>), Failure> {
        let path = folder.join("grade.toml");
        let explain = |error: String| format!("{}: {error}", terminal::name(&path));
        let text =
            if path.exists() { regular(&path).and_then(|path| read_text(path, MAX_BYTES)) } else { Ok(String::new()) };
        let text = text.map_err(|error| explain(error.to_string()))?;
        let file: Self = toml::from_str(&text).map_err(|error| explain(error.to_string()))?;
        file.check().map_err(explain)?;
        let name = terminal::name(folder);
        let teams = if file.program.is_empty() {
            teams::found(folder).map_err(|error| format!("{name}: {error}"))?
        } else {
            teams::named(folder, &file.program)
        };
        if teams.is_empty() {
            let message = "there is no folder of a team in it, and no grade.toml that names a program";
            return Err(format!("{name}: {message}").into());
        }
        if let Some(penalty) = file.penalty.iter().find(|penalty| !teams.iter().any(|team| team.name == penalty.team)) {
            return Err(explain(format!(
                "[[penalty]]: there is no team [{}]",
                terminal::name(Path::new(&penalty.team))
            ))
            .into());
        }
        Ok((file, teams))
    }

    fn check(&self) -> Result<(), String> {
        let Weights { messages, pictures, time, energy } = self.points;
        let weights = [messages, pictures, time, energy];
        if !weights.iter().all(|&weight| (0.0..1e9).contains(&weight)) || messages + pictures + time <= 0.0 {
            return Err("[points]: the weights must not be negative, and one besides energy above 0".to_owned());
        }
        let shown = |name: &str| terminal::name(Path::new(name));
        for Timed { name, reference, zero, joules, joules_zero, .. } in &self.scene {
            for (least, reference, zero) in [(LEAST_REFERENCE, reference, zero), (0.0, joules, joules_zero)] {
                let ordered =
                    [Some(0.0), *reference, *zero, Some(1e9)].into_iter().flatten().is_sorted_by(|a, b| a < b);
                if !ordered || (zero.is_some() && reference.is_none()) {
                    let advice = "reference must be above 0, and zero above reference, which it needs";
                    return Err(format!("scene [{}]: {advice}", shown(name)));
                }
                if reference.is_some_and(|reference| reference < least) {
                    let advice = format!("the scene is too small to be timed: a reference has at least {least} s");
                    return Err(format!("scene [{}]: {advice}", shown(name)));
                }
            }
        }
        let own = self.case.iter().flat_map(|case| [Some(case.weight), case.maximum, case.rmse]).flatten();
        if !own.chain(self.penalty.iter().map(|penalty| penalty.points)).all(|value| (0.0..1e9).contains(&value)) {
            return Err("a weight, a bound or a penalty is negative, too large or no number".to_owned());
        }
        let programs = self.program.iter().map(|program| ("program", &program.name));
        let scenes = self.scene.iter().map(|scene| ("scene", &scene.name));
        let mut known = HashSet::new();
        for (what, name) in programs.chain(scenes).chain(self.case.iter().map(|case| ("case", &case.name))) {
            let is_team =
                what == "program" && self.program.iter().any(|program| program.name == *name && program.team.is_some());
            if name.is_empty()
                || name.contains('/')
                || name.starts_with('.')
                || (!known.insert((what, name)) && !is_team)
            {
                let advice = "a name must be unique, not empty, without / and without a point at its start";
                return Err(format!("{what} [{}]: {advice}", shown(name)));
            }
        }
        let empty = self.program.iter().find(|program| program.command.is_empty());
        empty.map_or(Ok(()), |program| Err(format!("program [{}]: its command is empty", shown(&program.name))))
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
            (format!("{program}{scene}reference = 0.001"), "too small to be timed"),
            (format!("{program}{scene}joules = 2\njoules_zero = 1"), "zero above reference"),
            (format!("{program}[[penalty]]\nteam = 'b'\npoints = 1\nreason = ''"), "there is no team [b]"),
            (format!("{program}[[penalty]]\nteam = 'a'\npoints = -1\nreason = ''"), "is negative"),
            ("[points]\ntime = -1".to_owned(), "must not be negative"),
            (String::new(), "there is no folder of a team in it"),
        ] {
            folder.write("grade.toml", &text);
            let message = File::read(folder.path()).expect_err(&text).message();
            assert!(message.as_ref().is_some_and(|message| message.contains(reason)), "{text}: {message:?}");
        }
        folder.write("grade.toml", format!("{program}{scene}reference = 1\nzero = 2"));
        assert!(File::read(folder.path()).is_ok(), "a program and a scene may have one name");
        let both = program.replace("command", "team = 't'\ncommand")
            + &program.replace("'a'", "'b'").replace("command", "team = 't'\ncommand");
        folder.write("grade.toml", both);
        let (_, teams) = File::read(folder.path()).expect("two programs of one team");
        assert_eq!((teams.len(), teams[0].programs.len()), (1, 2));
    }
}
