//! `reference CONFIG SCENE OUT.ppm [exact]`: renders with the reference. It uses plain intersections, or exact ones if
//! the word `exact` is given. Its time is compared with the times of the evaluated programs. It also makes the digests
//! of pictures that are too large for the tests.

use std::error::Error;
use std::ffi::OsString;
use std::path::Path;
use std::process::ExitCode;

use cpu::reference::intersect::{Exact, Plain};
use cpu::{Aos, Config, Layout, Scatter, Scene};

const USAGE: &str = "\
reference CONFIG SCENE OUT.ppm [exact]
Renders by the definition, line by line, to time the real programs against it.

Example:
  cargo run --release -p bench --bin reference scenes/grid/config.txt scenes/grid/scene.txt out.ppm";

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
    let (config, scene, out, exact) = match names {
        [config, scene, out] => (config, scene, out, false),
        [config, scene, out, word] if word == "exact" => (config, scene, out, true),
        _ => return Err("the arguments must be CONFIG SCENE OUT.ppm, and [exact] or nothing; see --help".into()),
    };
    let (config, scene) = (Config::read(Path::new(config))?, Scene::read(Path::new(scene))?);
    let output = output::Output::open(Path::new(out), output::Options::default())?;
    let render = if exact {
        cpu::reference::render_with::<<Aos as Layout>::Image, Exact>
    } else {
        cpu::reference::render_with::<<Aos as Layout>::Image, Plain>
    };
    let image = render(&config, &scene, Scatter::Statement)?;
    output.fill(|file| cpu::internals::image::ppm::write_ppm(&image, file))?;
    Ok(())
}
