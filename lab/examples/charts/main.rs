//! Draws the charts of the documents from the tables of `stress` and `steps`: `cargo run --release -p lab --example
//! charts docs/accuracy`.

mod accuracy;

use std::path::Path;
use std::process::ExitCode;

use lab::report::chart::Chart;
use output::{Options, Output};

const USAGE: &str = "\
charts FOLDER
Draws the tables that stress --out and steps wrote into FOLDER, and writes eight charts beside them.

Example:
  cargo run --release -p lab --example charts docs/accuracy";

fn main() -> ExitCode {
    let arguments: Vec<_> = std::env::args().skip(1).collect();
    let drawn = match &arguments[..] {
        [first, ..] if first == "--help" => {
            println!("{USAGE}");
            return ExitCode::SUCCESS;
        }
        [folder] => accuracy::charts(Path::new(folder)).and_then(|charts| {
            charts.iter().try_for_each(|chart| write(chart, &Path::new(folder).join(format!("{}.svg", chart.name))))
        }),
        _ => Err("a FOLDER is needed; see --help".to_owned()),
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
