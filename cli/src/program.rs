//! The work of the programs: reads the two files, renders, and writes the picture.

use std::ffi::OsString;
use std::path::Path;

use cpu::{Config, Renderable, Scatter, Scene};
use output::{Options, Output};

use crate::{Error, stack};

/// Renders a scene into a file. `arguments` must have three names: `CONFIG`, `SCENE` and `OUT.ppm`.
///
/// # Errors
/// Returns the first error, in this order: [`Error::ArgumentCount`]; [`Error::Stack`]; an output that is
/// also an input; an error of the configuration, the scene, the picture or the output. A regular output file is then
/// unchanged.
pub fn run<L: Renderable>(arguments: impl IntoIterator<Item = OsString>) -> Result<(), Error> {
    let arguments: Vec<OsString> = arguments.into_iter().collect();
    let [config, scene, out] = &arguments[..] else {
        return Err(Error::ArgumentCount(arguments.len()));
    };
    stack::reserve()?;
    render_files::<L>(Path::new(config), Path::new(scene), Path::new(out), Scatter::Statement)
}

/// Renders the file `scene` with the configuration `config`, and writes the picture to `out`.
///
/// # Errors
/// The errors of [`run`], except [`Error::ArgumentCount`] and [`Error::Stack`].
fn render_files<L: Renderable>(config: &Path, scene: &Path, out: &Path, scatter: Scatter) -> Result<(), Error> {
    output::refuse_inputs(out, &[config, scene])?;
    let config_path = config;
    let config = Config::read(config_path)?;
    let scene = Scene::read(scene)?;
    // A camera without a window is an error of the configuration, so it must be reported before errors of the output.
    config.check_picture().map_err(|error| error.in_file(config_path))?;
    let output = Output::open(out, Options::default())?;
    let image = cpu::render::<L>(&config, scene, scatter).map_err(|error| error.in_file(config_path))?;
    Ok(output.fill(|file| cpu::write_ppm(&image, file))?)
}
