//! Draws the results of `bench/nearest` as a chart: the time of a nearest hit against the number of objects.
//!
//! `cargo run --release -p lab --example nearest_chart nearest.json nearest.svg`

use std::fs;
use std::path::Path;
use std::process::ExitCode;

use lab::report::chart::{Axis, Chart, Point, Series};
use lab::report::style::short;
use output::Output;
use serde_json::Value;

const USAGE: &str = "\
nearest_chart RESULTS CHART.svg
Draws the results that bench/nearest --json wrote: the time of a nearest hit of rays from surfaces, on a ground, against
the number of objects, with the first instruction set of the results.

Example:
  cargo run --release -p lab --example nearest_chart nearest.json nearest.svg";

fn main() -> ExitCode {
    let arguments: Vec<_> = std::env::args().skip(1).collect();
    if arguments.iter().any(|argument| argument == "--help") {
        println!("{USAGE}");
        return ExitCode::SUCCESS;
    }
    let [results, chart] = &arguments[..] else {
        eprintln!("Error: RESULTS and CHART.svg are needed; see --help");
        return ExitCode::from(2);
    };
    match draw(results).and_then(|svg| write(chart, &svg)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("Error: {error}");
            ExitCode::from(2)
        }
    }
}

/// Writes the file `path`, which appears only when it is complete.
fn write(path: &str, svg: &str) -> Result<(), String> {
    let written = Output::open(Path::new(path), output::Options::default())
        .and_then(|file| file.fill(|file| file.write_all(svg.as_bytes())));
    written.map_err(|error| error.to_string())
}

/// Returns the chart of the results in the file `path`, as SVG.
fn draw(path: &str) -> Result<String, String> {
    let text = fs::read_to_string(path).map_err(|error| format!("{path}: {error}"))?;
    let results: Value = serde_json::from_str(&text).map_err(|error| format!("{path}: {error}"))?;
    let times = results["times"].as_array().map_or(&[][..], Vec::as_slice);
    let set = times.first().and_then(|time| time["set"].as_str()).ok_or(format!("{path}: it has no times"))?;
    let is_shown = |time: &&Value, dense: bool| {
        let setting = &time["setting"];
        time["set"] == set && time["from_surfaces"] == true && setting["ground"] == true && setting["dense"] == dense
    };
    let lines = [("ours, sparse", false, false), ("Embree, sparse", false, true)];
    let lines = lines.into_iter().chain([("ours, dense", true, false), ("Embree, dense", true, true)]);
    let series = lines.zip(1..).map(|((name, dense, embree), color)| {
        let time_of = |time: &Value| if embree { time["embree"]["time"].as_f64() } else { time["ours"].as_f64() };
        let point = |time: &Value| {
            let (x, y) = (time["setting"]["size"].as_f64()?, time_of(time)?);
            Some(Point { x, y, bounds: None })
        };
        let points = times.iter().filter(|time| is_shown(time, dense)).filter_map(point).collect();
        Series { name: name.to_owned(), color, is_guide: false, points }
    });
    let chart = Chart {
        name: "nearest".to_owned(),
        title: format!("Nearest hit of a ray from a surface ({set})"),
        x: Axis { label: "objects in the scene", format: short },
        y: Axis { label: "ns a ray", format: short },
        series: series.filter(|series| !series.points.is_empty()).collect(),
        rows: Vec::new(),
    };
    chart.draw()
}
