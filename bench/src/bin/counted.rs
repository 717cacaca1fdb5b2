//! `counted CONFIG SCENE`: renders a scene and prints the counters of the renderer (`cargo run --release -p bench
//! --features counters --bin counted CONFIG SCENE`).

use std::error::Error;
use std::path::Path;

use cpu::internals::counters;
use cpu::internals::counters::Counter;
use cpu::internals::{InstructionSet, Prepared};
use cpu::{Aos, Config, Scatter, Scene};

const USAGE: &str = "\
counted CONFIG SCENE
Renders and prints how often each thing was done: rays, tests, nodes, ...

Example:
  cargo run --release -p bench --features counters --bin counted scenes/grid/config.txt scenes/grid/scene.txt";

fn main() -> Result<(), Box<dyn Error>> {
    let names: Vec<_> = std::env::args_os().skip(1).collect();
    if names.iter().any(|name| name == "--help") {
        println!("{USAGE}");
        return Ok(());
    }
    let [config, scene] = &names[..] else {
        return Err(USAGE.into());
    };
    let (config, scene) = (Config::read(Path::new(config))?, Scene::read(Path::new(scene))?);
    let prepared = Prepared::<Aos>::new(&config, &scene, Scatter::Statement)?;
    cpu::internals::render_with(&prepared, InstructionSet::chosen())?;
    let counts = counters::snapshot();
    for &counter in Counter::ALL {
        println!("{:14} {counter:?}", counts[counter as usize]);
    }
    Ok(())
}
