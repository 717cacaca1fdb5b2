//! `record --out FOLDER [--rounds N]`: measures the renderer, adds the times to the records of a folder, and compares
//! them with the last record there. `bench/record` is the folder of the committed records.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};
use std::{fs, io};

use bench::record::{Record, Time, latest};
use bench::time::{median, seconds_of};
use cpu::internals::{InstructionSet, Prepared, render_with};
use cpu::{Aos, Config, Scatter, Scene};
use generator::{self, Arrangement, Options};
use test_support::{golden, project_root};

const USAGE: &str = "\
record --out FOLDER [--rounds N]
Measures the renderer on the course's cases, if the reference folder is there, and on generated scenes, with every
instruction set of this machine. Writes FOLDER/DATE-MACHINE.json, and prints the quotients new / old with the last
record in FOLDER of this machine, or of another machine where there is none.

Examples:
  cargo run --release -p bench --bin record -- --out /tmp/record
  cargo run --release -p bench --bin record -- --out bench/record --rounds 9   adds to the committed records";

/// The name of a scene, and the scene prepared for rendering.
type Measured = (String, Prepared<Aos>);

fn main() -> ExitCode {
    match run(&std::env::args().skip(1).collect::<Vec<_>>()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("Error: {error}");
            ExitCode::from(2)
        }
    }
}

fn run(arguments: &[String]) -> io::Result<()> {
    let (mut rounds, mut folder) = (9, None);
    let mut rest = arguments.iter();
    while let Some(option) = rest.next() {
        let value = rest.next();
        match (option.as_str(), value) {
            ("--help", _) => {
                println!("{USAGE}");
                return Ok(());
            }
            ("--rounds", Some(count)) => {
                rounds = count
                    .parse()
                    .ok()
                    .filter(|&rounds| rounds > 0)
                    .ok_or(io::Error::other("--rounds must be a whole number above 0; see --help"))?;
            }
            ("--out", Some(path)) => folder = Some(PathBuf::from(path)),
            _ => return Err(io::Error::other(format!("[{option}] is not an option with a value; see --help"))),
        }
    }
    InstructionSet::named().map_err(io::Error::other)?;
    // Nothing is written into the project unless its folder is named.
    let folder = folder.ok_or(io::Error::other("--out FOLDER is missing; see --help"))?;
    let record = Record {
        date: output_of("date", &["-u", "+%F"])?,
        processor: processor()?,
        commit: output_of("git", &["describe", "--always", "--dirty", "--abbrev=12", "--exclude=*"])?,
        compiler: output_of("rustc", &["--version"])?,
        load: load()?,
        rounds,
        times: measure(&scenes()?, rounds)?,
    };
    fs::create_dir_all(&folder)?;
    let path = folder.join(record.file_name());
    let last = latest(&folder, &path, &record.processor)?;
    fs::write(&path, serde_json::to_string_pretty(&record)? + "\n")?;
    println!("{}", path.display());
    match last {
        Some(last) => print!("{}", record.compared_with(&last)),
        None => println!("There is no other record to compare with."),
    }
    Ok(())
}

/// Returns the scenes to measure. Their sizes are chosen so that each picture takes about a tenth of a second.
fn scenes() -> io::Result<Vec<Measured>> {
    let mut measured = Vec::new();
    let folder = golden::reference_folder();
    if folder.is_dir() {
        for case in 1..=4 {
            let read = |file: &str| fs::read(folder.join(format!("{file}{case}.txt")));
            let config = Config::parse(&read("config")?[..]).map_err(io::Error::other)?;
            let scene = Scene::parse(&read("scene")?[..]).map_err(io::Error::other)?;
            let config = Config { image_width: if case == 1 { 400 } else { 160 }, samples_per_pixel: 20, ..config };
            measured.push((format!("case {case}"), prepare(&config, &scene)?));
        }
    } else {
        println!("The course's cases are left out: there is no folder {}.", folder.display());
    }
    for objects in [16_u16, 200, 1_000, 10_000] {
        let extent = f64::from(objects).sqrt();
        let options = Options { objects: objects.into(), extent, arrangement: Arrangement::Grid, ..Options::default() };
        let config = Config { image_width: 160, samples_per_pixel: 20, ..generator::view(&options) };
        measured.push((format!("{objects} objects"), prepare(&config, &generator::scene(&options))?));
    }
    Ok(measured)
}

fn prepare(config: &Config, scene: &Scene) -> io::Result<Prepared<Aos>> {
    Prepared::new(config, scene, Scatter::Statement).map_err(io::Error::other)
}

/// Returns the times of all scenes with all instruction sets, by scene and then by instruction set. Each round renders
/// every scene once with every instruction set, and the yardstick once before each scene.
fn measure(scenes: &[Measured], rounds: usize) -> io::Result<BTreeMap<String, BTreeMap<String, Time>>> {
    let sets: Vec<_> = InstructionSet::available().collect();
    let yardstick = yardstick()?;
    let mut seconds = vec![Vec::new(); scenes.len() * sets.len()];
    let mut relative = seconds.clone();
    for round in 0..rounds {
        eprintln!("round {} of {rounds}", round + 1);
        for (index, (_, prepared)) in scenes.iter().enumerate() {
            let unit = yardstick();
            for (number, &set) in sets.iter().enumerate() {
                let time = seconds_of(|| drop(std::hint::black_box(render_with(prepared, set))));
                seconds[index * sets.len() + number].push(time);
                relative[index * sets.len() + number].push(time / unit);
            }
        }
    }
    let mut medians = seconds.into_iter().zip(relative);
    let mut times = BTreeMap::new();
    for (name, _) in scenes {
        let of_scene: BTreeMap<_, _> = sets
            .iter()
            .zip(medians.by_ref())
            .map(|(set, (seconds, relative))| {
                (set.name().to_owned(), Time { seconds: median(seconds), relative: median(relative) })
            })
            .collect();
        times.insert(name.clone(), of_scene);
    }
    Ok(times)
}

/// Returns a function that renders the yardstick's picture with the reference, and returns the time that this takes, in
/// seconds. The other times are compared with it.
fn yardstick() -> io::Result<impl Fn() -> f64> {
    let golden = golden::cases().swap_remove(0);
    let config = Config::parse(&fs::read(&golden.config)?[..]).map_err(io::Error::other)?;
    let scene = Scene::parse(&fs::read(&golden.scene)?[..]).map_err(io::Error::other)?;
    let render = move || {
        let image = cpu::reference::render::<<Aos as cpu::Layout>::Image>(&config, &scene, Scatter::Statement);
        std::hint::black_box(image).expect("the case can be rendered");
    };
    Ok(move || seconds_of(&render))
}

/// Returns the standard output of a command, without blanks at its ends.
fn output_of(program: &str, arguments: &[&str]) -> io::Result<String> {
    let output = Command::new(program).args(arguments).current_dir(project_root()).output()?;
    let text = String::from_utf8_lossy(&output.stdout).trim().to_owned();
    if output.status.success() { Ok(text) } else { Err(io::Error::other(format!("{program} fails"))) }
}

fn processor() -> io::Result<String> {
    let text = fs::read_to_string("/proc/cpuinfo")?;
    let mut names = text.lines().filter_map(|line| line.strip_prefix("model name"));
    Ok(names.next().map_or("unknown", |name| name.trim_matches([' ', '\t', ':'])).to_owned())
}

fn load() -> io::Result<f64> {
    let text = fs::read_to_string(Path::new("/proc/loadavg"))?;
    text.split(' ').next().and_then(|load| load.parse().ok()).ok_or(io::Error::other("/proc/loadavg has no load"))
}
