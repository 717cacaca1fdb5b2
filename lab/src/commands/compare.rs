//! `render-lab compare`: two pictures held against each other.

use std::path::PathBuf;

use clap::Args;
use cpu::output::{self, Options, Output};

use crate::Failure;
use crate::difference::{Difference, MAXIMUM_BOUND, RMSE_BOUND};
use crate::heatmap::heatmap;
use crate::picture::Picture;

/// Examples.
const EXAMPLES: &str = "\
Examples:
  render-lab compare mine.ppm theirs.ppm
  render-lab compare mine.png theirs.ppm --heatmap where.png
  render-lab compare a.ppm b.ppm --json | jq .rmse

Limits:
  A picture has at most 67108864 pixels, its file at most 1073741824 bytes; both pictures are held in memory

Exit status: 0 accepted (maximum < 150 and RMSE < 10), 1 not accepted, 2 an error";

/// Options of `compare`.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub struct Arguments {
    /// Picture, PPM or PNG
    first: PathBuf,
    /// Picture of the same size, PPM or PNG
    second: PathBuf,
    /// Write a PNG that shows where they differ, the largest difference brightest
    #[arg(long, value_name = "OUT.png")]
    heatmap: Option<PathBuf>,
    /// Print the figures as JSON
    #[arg(long)]
    json: bool,
}

impl Arguments {
    /// Compares.
    ///
    /// # Errors
    /// [`Failure::Rejected`], or what is wrong with a file.
    pub fn run(&self, options: Options) -> Result<(), Failure> {
        if let Some(path) = &self.heatmap {
            output::refuse_inputs(path, &[&self.first, &self.second])?;
        }
        let heatmap_output = self.heatmap.as_ref().map(|path| Output::open(path, options)).transpose()?;
        let (first, second) = (Picture::read(&self.first)?, Picture::read(&self.second)?);
        let difference = Difference::between(&first, &second)?;
        if let Some(output) = heatmap_output {
            let map = heatmap(&first, &second, difference.maximum)?;
            output.fill(|file| map.write_png(file))?;
        }
        if self.json {
            super::print_json(&difference)?;
        } else {
            crate::terminal::print(&Words(&difference).to_string())?;
        }
        if difference.accepted { Ok(()) } else { Err(Failure::Rejected) }
    }
}

/// The figures as lines for a reader.
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
        if let Some(flip) = flip {
            writeln!(out, "FLIP       {flip:.4}")?;
        }
        writeln!(out, "differing  {differing} of {pixels} pixels")?;
        if let Some([x, y, width, height]) = bounding_box {
            writeln!(out, "within     {width} x {height} pixels from column {x}, row {y}")?;
        }
        write!(out, "verdict    {}", if *accepted { "accepted" } else { "not accepted" })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words(first: [u8; 3], second: [u8; 3]) -> String {
        let picture = |pixel| Picture { width: 1, height: 1, pixels: vec![pixel] };
        let difference = Difference::between(&picture(first), &picture(second)).expect("one size");
        Words(&difference).to_string()
    }

    #[test]
    fn the_verdict_is_the_last_line() {
        assert_eq!(words([7; 3], [7; 3]), "identical: 1 pixels");
        let near = words([0; 3], [3, 0, 0]);
        assert!(near.starts_with("maximum    1.000") && near.ends_with("verdict    accepted"), "{near}");
        assert!(words([0; 3], [255; 3]).ends_with("verdict    not accepted"));
    }
}
