//! `reference CONFIG SCENE OUT.ppm`: renders by the definition, for timing the real programs against it.

use std::path::Path;

use cpu::{Aos, Config, Error, Layout, Scatter, Scene};

fn main() -> Result<(), Error> {
    let names: Vec<_> = std::env::args_os().skip(1).collect();
    let [config, scene, out] = &names[..] else {
        return Err(Error::ArgumentCount(names.len()));
    };
    let (config, scene) = (Config::read(Path::new(config))?, Scene::read(Path::new(scene))?);
    let output = cpu::output::Output::open(Path::new(out))?;
    let image: <Aos as Layout>::Image = cpu::reference::render(&config, &scene, Scatter::Statement)?;
    output.write(|file| cpu::ppm::write_ppm(&image, file))
}
