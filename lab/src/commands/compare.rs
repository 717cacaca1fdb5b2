//! `render-lab compare`: compares two pictures.

mod page;

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use minijinja::value::Serde;
use minijinja::{Value, context};
use output::Options;

use crate::difference::{Difference, MAXIMUM_BOUND, Numbers, RMSE_BOUND};
use crate::heatmap::{self, Scale, heatmap};
use crate::numbers::{LEAST, above_zero, number};
use crate::picture::any::{Any, Kind};
use crate::picture::floats::{Floats, GAMMA};
use crate::picture::{Picture, parse_crop};
use crate::template::filled;
use crate::{Failure, sources, terminal};

/// Options of `compare`.
#[derive(Debug, Args)]
#[command(after_help = include_str!("../../help/compare.txt").trim_ascii_end())]
pub struct Arguments {
    /// Picture, PPM, PNG, PFM, NPY or EXR; - is standard input
    first: PathBuf,
    /// Picture of the same size
    second: PathBuf,
    /// What the numbers of two PFM, NPY or EXR are: light, which is judged as a picture, or numbers such as depths.
    /// Without it, numbers of one channel, with NaN, below -0.1, or whole and above 1 are no light
    #[arg(long = "as", value_enum, value_name = "WHAT")]
    meaning: Option<Meaning>,
    /// Gamma between bytes and the linear light of PFM, NPY and EXR
    #[arg(long, default_value_t = GAMMA, value_parser = above_zero)]
    gamma: f64,
    /// Part or layer of an EXR, or one of its channels; given twice, the second is for the second picture
    #[arg(long, value_name = "NAME")]
    layer: Vec<String>,
    /// Compare this part of both pictures only
    #[arg(long, value_name = "COLUMN,ROW,WIDTH,HEIGHT", value_parser = parse_crop, allow_hyphen_values = true)]
    crop: Option<[usize; 4]>,
    /// Accept pictures whose largest difference is below this: 150 levels, or none for numbers
    #[arg(long, value_name = "DIFFERENCE", value_parser = above_zero)]
    accept_maximum: Option<f64>,
    /// Accept pictures whose RMSE is below this: 10 levels, or none for numbers
    #[arg(long, value_name = "RMSE", value_parser = above_zero)]
    accept_rmse: Option<f64>,
    /// Write a picture of where they differ, with a scale below, PNG or PPM by its name's ending; - is PNG on standard
    /// output
    #[arg(long, value_name = "OUT.png")]
    heatmap: Option<PathBuf>,
    /// Difference that has the heat map's last colour, in levels or in the unit of the numbers; the largest without it
    #[arg(
        long,
        value_name = "DIFFERENCE",
        requires = "heatmap",
        value_parser = number(LEAST..=1e9, "a number above 0 and up to 1000000000")
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

/// What numbers are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Meaning {
    /// Linear light
    Light,
    /// Other numbers, such as depths
    Numbers,
}

/// Two pictures that can be compared.
enum Pair {
    Pictures([Picture; 2]),
    Numbers([Floats; 2]),
}

impl Arguments {
    /// Compares the two pictures, prints the figures, and writes the heat map if one was asked for.
    ///
    /// # Errors
    /// [`Failure::Rejected`] if the difference is not accepted, or an error of a file.
    pub fn run(&self, options: Options) -> Result<(), Failure> {
        sources::refuse_inputs_in_one(&[&self.first, &self.second])?;
        let outs: Vec<_> = self.heatmap.iter().chain(&self.html).map(PathBuf::as_path).collect();
        sources::check_outputs(&outs, &[&self.first, &self.second], self.json)?;
        if self.layer.len() > 2 {
            return Err("--layer is for the first and the second picture, so it may be given twice".into());
        }
        let open =
            |path: &PathBuf| -> Result<_, Failure> { Ok((Kind::of_drawing(path)?, sources::open(path, options)?)) };
        let heatmap_output = self.heatmap.as_ref().map(open).transpose()?;
        let html = self.html.as_ref().map(|path| sources::open(path, options)).transpose()?;
        let pair = self.pair()?;
        let figures = self.figures(&pair)?;
        let text = |is_page| -> Result<String, Failure> {
            Ok(filled(include_str!("../../templates/compare.txt"), figures.values(is_page))?)
        };
        if let Some((kind, output)) = heatmap_output {
            let map = match &pair {
                Pair::Numbers([first, second]) => heatmap::of_numbers(first, second, self.max, self.signed)?,
                Pair::Pictures([first, second]) => {
                    let automatic = Scale::automatic(first, second, self.signed);
                    heatmap(first, second, Scale { most: self.max.unwrap_or(automatic.most), ..automatic })?
                }
            };
            output.fill(|file| Any::Bytes(map).write(kind, GAMMA, file))?;
        }
        if let Some(output) = html {
            let names = [&self.first, &self.second].map(|path| terminal::name(path));
            let page = page::page(&pair, names, &text(true)?)?;
            output.fill(|file| file.write_all(page.as_bytes()))?;
        }
        let (text, accepted) = (text(false)?, figures.accepted());
        match &figures {
            Figures::Levels { levels, .. } => super::print_as(self.json, &outs, levels, || text)?,
            Figures::Numbers { numbers, .. } => super::print_as(self.json, &outs, numbers, || text)?,
        }
        if accepted { Ok(()) } else { Err(Failure::Rejected) }
    }

    /// Reads the two pictures.
    fn pair(&self) -> Result<Pair, Failure> {
        let layer = |at: usize| self.layer.get(at).or(self.layer.last()).map(String::as_str);
        let read = |path: &PathBuf, at| -> Result<Any, Failure> {
            let name = || terminal::name(path);
            let picture = Any::read_layer(&sources::input(path), layer(at))?;
            let part = self.crop.map(|part| picture.crop(part)).transpose();
            Ok(part.map_err(|error| format!("{}: {error}", name()))?.unwrap_or(picture))
        };
        let pictures = (read(&self.first, 0)?, read(&self.second, 1)?);
        let is_numbers = match (&pictures, self.meaning) {
            ((Any::Floats(_), Any::Floats(_)), Some(meaning)) => meaning == Meaning::Numbers,
            ((Any::Floats(first), Any::Floats(second)), None) => first.is_no_light() || second.is_no_light(),
            (_, Some(Meaning::Numbers)) => {
                return Err("--as numbers needs two files of numbers: PFM, NPY or EXR".into());
            }
            _ => false,
        };
        match pictures {
            (Any::Floats(first), Any::Floats(second)) if is_numbers => Ok(Pair::Numbers([first, second])),
            (first, second) => {
                for (path, picture) in [(&self.first, &first), (&self.second, &second)] {
                    let clipped = if let Any::Floats(floats) = picture { floats.clipped() } else { None };
                    clipped
                        .iter()
                        .for_each(|lost| terminal::note(&format!("{}: as light, {lost}", terminal::name(path))));
                }
                Ok(Pair::Pictures([first.into_picture(self.gamma)?, second.into_picture(self.gamma)?]))
            }
        }
    }

    fn figures(&self, pair: &Pair) -> Result<Figures, Failure> {
        Ok(match pair {
            Pair::Numbers([first, second]) => {
                let bounds = [self.accept_maximum, self.accept_rmse];
                Figures::Numbers { numbers: Numbers::between(first, second, bounds)?, bounds }
            }
            Pair::Pictures([first, second]) => {
                let bounds = [self.accept_maximum.unwrap_or(MAXIMUM_BOUND), self.accept_rmse.unwrap_or(RMSE_BOUND)];
                Figures::Levels { levels: Difference::within(first, second, bounds)?, bounds }
            }
        })
    }
}

/// The figures of a comparison, with the bounds of the maximum and of the RMSE.
enum Figures {
    Levels { levels: Difference, bounds: [f64; 2] },
    Numbers { numbers: Numbers, bounds: [Option<f64>; 2] },
}

impl Figures {
    fn accepted(&self) -> bool {
        match self {
            Self::Levels { levels, .. } => levels.accepted,
            Self::Numbers { numbers, .. } => numbers.accepted,
        }
    }

    /// Returns the values for the template of the text. On a page, a bound that failed is marked.
    fn values(&self, is_page: bool) -> Value {
        let (figures, [maximum, rmse], bounds) = match self {
            Self::Levels { levels, bounds } => {
                let text = |value: f64| format!("{value:.3}");
                let figures = [(levels.maximum, text(levels.maximum)), (levels.rmse, text(levels.rmse))];
                (Value::from(Serde(levels)), figures, bounds.map(Some))
            }
            Self::Numbers { numbers, bounds } => {
                // As many digits as a number of a picture has.
                let text = |value: f64| (value as f32).to_string();
                let figures = [(numbers.maximum, text(numbers.maximum)), (numbers.rmse, text(numbers.rmse))];
                (Value::from(Serde(numbers)), figures, *bounds)
            }
        };
        let line = |name: &str, (value, text): (f64, String), bound: Option<f64>| match bound {
            None => format!("{name}{text}"),
            Some(bound) if value < bound => format!("{name}{text}  (accepted below {bound})"),
            Some(bound) => {
                let [start, end] = if is_page { ["<mark>", "</mark>"] } else { [""; 2] };
                format!("{start}{name}{text}  (not accepted: it must be below {bound}){end}")
            }
        };
        let maximum_line = line("maximum    ", maximum, bounds[0]);
        let rmse_line = line("RMSE       ", rmse, bounds[1]);
        context! { maximum_line, rmse_line, is_judged => bounds != [None; 2], ..figures }
    }
}
