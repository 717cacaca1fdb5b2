//! `render-lab compare`: compares two pictures.

use std::path::PathBuf;

use clap::Args;
use colorous::INFERNO;
use minijinja::value::Serde;
use minijinja::{Value, context};
use output::Options;
use serde::Serialize;

use crate::difference::{Difference, Errors, MAXIMUM_BOUND, RMSE_BOUND};
use crate::heatmap::{Scale, color_at, heatmap};
use crate::numbers::{LEAST, number};
use crate::picture::Picture;
use crate::picture::any::{Any, Kind};
use crate::picture::floats::{Floats, GAMMA};
use crate::template::filled;
use crate::{Failure, sources, terminal};

/// Options of `compare`.
#[derive(Debug, Args)]
#[command(after_help = include_str!("../../help/compare.txt").trim_ascii_end())]
pub struct Arguments {
    /// Picture, PPM, PNG, PFM, NPY or EXR; - is standard input. Numbers are compared as they are if both pictures have
    /// them, and otherwise as linear light for the gamma 2.2
    first: PathBuf,
    /// Picture of the same size
    second: PathBuf,
    /// Write a picture of where they differ, with a scale below, PNG or PPM by its name's ending; - is PNG on standard
    /// output
    #[arg(long, value_name = "OUT.png")]
    heatmap: Option<PathBuf>,
    /// Difference in levels, from 0 to 255, that has the heat map's last colour; the largest difference without it
    #[arg(
        long,
        value_name = "LEVELS",
        requires = "heatmap",
        value_parser = number(LEAST..=255.0, "a number above 0 and up to 255")
    )]
    max: Option<f64>,
    /// Show in the heat map which picture is brighter: red where the second is, blue where the first is
    #[arg(long, requires = "heatmap")]
    signed: bool,
    /// Write a page that shows both: with a slider, blinking or as a difference, with zoom and the values of a pixel;
    /// - is standard output
    #[arg(long, value_name = "OUT.html")]
    html: Option<PathBuf>,
    /// Print the figures as JSON
    #[arg(long)]
    json: bool,
}

impl Arguments {
    /// Compares the two pictures, prints the figures, and writes the heat map if one was asked for.
    ///
    /// # Errors
    /// [`Failure::Rejected`] if the course does not accept the difference, or an error of a file.
    pub fn run(&self, options: Options) -> Result<(), Failure> {
        sources::refuse_inputs_in_one(&[&self.first, &self.second])?;
        let outs: Vec<_> = self.heatmap.iter().chain(&self.html).map(PathBuf::as_path).collect();
        sources::check_outputs(&outs, &[&self.first, &self.second], self.json)?;
        let open =
            |path: &PathBuf| -> Result<_, Failure> { Ok((Kind::of(path, Kind::Png)?, sources::open(path, options)?)) };
        let heatmap_output = self.heatmap.as_ref().map(open).transpose()?;
        let html = self.html.as_ref().map(|path| sources::open(path, options)).transpose()?;
        let read = |path| Any::read(&sources::input(path));
        let (first, second) = (read(&self.first)?, read(&self.second)?);
        let values = match (&first, &second) {
            (Any::Floats(first), Any::Floats(second)) => Some(difference(first, second)?),
            _ => None,
        };
        let (first, second) = (first.into_picture(GAMMA)?, second.into_picture(GAMMA)?);
        let figures = Figures { levels: Difference::between(&first, &second)?, values };
        let bounds = context! { maximum_bound => MAXIMUM_BOUND, rmse_bound => RMSE_BOUND };
        let values = context! { ..bounds, ..Value::from(Serde(&figures)) };
        let text = filled(include_str!("../../templates/compare.txt"), values)?;
        if let Some((kind, output)) = heatmap_output {
            let automatic = Scale::automatic(&first, &second, self.signed);
            let map = heatmap(&first, &second, Scale { most: self.max.unwrap_or(automatic.most), ..automatic })?;
            output.fill(|file| Any::Bytes(map).write(kind, GAMMA, file))?;
        }
        if let Some(output) = html {
            let names = [&self.first, &self.second].map(|path| terminal::name(path));
            let page = page([&first, &second], names, &text)?;
            output.fill(|file| file.write_all(page.as_bytes()))?;
        }
        super::print_as(self.json, &outs, &figures, || text)?;
        if figures.levels.accepted { Ok(()) } else { Err(Failure::Rejected) }
    }
}

/// The figures of a comparison.
#[derive(Debug, Serialize)]
struct Figures {
    #[serde(flatten)]
    levels: Difference,
    /// The difference of the numbers, if both pictures have numbers.
    #[serde(skip_serializing_if = "Option::is_none")]
    values: Option<Errors>,
}

/// Returns the difference between two pictures of numbers, over all channels. A number differs by infinity from none
/// (NaN).
fn difference(first: &Floats, second: &Floats) -> Result<Errors, String> {
    let shapes = [first, second].map(|floats| (floats.width, floats.height, floats.channels));
    if shapes[0] != shapes[1] {
        let [a, b] = shapes.map(|(width, height, channels)| format!("{width} x {height} x {channels}"));
        return Err(format!("the pictures have different sizes or channels: {a} and {b}"));
    }
    Ok(Errors::of(first.values.iter().zip(&second.values).map(|(&a, &b)| {
        if a == b || a.is_nan() && b.is_nan() {
            return 0.0;
        }
        let distance = (f64::from(a) - f64::from(b)).abs();
        if distance.is_nan() { f64::INFINITY } else { distance }
    })))
}

/// Number of steps of the page's colour map. The page interpolates between them.
const STEPS: usize = 32;

/// Returns a page that shows two pictures with these names: with a slider, blinking, or their difference, with zoom.
/// `figures` is the text below them.
fn page(pictures: [&Picture; 2], [first, second]: [String; 2], figures: &str) -> Result<String, Failure> {
    let addresses = format!("{:?}", [pictures[0].address()?, pictures[1].address()?]);
    let colors: Vec<_> = (0..=STEPS).map(|step| color_at(INFERNO, step as f64 / STEPS as f64)).collect();
    let values = context! { first, second, addresses, colors => format!("{colors:?}"), figures };
    Ok(filled(include_str!("../../templates/compare.html"), values)? + "\n")
}
