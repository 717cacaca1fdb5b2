//! The command line of `shader-lab`.

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use clap::builder::{PathBufValueParser, TypedValueParser};
use clap::error::ErrorKind;
use clap::{Args, CommandFactory, Parser};
use shaders::{Features, Precision};

use crate::Form;
use crate::sampled::Convention;

/// The file that the name `-` of an input stands for.
const STANDARD_INPUT: &str = "/dev/stdin";

/// Names and values of constants that a user's module declares.
pub type Own<'a> = Vec<(&'a str, f64)>;

/// Renders with your own WGSL modules, and reports the difference from the picture of the CPU.
#[derive(Clone, Debug, PartialEq, Parser)]
#[command(
    name = "shader-lab",
    max_term_width = 120,
    after_help = "\
OUT ends in .png or .ppm; a name without an ending gives a PPM. A name of - is standard input or, as OUT, a PPM on
standard output.

Examples:
  shader-lab --template my.wgsl
  shader-lab my.wgsl --config scenes/materials/config.txt --scene scenes/materials/scene.txt \\
      --out out.png --watch
  shader-lab my.wgsl --config scenes/grid/config.txt --scene scenes/grid/scene.txt --out out.png \\
      --pixel 200 100
  shader-lab sphere.wgsl --config scenes/grid/config.txt --scene scenes/grid/scene.txt \\
      --out out.png --first-difference

Exit status: 0 done
             1 --check, and a bit differs
             2 an error or a command line that is not understood
             130 interrupted"
)]
pub struct Arguments {
    /// Write a module to start from into this new file, and do nothing else
    #[arg(long, value_name = "FILE", exclusive = true)]
    pub template: Option<PathBuf>,
    /// What to render, if no template is written.
    #[command(flatten)]
    pub options: Option<Options>,
}

/// The options for rendering a picture.
#[derive(Args, Clone, Debug, PartialEq)]
pub struct Options {
    /// A WGSL file or a folder of them. Each stands in for the module of shaders/wgsl that has its name, or that its
    /// first line names, as in: // module: kernels/image
    #[arg(value_parser = PathBufValueParser::new().map(input))]
    pub modules: PathBuf,
    /// The configuration
    #[arg(long, value_name = "FILE", value_parser = PathBufValueParser::new().map(input))]
    pub config: PathBuf,
    /// The scene
    #[arg(long, value_name = "FILE", value_parser = PathBufValueParser::new().map(input))]
    pub scene: PathBuf,
    /// The picture to write
    #[arg(long)]
    pub out: PathBuf,
    /// Calculate in f32
    #[arg(long)]
    pub f32: bool,
    /// Calculate in f64, which is the default
    #[arg(long, conflicts_with = "f32")]
    pub f64: bool,
    /// Calculate f64 by integers, as on an adapter without f64
    #[arg(long, conflicts_with = "f32")]
    pub integers: bool,
    /// Let the driver rewrite the arithmetic, which it otherwise does as it is written
    #[arg(long, conflicts_with = "integers")]
    pub as_driver_likes: bool,
    /// Render as the programs do: with random numbers and samples_per_pixel samples
    #[arg(long, conflicts_with_all = ["pixel", "first_difference"])]
    pub samples: bool,
    /// With --samples: the scatter vectors of the statement (default) or the published pictures
    #[arg(long, value_name = "CONVENTION", requires = "samples")]
    pub scatter: Option<Convention>,
    /// A pipeline constant: has_spheres, has_cylinders, has_matte, has_metal, has_refraction, max_depth, or one that
    /// your module declares with `override`
    #[arg(long = "set", value_name = "NAME=VALUE", value_parser = constant)]
    pub constants: Vec<(String, f64)>,
    /// Print the way of this pixel's ray, CPU and WGSL side by side; 0 0 is the top left
    #[arg(long, num_args = 2, value_names = ["X", "Y"])]
    pub pixel: Option<Vec<usize>>,
    /// Print the function, the line and the number where the first pixel that differs leaves the CPU
    #[arg(long)]
    pub first_difference: bool,
    /// Do not wait until pictures are on the disk: a loss of power may then damage them
    #[arg(long)]
    pub no_sync: bool,
    /// Render again whenever a file changes, until interrupted
    #[arg(long)]
    pub watch: bool,
    /// Exit with status 1 when a bit of the picture differs from the CPU's
    #[arg(long)]
    pub check: bool,
}

impl Arguments {
    /// Returns the arguments in `line`, which begins with the program's name. Names of files may be any bytes.
    ///
    /// # Errors
    /// The help text, or a message for the user that tells what is wrong.
    pub fn read(line: impl IntoIterator<Item = OsString>) -> Result<Self, clap::Error> {
        let arguments = Self::try_parse_from(line)?;
        let checked = arguments.options.as_ref().map_or(Ok(()), Options::check);
        checked.map_err(|message| Self::command().error(ErrorKind::ValueValidation, message))?;
        if arguments.options.is_none() && arguments.template.is_none() {
            let message = "the WGSL file or folder is missing; --template writes one to start from";
            return Err(Self::command().error(ErrorKind::MissingRequiredArgument, message));
        }
        Ok(arguments)
    }
}

/// Checks that the name of a picture's file ends in `.png` or `.ppm`, or has no ending, which means PPM.
fn check_name(path: &Path) -> Result<(), String> {
    match path.extension() {
        None => Ok(()),
        Some(ending) if ["png", "ppm"].iter().any(|known| ending.eq_ignore_ascii_case(known)) => Ok(()),
        Some(ending) => {
            let ending = ending.to_string_lossy();
            Err(format!("--out: a picture cannot be written as .{ending}; its name must end in .png or .ppm"))
        }
    }
}

/// Returns the path to open: `/dev/stdin` if `path` is `-`, and otherwise `path`.
fn input(path: PathBuf) -> PathBuf {
    if path.as_os_str() == "-" { STANDARD_INPUT.into() } else { path }
}

fn constant(text: &str) -> Result<(String, f64), String> {
    let (name, value) = text.split_once('=').ok_or("it is not NAME=VALUE")?;
    let number = match value {
        "true" => 1.0,
        "false" => 0.0,
        _ => value.parse().map_err(|_| format!("[{value}] is not a number, true or false"))?,
    };
    Ok((name.to_owned(), number))
}

impl Options {
    /// Returns the convention of a picture with random numbers, or `None` for deterministic mode.
    #[must_use]
    pub fn convention(&self) -> Option<Convention> {
        self.samples.then(|| self.scatter.unwrap_or(Convention::Statement))
    }

    /// Returns the column and the row of the pixel whose path is printed.
    #[must_use]
    pub fn pixel(&self) -> Option<[usize; 2]> {
        self.pixel.as_deref()?.try_into().ok()
    }

    /// Returns the number type that `real` stands for.
    #[must_use]
    pub const fn precision(&self) -> Precision {
        if self.f32 { Precision::F32 } else { Precision::F64 }
    }

    /// Returns the form in which the device gets the shaders.
    #[must_use]
    pub const fn form(&self) -> Form {
        match (self.integers, self.as_driver_likes) {
            (true, _) => Form::ByIntegers,
            (false, true) => Form::AsDriverLikes,
            (false, false) => Form::AsWritten,
        }
    }

    /// Checks what the command line alone cannot.
    fn check(&self) -> Result<(), String> {
        check_name(&self.out)?;
        let inputs = [&self.modules, &self.config, &self.scene];
        match inputs.into_iter().filter(|path| path.as_os_str() == STANDARD_INPUT).count() {
            0 => {}
            1 if self.watch => return Err("--watch needs files, and - is standard input".to_owned()),
            1 => {}
            _ => return Err("standard input (-) can be only one of MODULES, --config and --scene".to_owned()),
        }
        Ok(())
    }

    /// Returns the scene's features and the other constants. Constants of the command line that name a feature change
    /// that feature.
    ///
    /// # Errors
    /// A message for the user, if a feature cannot have the given value.
    pub fn apply(&self, mut features: Features) -> Result<(Features, Own<'_>), String> {
        let mut own = Vec::new();
        for (name, value) in &self.constants {
            let flag = match name.as_str() {
                "has_spheres" => &mut features.has_spheres,
                "has_cylinders" => &mut features.has_cylinders,
                "has_matte" => &mut features.has_matte,
                "has_metal" => &mut features.has_metal,
                "has_refraction" => &mut features.has_refraction,
                "max_depth" => {
                    if value.fract() != 0.0 || !(0.0..=f64::from(u32::MAX)).contains(value) {
                        return Err(format!("--set max_depth: {value} is not a whole number that fits in 32 bits"));
                    }
                    features.max_depth = *value as u32;
                    continue;
                }
                _ => {
                    own.push((name.as_str(), *value));
                    continue;
                }
            };
            *flag = *value != 0.0;
        }
        Ok((features, own))
    }
}

#[cfg(test)]
mod tests;
