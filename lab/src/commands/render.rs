//! `render-lab render`: renders a scene into a file, and shows the progress, time and memory.

mod lock;
mod stages;
mod taken;

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::time::Instant;

use clap::builder::{PossibleValue, StringValueParser, TypedValueParser};
use clap::{Arg, Args, Command};
use cpu::internals::{InstructionSet, Limits, Prepared, render_linear};
use cpu::{Aos, Config, Error, Renderable, Scene, Soa};
use indicatif::ProgressBar;
use measure::clock::{own_seconds, peak_memory};
use output::Options;

use crate::checkpoint::Origin;
use crate::engine::{self, LayoutName, ScatterName, name_of};
use crate::picture::any::{Any, Kind};
use crate::picture::floats::{Floats, GAMMA};
use crate::picture::{Picture, parse_crop, with_room, within};
use crate::show::{self, Quantity};
use crate::{Failure, interrupt, sources, terminal};
use stages::Stages;
use taken::Taken;

/// Options of `render`.
#[derive(Debug, Args)]
#[command(after_help = include_str!("../../help/render.txt").trim_ascii_end())]
pub struct Arguments {
    /// Configuration file; - is standard input
    config: PathBuf,
    /// Scene file; - is standard input
    scene: PathBuf,
    /// Picture to write, PNG or PPM by its name's ending, or its linear light as PFM, NPY or EXR; a name without an
    /// ending gives PPM, and - is PPM on standard output. An old file is replaced when the new one is complete
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
    #[arg(long, value_name = "COLUMN,ROW,WIDTH,HEIGHT", value_parser = parse_crop, allow_hyphen_values = true)]
    crop: Option<[usize; 4]>,
    /// Show this quantity instead of the colours: with a scale in a .png or .ppm, as numbers in the other formats
    #[arg(long, value_enum, value_name = "QUANTITY")]
    show: Option<Quantity>,
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

impl Arguments {
    /// Renders the scene, writes the picture, and prints what it took.
    ///
    /// # Errors
    /// An error of a file, or [`Failure::Interrupted`].
    pub fn run(&self, options: Options) -> Result<(), Failure> {
        sources::refuse_inputs_in_one(&[&self.config, &self.scene])?;
        let kind = Kind::of(&self.out, Kind::Ppm)?;
        let inputs: Vec<&Path> = [&self.config, &self.scene].into_iter().map(PathBuf::as_path).collect();
        for path in self.stages.files() {
            sources::refuse_stdout("a checkpoint", path)?;
            sources::check_outputs(&[path, &self.out], &inputs, self.json)?;
        }
        let kept = self.stages.files().map(PathBuf::as_path);
        let inputs: Vec<_> = inputs.into_iter().chain(kept).collect();
        sources::check_outputs(&[&self.out], &inputs, self.json)?;
        let config = sources::config(&self.config, &self.set)?;
        let scene = sources::scene(&self.scene)?;
        let is_in_parts = self.crop.is_some() || self.stages.files().next().is_some();
        if is_in_parts && (kind.is_of_floats() || self.show.is_some()) {
            return Err("--crop, --checkpoint and --resume are for pictures of colours, .ppm or .png".into());
        }
        let (inputs, how) = ((&config, &scene), (kind, options));
        let mut taken = match self.layout {
            LayoutName::Aos => self.write::<Aos>(inputs, how)?,
            LayoutName::Soa => self.write::<Soa>(inputs, how)?,
        };
        if self.count {
            let counts = cpu::reference::render_linear::<cpu::reference::intersect::Exact>(
                &config,
                &scene,
                self.scatter.into(),
                |_, _| {},
            )?;
            taken.rays = Some(counts.rays);
            taken.hits = Some(counts.hits);
            // The rays of the whole picture were counted. If the time is that of a part of the picture or of a
            // quantity, the time of one ray is unknown.
            let all = !is_in_parts && self.show.is_none() && counts.rays > 0;
            taken.nanoseconds_per_ray = all.then(|| taken.user_seconds * 1e9 / counts.rays as f64);
        }
        if self.json {
            terminal::print_json(&taken)?;
        }
        if !self.quiet {
            terminal::note(&format!("{}: {taken}", sources::output_name(&self.out)));
        }
        Ok(())
    }

    /// Renders the picture or the quantity, and writes it. Returns the time, the memory and the rays.
    fn write<L: Renderable>(&self, inputs: (&Config, &Scene), how: (Kind, Options)) -> Result<Taken, Failure> {
        let ((config, scene), (kind, options)) = (inputs, how);
        let explain = |error: Error| sources::about_picture(error, &self.config, &self.set);
        let prepared = Prepared::<L>::new(config, scene, self.scatter.into()).map_err(explain)?;
        let output = sources::open(&self.out, options)?;
        let (before, start) = (own_seconds(), Instant::now());
        let rows = prepared.size.height();
        let bar = if self.quiet { ProgressBar::hidden() } else { terminal::progress(rows, "rows") };
        let (picture, rows) = if let Some(quantity) = self.show {
            interrupt::listen();
            let floats = show::show(quantity, &prepared, |row| {
                bar.set_position(row as u64);
                interrupt::flow()
            })?;
            let mut floats = floats.ok_or(Failure::Interrupted)?;
            floats.is_depth = quantity == Quantity::Depth;
            (if kind.is_of_floats() { Any::Floats(floats) } else { Any::Bytes(quantity.draw(&floats)?) }, rows)
        } else {
            self.colors(inputs, how, &prepared, &bar)?
        };
        bar.finish_and_clear();
        let (width, height) = match &picture {
            Any::Bytes(picture) => (picture.width, picture.height),
            Any::Floats(floats) => (floats.width, floats.height),
        };
        output.fill(|file| picture.write(kind, GAMMA, file))?;
        let rays = self.show.map_or(prepared.samples, |quantity| quantity.primary_rays(prepared.samples));
        let primary_rays = ((rows * prepared.size.width()) as u64).saturating_mul(rays);
        let user_seconds = own_seconds() - before;
        Ok(Taken {
            width,
            height,
            samples_per_pixel: self.show.is_none_or(Quantity::takes_samples).then_some(prepared.samples),
            primary_rays,
            seconds: start.elapsed().as_secs_f64(),
            user_seconds,
            nanoseconds_per_primary_ray: (primary_rays > 0).then(|| user_seconds * 1e9 / primary_rays as f64),
            peak_memory_bytes: peak_memory(),
            ..Taken::default()
        })
    }

    /// Renders the colours of the pixels: as bytes, or as linear light for a format of numbers. Returns the number of
    /// rendered rows too.
    fn colors<L: Renderable>(
        &self,
        (config, scene): (&Config, &Scene),
        (kind, options): (Kind, Options),
        prepared: &Prepared<L>,
        bar: &ProgressBar,
    ) -> Result<(Any, usize), Failure> {
        let (width, height) = (prepared.size.width(), prepared.size.height());
        if kind.is_of_floats() {
            let mut floats = Floats::zeros(width, height, 3)?;
            render_linear(prepared, InstructionSet::chosen(), &Limits::default(), |index, mean| {
                bar.set_position((index / width) as u64);
                let pixel = &mut floats.values[3 * index..3 * index + 3];
                pixel.iter_mut().zip(mean.to_array()).for_each(|(value, mean)| *value = mean as f32);
            })?;
            return Ok((Any::Floats(floats), height));
        }
        let part = self.crop.unwrap_or([0, 0, width, height]);
        within(part, width, height)?;
        let rows = part[1] + part[3];
        // What the file needs is there before the long work.
        let pixels = with_room(part[2] * part[3])?;
        interrupt::listen();
        let origin = || Origin::new(config, scene, &name_of(&self.scatter));
        let (from, mut run) = self.stages.begin(origin, prepared.size, rows, options)?;
        let first = from.as_ref().map_or(0, |from| from.rows);
        bar.set_length(rows as u64);
        bar.set_position(first as u64);
        bar.reset_eta();
        let (image, done) = engine::render_rows::<L>(prepared, from.as_ref(), |row, image, streams| {
            bar.set_position(row as u64);
            run.after_row(row, image, streams)
        })?;
        run.end(done)?;
        Ok((Any::Bytes(Picture::part(part, width, pixels, Picture::pixels_of(&image))), done - first))
    }
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
