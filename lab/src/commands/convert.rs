//! `render-lab convert`: writes a picture in another format.

use std::path::PathBuf;

use clap::Args;
use output::{Options, Output};

use crate::picture::any::Any;
use crate::picture::floats::GAMMA;
use crate::picture::kind::Kind;
use crate::supervise::above_zero;
use crate::{Failure, sources};

/// Examples, shown after the help of `convert`.
const EXAMPLES: &str = "\
Examples:
  render-lab convert picture.ppm picture.png
  render-lab convert linear.exr picture.png --gamma 2.4
  render-lab convert depth.npy depth.pfm";

/// Options of `convert`.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub struct Arguments {
    /// Picture, PPM, PNG, PFM, NPY or EXR; - is standard input
    input: PathBuf,
    /// Picture to write, in the format of its name's ending; - is PNG on standard output
    out: PathBuf,
    /// Gamma between bytes and the linear light of PFM, NPY and EXR
    #[arg(long, default_value_t = GAMMA, value_parser = above_zero)]
    gamma: f64,
}

impl Arguments {
    /// Converts the picture.
    ///
    /// # Errors
    /// An error of a file.
    pub fn run(&self, options: Options) -> Result<(), Failure> {
        let kind = Kind::of(&self.out, Kind::Png)?;
        output::refuse_inputs(&self.out, &[&self.input])?;
        let output = Output::open(&sources::output(&self.out), options)?;
        let picture = Any::read(&sources::input(&self.input))?;
        Ok(output.fill(|file| picture.write(kind, self.gamma, file))?)
    }
}
