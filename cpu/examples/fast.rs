//! `fast CONFIG SCENE OUT.ppm [textbook]`: what `render-aos` does, or the same with the textbook's intersections, for
//! timing one against the other.

use std::path::Path;

use cpu::certified::{Intersect, Textbook};
use cpu::{Aos, Config, Error, InstructionSet, Layout, Prepared, Scatter, Scene};

const USAGE: &str = "\
fast CONFIG SCENE OUT.ppm [textbook]
Renders as render-aos does, or with the textbook's intersections, to time one against the other.

Example:
  cargo run --release -p cpu --example fast scenes/grid/config.txt scenes/grid/scene.txt out.ppm textbook";

fn main() -> Result<(), Error> {
    let names: Vec<_> = std::env::args_os().skip(1).collect();
    if names.iter().any(|name| name == "--help") {
        println!("{USAGE}");
        return Ok(());
    }
    let (config, scene, out, textbook) = match &names[..] {
        [config, scene, out] => (config, scene, out, false),
        [config, scene, out, word] if word == "textbook" => (config, scene, out, true),
        _ => return Err(Error::ArgumentCount(names.len())),
    };
    let (config, scene) = (Config::read(Path::new(config))?, Scene::read(Path::new(scene))?);
    let output = cpu::output::Output::open(Path::new(out), cpu::output::Options::default())?;
    let image = if textbook {
        render(&Prepared::<Aos, Textbook>::new(&config, &scene, Scatter::Statement)?)?
    } else {
        render(&Prepared::<Aos>::new(&config, &scene, Scatter::Statement)?)?
    };
    output.fill(|file| cpu::ppm::write_ppm(&image, file))
}

fn render<P: Intersect>(prepared: &Prepared<Aos, P>) -> Result<<Aos as Layout>::Image, Error> {
    cpu::render_with(prepared, InstructionSet::chosen())
}
