//! `cliffs LITERAL OURS`: searches families of scenes for those on which the renderer gains least over the literal
//! program. bench/cliffs builds and runs it.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use bench::families::{FAMILIES, Family, FamilyScene, PROPERTIES, Point};
use bench::programs::{Comparison, Program, compare, known};
use clap::Parser;
use cpu::internals::counters::{Counter, reset, snapshot};
use cpu::internals::sampling::uniform::Uniform;
use cpu::internals::{InstructionSet, Prepared};
use cpu::reference::{Exact, render_with};
use cpu::{Aos, Config, Layout, Scatter, Scene};
use measure::busy;

/// Searches each family of scenes for the one with the smallest ratio of the literal program's user time to ours. Each
/// search begins at random points, and then changes the worst one in ever smaller steps.
///
/// Prints two lines for the worst scene of each family. The first has the ratio, with its bounds, and both times. It
/// says so if the pictures differ. The second is about a small picture: how many intersections the compensated formulas
/// decide and how many need dyadic arithmetic, misses included, how many comparisons of hits are near or need
/// exact arithmetic, and how many tests are made without a filter, each divided by the number of hits; and whether the
/// picture is that of the exact reference.
#[derive(Parser)]
#[command(
    name = "cliffs",
    term_width = 120,
    after_help = "\
Examples:
  bench/cliffs                             # all families; ten minutes
  bench/cliffs --family tube --set avx2    # one of them, with an instruction set

Exit status: 0 every family has at least the literal program's speed and the reference's pictures, 1 one has not,
2 an error"
)]
struct Options {
    /// Search only this family; may be repeated
    #[arg(long, value_name = "NAME", value_parser = named)]
    family: Vec<String>,
    /// Force an instruction set: avx512-throughout, avx512, avx2, neon, portable
    #[arg(long, value_name = "NAME", value_parser = known)]
    set: Option<String>,
    /// The seed of the random points
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,
    /// Number of random points in a family
    #[arg(long, value_name = "N", default_value_t = 12, value_parser = clap::value_parser!(u16).range(1..))]
    points: u16,
    /// Number of changes of the worst point
    #[arg(long, value_name = "N", default_value_t = 12)]
    steps: u16,
    /// Write the files of the worst scenes to this folder
    #[arg(long, value_name = "FOLDER")]
    out: Option<PathBuf>,
    /// The literal program
    literal: PathBuf,
    /// The program that is compared with it
    ours: PathBuf,
}

fn main() -> ExitCode {
    bench::main(run)
}

fn named(name: &str) -> Result<String, String> {
    let names = FAMILIES.iter().map(|family| family.name).collect::<Vec<_>>();
    let message = || format!("there is no family [{name}]; there are {}", names.join(", "));
    names.contains(&name).then(|| name.to_owned()).ok_or_else(message)
}

/// Searches the families, and prints the worst scene of each. Returns whether each has a ratio of at least 1, and the
/// reference's picture.
fn run(options: &Options) -> Result<bool, String> {
    if let Some(warning) = busy::warning(busy::load()) {
        eprintln!("{warning}");
    }
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let mut is_fast = true;
    for family in FAMILIES {
        if options.family.is_empty() || options.family.iter().any(|name| name == family.name) {
            is_fast &= search(options, family, folder.path())?;
        }
    }
    Ok(is_fast)
}

/// The smallest user time of the literal program that is measured, in seconds.
const SHORTEST: f64 = 0.05;
/// The width of the pictures.
const WIDTH: usize = 100;
/// The width of the small pictures that are compared with the exact reference, with one sample in each pixel.
const SMALL: usize = 32;

/// Searches one family. Returns whether the worst scene has a ratio of at least 1, and the reference's picture.
fn search(options: &Options, family: &Family, folder: &Path) -> Result<bool, String> {
    let mut draws = Uniform::new(options.seed);
    let mut worst: Option<(Point, Comparison, usize)> = None;
    for number in 0..options.points + options.steps {
        let point: Point = match &worst {
            Some((point, ..)) if number >= options.points => {
                let step = 0.5_f64.powf(1.0 + 4.0 * f64::from(number - options.points) / f64::from(options.steps));
                std::array::from_fn(|at| (point[at] + draws.draw(-step, step)).clamp(0.0, 1.0))
            }
            _ => [(); PROPERTIES].map(|()| draws.canonical()),
        };
        let Some((comparison, samples)) = measure(options, &(family.scene)(point), 3, folder)? else { continue };
        if worst.as_ref().is_none_or(|(_, worst, _)| comparison.ratio.median < worst.ratio.median) {
            worst = Some((point, comparison, samples));
        }
    }
    let Some((point, ..)) = worst else {
        println!("{}: the literal program takes less than {SHORTEST} s with every scene", family.name);
        return Ok(true);
    };
    let scene = (family.scene)(point);
    // The smallest of many ratios is too small by chance, so the worst scene is measured again.
    let (comparison, samples) =
        measure(options, &scene, 7, folder)?.ok_or("the time of the worst scene has changed")?;
    let Comparison { ratio, seconds, is_equal } = comparison;
    println!(
        "{}: {:.2} ({:.2} to {:.2}), {:.3} s and {:.3} s, {}{}",
        family.name,
        ratio.median,
        ratio.low,
        ratio.high,
        seconds[0],
        seconds[1],
        scene.properties,
        if is_equal { "" } else { "; another picture than the literal program's" }
    );
    let (counts, is_right) = counts(&scene, options.set.as_deref())?;
    println!("    {counts}");
    if let Some(out) = &options.out {
        write(&scene, samples, out, family.name)?;
    }
    Ok(ratio.median >= 1.0 && is_right)
}

/// Times both programs with a scene, with as many samples as the literal program needs to take long enough. Returns the
/// comparison and the number of samples, or `None` if even 1,000 samples do not take that long.
fn measure(
    options: &Options,
    scene: &FamilyScene,
    rounds: usize,
    folder: &Path,
) -> Result<Option<(Comparison, usize)>, String> {
    let programs =
        [Program { path: &options.literal, set: None }, Program { path: &options.ours, set: options.set.as_deref() }];
    const MOST_SAMPLES: usize = 1_000;
    let mut samples = 1;
    loop {
        let [config, text] = write(scene, samples, folder, "scene")?;
        let before = measure::clock::seconds_of_children();
        programs[0].render([&config, &text], Path::new("/dev/null"))?;
        let seconds = measure::clock::seconds_of_children() - before;
        if seconds >= SHORTEST {
            return Ok(Some((compare(&programs, [&config, &text], rounds, folder)?, samples)));
        }
        if samples == MOST_SAMPLES {
            return Ok(None);
        }
        let factor = (1.3 * SHORTEST / seconds.max(0.001)).clamp(2.0, 50.0).ceil() as usize;
        samples = (samples * factor).min(MOST_SAMPLES);
    }
}

/// Writes the two files of a scene. Returns their paths.
fn write(scene: &FamilyScene, samples: usize, folder: &Path, name: &str) -> Result<[PathBuf; 2], String> {
    let paths = ["config", "scene"].map(|kind| folder.join(format!("{name}-{kind}.txt")));
    let failed = |error| format!("{}: {error}", folder.display());
    std::fs::create_dir_all(folder).map_err(failed)?;
    std::fs::write(&paths[0], scene.config(WIDTH, samples)).map_err(failed)?;
    std::fs::write(&paths[1], &scene.scene).map_err(failed)?;
    Ok(paths)
}

/// Renders a small picture with the instruction set of this name, or with the chosen one. Returns which step decided
/// how many intersections, in words, and whether the picture is that of the exact reference.
fn counts(scene: &FamilyScene, set: Option<&str>) -> Result<(String, bool), String> {
    let named = InstructionSet::available().find(|known| Some(known.name()) == set);
    let set = named.unwrap_or_else(InstructionSet::chosen);
    let config = Config::parse(scene.config(SMALL, 1).as_bytes()).map_err(|error| error.to_string())?;
    let objects = Scene::parse(scene.scene.as_bytes()).map_err(|error| error.to_string())?;
    let prepared: Prepared<Aos> =
        Prepared::new(&config, &objects, Scatter::Statement).map_err(|error| error.to_string())?;
    reset();
    let image = cpu::internals::render_with(&prepared, set).map_err(|error| error.to_string())?;
    let counted = snapshot();
    let reference: <Aos as Layout>::Image =
        render_with::<_, Exact>(&config, &objects, Scatter::Statement).map_err(|error| error.to_string())?;
    let [image, reference] = [image, reference].map(|image| {
        let mut bytes = Vec::new();
        cpu::write_ppm(&image, &mut bytes).map(|()| bytes)
    });
    let is_equal = image.map_err(|error| error.to_string())? == reference.map_err(|error| error.to_string())?;
    let hits = counted[Counter::Hits as usize].max(1) as f64;
    let share = |counter: Counter| counted[counter as usize] as f64 / hits;
    let text = format!(
        "of {hits} hits: compensated {:.3}, dyadic {:.3}, near {:.3}, near and exact {:.4}, unfiltered {:.1}; {}",
        share(Counter::Compensated),
        share(Counter::Fallbacks),
        share(Counter::NearHits),
        share(Counter::NearHitsExactly),
        share(Counter::UnfilteredTests),
        if is_equal { "the reference's picture" } else { "NOT THE REFERENCE'S PICTURE" }
    );
    Ok((text, is_equal))
}
