//! `render-lab animate`: renders the frames of an animation, into a folder or into one APNG.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::Instant;

use clap::Args;
use cpu::internals::Prepared;
use cpu::internals::input::reader::read_text;
use cpu::internals::math::vec3::Vec3;
use cpu::{Aos, Config, Error, Scene, Size};
use indicatif::ProgressBar;
use output::{Options, Output};
use serde::Serialize;
use serde_json::json;

use crate::checkpoint::Origin;
use crate::engine::{self, ScatterName, name_of};
use crate::picture::{self, Picture};
use crate::{Failure, interrupt, sources, terminal};

/// Options of `animate`.
#[derive(Debug, Args)]
#[command(after_help = include_str!("../../help/animate.txt").trim_ascii_end())]
pub struct Arguments {
    /// Configuration file: the first camera
    config: PathBuf,
    /// Scene file
    scene: PathBuf,
    /// A name that ends in .png or .apng gives one animated PNG. A name without such an ending is a folder for the
    /// frames, where those that it has already are kept
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
        let inputs: Vec<_> = [&self.config, &self.scene].into_iter().chain(&self.to).map(PathBuf::as_path).collect();
        sources::refuse_stdout("an animation", &self.out)?;
        sources::refuse_inputs_in_one(&inputs)?;
        output::refuse_inputs(&self.out, &inputs)?;
        let is_one_file = is_animated(&self.out)?;
        let config = sources::config(&self.config, &self.set)?;
        let to = self.to.as_ref().map(|path| sources::config(path, &self.set)).transpose()?;
        let scene = sources::scene(&self.scene)?;
        let explain = |error| sources::about_picture(Error::Picture(error), &self.config, &self.set);
        let size = config.image_size().map_err(explain)?;
        let cameras: Vec<_> = (0..self.frames).map(|frame| self.camera(frame, &config, to.as_ref())).collect();
        // An invalid camera is an error before the first frame is rendered.
        for (frame, config) in cameras.iter().enumerate() {
            let files = std::iter::once(&self.config).chain(&self.to).map(|path| path.as_os_str());
            config.check_picture().map_err(|error| format!("{}: frame {frame}: {error}", terminal::quoted(files)))?;
        }
        let start = Instant::now();
        interrupt::listen();
        let rows = size.height() * cameras.len();
        let bar = if self.quiet { ProgressBar::hidden() } else { terminal::progress(rows, "rows") };
        let film = Film { scene: &scene, scatter: self.scatter, cameras, size, bar };
        let rendered = if is_one_file {
            film.write_animated(&self.out, self.rate, options)?
        } else {
            let origin = |config| Origin::new(config, &scene, &name_of(&self.scatter));
            let about = About { from: origin(&config), to: to.as_ref().map(origin), frames: self.frames };
            film.write_folder(&self.out, &about, options)?
        };
        film.bar.finish_and_clear();
        let (frames, seconds) = (self.frames, start.elapsed().as_secs_f64());
        if self.json {
            // The folder had the frames that were not rendered.
            terminal::print_json(&json!({ "frames": frames, "rendered": rendered, "seconds": seconds }))?;
        }
        if !self.quiet {
            let (name, what) = (terminal::name(&self.out), if is_one_file { "an animated PNG" } else { "a folder" });
            terminal::note(&format!(
                "{name}: {what} of {frames} frames, {rendered} of them rendered in {seconds:.1} s"
            ));
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
}

/// Returns whether `out` is one animated PNG, and not a folder of frames.
///
/// # Errors
/// The name of a new folder ends as that of a file of pictures, which would surprise.
fn is_animated(out: &Path) -> Result<bool, Failure> {
    const OTHERS: [&str; 15] =
        ["gif", "webp", "avif", "mp4", "m4v", "mov", "mkv", "webm", "avi", "mpg", "mpeg", "jpg", "jpeg", "ppm", "exr"];
    let ending = out.extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase()).unwrap_or_default();
    let is_folder = out.is_dir() || out.as_os_str().as_encoded_bytes().ends_with(b"/");
    if OTHERS.contains(&&ending[..]) && !is_folder {
        let name = terminal::name(out);
        return Err(format!(
            "{name}: .{ending} is not written. Name an animated PNG (.png), or a folder of frames, from which ffmpeg \
             makes a film: render-lab help animate"
        )
        .into());
    }
    Ok(["png", "apng"].contains(&&ending[..]) && !is_folder)
}

/// Returns `vector`, turned by `angle` in radians about `axis`, which has length one (Rodrigues' formula).
fn turned(vector: Vec3, axis: Vec3, angle: f64) -> Vec3 {
    let (sine, cosine) = angle.sin_cos();
    vector * cosine + axis.cross(vector) * sine + axis * (axis.dot(vector) * (1.0 - cosine))
}

/// The frames, with what they have in common.
struct Film<'a> {
    scene: &'a Scene,
    scatter: ScatterName,
    /// The configuration of each frame.
    cameras: Vec<Config>,
    size: Size,
    bar: ProgressBar,
}

impl Film<'_> {
    /// Renders a frame. Returns `None` if a signal stopped it.
    fn frame(&self, frame: usize) -> Result<Option<Picture>, Failure> {
        let prepared = Prepared::<Aos>::new(&self.cameras[frame], self.scene, self.scatter.into());
        let prepared = prepared.map_err(|error| format!("frame {frame}: {error}"))?;
        let (image, rows) = engine::render_rows(&prepared, None, |_, _, _| {
            self.bar.inc(1);
            interrupt::flow()
        })?;
        Ok((rows == prepared.size.height()).then(|| Picture::of(&image)).transpose()?)
    }

    /// Writes all frames into the file `out`. Returns their number.
    fn write_animated(&self, out: &Path, rate: u16, options: Options) -> Result<usize, Failure> {
        let mut output = Output::open(out, options)?;
        let text = |error: png::EncodingError| error.to_string();
        let mut encoder = picture::png::encoder(&mut output, [self.size.width(), self.size.height()])?;
        encoder.set_animated(self.cameras.len() as u32, 0).map_err(text)?;
        encoder.set_frame_delay(1, rate).map_err(text)?;
        let mut writer = encoder.write_header().map_err(text)?;
        for frame in 0..self.cameras.len() {
            let picture = self.frame(frame)?.ok_or(Failure::Interrupted)?;
            writer.write_image_data(picture.pixels.as_flattened()).map_err(text)?;
        }
        writer.finish().map_err(text)?;
        output.commit()?;
        Ok(self.cameras.len())
    }

    /// Writes each frame into a file of its own, if the folder does not have it whole. Returns how many frames were
    /// rendered.
    fn write_folder(&self, folder: &Path, about: &About, options: Options) -> Result<usize, Failure> {
        let name = terminal::name(folder);
        sources::make_folder(folder)?;
        let about = serde_json::to_string_pretty(about).map_err(|error| error.to_string())?;
        let place = folder.join(ABOUT);
        let frames: Vec<_> = (0..self.cameras.len()).map(|frame| folder.join(format!("{frame:04}.png"))).collect();
        // A pipe of this name would be waited for, and a device overwritten.
        for path in frames.iter().chain([&place]) {
            if fs::symlink_metadata(path).is_ok_and(|found| !found.is_file()) {
                let name = terminal::name(path);
                return Err(format!("{name}: it is not a regular file; delete it, or choose another folder").into());
            }
        }
        if fs::exists(&place).map_err(|error| format!("{name}: {error}"))? {
            if sources::regular(&place).and_then(|place| read_text(place, 1 << 16)).ok().as_ref() != Some(&about) {
                return Err(format!("{name}: it has frames of another animation; choose another folder").into());
            }
        } else if let Some(old) = frames.iter().find(|path| path.exists()) {
            let remedy = format!("no {ABOUT} tells its animation; choose another folder, or delete its frames");
            return Err(format!("{}: {remedy}", terminal::name(old)).into());
        } else {
            Output::open(&place, options)?.fill(|file| file.write_all(about.as_bytes()))?;
        }
        let is_whole = |old: Picture| (old.width, old.height) == (self.size.width(), self.size.height());
        let mut rendered = 0;
        for (frame, path) in frames.iter().enumerate() {
            if path.is_file() && Picture::read(path).is_ok_and(is_whole) {
                self.bar.inc(self.size.height() as u64);
                continue;
            }
            let Some(picture) = self.frame(frame)? else {
                let message = format!("{name} has {frame} of {} frames; the same command goes on", frames.len());
                return Err(Failure::Kept { message, interrupted: true });
            };
            Output::open(path, options)?.fill(|file| picture.write_png(file))?;
            rendered += 1;
        }
        Ok(rendered)
    }
}
