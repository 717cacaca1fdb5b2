//! `render-lab animate`: renders the frames of an animation, into a folder or into one APNG.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::Instant;

use clap::Args;
use cpu::internals::Prepared;
use cpu::internals::math::vec3::Vec3;
use cpu::{Aos, Config, Error, Scene, Size};
use indicatif::ProgressBar;
use output::{Options, Output};
use serde::Serialize;

use super::render::progress;
use crate::checkpoint::Origin;
use crate::engine::{self, ScatterName};
use crate::interrupt::Interrupt;
use crate::picture::Picture;
use crate::{Failure, sources, terminal};

/// Examples, shown after the help of `animate`.
const EXAMPLES: &str = "\
Examples:
  render-lab animate config.txt scene.txt turn.png --frames 48 --set image_width=320
  render-lab animate config.txt scene.txt frames/ --frames 250      # frames/0000.png, ...; again: goes on
  render-lab animate from.txt scene.txt flight.png --to to.txt
  ffmpeg -framerate 25 -i frames/%04d.png turn.mp4";

/// Options of `animate`.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub struct Arguments {
    /// Configuration file: the first camera
    config: PathBuf,
    /// Scene file
    scene: PathBuf,
    /// A name that ends in .png gives one animated PNG. Any other name is a folder for the frames, where those that it
    /// has already are kept
    out: PathBuf,
    /// Configuration file whose camera the last frame has, on a straight way from the first. Without it the camera
    /// turns once about its target and its north
    #[arg(long, value_name = "CONFIG")]
    to: Option<PathBuf>,
    /// Number of frames
    #[arg(long, default_value_t = 48, value_parser = clap::value_parser!(u32).range(2..=100_000))]
    frames: u32,
    /// Frames a second of an animated PNG
    #[arg(long, default_value_t = 24, value_parser = clap::value_parser!(u16).range(1..=1000))]
    rate: u16,
    /// How surfaces scatter light
    #[arg(long, value_enum, default_value_t)]
    scatter: ScatterName,
    /// Replace a value of the configurations; may be repeated
    #[arg(long, value_name = "KEY=VALUE")]
    set: Vec<String>,
    /// Print what it took as JSON on standard output
    #[arg(long)]
    json: bool,
    /// Say nothing but errors
    #[arg(long)]
    quiet: bool,
}

/// What an animation took.
#[derive(Debug, Default, Serialize)]
struct Taken {
    frames: u32,
    /// Number of frames that were rendered. The folder had the others.
    rendered: u32,
    seconds: f64,
}

/// What decides the frames in a folder. The folder has it in the file [`ABOUT`].
#[derive(Serialize)]
struct About {
    #[serde(flatten)]
    from: Origin,
    to: Option<Origin>,
    frames: u32,
}

const ABOUT: &str = "animation.json";

impl Arguments {
    /// Renders the frames and writes them.
    ///
    /// # Errors
    /// An error of a file or of a camera, or an interruption.
    pub fn run(&self, options: Options) -> Result<(), Failure> {
        if self.out == Path::new("-") {
            return Err("an animation has no standard output (-); name a .png file or a folder".into());
        }
        let config = sources::config(&self.config, &self.set)?;
        let to = self.to.as_ref().map(|path| sources::config(path, &self.set)).transpose()?;
        let scene = sources::scene(&self.scene)?;
        let inputs: Vec<&Path> =
            [&self.config, &self.scene].into_iter().chain(&self.to).map(PathBuf::as_path).collect();
        output::refuse_inputs(&self.out, &inputs)?;
        let explain = |error| sources::about_picture(Error::Picture(error), &self.config, &self.set);
        let size = config.image_size().map_err(explain)?;
        let start = Instant::now();
        let rows = size.height() * self.frames as usize;
        let bar = if self.quiet { ProgressBar::hidden() } else { progress(rows) };
        let cameras = (0..self.frames).map(|frame| self.camera(frame, &config, to.as_ref()));
        // An invalid camera is an error before the first frame is rendered.
        for (frame, config) in cameras.clone().enumerate() {
            config.check_picture().map_err(|error| format!("frame {frame}: {error}"))?;
        }
        let film = Film { scene: &scene, scatter: self.scatter, bar: &bar, interrupt: Interrupt::listen() };
        let rendered = if self.out.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("png")) {
            self.write_animated(&film, cameras, size, options)?
        } else {
            let origin = |config| Origin::new(config, &scene, self.scatter);
            let about = About { from: origin(&config), to: to.as_ref().map(origin), frames: self.frames };
            self.write_folder(&film, cameras, (&about, size), options)?
        };
        bar.finish_and_clear();
        let taken = Taken { frames: self.frames, rendered, seconds: start.elapsed().as_secs_f64() };
        if self.json {
            super::print_json(&taken)?;
        }
        if !self.quiet {
            let (name, Taken { frames, seconds, .. }) = (terminal::name(&self.out), taken);
            terminal::note(&format!("{name}: {frames} frames, {rendered} of them rendered in {seconds:.1} s"));
        }
        Ok(())
    }

    /// Returns the configuration of a frame.
    fn camera(&self, frame: u32, from: &Config, to: Option<&Config>) -> Config {
        let mut config = from.clone();
        match to {
            None => {
                let angle = std::f64::consts::TAU * f64::from(frame) / f64::from(self.frames);
                let arm = turned(from.camera_position - from.camera_target, from.camera_north.unit(), angle);
                config.camera_position = from.camera_target + arm;
            }
            Some(to) => {
                let share = f64::from(frame) / f64::from(self.frames - 1);
                let between = |from: Vec3, to: Vec3| from * (1.0 - share) + to * share;
                config.camera_position = between(from.camera_position, to.camera_position);
                config.camera_target = between(from.camera_target, to.camera_target);
                config.camera_north = between(from.camera_north, to.camera_north);
                config.field_of_view = from.field_of_view * (1.0 - share) + to.field_of_view * share;
            }
        }
        config
    }

    /// Writes all frames into one file.
    fn write_animated(
        &self,
        film: &Film<'_>,
        cameras: impl Iterator<Item = Config>,
        size: Size,
        options: Options,
    ) -> Result<u32, Failure> {
        let mut output = Output::open(&self.out, options)?;
        let side = |pixels| u32::try_from(pixels).map_err(|_| "too large a picture for a PNG".to_owned());
        let text = |error: png::EncodingError| error.to_string();
        let mut encoder = png::Encoder::new(&mut output, side(size.width())?, side(size.height())?);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_animated(self.frames, 0).map_err(text)?;
        encoder.set_frame_delay(1, self.rate).map_err(text)?;
        let mut writer = encoder.write_header().map_err(text)?;
        for (frame, config) in (0..).zip(cameras) {
            let picture = film.frame(frame, &config)?.ok_or(Failure::Interrupted)?;
            writer.write_image_data(picture.pixels.as_flattened()).map_err(text)?;
        }
        writer.finish().map_err(text)?;
        output.commit()?;
        Ok(self.frames)
    }

    /// Writes each frame into a file of its own, if the folder does not have it whole. Returns how many frames were
    /// rendered.
    fn write_folder(
        &self,
        film: &Film<'_>,
        cameras: impl Iterator<Item = Config>,
        (about, size): (&About, Size),
        options: Options,
    ) -> Result<u32, Failure> {
        let name = terminal::name(&self.out);
        fs::create_dir_all(&self.out).map_err(|error| format!("{name}: {error}"))?;
        let about = serde_json::to_string_pretty(about).map_err(|error| error.to_string())?;
        let place = self.out.join(ABOUT);
        let frames = || (0..self.frames).map(|frame| self.out.join(format!("{frame:04}.png")));
        match fs::exists(&place).map_err(|error| format!("{name}: {error}"))? {
            true if cpu::internals::input::reader::read_text(&place, 1 << 16).ok().as_ref() != Some(&about) => {
                return Err(format!("{name}: it has frames of another animation; choose another folder").into());
            }
            true => {}
            false => {
                if let Some(old) = frames().find(|path| path.exists()) {
                    let remedy = format!("no {ABOUT} tells its animation; choose another folder, or delete its frames");
                    return Err(format!("{}: {remedy}", terminal::name(&old)).into());
                }
                Output::open(&place, options)?.fill(|file| file.write_all(about.as_bytes()))?;
            }
        }
        let is_whole = |old: Picture| (old.width, old.height) == (size.width(), size.height());
        let mut rendered = 0;
        for ((frame, path), config) in (0..).zip(frames()).zip(cameras) {
            if path.exists() && Picture::read(&path).is_ok_and(is_whole) {
                film.bar.inc(size.height() as u64);
                continue;
            }
            let Some(picture) = film.frame(frame, &config)? else {
                let message = format!("{name} has {frame} of {} frames; the same command goes on", self.frames);
                return Err(Failure::Kept { message, interrupted: true });
            };
            Output::open(&path, options)?.fill(|file| picture.write_png(file))?;
            rendered += 1;
        }
        Ok(rendered)
    }
}

/// What all frames have in common.
struct Film<'a> {
    scene: &'a Scene,
    scatter: ScatterName,
    bar: &'a ProgressBar,
    interrupt: Interrupt,
}

impl Film<'_> {
    /// Renders a frame. Returns `None` if a signal stopped it.
    fn frame(&self, frame: u32, config: &Config) -> Result<Option<Picture>, Failure> {
        let prepared = Prepared::<Aos>::new(config, self.scene, self.scatter.into());
        let prepared = prepared.map_err(|error| format!("frame {frame}: {error}"))?;
        let (image, rows) = engine::render_rows(&prepared, None, |_, _, _| {
            self.bar.inc(1);
            self.interrupt.flow()
        })?;
        Ok((rows == prepared.size.height()).then(|| Picture::of(&image)).transpose()?)
    }
}

/// Returns `vector`, turned by `angle` in radians about `axis`, which has length one (Rodrigues' formula).
fn turned(vector: Vec3, axis: Vec3, angle: f64) -> Vec3 {
    let (sin, cos) = angle.sin_cos();
    vector * cos + axis.cross(vector) * sin + axis * (axis.dot(vector) * (1.0 - cos))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_vector_turns_about_its_axis() {
        let (axis, right) = (Vec3::new(0.0, 0.0, 1.0), std::f64::consts::FRAC_PI_2);
        let turned = turned(Vec3::new(2.0, 0.0, 5.0), axis, right);
        assert!((turned - Vec3::new(0.0, 2.0, 5.0)).length() < 1e-15, "{turned:?}");
    }
}
