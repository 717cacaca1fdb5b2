//! `reference CONFIG SCENE OUT.ppm`: renders with the reference, with plain intersections. Its time is compared with
//! the times of the evaluated programs.

use std::error::Error;
use std::path::PathBuf;
use std::process::ExitCode;

use clap::Parser;
use cpu::{Aos, Config, Layout, Scatter, Scene};
use output::Output;

/// Renders by the definition, line by line, to time the real programs against it.
#[derive(Parser)]
#[command(
    name = "reference",
    after_help = "\
Example:
  cargo run --release -p bench --bin reference scenes/grid/config.txt scenes/grid/scene.txt out.ppm"
)]
struct Options {
    config: PathBuf,
    scene: PathBuf,
    /// The picture to write
    out: PathBuf,
}

fn main() -> ExitCode {
    bench::main(|options: &Options| run(options).map(|()| true).map_err(|error| error.to_string()))
}

fn run(Options { config, scene, out }: &Options) -> Result<(), Box<dyn Error>> {
    let (config, scene) = (Config::read(config)?, Scene::read(scene)?);
    let output = Output::open(out, output::Options::default())?;
    let image: <Aos as Layout>::Image = cpu::reference::render(&config, &scene, Scatter::Statement)?;
    output.fill(|file| cpu::internals::image::ppm::write_ppm(&image, file))?;
    Ok(())
}
