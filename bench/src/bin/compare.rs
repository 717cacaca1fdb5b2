//! `compare BASE NEW CONFIG SCENE ...`: times two programs in turn, each with its instruction set. bench/compare builds
//! and runs it.

use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Stdio};

use clap::Parser;
use cpu::internals::InstructionSet;
use measure::busy;
use measure::clock::seconds_of_children;
use measure::statistics::Median;
use measure::turns::{in_turn, ratio, turns_of};

/// Renders each scene with two programs in turn, and prints how much longer BASE takes than NEW: the median of the
/// rounds' ratios of user times, with its bounds. Both must write the same picture.
#[derive(Parser)]
#[command(
    name = "compare",
    term_width = 120,
    after_help = "\
Examples:
  bench/compare target/release/reference target/release/render-aos scenes/grid/config.txt scenes/grid/scene.txt
  bench/compare --set avx2 /tmp/render-aos-before target/release/render-aos scenes/grid/config.txt scenes/grid/scene.txt

Exit status: 0 compared, 1 a picture differs, 2 an error"
)]
struct Options {
    /// Number of rounds
    #[arg(long, value_name = "N", default_value_t = 5, value_parser = clap::value_parser!(u16).range(1..))]
    rounds: u16,
    /// Force an instruction set of both: avx512-throughout, avx512, avx2, neon, portable
    #[arg(long, value_name = "NAME", value_parser = known)]
    set: Option<String>,
    /// Force another one of BASE
    #[arg(long, value_name = "NAME", value_parser = known)]
    base_set: Option<String>,
    /// The program whose time is the numerator of the ratio
    base: PathBuf,
    /// The program that is compared with it
    new: PathBuf,
    /// The scenes
    #[arg(required = true, num_args = 2.., value_names = ["CONFIG", "SCENE"])]
    scenes: Vec<PathBuf>,
}

fn main() -> ExitCode {
    bench::main(run)
}

/// Checks that this machine has the instruction set. The programs ignore the name of a set that it lacks.
fn known(name: &str) -> Result<String, String> {
    let names: Vec<_> = InstructionSet::available().map(InstructionSet::name).collect();
    let message = || format!("this machine has no instruction set [{name}]; it has {}", names.join(", "));
    names.contains(&name).then(|| name.to_owned()).ok_or_else(message)
}

/// Compares the programs on all scenes. Returns whether all pictures are equal.
fn run(options: &Options) -> Result<bool, String> {
    let (scenes, []) = options.scenes.as_chunks::<2>() else {
        return Err("a scene is missing for the last configuration; see --help".to_owned());
    };
    if let Some(warning) = busy::warning(busy::load()) {
        eprintln!("{warning}");
    }
    let folder = std::env::temp_dir().join(format!("compare-{}", std::process::id()));
    std::fs::create_dir(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let result = compare(options, scenes, &folder);
    // The folder is in the system's place for temporary files, so it is no error if it stays.
    let _ = std::fs::remove_dir_all(&folder);
    result
}

fn compare(options: &Options, scenes: &[[PathBuf; 2]], folder: &Path) -> Result<bool, String> {
    let programs = [&options.base, &options.new];
    let sets = [options.base_set.as_ref().or(options.set.as_ref()), options.set.as_ref()];
    let rounds = usize::from(options.rounds);
    let mut all_equal = true;
    for [config, scene] in scenes {
        let render = |index: usize, out: &Path| {
            let mut command = Command::new(programs[index]);
            command.envs(sets[index].map(|set| ("RENDER_INSTRUCTION_SET", set)));
            let status = command.args([config, scene]).arg(out).stdout(Stdio::null()).status();
            let name = programs[index].display();
            match status {
                Ok(status) if status.success() => Ok(()),
                Ok(status) => Err(format!("{name} fails with {}: {status}", scene.display())),
                Err(error) => Err(format!("{name}: {error}")),
            }
        };
        let (mut turns, mut pictures) = (Vec::new(), Vec::new());
        for (index, program) in programs.iter().enumerate() {
            // Each program has its own file, so one that writes nothing is an error.
            let out = folder.join(format!("{index}.ppm"));
            let before = seconds_of_children();
            render(index, &out)?;
            turns.push(turns_of(seconds_of_children() - before));
            let failed = |error| format!("{} wrote no picture: {error}", program.display());
            pictures.push(
                std::fs::read(&out).and_then(|bytes| std::fs::remove_file(&out).map(|()| bytes)).map_err(failed)?,
            );
        }
        let times = in_turn(rounds, &turns, seconds_of_children, |index| render(index, Path::new("/dev/null")))?;
        let is_equal = pictures[0] == pictures[1];
        all_equal &= is_equal;
        let Median { median, low, high, .. } = ratio(&times[0], &times[1]);
        let seconds = [0, 1].map(|index| Median::of(&times[index]).median);
        println!(
            "{}: {median:.3} ({low:.3} to {high:.3}, {} rounds), {:.3} s and {:.3} s{}",
            scene.display(),
            rounds,
            seconds[0],
            seconds[1],
            if is_equal { "" } else { "; THE PICTURES DIFFER" }
        );
    }
    Ok(all_equal)
}
