//! `nearest [--sizes N,…] [--rounds N] [--rays N] [--set NAME] [--json FILE]`: compares the time of a nearest hit with
//! Embree's. `bench/nearest` runs it.

use std::path::PathBuf;
use std::process::ExitCode;
use std::str::FromStr;

use bench::nearest::embree;
use bench::nearest::measure::{Options, Results};
use bench::nearest::scene::Setting;
use bench::nearest::table::markdown;
use cpu::internals::InstructionSet;
use output::Output;

const USAGE: &str = "\
nearest [--sizes N,...] [--rounds N] [--rays N] [--set avx512|avx2] [--json FILE]
Compares the time of a nearest hit of an incoherent ray with Embree 3: the structure that the renderer chooses, with
the hits of exact arithmetic in double precision, and rtcIntersect1 in single precision with a structure of high
quality. The scenes are spheres in a cube, sparse and dense, on a ground and without one. The rays start on surfaces,
or anywhere (free). As in a picture, the record of the sphere on which a ray starts is in a near cache.

Prints two tables in Markdown: the median user time of a ray, and the time and memory of each structure. Without
Embree (Debian: libembree-dev) only our side is measured. The status is 1 if less than 99.99 % of the rays of a row hit
the same object on both sides. Embree's self-hits are left out of this share and counted: by rounding, its ray hits the
object on which it starts.

  --sizes   numbers of spheres; by default 33 to 1000000
  --rounds  measurements of each time, in turn; by default 9
  --rays    rays in each measurement, each at another place; by default 200000
  --set     one instruction set; by default all of this machine
  --json    a file for the results

Examples:
  cargo run --release -p bench --bin nearest
  cargo run --release -p bench --bin nearest -- --sizes 33,1000 --rounds 3 --set avx2";

/// The sizes without `--sizes`.
const SIZES: [usize; 10] = [33, 100, 300, 1_000, 3_000, 10_000, 30_000, 100_000, 300_000, 1_000_000];

struct CommandLine {
    sizes: Vec<usize>,
    options: Options,
    json: Option<PathBuf>,
}

fn main() -> ExitCode {
    let arguments: Vec<_> = std::env::args().skip(1).collect();
    if arguments.iter().any(|argument| argument == "--help") {
        println!("{USAGE}");
        return ExitCode::SUCCESS;
    }
    match parse(&arguments).and_then(|command| run(&command)) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("Error: {error}");
            ExitCode::from(2)
        }
    }
}

/// Measures and prints. Returns whether enough hits agree in every row.
fn run(command: &CommandLine) -> Result<bool, String> {
    InstructionSet::named()?;
    // A file that cannot be written is found before the measurement.
    let open = |path: &PathBuf| Output::open(path, output::Options::default()).map_err(|error| error.to_string());
    let json = command.json.as_ref().map(open).transpose()?;
    if let Some(reason) = embree::missing() {
        println!("Embree is ignored: {reason}.\n");
    }
    let settings: Vec<_> = command.sizes.iter().flat_map(|&size| Setting::all(size)).collect();
    let mut results = Results::default();
    for (index, &setting) in settings.iter().enumerate() {
        eprintln!("scene {} of {}", index + 1, settings.len());
        results.add(setting, &command.options)?;
    }
    print!("{}", markdown(&results));
    if let Some(file) = json {
        let text = serde_json::to_string_pretty(&results).map_err(|error| error.to_string())? + "\n";
        file.fill(|file| file.write_all(text.as_bytes())).map_err(|error| error.to_string())?;
    }
    for time in results.disagreements() {
        eprintln!("Too few hits agree: {time:?}");
    }
    Ok(results.disagreements().next().is_none())
}

fn parse(arguments: &[String]) -> Result<CommandLine, String> {
    let options = Options { rounds: 9, rays: 200_000, sets: sets(), embree: embree::missing().is_none() };
    let mut command = CommandLine { sizes: SIZES.to_vec(), options, json: None };
    let mut rest = arguments.iter();
    while let Some(option) = rest.next() {
        let value = rest.next().ok_or(format!("[{option}] is not an option with a value; see --help"))?;
        match option.as_str() {
            "--sizes" => {
                command.sizes = value.split(',').map(|size| number(option, size)).collect::<Result<_, _>>()?;
            }
            "--rounds" => command.options.rounds = number(option, value)?,
            "--rays" => command.options.rays = number(option, value)?,
            "--set" => command.options.sets.retain(|(name, _)| name == value),
            "--json" => command.json = Some(value.into()),
            _ => return Err(format!("[{option}] is not an option; see --help")),
        }
    }
    if command.options.sets.is_empty() {
        return Err("this machine has no such instruction set; see --help".to_owned());
    }
    Ok(command)
}

/// Returns a whole number from 1 to 10,000,000.
fn number(option: &str, text: &str) -> Result<usize, String> {
    let number = usize::from_str(text).ok().filter(|number| (1..=10_000_000).contains(number));
    number.ok_or(format!("[{text}] for {option} is no whole number from 1 to 10000000; see --help"))
}

/// Returns the instruction sets that both sides have on this machine, by Embree's names. With AVX-512 ours is the one
/// that the renderer chooses.
fn sets() -> Vec<(&'static str, InstructionSet)> {
    let best = InstructionSet::best();
    let is_512 = matches!(best, InstructionSet::Avx512 | InstructionSet::Avx512Throughout);
    let avx2 = InstructionSet::Avx2;
    is_512.then_some(("avx512", best)).into_iter().chain(avx2.is_available().then_some(("avx2", avx2))).collect()
}
