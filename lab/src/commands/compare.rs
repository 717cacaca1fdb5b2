//! `render-lab compare`: compares two pictures.

use std::path::PathBuf;

use clap::Args;
use output::{Options, Output};

use crate::Failure;
use crate::difference::{Difference, MAXIMUM_BOUND, RMSE_BOUND};
use crate::heatmap::{Scale, heatmap};
use crate::picture::Picture;
use crate::picture::kind::Kind;
use crate::{sources, terminal};

/// Examples, limits and exit statuses, shown after the help of `compare`.
const EXAMPLES: &str = "\
Examples:
  render-lab compare mine.ppm theirs.ppm
  render-lab compare mine.png theirs.ppm --heatmap where.png
  render-lab compare a.ppm b.ppm --heatmap where.png --signed      # which of the two is brighter
  render-lab compare a.ppm b.ppm --heatmap 1.png --max 20          # one scale for several heat maps
  render-aos config.txt scene.txt /dev/stdout | render-lab compare - theirs.ppm
  render-lab compare a.ppm b.ppm --json | jq .rmse

Limits:
  A picture has at most 67108864 pixels, its file at most 1073741824 bytes; both pictures are held in memory

Exit status: 0 accepted (maximum < 150 and RMSE < 10), 1 not accepted, 2 an error";

/// Options of `compare`.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub struct Arguments {
    /// Picture, PPM or PNG; - is standard input
    first: PathBuf,
    /// Picture of the same size, PPM or PNG
    second: PathBuf,
    /// Write a picture of where they differ, with a scale below, PNG or PPM by its name's ending; - is PNG on standard
    /// output
    #[arg(long, value_name = "OUT.png")]
    heatmap: Option<PathBuf>,
    /// Difference in levels, from 0 to 255, that has the heat map's last colour; the largest difference without it
    #[arg(long, value_name = "LEVELS", requires = "heatmap", value_parser = levels)]
    max: Option<f64>,
    /// Show in the heat map which picture is brighter: red where the second is, blue where the first is
    #[arg(long, requires = "heatmap")]
    signed: bool,
    /// Print the figures as JSON
    #[arg(long)]
    json: bool,
}

fn levels(text: &str) -> Result<f64, String> {
    let number = text.parse().ok().filter(|&levels: &f64| levels > 0.0 && levels <= 255.0);
    number.ok_or_else(|| "a number above 0 and up to 255 is needed".to_owned())
}

impl Arguments {
    /// Compares the two pictures, prints the figures, and writes the heat map if one was asked for.
    ///
    /// # Errors
    /// [`Failure::Rejected`] if the course does not accept the difference, or an error of a file.
    pub fn run(&self, options: Options) -> Result<(), Failure> {
        if self.first == self.second && self.first.as_os_str() == "-" {
            return Err("standard input (-) can be only one of the two pictures".into());
        }
        let is_output_taken = self.heatmap.as_ref().is_some_and(|path| path.as_os_str() == "-");
        if self.json && is_output_taken {
            return Err("--json and --heatmap - both write to standard output; choose a file".into());
        }
        if let Some(path) = &self.heatmap {
            output::refuse_inputs(path, &[&self.first, &self.second])?;
        }
        let open = |path: &PathBuf| -> Result<_, Failure> {
            Ok((Kind::of(path, Kind::Png)?, Output::open(&sources::output(path), options)?))
        };
        let heatmap_output = self.heatmap.as_ref().map(open).transpose()?;
        let read = |path| Picture::read(&sources::input(path));
        let (first, second) = (read(&self.first)?, read(&self.second)?);
        let difference = Difference::between(&first, &second)?;
        if let Some((kind, output)) = heatmap_output {
            let automatic = Scale::automatic(&first, &second, self.signed);
            let map = heatmap(&first, &second, Scale { most: self.max.unwrap_or(automatic.most), ..automatic })?;
            output.fill(|file| map.write(kind, file))?;
        }
        match (self.json, is_output_taken) {
            (true, _) => super::print_json(&difference)?,
            (false, true) => terminal::note(&Words(&difference).to_string()),
            (false, false) => terminal::print(&Words(&difference).to_string())?,
        }
        if difference.accepted { Ok(()) } else { Err(Failure::Rejected) }
    }
}

/// Formats a difference as lines of text for the terminal.
struct Words<'a>(&'a Difference);

impl std::fmt::Display for Words<'_> {
    fn fmt(&self, out: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Difference { rmse, maximum, mae, psnr, flip, differing, pixels, bounding_box, accepted } = self.0;
        if *differing == 0 {
            return write!(out, "identical: {pixels} pixels");
        }
        writeln!(out, "maximum    {maximum:.3}  (accepted below {MAXIMUM_BOUND})")?;
        writeln!(out, "RMSE       {rmse:.3}  (accepted below {RMSE_BOUND})")?;
        writeln!(out, "MAE        {mae:.3}")?;
        if let Some(psnr) = psnr {
            writeln!(out, "PSNR       {psnr:.2} dB")?;
        }
        match flip {
            Some(flip) => writeln!(out, "FLIP       {flip:.4}")?,
            None => writeln!(
                out,
                "FLIP       not built in (cargo install --locked --path lab --features flip needs a C++ compiler)"
            )?,
        }
        writeln!(out, "differing  {differing} of {pixels} pixels")?;
        if let Some([x, y, width, height]) = bounding_box {
            writeln!(out, "within     {width} x {height} pixels from column {x}, row {y}")?;
        }
        write!(out, "verdict    {}", if *accepted { "accepted" } else { "not accepted" })
    }
}
