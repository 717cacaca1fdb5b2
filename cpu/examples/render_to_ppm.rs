//! Renders a scene from code, without files for the configuration and the scene, and writes the picture as PPM.
//!
//! `cargo run --release -p cpu --example render_to_ppm > picture.ppm`

use std::io::{Error, Write, stdout};
use std::process::ExitCode;

use cpu::{Aos, Config, Scatter, Scene, write_ppm};

const CONFIG: &str = "\
image_width: 320
aspect_ratio: 16 9
camera_position: 0 1 -6
camera_target: 0 0.5 0
samples_per_pixel: 50
";

const SCENE: &str = "\
matte: ground 0.4 0.5 0.3
metal: mirror 0.9 0.9 0.9 0.05
refractive: glass 1.5
sphere: 0 -1000 0 1000 ground
sphere: -1.1 1 0 1 glass
cylinder: 1.1 0.8 0.5 0.7 0 1.6 0 mirror
";

const USAGE: &str = "\
render_to_ppm
Renders a scene from code and writes the picture as PPM to standard output.

Example:
  cargo run --release -p cpu --example render_to_ppm > picture.ppm";

fn main() -> ExitCode {
    let result = match std::env::args_os().nth(1) {
        None => render(),
        Some(argument) if argument == "--help" => writeln!(stdout(), "{USAGE}"),
        Some(argument) => Err(Error::other(format!("{argument:?} is not an option; see --help"))),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("Error: {error}");
            ExitCode::from(2)
        }
    }
}

fn render() -> Result<(), Error> {
    // Both texts are checked here: an error names the line and what is wrong with it.
    let config = Config::parse(CONFIG.as_bytes()).map_err(Error::other)?;
    let scene = Scene::parse(SCENE.as_bytes()).map_err(Error::other)?;
    // `Aos` stores objects and pixels as an array of structures, `Soa` as a structure of arrays. The bytes are equal.
    let image = cpu::render::<Aos>(&config, &scene, Scatter::Statement).map_err(Error::other)?;
    let mut ppm = Vec::new();
    write_ppm(&image, &mut ppm)?;
    stdout().write_all(&ppm)
}
