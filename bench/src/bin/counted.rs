//! `counted CONFIG SCENE`: renders a scene and prints the counters of the renderer (`cargo run --release -p bench
//! --features counters --bin counted CONFIG SCENE`).

use std::error::Error;
use std::ffi::OsString;
use std::path::Path;
use std::process::ExitCode;

use cpu::internals::Prepared;
use cpu::internals::counters;
use cpu::internals::counters::Counter;
use cpu::{Aos, Config, Scatter, Scene};

const USAGE: &str = "\
counted CONFIG SCENE
Renders and prints how often each thing was done: rays, tests, nodes, ...

Example:
  cargo run --release -p bench --features counters --bin counted scenes/grid/config.txt scenes/grid/scene.txt";

fn main() -> ExitCode {
    match run(&std::env::args_os().skip(1).collect::<Vec<_>>()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("Error: {error}");
            ExitCode::from(2)
        }
    }
}

fn run(names: &[OsString]) -> Result<(), Box<dyn Error>> {
    if names.iter().any(|name| name == "--help") {
        println!("{USAGE}");
        return Ok(());
    }
    let [config, scene] = names else {
        return Err("two arguments are needed, CONFIG and SCENE; see --help".into());
    };
    let (config, scene) = (Config::read(Path::new(config))?, Scene::read(Path::new(scene))?);
    let prepared = Prepared::<Aos>::new(&config, &scene, Scatter::Statement)?;
    cpu::internals::render_with(&prepared, bench::instruction_set())?;
    let counts = counters::snapshot();
    for &counter in Counter::ALL {
        println!("{:14} {counter:?}", counts[counter as usize]);
    }
    Ok(())
}
