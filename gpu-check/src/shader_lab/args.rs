//! The command line of `shader-lab`.

use std::ffi::{OsStr, OsString};
use std::path::PathBuf;

use shaders::{Features, Precision};

use super::png;
use super::view::View;

/// How the program is called.
pub const USAGE: &str = "\
shader-lab MODULES --config CONFIG --scene SCENE --out OUT [options]
shader-lab --template NEW_FILE.wgsl
shader-lab --serve PORT --config CONFIG --scene SCENE

MODULES is a WGSL file or a folder of them. Each stands in for the module of shaders/wgsl that has its name, or that
its first line names, as in: // module: kernels/image

  --f32                   calculate in f32 (default: f64)
  --set NAME=VALUE        a pipeline constant: has_spheres, has_cylinders, has_matte, has_metal, has_refraction,
                          max_depth, or one that your module declares with `override`
  --show VIEW             lambda, normal, object, side, steps or difference, in false colours
  --pixel X Y             print the way of this pixel's ray, CPU and WGSL side by side; 0 0 is the top left
  --no-sync               do not wait until pictures are on the disk: a loss of power may then damage them
  --watch                 render again whenever a file changes, until interrupted
  --check                 exit with status 1 when a bit of the picture differs from the CPU's
  --template FILE         write a module to start from
  --serve PORT            a page for a browser with WebGPU, at http://127.0.0.1:PORT/, until interrupted

OUT ends in .png or .ppm; a name without an ending gives a PPM. A name of - is standard input or, as OUT, a PPM on
standard output.

Examples:
  shader-lab --template my.wgsl
  shader-lab my.wgsl --config scenes/materials/config.txt --scene scenes/materials/scene.txt --out out.png --watch
  shader-lab my.wgsl --config scenes/grid/config.txt --scene scenes/grid/scene.txt --out out.png --pixel 200 100

Exit status: 0 done, 1 --check and a bit differs, 2 an error or a command line that is not understood, 130 interrupted";

/// Names and values of the constants that a user's module declares.
pub type Own<'a> = Vec<(&'a str, f64)>;

/// What the program is asked to do.
#[derive(Clone, Debug, PartialEq)]
pub enum Command {
    /// Print [`USAGE`].
    Help,
    /// Write the template to this file.
    Template(PathBuf),
    /// Render a picture.
    Render(Options),
    /// Serve the page for browsers.
    Serve {
        /// The port on this machine.
        port: u16,
        /// The configuration's file.
        config: PathBuf,
        /// The scene's file.
        scene: PathBuf,
    },
}

/// What to render, and how.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// A WGSL file or a folder of them.
    pub modules: PathBuf,
    /// The configuration's file.
    pub config: PathBuf,
    /// The scene's file.
    pub scene: PathBuf,
    /// The picture to write.
    pub out: PathBuf,
    /// What `real` stands for.
    pub precision: Precision,
    /// Pipeline constants, by name.
    pub constants: Vec<(String, f64)>,
    /// The view to show in place of the picture.
    pub view: Option<View>,
    /// Column and row of a pixel whose path is printed.
    pub pixel: Option<[usize; 2]>,
    /// Whether to render again when files change.
    pub watch: bool,
    /// Whether to wait until pictures are on the disk.
    pub sync: bool,
    /// Whether the exit status is 1 for a picture that differs from the CPU's in a bit.
    pub check: bool,
}

/// Reads the arguments that follow the program's name. Names of files may be any bytes.
///
/// # Errors
/// A message for the user.
pub fn parse(arguments: impl IntoIterator<Item = OsString>) -> Result<Command, String> {
    let mut arguments = arguments.into_iter();
    let (mut modules, mut config, mut scene, mut out) = (None, None, None, None);
    let (mut precision, mut port) = (Precision::F64, None);
    let (mut constants, mut view, mut pixel) = (Vec::new(), None, None);
    let (mut watch, mut check, mut sync) = (false, false, true);
    while let Some(argument) = arguments.next() {
        let name = shown(&argument);
        let mut value = |what: &str| arguments.next().ok_or(format!("{name} needs {what} after it"));
        match argument.to_str() {
            Some("--help" | "-h") => return Ok(Command::Help),
            Some("--template") => return Ok(Command::Template(value("a file to write")?.into())),
            Some("--config") => config = Some(PathBuf::from(value("a file")?)),
            Some("--scene") => scene = Some(PathBuf::from(value("a file")?)),
            Some("--out") => out = Some(PathBuf::from(value("a file")?)),
            Some("--serve") => {
                let text = shown(&value("a port")?);
                port = Some(text.parse().map_err(|_| format!("--serve: [{text}] is not a port"))?);
            }
            Some("--f32") => precision = Precision::F32,
            Some("--f64") => precision = Precision::F64,
            Some("--set") => constants.push(constant(&shown(&value("NAME=VALUE")?))?),
            Some("--show") => view = Some(shown(&value("a view")?).parse::<View>()?),
            Some("--pixel") => {
                let mut number = |what: &str| {
                    let text = shown(&value(what)?);
                    text.parse().map_err(|_| format!("--pixel: [{text}] is not {what}"))
                };
                pixel = Some([number("a column")?, number("a row")?]);
            }
            Some("--watch") => watch = true,
            Some("--check") => check = true,
            Some("--no-sync") => sync = false,
            _ if argument.as_encoded_bytes().starts_with(b"-") && argument != "-" => return Err(unknown(&name)),
            _ if modules.is_some() => return Err(format!("[{name}] is one name too many")),
            _ => modules = Some(PathBuf::from(&argument)),
        }
    }
    let files = || Ok::<_, String>((config.ok_or("--config is missing")?, scene.ok_or("--scene is missing")?));
    if let Some(port) = port {
        let (config, scene) = files()?;
        return Ok(Command::Serve { port, config, scene });
    }
    let modules = modules.ok_or("the WGSL file or folder is missing; --template writes one to start from")?;
    let (config, scene) = files()?;
    let out = out.ok_or("--out is missing")?;
    png::check_name(&out)?;
    let from_input = [&modules, &config, &scene].into_iter().filter(|path| path.as_os_str() == "-").count();
    if from_input > 1 {
        return Err("standard input (-) can be only one of the module, --config and --scene".to_owned());
    }
    if from_input == 1 && watch {
        return Err("--watch needs files, and - is standard input".to_owned());
    }
    let [modules, config, scene] = [modules, config, scene].map(input);
    Ok(Command::Render(Options { modules, config, scene, out, precision, constants, view, pixel, watch, check, sync }))
}

/// An argument as text; bytes that are not UTF-8 become replacement characters.
fn shown(argument: &OsStr) -> String {
    argument.to_string_lossy().into_owned()
}

/// The path to open: for `-` it is that of standard input.
fn input(path: PathBuf) -> PathBuf {
    if path.as_os_str() == "-" { PathBuf::from("/dev/stdin") } else { path }
}

/// The message for an option that does not exist. It suggests the most similar option, if there is one.
fn unknown(option: &str) -> String {
    /// The smallest similarity of Jaro and Winkler with which an option is suggested.
    const LIKE: f64 = 0.8;
    let known = OPTIONS.iter().map(|known| (strsim::jaro_winkler(option, known), known));
    let nearest = known.filter(|(likeness, _)| *likeness > LIKE).max_by(|one, other| one.0.total_cmp(&other.0));
    let hint = nearest.map_or_else(String::new, |(_, known)| format!("; did you mean [{known}]?"));
    format!("there is no option [{option}]{hint}")
}

/// Every option.
const OPTIONS: [&str; 14] = [
    "--help",
    "--template",
    "--config",
    "--scene",
    "--out",
    "--serve",
    "--f32",
    "--f64",
    "--set",
    "--show",
    "--pixel",
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
    /// Returns the scene's features, changed by the constants that name a feature, and all other constants.
    ///
    /// # Errors
    /// A message, when a feature cannot have its value.
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
