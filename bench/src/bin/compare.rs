//! `compare BASE NEW CONFIG SCENE ...`: times two programs in turn, each with its instruction set. bench/compare builds
//! and runs it.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use bench::programs::{Comparison, Program, compare as compare_programs, known};
use clap::Parser;
use measure::busy;

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
    let programs = [
        Program { path: &options.base, set: options.base_set.as_deref().or(options.set.as_deref()) },
        Program { path: &options.new, set: options.set.as_deref() },
    ];
    let mut all_equal = true;
    for [config, scene] in scenes {
        let Comparison { ratio, seconds, is_equal } =
            compare_programs(&programs, [config, scene], usize::from(options.rounds), folder)?;
        all_equal &= is_equal;
        println!(
            "{}: {:.3} ({:.3} to {:.3}, {} rounds), {:.3} s and {:.3} s{}",
            scene.display(),
            ratio.median,
            ratio.low,
            ratio.high,
            options.rounds,
            seconds[0],
            seconds[1],
            if is_equal { "" } else { "; THE PICTURES DIFFER" }
        );
    }
    Ok(all_equal)
}
