//! `render-lab convert`: writes a picture in another format, or our scene for pbrt-v4 or Mitsuba 3.

use std::ffi::OsStr;
use std::io::Write as _;
use std::path::{Path, PathBuf};

use clap::Args;
use cpu::internals::input::reader::read;
use cpu::internals::input::text::MAX_FILE_BYTES;
use output::Options;

use crate::convert::notes::Notes;
use crate::convert::sky::Layout;
use crate::convert::write::{self, Source};
use crate::numbers::above_zero;
use crate::picture::any::{Any, Kind};
use crate::picture::floats::GAMMA;
use crate::picture::spare;
use crate::{Failure, sources, terminal};

/// The endings of the names of scenes for pbrt and Mitsuba.
const SCENES: [&str; 2] = ["pbrt", "xml"];
const NOT_READ: &str = "render-lab writes scenes of pbrt and Mitsuba, and reads them no more; write its spheres, \
                        cylinders and materials as lines of a scene of ours (render-lab help scene), and its camera \
                        and sky as those of a configuration (render-lab help config)";

/// Options of `convert`.
#[derive(Debug, Args)]
#[command(
    after_help = include_str!("../../help/convert.txt").trim_ascii_end(),
    override_usage = "render-lab convert [OPTIONS] PICTURE OUT\n       \
                      render-lab convert CONFIG SCENE OUT.pbrt|OUT.xml"
)]
pub struct Arguments {
    /// Two pictures, PPM, PNG, PFM, NPY or EXR, of which the second is written in the format of its name's ending; - is
    /// standard input, and PNG on standard output. Or our configuration and scene, and the file for pbrt or Mitsuba
    #[arg(required = true, num_args = 2..=3, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// Gamma between bytes and the linear light of PFM, NPY and EXR
    #[arg(long, default_value_t = GAMMA, value_parser = above_zero)]
    gamma: f64,
    /// Scale numbers for a PNG or PPM: LOW becomes black, HIGH white, without gamma
    #[arg(long, value_name = "LOW,HIGH", value_parser = range, allow_hyphen_values = true)]
    range: Option<(f64, f64)>,
    /// Part or layer of an EXR, or one of its channels
    #[arg(long, value_name = "NAME")]
    layer: Option<String>,
}

/// Returns the two numbers in a text such as `0,12.5`.
fn range(text: &str) -> Result<(f64, f64), String> {
    let number = |text: &str| text.trim().parse().ok().filter(|number: &f64| number.is_finite());
    let range = text.split_once(',').and_then(|(low, high)| Some((number(low)?, number(high)?)));
    range
        .filter(|(low, high)| low < high)
        .ok_or_else(|| "two numbers are needed, LOW,HIGH, the second larger".to_owned())
}

impl Arguments {
    /// Converts the picture or the scene.
    ///
    /// # Errors
    /// An error of a file.
    pub fn run(&self, options: Options) -> Result<(), Failure> {
        let ending = |path: &Path| path.extension().and_then(OsStr::to_str).unwrap_or_default().to_ascii_lowercase();
        match &self.files[..] {
            [input, out] if !SCENES.contains(&&ending(input)[..]) => self.picture(input, out, options),
            [config, scene, out] if SCENES.contains(&&ending(out)[..]) => {
                to_other([config, scene], out, ending(out) == "pbrt", options)
            }
            [input, ..] if SCENES.contains(&&ending(input)[..]) => {
                Err(format!("{}: {NOT_READ}", terminal::name(input)).into())
            }
            _ => Err("the third file must be a scene to write, whose name ends in .pbrt or .xml".into()),
        }
    }

    fn picture(&self, input: &Path, out: &Path, options: Options) -> Result<(), Failure> {
        let kind = Kind::of(out, Kind::Png)?;
        output::refuse_inputs(out, &[input])?;
        let output = sources::open(out, options)?;
        let mut picture = Any::read_layer(&sources::input(input), self.layer.as_deref())?;
        match (&picture, self.range) {
            (Any::Floats(floats), Some(range)) if !kind.is_of_floats() => picture = Any::Bytes(floats.scaled(range)?),
            (Any::Floats(floats), None) if !kind.is_of_floats() => {
                floats.clipped().iter().for_each(|lost| terminal::note(&format!("{}: {lost}", terminal::name(input))));
            }
            (_, Some(_)) => return Err("--range is for numbers (PFM, NPY, EXR) that become a PNG or PPM".into()),
            _ => {}
        }
        Ok(output.fill(|file| picture.write(kind, self.gamma, file))?)
    }
}

/// Writes the configuration and the scene in the files `inputs` as a scene of pbrt or Mitsuba.
fn to_other(inputs: [&PathBuf; 2], out: &PathBuf, is_pbrt: bool, options: Options) -> Result<(), Failure> {
    if inputs.iter().any(|path| sources::read_once(path).is_some()) {
        return Err(
            "the configuration and the scene are read twice, so they cannot be standard input (-) or pipes".into()
        );
    }
    let (config, scene) = (sources::config(inputs[0], &[])?, sources::scene(inputs[1])?);
    let size = config.check_picture().and_then(|()| Ok(config.image_size()?));
    let size = size.map_err(|error| sources::about_picture(error, inputs[0], &[]))?;
    // Both texts and the new one are in memory. A cylinder takes at most a thousand bytes of the new one.
    let bytes = [inputs[0], inputs[1]].map(|path| std::fs::metadata(path).map_or(0, |about| about.len() as usize));
    spare(1000 * (scene.objects.len() + scene.materials.len()) + 3 * (bytes[0] + bytes[1]))
        .map_err(|_| "not enough memory for the text of the scene; allow more by ulimit -v")?;
    // The name stands between quotation marks in both formats.
    let name = out.file_name().and_then(OsStr::to_str).unwrap_or_default();
    let name = format!("{}.exr", name.replace(|c: char| !c.is_alphanumeric() && !"-_. ".contains(c), "_"));
    let has_picture = config.background_dark_color != config.background_light_color;
    let source = Source { config: &config, scene: &scene, size, sky: has_picture.then_some(&name) };
    let mut notes = Notes::of(inputs.map(|path| terminal::name(path)).to_vec());
    let text = |path: &PathBuf| read(path, MAX_FILE_BYTES).map(|bytes| String::from_utf8_lossy(&bytes).into_owned());
    write::note(&source, is_pbrt, [&text(inputs[0])?, &text(inputs[1])?], &mut notes);
    let text = write::text(&source, is_pbrt)?;
    let (sky, mut outs) = (out.with_file_name(&name), Vec::new());
    if has_picture {
        let mut bytes = Vec::new();
        let layout = if is_pbrt { Layout::Square } else { Layout::Rows };
        Any::Floats(layout.picture(&config)?).write(Kind::Exr, GAMMA, &mut bytes)?;
        outs.push((&sky, bytes));
    }
    outs.push((out, text.into_bytes()));
    write_all(&inputs.map(PathBuf::clone), &outs, options)?;
    notes.print();
    if has_picture {
        terminal::note(&format!("{}: holds the picture of the sky", terminal::name(&sky)));
    }
    Ok(())
}

/// Writes several files. All are written completely before the first of them gets its name, so none is changed if one
/// of them cannot be written.
fn write_all(inputs: &[PathBuf], files: &[(&PathBuf, Vec<u8>)], options: Options) -> Result<(), Failure> {
    let inputs: Vec<_> = inputs.iter().map(PathBuf::as_path).collect();
    sources::check_outputs(&files.iter().map(|(path, _)| path.as_path()).collect::<Vec<_>>(), &inputs, false)?;
    let (mut regular, mut others) = (Vec::new(), Vec::new());
    for (path, bytes) in files {
        let output = sources::open(path, options)?;
        if output.is_regular() { &mut regular } else { &mut others }.push((path, output, bytes));
    }
    for (path, output, bytes) in &mut regular {
        output.write_all(bytes).map_err(|cause| output::Error { path: path.to_path_buf(), cause })?;
    }
    // A pipe is closed before the next one is opened, because its reader may wait for that.
    for (_, output, bytes) in others {
        output.fill(|file| file.write_all(bytes))?;
    }
    regular.into_iter().try_for_each(|(_, output, _)| Ok(output.commit()?))
}
