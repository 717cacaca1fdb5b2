//! Draws the charts of the documents from the data of two other programs: `cargo run --release -p lab --example charts
//! nearest.json docs/nearest.svg`, or `... --example charts docs/accuracy`.

mod accuracy;
mod nearest;

use std::path::Path;
use std::process::ExitCode;

use lab::report::chart::Chart;
use output::{Options, Output};

const USAGE: &str = "\
charts NEAREST.json CHART.svg
charts FOLDER
Draws the results that bench/nearest --json wrote: the time of a nearest hit of rays from surfaces, on a ground, against
the number of objects, with the first instruction set of the results. Or draws the tables that stress --out wrote into
FOLDER, and writes five charts beside them.

Examples:
  cargo run --release -p lab --example charts nearest.json docs/nearest.svg
  cargo run --release -p lab --example charts docs/accuracy";

fn main() -> ExitCode {
    let arguments: Vec<_> = std::env::args().skip(1).collect();
    let drawn = match &arguments[..] {
        [first, ..] if first == "--help" => {
            println!("{USAGE}");
            return ExitCode::SUCCESS;
        }
        [results, chart] => nearest::chart(results).and_then(|nearest| write(&nearest, Path::new(chart))),
        [folder] => accuracy::charts(Path::new(folder)).and_then(|charts| {
            charts.iter().try_for_each(|chart| write(chart, &Path::new(folder).join(format!("{}.svg", chart.name))))
        }),
        _ => Err("NEAREST.json and CHART.svg, or a FOLDER, are needed; see --help".to_owned()),
    };
    match drawn {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("Error: {error}");
            ExitCode::from(2)
        }
    }
}

/// Writes the file `path`, which appears only when it is complete.
fn write(chart: &Chart, path: &Path) -> Result<(), String> {
    let svg = chart.draw()?;
    let written =
        Output::open(path, Options::default()).and_then(|file| file.fill(|file| file.write_all(svg.as_bytes())));
    written.map_err(|error| error.to_string())
}
