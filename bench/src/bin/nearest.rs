//! `nearest [--sizes N,…] [--rounds N] [--rays N] [--set NAME]`: compares the time of a nearest hit with
//! Embree's. `cargo run --release -p bench --bin nearest` runs it.

use std::process::ExitCode;

use bench::nearest::embree;
use bench::nearest::measure::{Options, measure};
use bench::nearest::scene::Setting;
use bench::nearest::table::{HEAD, row};
use clap::Parser;
use cpu::internals::InstructionSet;

/// Compares the time of a nearest hit of an incoherent ray with Embree 3.
///
/// Ours is the structure that the renderer chooses, with the hits of exact arithmetic in double precision. Embree's is
/// rtcIntersect1 in single precision with a structure of high quality. The scenes are spheres in a cube, sparse and
/// dense, on a ground and without one. The rays start on surfaces, or anywhere (free). As in a picture, the record of
/// the sphere on which a ray starts is in a near cache.
///
/// Prints a table in Markdown with the median user time of a ray. Without Embree (Debian: libembree-dev) only our side
/// is measured. The status is 1 if less than 99.99 % of the rays of a row hit the same object on both sides. Embree's
/// self-hits are left out of this share and counted: by rounding, its ray hits the object on which it starts.
#[derive(Parser)]
#[command(
    name = "nearest",
    max_term_width = 120,
    after_help = "\
Examples:
  cargo run --release -p bench --bin nearest
  cargo run --release -p bench --bin nearest -- --sizes 33,1000 --rounds 3 --set avx2"
)]
struct CommandLine {
    /// Numbers of spheres
    #[arg(long, value_name = "N,...", value_delimiter = ',', value_parser = number,
          default_value = "33,100,300,1000,3000,10000,30000,100000,300000,1000000")]
    sizes: Vec<usize>,
    /// Measurements of each time, in turn
    #[arg(long, value_name = "N", default_value = "9", value_parser = number)]
    rounds: usize,
    /// Rays in each measurement, each at another place
    #[arg(long, value_name = "N", default_value = "200000", value_parser = number)]
    rays: usize,
    /// One instruction set, avx512 or avx2; all of this machine without it
    #[arg(long, value_name = "NAME")]
    set: Option<String>,
}

fn main() -> ExitCode {
    bench::main(run)
}

/// Measures and prints. Returns whether enough hits agree in every row.
fn run(command: &CommandLine) -> Result<bool, String> {
    let mut sets = sets();
    sets.retain(|(name, _)| command.set.as_ref().is_none_or(|set| set == name));
    if sets.is_empty() {
        return Err("this machine has no such instruction set; see --help".to_owned());
    }
    let (rounds, rays) = (command.rounds, command.rays);
    let options = Options { rounds, rays, sets, embree: embree::missing().is_none() };
    if let Some(reason) = embree::missing() {
        println!("Embree is ignored: {reason}.\n");
    }
    println!("{HEAD}");
    let mut is_enough = true;
    for setting in command.sizes.iter().flat_map(|&size| Setting::all(size)) {
        for time in measure(setting, &options)? {
            println!("{}", row(&time));
            is_enough &= time.embree.is_none_or(|embree| embree.agreement.is_enough());
        }
    }
    Ok(is_enough)
}

/// Returns a whole number from 1 to 10,000,000.
fn number(text: &str) -> Result<usize, String> {
    let number = text.parse().ok().filter(|number| (1..=10_000_000).contains(number));
    number.ok_or_else(|| "a whole number from 1 to 10000000 is needed".to_owned())
}

/// Returns the instruction sets that both sides have on this machine, by Embree's names. With AVX-512 ours is the one
/// that the renderer chooses.
fn sets() -> Vec<(&'static str, InstructionSet)> {
    let best = InstructionSet::best();
    let is_512 = matches!(best, InstructionSet::Avx512 | InstructionSet::Avx512Throughout);
    let avx2 = InstructionSet::Avx2;
    is_512.then_some(("avx512", best)).into_iter().chain(avx2.is_available().then_some(("avx2", avx2))).collect()
}
