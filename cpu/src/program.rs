//! What the programs do, from three names to a written file.

use std::ffi::OsString;
use std::path::Path;

use crate::image::ppm::write_ppm;
use crate::input::config::Config;
use crate::input::error::Error;
use crate::input::scene::Scene;
use crate::layout::Layout;
use crate::output;
use crate::output::{Options, Output};
use crate::sampling::scatter_vectors::Scatter;

#[cfg(unix)]
pub use crate::output::stop::remove_temporary_when_stopped;

/// Renders `SCENE` as `CONFIG` asks into `OUT.ppm`, given these three names.
///
/// # Errors
/// [`Error::ArgumentCount`] for another number of arguments, then an output that is one of the inputs, then whatever is
/// wrong with the configuration, the scene, the picture or the output, in this order. The output is as it was.
pub fn run<L: Layout>(arguments: impl IntoIterator<Item = OsString>) -> Result<(), Error> {
    reserve_stack();
    let arguments: Vec<OsString> = arguments.into_iter().collect();
    let [config, scene, out] = &arguments[..] else {
        return Err(Error::ArgumentCount(arguments.len()));
    };
    render_files::<L>(Path::new(config), Path::new(scene), Path::new(out), Scatter::Statement)
}

/// Makes the system give the stack all the memory that rendering needs, before anything else takes it.
///
/// The stack grows on demand, and where the address space is limited and used up it cannot: the process would end by
/// SIGSEGV instead of with a message. All other memory that grows with the input is asked for in ways that report a
/// refusal. The programs have this one thread.
///
/// Rendering 10,000 objects needs a stack of 384 KiB in test builds and of 288 KiB in release builds. These are the
/// smallest values of `ulimit -s` with which the programs rendered them.
#[inline(never)]
fn reserve_stack() {
    const BYTES: usize = 512 << 10;
    std::hint::black_box(&mut [0_u8; BYTES]);
}

/// Renders the files named.
///
/// # Errors
/// As [`run`], but for the number of arguments.
pub fn render_files<L: Layout>(config: &Path, scene: &Path, out: &Path, scatter: Scatter) -> Result<(), Error> {
    output::refuse_inputs(out, &[config, scene])?;
    let config_path = config;
    let config = Config::read(config_path)?;
    let scene = Scene::read(scene)?;
    // A camera that cannot be is a fault of the configuration: say so before the output is touched.
    crate::geometry::camera::Camera::new(
        &config,
        config.image_size().map_err(|error| Error::from(error).in_file(config_path))?,
    )
    .map_err(|error| Error::from(error).in_file(config_path))?;
    let output = Output::open(out, Options::default())?;
    let image = crate::render::<L>(&config, &scene, scatter).map_err(|error| error.in_file(config_path))?;
    output.fill(|file| write_ppm(&image, file))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layout::aos::Aos;

    #[test]
    fn three_arguments_are_needed() {
        for count in [0, 1, 2, 4, 9] {
            let error = run::<Aos>(vec![OsString::from("x"); count]).expect_err("the number is wrong");
            assert_eq!(error.to_string(), format!("Invalid number of arguments: {count}"));
        }
    }

    #[test]
    fn the_configuration_is_read_first() {
        let names = ["/nowhere/config", "/nowhere/scene", "/nowhere/out"].map(OsString::from);
        let error = run::<Aos>(names).expect_err("no file exists");
        assert!(error.to_string().starts_with("Cannot read file [/nowhere/config]: "), "{error}");
    }
}
