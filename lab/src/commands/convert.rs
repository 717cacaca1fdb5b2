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
        let picture = Any::read(&sources::input(input))?;
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
