//! Times two programs in turn that render the same scene.

use std::path::Path;
use std::process::{Command, Stdio};

use cpu::internals::InstructionSet;
use measure::clock::seconds_of_children;
use measure::statistics::Median;
use measure::turns::{in_turn, ratio, turns_of};

/// A program with the command line `CONFIG SCENE OUT`.
#[derive(Clone, Copy, Debug)]
pub struct Program<'a> {
    /// The program's file.
    pub path: &'a Path,
    /// The instruction set that it is told to use, or `None` for its own choice.
    pub set: Option<&'a str>,
}

/// The user times of two programs.
#[derive(Clone, Copy, Debug)]
pub struct Comparison {
    /// The median of the rounds' ratios: the first program's time over the second's.
    pub ratio: Median,
    /// The median user time of each, in seconds.
    pub seconds: [f64; 2],
    /// Whether both write the same picture.
    pub is_equal: bool,
}

/// Returns `name` if this machine has this instruction set. The programs ignore the name of a set that it lacks.
///
/// # Errors
/// A message with the names of the sets that it has.
pub fn known(name: &str) -> Result<String, String> {
    let names: Vec<_> = InstructionSet::available().map(InstructionSet::name).collect();
    let message = || format!("this machine has no instruction set [{name}]; it has {}", names.join(", "));
    names.contains(&name).then(|| name.to_owned()).ok_or_else(message)
}

impl Program<'_> {
    /// Renders a scene into the file `out`.
    ///
    /// # Errors
    /// A message if the program cannot be started or fails.
    pub fn render(&self, [config, scene]: [&Path; 2], out: &Path) -> Result<(), String> {
        let mut command = Command::new(self.path);
        command.envs(self.set.map(|set| ("RENDER_INSTRUCTION_SET", set)));
        let status = command.args([config, scene, out]).stdout(Stdio::null()).status();
        let name = self.path.display();
        match status {
            Ok(status) if status.success() => Ok(()),
            Ok(status) => Err(format!("{name} fails with {}: {status}", scene.display())),
            Err(error) => Err(format!("{name}: {error}")),
        }
    }
}

/// Renders a scene with both programs, and then times them in turn. `folder` is a place for their pictures.
///
/// # Errors
/// A message if a program fails or writes no picture.
pub fn compare(programs: &[Program; 2], files: [&Path; 2], rounds: usize, folder: &Path) -> Result<Comparison, String> {
    let (mut turns, mut pictures) = (Vec::new(), Vec::new());
    for (index, program) in programs.iter().enumerate() {
        // Each program has its own file, so one that writes nothing is an error.
        let out = folder.join(format!("{index}.ppm"));
        let before = seconds_of_children();
        program.render(files, &out)?;
        turns.push(turns_of(seconds_of_children() - before));
        let failed = |error| format!("{} wrote no picture: {error}", program.path.display());
        pictures
            .push(std::fs::read(&out).and_then(|bytes| std::fs::remove_file(&out).map(|()| bytes)).map_err(failed)?);
    }
    let render = |index: usize| programs[index].render(files, Path::new("/dev/null"));
    let times = in_turn(rounds, &turns, seconds_of_children, render)?;
    let seconds = [0, 1].map(|index| Median::of(&times[index]).median);
    Ok(Comparison { ratio: ratio(&times[0], &times[1]), seconds, is_equal: pictures[0] == pictures[1] })
}
