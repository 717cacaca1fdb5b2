//! `render-lab generate`: writes a random scene from a seed. It uses the generator of the tests.

use std::path::PathBuf;

use clap::Args;
use generator::{self, Arrangement, Options};

use crate::numbers::number;
use crate::{Failure, sources, terminal};

/// Options of `generate`.
#[derive(Debug, Args)]
#[command(after_help = include_str!("../../help/generate.txt").trim_ascii_end())]
pub struct Arguments {
    /// Configuration file to write; - is standard output
    config: PathBuf,
    /// Scene file to write; - is standard output
    scene: PathBuf,
    /// Replace files that exist
    #[arg(long)]
    force: bool,
    /// Where all random numbers come from
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Number of objects, at most 10000000
    #[arg(long, default_value_t = 100, value_parser = count)]
    objects: usize,
    /// Share of cylinders, from 0 to 1; the others are spheres
    #[arg(long, default_value_t = 0.5, value_parser = number(0.0..=1.0, "a number from 0 to 1"))]
    cylinders: f64,
    /// Weight of matte materials
    #[arg(long, default_value_t = 2.0, value_parser = number(0.0..=f64::MAX, "a number that is not negative"))]
    matte: f64,
    /// Weight of metal materials
    #[arg(long, default_value_t = 1.0, value_parser = number(0.0..=f64::MAX, "a number that is not negative"))]
    metal: f64,
    /// Weight of refractive materials
    #[arg(long, default_value_t = 1.0, value_parser = number(0.0..=f64::MAX, "a number that is not negative"))]
    refractive: f64,
    // Outside this range, squares of lengths overflow or underflow, and the renderer would refuse the scene's file.
    /// Half the side of the cube that holds the objects' centres, from 1e-100 to 1e100
    #[arg(long, default_value_t = 10.0, value_parser = number(1e-100..=1e100, "a number from 1e-100 to 1e100"))]
    extent: f64,
    /// Where objects are put
    #[arg(long, value_enum, default_value_t)]
    arrangement: Arrangement,
}

/// Largest number of objects of a generated scene. A file with more objects would be too large to be read.
const MOST_OBJECTS: usize = 10_000_000;

fn count(text: &str) -> Result<usize, String> {
    text.parse()
        .ok()
        .filter(|&count| count <= MOST_OBJECTS)
        .ok_or_else(|| format!("a number from 0 to {MOST_OBJECTS} is needed"))
}

impl Arguments {
    fn options(&self) -> Result<Options, String> {
        let materials = [self.matte, self.metal, self.refractive];
        if materials.iter().sum::<f64>() <= 0.0 {
            return Err("one of --matte, --metal and --refractive must be positive".to_owned());
        }
        let Self { seed, objects, cylinders, extent, arrangement, .. } = *self;
        Ok(Options { seed, objects, cylinders, materials, extent, arrangement })
    }

    /// Writes the configuration and the scene.
    ///
    /// # Errors
    /// An error if a file exists or cannot be written, or if the weights of all materials are zero.
    pub fn run(&self, how: output::Options) -> Result<(), Failure> {
        let options = self.options()?;
        sources::check_outputs(&[&self.config, &self.scene], &[], false)?;
        if let Some(old) = [&self.config, &self.scene].into_iter().find(|path| path.is_file() && !self.force) {
            let name = terminal::name(old);
            return Err(format!("{name}: a file of this name exists; choose another, or replace it by --force").into());
        }
        check_memory(options.objects)?;
        // Both files are opened before one is written. So neither is changed if one of them cannot be opened.
        let (config, scene) = (sources::open(&self.config, how)?, sources::open(&self.scene, how)?);
        config.fill(|file| file.write_all(generator::write::config(&generator::view(&options)).as_bytes()))?;
        scene.fill(|file| file.write_all(generator::write::scene(&generator::scene(&options)).as_bytes()))?;
        Ok(())
    }
}

/// Returns an error if the memory that `objects` objects will need cannot be allocated now.
fn check_memory(objects: usize) -> Result<(), cpu::Error> {
    /// Number of bytes of one object and its line of text. Each is in a list that may have twice the capacity that it
    /// needs.
    const BYTES: usize = 512;

    let room = Vec::<u8>::new().try_reserve_exact(objects.saturating_mul(BYTES));
    room.map_err(|_| cpu::Error::OutOfMemory { what: "so many objects" })
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::Parser;

    #[derive(Parser)]
    struct Alone {
        #[command(flatten)]
        arguments: Arguments,
    }

    #[test]
    fn the_defaults_are_the_generators_and_the_largest_number_of_objects_is_allowed() {
        let options = |words: &[&str]| Alone::try_parse_from(words).expect("all is valid").arguments.options();
        assert_eq!(options(&["generate", "c", "s"]), Ok(Options::default()));
        let most = options(&["generate", "c", "s", "--objects=10000000"]);
        assert_eq!(most, Ok(Options { objects: MOST_OBJECTS, ..Options::default() }));
    }
}
