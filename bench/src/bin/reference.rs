//! `reference CONFIG SCENE OUT.ppm [certified]`: renders by the definition, for timing the real programs against it and
//! for digests of pictures that are too large for the tests.

use std::path::Path;

use cpu::reference::intersect::{Exact, Plain};
use cpu::{Aos, Config, Error, Layout, Scatter, Scene};

const USAGE: &str = "\
reference CONFIG SCENE OUT.ppm [certified]
Renders by the definition, line by line, to time the real programs against it.

Example:
  cargo run --release -p bench --bin reference scenes/grid/config.txt scenes/grid/scene.txt out.ppm";

fn main() -> Result<(), Error> {
    let names: Vec<_> = std::env::args_os().skip(1).collect();
    if names.iter().any(|name| name == "--help") {
        println!("{USAGE}");
        return Ok(());
    }
    let (config, scene, out, certified) = match &names[..] {
        [config, scene, out] => (config, scene, out, false),
        [config, scene, out, word] if word == "certified" => (config, scene, out, true),
        _ => return Err(Error::ArgumentCount(names.len())),
    };
    let (config, scene) = (Config::read(Path::new(config))?, Scene::read(Path::new(scene))?);
    let output = cpu::internals::output::Output::open(Path::new(out), cpu::internals::output::Options::default())?;
    let render = if certified {
        cpu::reference::render_with::<<Aos as Layout>::Image, Exact>
    } else {
        cpu::reference::render_with::<<Aos as Layout>::Image, Plain>
    };
    let image = render(&config, &scene, Scatter::Statement)?;
    output.fill(|file| cpu::internals::image::ppm::write_ppm(&image, file))
}
