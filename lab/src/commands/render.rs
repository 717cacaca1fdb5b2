//! `render-lab render`: renders a scene into a file, and shows the progress, time and memory.

mod stages;

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::time::Instant;

use clap::builder::{PossibleValue, StringValueParser, TypedValueParser};
use clap::{Arg, Args, Command};
use cpu::internals::Prepared;
use cpu::{Aos, Config, Error, Renderable, Scene, Soa};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use measure::clock::{own_seconds, peak_memory};
use output::{Options, Output};
use serde::Serialize;

use crate::Failure;
use crate::checkpoint::Origin;
use crate::engine::{self, LayoutName, ScatterName};
use crate::interrupt::Interrupt;
use crate::picture::Picture;
use crate::picture::kind::Kind;
use crate::sources;
use crate::terminal;
use stages::Stages;

/// Examples, shown after the help of `render`.
const EXAMPLES: &str = "\
Examples:
  render-lab render scenes/grid/config.txt scenes/grid/scene.txt grid.png
  render-lab render config.txt scene.txt out.ppm --set samples_per_pixel=500 --set gamma=2
  render-lab render config.txt scene.txt part.png --crop 100,40,64,64
  render-lab render config.txt scene.txt out.ppm --json --count
  render-lab render config.txt scene.txt - --quiet | pnmtojpeg > out.jpg
  render-lab render config.txt scene.txt out.png --checkpoint long.rlc   # later: the same with --resume long.rlc

Keys of --set: render-lab help config. The bytes are those of render-aos and render-soa.

Limits:
  A picture has at most 1073741824 pixels, a file at most 1073741824 bytes, a line at most 1048576";

/// Options of `render`.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub struct Arguments {
    /// Configuration file; - is standard input
    config: PathBuf,
    /// Scene file; - is standard input
    scene: PathBuf,
    /// Picture to write, PNG or PPM by its name's ending; a name without an ending gives PPM, and - is PPM on standard
    /// output. An old file is replaced when the new one is complete and not before
    out: PathBuf,
    /// How objects and pixels lie in memory; changes no byte
    #[arg(long, value_enum, default_value_t)]
    layout: LayoutName,
    /// How surfaces scatter light
    #[arg(long, value_enum, default_value_t)]
    scatter: ScatterName,
    /// Replace a value of the configuration; may be repeated
    #[arg(long, value_name = "KEY=VALUE", value_parser = Setting, hide_possible_values = true)]
    set: Vec<String>,
    /// Write this part of the picture only. What comes before it is rendered all the same, for its random numbers
    #[arg(long, value_name = "COLUMN,ROW,WIDTH,HEIGHT", value_parser = parse_crop)]
    crop: Option<[usize; 4]>,
    #[command(flatten)]
    stages: Stages,
    /// Count rays and hits too: renders again, by the reference, which may take far longer
    #[arg(long)]
    count: bool,
    /// Print what it took as JSON on standard output
    #[arg(long)]
    json: bool,
    /// Say nothing but errors
    #[arg(long)]
    quiet: bool,
}

/// Takes any text as a setting, and offers the keys to the scripts that complete a command line.
#[derive(Clone)]
struct Setting;

impl TypedValueParser for Setting {
    type Value = String;

    fn parse_ref(&self, command: &Command, argument: Option<&Arg>, value: &OsStr) -> Result<String, clap::Error> {
        StringValueParser::new().parse_ref(command, argument, value)
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        let keys = format::CONFIG.iter().map(|line| line.tag.replace(':', "="));
        Some(Box::new(keys.map(PossibleValue::new)))
    }
}

fn parse_crop(text: &str) -> Result<[usize; 4], String> {
    let numbers: Vec<usize> = text.split(',').filter_map(|number| number.trim().parse().ok()).collect();
    <[usize; 4]>::try_from(numbers)
        .ok()
        .filter(|[.., width, height]| text.matches(',').count() == 3 && *width > 0 && *height > 0)
        .ok_or_else(|| "four numbers are needed, COLUMN,ROW,WIDTH,HEIGHT, the last two positive".to_owned())
}

/// The time, the memory and the rays of one rendering.
#[derive(Clone, Debug, Serialize)]
struct Taken {
    width: usize,
    height: usize,
    samples_per_pixel: u64,
    /// Number of camera rays in the rows that were rendered.
    primary_rays: u64,
    /// Elapsed time in seconds, including the time to write the file.
    seconds: f64,
    user_seconds: f64,
    nanoseconds_per_primary_ray: f64,
    peak_memory_bytes: u64,
    /// Number of all rays; `None` without `--count`.
    rays: Option<u64>,
    hits: Option<u64>,
    nanoseconds_per_ray: Option<f64>,
}

impl Arguments {
    /// Renders the scene, writes the picture, and prints what it took.
    ///
    /// # Errors
    /// An error of a file, or [`Failure::Interrupted`].
    pub fn run(&self, options: Options) -> Result<(), Failure> {
        let is_dash = |path: &Path| path == Path::new("-");
        if is_dash(&self.config) && is_dash(&self.scene) {
            return Err("standard input (-) can be only one of the two files".into());
        }
        if is_dash(&self.out) && self.json {
            return Err("--json and the picture - both write to standard output; choose a file".into());
        }
        let kind = Kind::of(&self.out, Kind::Ppm)?;
        let inputs: Vec<&Path> = [&self.config, &self.scene].into_iter().map(PathBuf::as_path).collect();
        for path in self.stages.files() {
            output::refuse_inputs(path, &inputs)?;
            if *path == self.out {
                return Err("the picture and its checkpoint need a file each".into());
            }
        }
        let kept = self.stages.files().map(PathBuf::as_path);
        output::refuse_inputs(&self.out, &inputs.iter().copied().chain(kept).collect::<Vec<_>>())?;
        let config = sources::config(&self.config, &self.set)?;
        let scene = sources::scene(&self.scene)?;
        let interrupt = Interrupt::listen();
        let mut taken = match self.layout {
            LayoutName::Aos => self.write_picture::<Aos>(&config, &scene, (kind, options), &interrupt)?,
            LayoutName::Soa => self.write_picture::<Soa>(&config, &scene, (kind, options), &interrupt)?,
        };
        if self.count {
            let counts = cpu::reference::render_counted::<cpu::reference::intersect::Exact>(
                &config,
                &scene,
                self.scatter.into(),
                |_, _| {},
            )?;
            taken.rays = Some(counts.rays);
            taken.hits = Some(counts.hits);
            // The rays of the whole picture were counted. With `--crop`, the time is that of a part of the picture, so
            // the time of one ray is unknown.
            let all = self.crop.is_none() && counts.rays > 0;
            taken.nanoseconds_per_ray = all.then(|| taken.user_seconds * 1e9 / counts.rays as f64);
        }
        if self.json {
            super::print_json(&taken)?;
        }
        if !self.quiet {
            terminal::note(&format!("{}: {taken}", sources::output_name(&self.out)));
        }
        Ok(())
    }

    /// Renders the picture and writes its file. Returns the time, the memory and the rays.
    fn write_picture<L: Renderable>(
        &self,
        config: &Config,
        scene: &Scene,
        (kind, options): (Kind, Options),
        interrupt: &Interrupt,
    ) -> Result<Taken, Failure> {
        let explain = |error: Error| sources::about_picture(error, &self.config, &self.set);
        let prepared = Prepared::<L>::new(config, scene, self.scatter.into()).map_err(explain)?;
        let size = prepared.size;
        let part = self.crop.unwrap_or([0, 0, size.width(), size.height()]);
        let rows = rows_of(part, size.width(), size.height())?;
        let output = Output::open(&sources::output(&self.out), options)?;
        let (before, start) = (own_seconds(), Instant::now());
        let origin = || Origin::new(config, scene, self.scatter);
        let (from, mut run) = self.stages.begin(origin, size, rows, options)?;
        let first = from.as_ref().map_or(0, |from| from.rows);
        let bar = if self.quiet { ProgressBar::hidden() } else { progress(rows) }.with_position(first as u64);
        bar.reset_eta();
        let (image, done) = engine::render_rows::<L>(&prepared, from.as_ref(), |row, image, streams| {
            bar.set_position(row as u64);
            run.after_row(row, image, streams, interrupt)
        })?;
        bar.finish_and_clear();
        run.end(done, interrupt)?;
        let picture = Picture::of(&image)?;
        let picture = if self.crop.is_some() { picture.crop(part)? } else { picture };
        output.fill(|file| picture.write(kind, file))?;
        let primary_rays = (((done - first) * size.width()) as u64).saturating_mul(prepared.samples);
        let user_seconds = own_seconds() - before;
        Ok(Taken {
            width: picture.width,
            height: picture.height,
            samples_per_pixel: prepared.samples,
            primary_rays,
            seconds: start.elapsed().as_secs_f64(),
            user_seconds,
            nanoseconds_per_primary_ray: user_seconds * 1e9 / primary_rays as f64,
            peak_memory_bytes: peak_memory(),
            rays: None,
            hits: None,
            nanoseconds_per_ray: None,
        })
    }
}

/// Returns the number of rows to render for a part of the picture (x, y, width, height): all rows down to the last one
/// of the part. Returns an error if the part goes beyond the picture.
fn rows_of([x, y, part_width, part_height]: [usize; 4], width: usize, height: usize) -> Result<usize, String> {
    let within = |start: usize, length: usize, all| start.checked_add(length).filter(|&end| end <= all);
    match (within(x, part_width, width), within(y, part_height, height)) {
        (Some(_), Some(rows)) => Ok(rows),
        _ => Err(format!("--crop goes beyond the picture of {width} x {height} pixels")),
    }
}

/// Returns a progress bar on standard error. It shows nothing if standard error is not a terminal.
fn progress(rows: usize) -> ProgressBar {
    const TEMPLATE: &str = "{wide_bar} {percent:>3} %  {per_sec}  {eta} left";
    let style = ProgressStyle::with_template(TEMPLATE).unwrap_or_else(|_| ProgressStyle::default_bar());
    ProgressBar::with_draw_target(Some(rows as u64), ProgressDrawTarget::stderr()).with_style(style.with_key(
        "per_sec",
        |state: &indicatif::ProgressState, out: &mut dyn std::fmt::Write| {
            // An error is ignored: it means that the bar cannot be shown.
            let _ = write!(out, "{:.0} rows/s", state.per_sec());
        },
    ))
}

/// The least nanoseconds that are shown; with one decimal, less would be 0.0.
const SHOWN: f64 = 0.05;

impl std::fmt::Display for Taken {
    fn fmt(&self, out: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let (seconds, memory) = (self.user_seconds, self.peak_memory_bytes as f64 / 1e6);
        write!(out, "{} x {} pixels, {} samples each: ", self.width, self.height, self.samples_per_pixel)?;
        write!(out, "{:.3} s, {seconds:.3} s of user time, ", self.seconds)?;
        // The system's clock of user time may be too coarse for a tiny picture, and then counts nothing.
        if self.nanoseconds_per_primary_ray >= SHOWN {
            write!(out, "{:.1} ns a primary ray, ", self.nanoseconds_per_primary_ray)?;
        }
        write!(out, "peak memory {memory:.1} MB")?;
        if let (Some(rays), Some(hits)) = (self.rays, self.hits) {
            write!(out, "; {rays} rays, {hits} hits")?;
        }
        let time = self.nanoseconds_per_ray.filter(|&time| time >= SHOWN);
        time.map_or(Ok(()), |time| write!(out, ", {time:.1} ns a ray"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_time_that_was_not_counted_is_not_shown() {
        let taken = |nanoseconds| Taken {
            width: 1,
            height: 1,
            samples_per_pixel: 1,
            primary_rays: 1,
            seconds: 1.0,
            user_seconds: 0.0,
            nanoseconds_per_primary_ray: nanoseconds,
            peak_memory_bytes: 1,
            rays: Some(1),
            hits: Some(1),
            nanoseconds_per_ray: Some(nanoseconds),
        };
        let [none, some] = [0.0, 2.0].map(|nanoseconds| taken(nanoseconds).to_string());
        assert!(!none.contains(" ns "), "{none}");
        assert!(some.contains("2.0 ns a primary ray") && some.ends_with("2.0 ns a ray"), "{some}");
    }

    #[test]
    fn a_part_is_four_numbers() {
        assert_eq!(parse_crop("1,2,3,4"), Ok([1, 2, 3, 4]));
        for text in ["", "1,2,3", "1,2,3,4,5", "1,2,0,4", "1,2,3,x", "-1,2,3,4", "1,2,3,4,x"] {
            assert!(parse_crop(text).is_err(), "{text}");
        }
    }

    #[test]
    fn only_the_rows_down_to_the_part_are_needed() {
        assert_eq!(rows_of([1, 2, 3, 4], 4, 9), Ok(6));
        assert!(rows_of([2, 0, 3, 1], 4, 9).is_err());
        assert!(rows_of([0, 9, 1, 1], 4, 9).is_err());
        assert!(rows_of([0, 0, 1, usize::MAX], 4, 9).is_err());
    }
}
