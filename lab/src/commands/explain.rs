//! `render-lab explain`: tells the life of a pixel.

use std::path::PathBuf;

use clap::Args;
use cpu::{Image, Rgb};
use literal::explain::Walk;
use minijinja::value::Serde;
use serde_json::json;

use crate::engine::ScatterName;
use crate::picture::Picture;
use crate::template::filled;
use crate::{Failure, sources, terminal};

/// Options of `explain`.
#[derive(Debug, Args)]
#[command(after_help = include_str!("../../help/explain.txt").trim_ascii_end())]
pub struct Arguments {
    /// Configuration file
    config: PathBuf,
    /// Scene file
    scene: PathBuf,
    /// Column of the pixel, from 0 at the left
    x: usize,
    /// Row of the pixel, from 0 at the top
    y: usize,
    /// Tell only this sample, from 0
    #[arg(long, value_name = "N")]
    sample: Option<usize>,
    /// Show the pixel of another program's picture beside it, and the first pixel that differs
    #[arg(long, value_name = "PICTURE")]
    other: Option<PathBuf>,
    /// How surfaces scatter light
    #[arg(long, value_enum, default_value_t)]
    scatter: ScatterName,
    /// Print it as JSON
    #[arg(long)]
    json: bool,
}

impl Arguments {
    /// Tells the life of the pixel.
    ///
    /// # Errors
    /// An error of a file, or a pixel or a sample that does not exist.
    pub fn run(&self) -> Result<(), Failure> {
        let inputs: Vec<_> = [&self.config, &self.scene].into_iter().chain(&self.other).map(PathBuf::as_path).collect();
        sources::refuse_inputs_in_one(&inputs)?;
        let config = sources::config(&self.config, &[])?;
        let scene = sources::scene(&self.scene)?;
        let other = self.other.as_ref().map(|path| Picture::read(path)).transpose()?;
        let about = |error| sources::about_picture(error, &self.config, &[]);
        let walk = Walk::new(&config, &scene, self.scatter.into()).map_err(about)?;
        let (width, height) = (walk.image.size().width(), walk.image.size().height());
        if let Some(other) = other.as_ref().filter(|other| (other.width, other.height) != (width, height)) {
            let sizes = format!("{} x {} pixels, and this picture has {width} x {height}", other.width, other.height);
            return Err(format!("{}: it has {sizes}", terminal::name(inputs[2])).into());
        }
        let mut life = walk.explain([self.x, self.y]).map_err(about)?.ok_or_else(|| {
            format!("there is no pixel {} {}: columns are 0 to {}, rows 0 to {}", self.x, self.y, width - 1, height - 1)
        })?;
        let count = life["samples"].as_array().map_or(0, Vec::len);
        if let Some(sample) = self.sample.filter(|&sample| sample >= count) {
            return Err(format!("--sample {sample}: samples are 0 to {}", count - 1).into());
        }
        if let Some(sample) = self.sample {
            life["samples"] = json!([life["samples"][sample].take()]);
        }
        life["first_sample"] = json!(self.sample.unwrap_or(0));
        let both = |place: usize| {
            let Rgb { red, green, blue } = walk.image.pixel(place);
            let (ours, theirs) = ([red, green, blue], other.as_ref()?.pixels[place]);
            Some(json!({"column": place % width, "row": place / width, "ours": ours, "theirs": theirs}))
        };
        life["other"] = json!(both(self.y * width + self.x));
        life["first"] = json!((0..width * height).filter_map(both).find(|both| both["ours"] != both["theirs"]));
        let text = filled(include_str!("../../templates/explain.txt"), Serde(&life).into())?;
        super::print_as(self.json, &[], &life, || text)
    }
}
