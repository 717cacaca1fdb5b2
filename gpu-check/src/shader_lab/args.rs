//! The command line of `shader-lab`.

use std::ffi::{OsStr, OsString};
use std::path::PathBuf;

use shaders::{Features, Precision};

use super::png;
use super::view::View;
use crate::sampled::Convention;

/// The help text of the program.
pub const USAGE: &str = "\
shader-lab MODULES --config CONFIG --scene SCENE --out OUT [options]
shader-lab --template NEW_FILE.wgsl

MODULES is a WGSL file or a folder of them. Each stands in for the module of shaders/wgsl that has its name, or that
its first line names, as in: // module: kernels/image

  --f32                   calculate in f32 (default: f64)
  --samples               render as the programs do: with random numbers and samples_per_pixel samples
  --scatter CONVENTION    with --samples: the scatter vectors of the statement (default) or the published pictures
  --set NAME=VALUE        a pipeline constant: has_spheres, has_cylinders, has_matte, has_metal, has_refraction,
                          max_depth, or one that your module declares with `override`
  --show VIEW             lambda, normal, object, side, steps or difference, in false colours
  --pixel X Y             print the way of this pixel's ray, CPU and WGSL side by side; 0 0 is the top left
  --first-difference      print the function, the line and the number where the first pixel that differs leaves the CPU
  --no-sync               do not wait until pictures are on the disk: a loss of power may then damage them
  --watch                 render again whenever a file changes, until interrupted
  --check                 exit with status 1 when a bit of the picture differs from the CPU's
  --template FILE         write a module to start from

OUT ends in .png or .ppm; a name without an ending gives a PPM. A name of - is standard input or, as OUT, a PPM on
standard output.

Examples:
  shader-lab --template my.wgsl
  shader-lab my.wgsl --config scenes/materials/config.txt --scene scenes/materials/scene.txt --out out.png --watch
  shader-lab my.wgsl --config scenes/grid/config.txt --scene scenes/grid/scene.txt --out out.png --pixel 200 100
  shader-lab sphere.wgsl --config scenes/grid/config.txt --scene scenes/grid/scene.txt --out out.png --first-difference

Exit status: 0 done, 1 --check and a bit differs, 2 an error or a command line that is not understood, 130 interrupted";

/// Names and values of constants that a user's module declares.
pub type Own<'a> = Vec<(&'a str, f64)>;

/// The action that the command line asks for.
#[derive(Clone, Debug, PartialEq)]
pub enum Command {
    /// Print the help text [`USAGE`].
    Help,
    /// Write the template into this new file.
    Template(PathBuf),
    /// Render a picture with these options.
    Render(Options),
}

/// The options for rendering a picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// Path of a WGSL file, or of a folder with WGSL files.
    pub modules: PathBuf,
    /// Path of the configuration.
    pub config: PathBuf,
    /// Path of the scene.
    pub scene: PathBuf,
    /// Path of the picture to write.
    pub out: PathBuf,
    /// The number type that `real` stands for.
    pub precision: Precision,
    /// The convention of the scatter vectors for a picture with random numbers; `None` for deterministic mode.
    pub samples: Option<Convention>,
    /// Names and values of pipeline constants.
    pub constants: Vec<(String, f64)>,
    /// The view to show instead of the picture.
    pub view: Option<View>,
    /// Column and row of the pixel whose path is printed; `None` if no path is printed.
    pub pixel: Option<[usize; 2]>,
    /// Whether to find the function in which the first pixel that differs leaves the CPU.
    pub first_difference: bool,
    /// Whether to render again whenever a file changes.
    pub watch: bool,
    /// Whether to wait until pictures are on the disk.
    pub sync: bool,
    /// Whether the exit status is 1 if any bit of the picture differs from the CPU's picture.
    pub check: bool,
}

/// Returns the command that `arguments` ask for. `arguments` must not include the program's name. Names of files may be
/// any bytes.
///
/// # Errors
/// A message for the user that tells what is wrong.
pub fn parse(arguments: impl IntoIterator<Item = OsString>) -> Result<Command, String> {
    let mut arguments = arguments.into_iter();
    let (mut modules, mut config, mut scene, mut out) = (None, None, None, None);
    let mut precision = Precision::F64;
    let (mut constants, mut view, mut pixel) = (Vec::new(), None, None);
    let (mut samples, mut scatter) = (false, None);
    let (mut watch, mut check, mut sync, mut first_difference) = (false, false, true, false);
    while let Some(argument) = arguments.next() {
        let name = shown(&argument);
        let mut value = |what: &str| arguments.next().ok_or(format!("{name} needs {what} after it"));
        match argument.to_str() {
            Some("--help" | "-h") => return Ok(Command::Help),
            Some("--template") => return Ok(Command::Template(value("a file to write")?.into())),
            Some("--config") => config = Some(PathBuf::from(value("a file")?)),
            Some("--scene") => scene = Some(PathBuf::from(value("a file")?)),
            Some("--out") => out = Some(PathBuf::from(value("a file")?)),
            Some("--f32") => precision = Precision::F32,
            Some("--f64") => precision = Precision::F64,
            Some("--samples") => samples = true,
            Some("--scatter") => scatter = Some(convention(&shown(&value("a convention")?))?),
            Some("--set") => constants.push(constant(&shown(&value("NAME=VALUE")?))?),
            Some("--show") => view = Some(shown(&value("a view")?).parse::<View>()?),
            Some("--pixel") => {
                let mut number = |what: &str| {
                    let text = shown(&value(what)?);
                    text.parse().map_err(|_| format!("--pixel: [{text}] is not {what}"))
                };
                pixel = Some([number("a column")?, number("a row")?]);
            }
            Some("--first-difference") => first_difference = true,
            Some("--watch") => watch = true,
            Some("--check") => check = true,
            Some("--no-sync") => sync = false,
            _ if argument.as_encoded_bytes().starts_with(b"-") && argument != "-" => return Err(unknown(&name)),
            _ if modules.is_some() => return Err(format!("[{name}] is one name too many")),
            _ => modules = Some(PathBuf::from(&argument)),
        }
    }
    let modules = modules.ok_or("the WGSL file or folder is missing; --template writes one to start from")?;
    let (config, scene) = (config.ok_or("--config is missing")?, scene.ok_or("--scene is missing")?);
    let out = out.ok_or("--out is missing")?;
    png::check_name(&out)?;
    let from_input = [&modules, &config, &scene].into_iter().filter(|path| path.as_os_str() == "-").count();
    if from_input > 1 {
        return Err("standard input (-) can be only one of the module, --config and --scene".to_owned());
    }
    if from_input == 1 && watch {
        return Err("--watch needs files, and - is standard input".to_owned());
    }
    if samples && first_difference {
        return Err("--first-difference follows one ray, so it does not go with --samples".to_owned());
    }
    let samples = sampled(samples, scatter, view, pixel.is_some())?;
    let [modules, config, scene] = [modules, config, scene].map(input);
    Ok(Command::Render(Options {
        modules,
        config,
        scene,
        out,
        precision,
        samples,
        constants,
        view,
        pixel,
        first_difference,
        watch,
        check,
        sync,
    }))
}

/// Returns the convention of a picture with random numbers, or `None` for deterministic mode. `samples` tells whether
/// the command line has `--samples`, and `scatter` is the value of `--scatter`.
fn sampled(
    samples: bool,
    scatter: Option<Convention>,
    view: Option<View>,
    is_pixel_followed: bool,
) -> Result<Option<Convention>, String> {
    let is_step_view = view.is_some_and(|view| view != View::Difference);
    match (samples, scatter) {
        (true, _) if is_pixel_followed => Err("--pixel follows one ray, so it does not go with --samples".to_owned()),
        (true, _) if is_step_view => Err("with --samples, --show shows only the difference".to_owned()),
        (true, scatter) => Ok(Some(scatter.unwrap_or(Convention::Statement))),
        (false, Some(_)) => Err("--scatter needs --samples: without it there are no random numbers".to_owned()),
        (false, None) => Ok(None),
    }
}

fn convention(text: &str) -> Result<Convention, String> {
    match text {
        "statement" => Ok(Convention::Statement),
        "published" => Ok(Convention::Published),
        _ => Err(format!("--scatter: [{text}] is neither statement nor published")),
    }
}

/// Returns an argument as text. Replacement characters stand for bytes that are not UTF-8.
fn shown(argument: &OsStr) -> String {
    argument.to_string_lossy().into_owned()
}

/// Returns the path to open: `/dev/stdin` if `path` is `-`, and otherwise `path`.
fn input(path: PathBuf) -> PathBuf {
    if path.as_os_str() == "-" { PathBuf::from("/dev/stdin") } else { path }
}

/// Returns the message for an unknown option. It suggests the most similar option, if there is one.
fn unknown(option: &str) -> String {
    /// The smallest Jaro-Winkler similarity (from 0 to 1) of an option that is suggested.
    const LIKE: f64 = 0.8;
    let known = OPTIONS.iter().map(|known| (strsim::jaro_winkler(option, known), known));
    let nearest = known.filter(|(likeness, _)| *likeness > LIKE).max_by(|one, other| one.0.total_cmp(&other.0));
    let hint = nearest.map_or_else(String::new, |(_, known)| format!("; did you mean [{known}]?"));
    format!("there is no option [{option}]{hint}")
}

/// Names of all options.
const OPTIONS: [&str; 16] = [
    "--help",
    "--template",
    "--config",
    "--scene",
    "--out",
    "--f32",
    "--f64",
    "--samples",
    "--scatter",
    "--set",
    "--show",
    "--pixel",
    "--first-difference",
    "--no-sync",
    "--watch",
    "--check",
];

fn constant(text: &str) -> Result<(String, f64), String> {
    let (name, value) = text.split_once('=').ok_or_else(|| format!("--set: [{text}] is not NAME=VALUE"))?;
    let number = match value {
        "true" => 1.0,
        "false" => 0.0,
        _ => value.parse().map_err(|_| format!("--set {name}: [{value}] is not a number, true or false"))?,
    };
    Ok((name.to_owned(), number))
}

impl Options {
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
