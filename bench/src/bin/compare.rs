//! `compare BASE NEW CONFIG SCENE ...`: times two programs in turn, each with its instruction set. bench/compare builds
//! and runs it.

use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Stdio};

use cpu::internals::InstructionSet;
use measure::busy;
use measure::clock::seconds_of_children;
use measure::statistics::Median;
use measure::turns::{in_turn, ratio, turns_of};

const USAGE: &str = "\
compare [--rounds N] [--set NAME] [--base-set NAME] BASE NEW CONFIG SCENE [CONFIG SCENE ...]
Renders each scene with two programs in turn, and prints how much longer BASE takes than NEW: the median of the rounds'
ratios of user times, with its bounds. Both must write the same picture.

  --rounds N        number of rounds (5)
  --set NAME        force an instruction set of both: avx512-throughout, avx512, avx2, neon, portable
  --base-set NAME   force another one of BASE

Examples:
  bench/compare target/release/reference target/release/render-aos scenes/grid/config.txt scenes/grid/scene.txt
  bench/compare --set avx2 /tmp/render-aos-before target/release/render-aos scenes/grid/config.txt scenes/grid/scene.txt

Exit status: 0 compared, 1 a picture differs, 2 an error";

/// What the command line asks for.
struct Options {
    rounds: usize,
    /// The instruction sets of the base and of the new program.
    sets: [Option<String>; 2],
    programs: [PathBuf; 2],
    /// Configurations and scenes.
    scenes: Vec<[PathBuf; 2]>,
}

fn main() -> ExitCode {
    let arguments: Vec<_> = std::env::args().skip(1).collect();
    if arguments.iter().any(|argument| argument == "--help") {
        println!("{USAGE}");
        return ExitCode::SUCCESS;
    }
    match options(&arguments).and_then(|options| run(&options)) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(message) => {
            eprintln!("Error: {message}");
            ExitCode::from(2)
        }
    }
}

fn options(arguments: &[String]) -> Result<Options, String> {
    let mut names = Vec::new();
    let (mut rounds, mut set, mut base_set) = (5, None, None);
    let mut arguments = arguments.iter();
    while let Some(argument) = arguments.next() {
        let mut value = || arguments.next().ok_or(format!("{argument} needs a value; see --help"));
        match argument.as_str() {
            "--rounds" => {
                let text = value()?;
                let number = text.parse().ok().filter(|&number| number > 0);
                rounds = number.ok_or(format!("--rounds: [{text}] is not a number of rounds; see --help"))?;
            }
            "--set" => set = Some(known(value()?)?),
            "--base-set" => base_set = Some(known(value()?)?),
            _ if argument.starts_with('-') => return Err(format!("there is no option [{argument}]; see --help")),
            _ => names.push(PathBuf::from(argument)),
        }
    }
    let (pairs, rest) = names.as_chunks::<2>();
    match pairs {
        [programs, scenes @ ..] if !scenes.is_empty() && rest.is_empty() => {
            let sets = [base_set.or_else(|| set.clone()), set];
            Ok(Options { rounds, sets, programs: programs.clone(), scenes: scenes.to_vec() })
        }
        _ => Err("two programs, and pairs of a configuration and a scene, are needed; see --help".to_owned()),
    }
}

/// Checks that this machine has the instruction set. The programs ignore the name of a set that it lacks.
fn known(name: &str) -> Result<String, String> {
    let names: Vec<_> = InstructionSet::available().map(InstructionSet::name).collect();
    let message = || format!("this machine has no instruction set [{name}]; it has {}", names.join(", "));
    names.contains(&name).then(|| name.to_owned()).ok_or_else(message)
}

/// Compares the programs on all scenes. Returns whether all pictures are equal.
fn run(options: &Options) -> Result<bool, String> {
    if let Some(warning) = busy::warning(busy::load()) {
        eprintln!("{warning}");
    }
    let folder = std::env::temp_dir().join(format!("compare-{}", std::process::id()));
    std::fs::create_dir(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let result = compare(options, &folder);
    // The folder is in the system's place for temporary files, so it is no error if it stays.
    let _ = std::fs::remove_dir_all(&folder);
    result
}

fn compare(options: &Options, folder: &Path) -> Result<bool, String> {
    let mut all_equal = true;
    for [config, scene] in &options.scenes {
        let render = |index: usize, out: &Path| {
            let mut command = Command::new(&options.programs[index]);
            if let Some(set) = &options.sets[index] {
                command.env("RENDER_INSTRUCTION_SET", set);
            }
            let status = command.args([config, scene]).arg(out).stdout(Stdio::null()).status();
            let name = options.programs[index].display();
            match status {
                Ok(status) if status.success() => Ok(()),
                Ok(status) => Err(format!("{name} fails with {}: {status}", scene.display())),
                Err(error) => Err(format!("{name}: {error}")),
            }
        };
        let (mut turns, mut pictures) = (Vec::new(), Vec::new());
        for index in 0..2 {
            // Each program has its own file, so one that writes nothing is an error.
            let out = folder.join(format!("{index}.ppm"));
            let before = seconds_of_children();
            render(index, &out)?;
            turns.push(turns_of(seconds_of_children() - before));
            let failed = |error| format!("{} wrote no picture: {error}", options.programs[index].display());
            pictures.push(
                std::fs::read(&out).and_then(|bytes| std::fs::remove_file(&out).map(|()| bytes)).map_err(failed)?,
            );
        }
        let times =
            in_turn(options.rounds, &turns, seconds_of_children, |index| render(index, Path::new("/dev/null")))?;
        let is_equal = pictures[0] == pictures[1];
        all_equal &= is_equal;
        let Median { median, low, high, .. } = ratio(&times[0], &times[1]);
        let seconds = [0, 1].map(|index| Median::of(&times[index]).median);
        println!(
            "{}: {median:.3} ({low:.3} to {high:.3}, {} rounds), {:.3} s and {:.3} s{}",
            scene.display(),
            options.rounds,
            seconds[0],
            seconds[1],
            if is_equal { "" } else { "; THE PICTURES DIFFER" }
        );
    }
    Ok(all_equal)
}
