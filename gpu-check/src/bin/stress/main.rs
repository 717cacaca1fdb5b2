//! `stress --out FOLDER`: runs the whole stress test of the intersections, in Rust and in WGSL, and writes its tables
//! into a folder. `stress --help` lists all options.

mod tables;

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

use clap::Parser;
use cpu::{Config, Scatter, Scene};
use gpu_check::{Gpu, terminal};
use output::{Options, Output};
use stability::methods::{self, EXACT, PROJECTED};
use stability::observed::Counts;
use stability::regimes;
use stability::report::{self, Picture, Section};
use stability::run::{self, LargeSpheres};

/// Compares the intersections, in Rust and in WGSL, with exact arithmetic, and writes tables of the results.
#[derive(Debug, Parser)]
#[command(
    name = "stress",
    max_term_width = 120,
    after_help = "\
Examples:
  stress --out /tmp/accuracy                 minutes; nothing else is written
  stress --out /tmp/accuracy --rays 2000     seconds, to see what it writes
  stress --out docs/accuracy --case case-1 ../shared/reference/config1.txt ../shared/reference/scene1.txt ...
                                             rewrites the tables there; name every case that pictures.csv has
  cargo run --release -p lab --example charts docs/accuracy      draws the tables

Exit status: 0 no decision of the exact intersection is wrong, and no error of its lambda is above the proved bound;
               the projected form has no wrong decision beyond 8 roundings of distance + size
             1 one of these does not hold; the tables are written all the same
             2 an error, such as a file that cannot be written"
)]
struct Arguments {
    /// Folder for the results: tables (CSV), and run.txt, which says how they were made
    #[arg(long, value_name = "FOLDER")]
    out: PathBuf,
    /// Rays of each regime
    #[arg(long, default_value_t = 100_000, value_parser = count)]
    rays: usize,
    /// Seed of all random numbers
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// A picture to render beside those of tests/cases; may be repeated
    #[arg(long, num_args = 3, value_names = ["NAME", "CONFIG", "SCENE"])]
    case: Vec<String>,
}

/// Smallest number of rays of a regime. With fewer rays, some regimes would have no hit.
const FEWEST_RAYS: usize = 1000;

fn count(text: &str) -> Result<usize, String> {
    let number = text.parse().ok().filter(|&count| count >= FEWEST_RAYS);
    number.ok_or_else(|| format!("a whole number from {FEWEST_RAYS} on is needed"))
}

/// What the program looks for: a decision that is wrong, or an error of lambda that is not within its bound.
#[derive(Debug, thiserror::Error)]
#[error("{0}")]
struct Wrong(String);

/// The exit status for an error of [`run()`].
fn status(error: &(dyn Error + 'static)) -> u8 {
    if error.is::<Wrong>() { 1 } else { 2 }
}

fn main() -> ExitCode {
    gpu_check::runtime::ensure_folder();
    // From here on, a signal that ends the process first removes the temporary files.
    output::stop::remove_temporary_when_stopped();
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(answer) => return terminal::answer(&answer),
    };
    match run(&arguments) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            terminal::note(&format!("Error: {error}"));
            ExitCode::from(status(&*error))
        }
    }
}

fn run(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    let Arguments { out, rays, seed, case } = arguments;
    let (rays, seed) = (*rays, *seed);
    let folder = out;
    // Checked before the run, which takes minutes and replaces the tables.
    let pictures_file = folder.join("pictures.csv");
    tables::check_that_no_row_goes(&pictures_file, case)
        .map_err(|message| format!("{}: {message}", pictures_file.display()))?;
    fs::create_dir_all(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    Output::open(&pictures_file, Options { sync: true })?;

    let gpu = Gpu::open()?;
    let device = gpu.to_string();
    terminal::print(&format!("{device}\n"))?;
    let mut methods = methods::all();
    methods.extend(gpu_check::methods::all(gpu)?);

    let spheres = run::sections(&methods, &regimes::SPHERES, seed, rays)?;
    let cylinders = run::sections(&methods, &regimes::CYLINDERS, seed, rays)?;
    print_costs(&spheres)?;
    print_costs(&cylinders)?;
    let kinds: [(&str, &[Section]); 2] = [("sphere", &spheres), ("cylinder", &cylinders)];
    tables::put(&folder.join("errors.csv"), &report::errors(&kinds))?;
    tables::put(&folder.join("costs.csv"), &report::costs(&kinds))?;
    let large = LargeSpheres::new(&methods, seed, rays)?;
    tables::put(&folder.join("large-spheres.csv"), &report::large_spheres(&large.radii, &large.wrong))?;
    for method in [PROJECTED, gpu_check::methods::PROJECTED, EXACT] {
        let (never, seldom) = (large.limit(method, 0.0), large.limit(method, 1e-3));
        terminal::print(&format!(
            "{method}: no ray that leaves a sphere is wrong up to a radius of {never}, at most one in a thousand up \
             to {seldom}\n"
        ))?;
    }
    tables::put(&pictures_file, &report::pictures(&pictures(case)?))?;
    tables::put(&folder.join("run.txt"), &run_text(arguments, &device)?)?;
    terminal::print(&format!("wrote {}\n", folder.display()))?;

    let checked = [0, 1].map(|index| run::check(kinds[index].0, kinds[index].1, run::PROVEN_ERRORS[index]));
    for row in [&spheres, &cylinders].into_iter().flat_map(|sections| run::parted_from_their_twins(sections)) {
        let (regime, method) = (row.regime, row.method);
        terminal::print(&format!("{regime}, {method}: not the figures of the same formulas in Rust\n"))?;
    }
    let [spheres, cylinders] = match checked {
        [Ok(spheres), Ok(cylinders)] => [spheres, cylinders],
        failed => {
            let messages: Vec<_> = failed.into_iter().filter_map(Result::err).collect();
            return Err(Wrong(messages.join("\n")).into());
        }
    };
    let summary = format!("exact: 0 wrong; plain: {spheres} spheres and {cylinders} cylinders wrong\n");
    Ok(terminal::print(&summary)?)
}

/// Returns the text that says how the tables were made: the command, the date, the commit and the machine.
fn run_text(Arguments { rays, seed, case, .. }: &Arguments, device: &str) -> Result<String, Box<dyn Error>> {
    let mut command =
        format!("cargo run --release -p gpu-check --bin stress -- --out FOLDER --rays {rays} --seed {seed}");
    for triple in case.chunks_exact(3) {
        command += &format!(" --case {} CONFIG SCENE", triple[0]);
    }
    let date = said_by("date", &["-u", "+%F"])?;
    let commit = said_by("git", &["describe", "--always", "--dirty", "--abbrev=12", "--exclude=*"])?;
    let about = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let processor = about.lines().find_map(|line| line.strip_prefix("model name")?.split_once(": "));
    let processor = processor.map_or("unknown", |(_, name)| name);
    Ok(format!("command: {command}\ndate: {date}\ncommit: {commit}\nprocessor: {processor}\nWGSL: {device}\n"))
}

/// Runs a program and returns its first line of output, or `unknown` if the program fails.
fn said_by(program: &str, arguments: &[&str]) -> Result<String, Box<dyn Error>> {
    let output = Command::new(program).args(arguments).output()?;
    let text = String::from_utf8(output.stdout)?;
    Ok(text.lines().next().filter(|_| output.status.success()).unwrap_or("unknown").to_owned())
}

fn print_costs(sections: &[Section]) -> Result<(), output::Error> {
    let rows = sections.iter().flat_map(|section| &section.rows);
    let lines = rows.map(|row| format!("{:36} {:18} {:8.1} ns a test\n", row.regime, row.method, row.nanoseconds));
    terminal::print(&lines.collect::<String>())
}

/// Renders the pictures and returns their counts. The first entry adds up all pictures of `tests/cases`. The others are
/// the pictures of `--case`.
fn pictures(others: &[String]) -> Result<Vec<Picture>, Box<dyn Error>> {
    let mut pictures = Vec::new();
    let mut all = Picture { name: tables::CASES_OF_THE_TESTS.into(), counts: Counts::default(), same_bytes: true };
    let folder = Path::new("tests/cases");
    let cases = fs::read_dir(folder)
        .map_err(|error| format!("{}: {error}; run this program in the folder of the project", folder.display()))?;
    for entry in cases {
        let path = entry?.path();
        if path.is_dir() {
            let picture = render("", &path.join("config.txt"), &path.join("scene.txt"))?;
            all.counts = all.counts.with(&picture.counts);
            all.same_bytes &= picture.same_bytes;
        }
    }
    pictures.push(all);
    for triple in others.chunks_exact(3) {
        pictures.push(render(&triple[0], Path::new(&triple[1]), Path::new(&triple[2]))?);
    }
    Ok(pictures)
}

fn render(name: &str, config: &Path, scene: &Path) -> Result<Picture, cpu::Error> {
    run::picture(name, &Config::read(config)?, &Scene::read(scene)?, Scatter::Statement)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_wrong_decision_has_status_1_and_an_error_has_2() {
        assert_eq!(status(&Wrong("ordinary: 1 wrong".to_owned())), 1);
        assert_eq!(status(&std::io::Error::other("no space")), 2);
    }
}
