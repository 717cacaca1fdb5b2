//! The charts of the stress test: wrong decisions and errors of lambda in every regime, and wrong decisions over the
//! radius of a sphere. The implementations in WGSL are left out, because they have the figures of those in Rust.
//!
//! Also the charts of `steps`: what the steps of the exact intersection cost, and how often each of them decides.

use std::path::Path;

use lab::report::chart::{Axis, Chart, Point, Series};
use lab::report::style::short;
use serde::Deserialize;
use serde::de::DeserializeOwned;

/// The columns of `errors.csv` that are drawn.
#[derive(Deserialize)]
struct Row {
    object: String,
    regime: String,
    implementation: String,
    cases: f64,
    wrong: f64,
    lambda_max: f64,
}

/// The columns of `step-times.csv` that are drawn.
#[derive(Deserialize)]
struct StepTime {
    object: String,
    step: String,
    difficulty: f64,
    nanoseconds: f64,
}

/// Returns the eight charts of the tables in `folder`.
pub fn charts(folder: &Path) -> Result<Vec<Chart>, String> {
    let rows: Vec<Row> = read(&folder.join("errors.csv"))?;
    let mut charts = Vec::new();
    for object in ["sphere", "cylinder"] {
        let its = || rows.iter().filter(|row| row.object == object);
        let title = format!("Wrong decisions of {object}s (no mark: none)");
        let wrong = its().map(|row| (&*row.regime, &*row.implementation, row.wrong / row.cases));
        charts.push(by_regime(format!("{object}-wrong"), title, "share of rays", wrong));
        let title = format!("Largest error of lambda of {object}s, decided rightly");
        let errors = its().map(|row| (&*row.regime, &*row.implementation, row.lambda_max));
        charts.push(by_regime(format!("{object}-lambda"), title, "relative error", errors));
    }
    // The columns are the implementation, the radius and the share of wrong decisions.
    let large: Vec<(String, f64, f64)> = read(&folder.join("large-spheres.csv"))?;
    let points = large.iter().map(|(implementation, radius, share)| (&**implementation, *radius, *share));
    let x = Axis { label: "radius", format: power_of_ten };
    let y = Axis { label: "share of rays (no mark: none)", format: power_of_ten };
    charts.push(lines("large-spheres", "Wrong decisions of rays that leave a sphere", [x, y], points));
    let times: Vec<StepTime> = read(&folder.join("step-times.csv"))?;
    for object in ["sphere", "cylinder"] {
        let its = times.iter().filter(|row| row.object == object);
        let points = its.map(|row| (&*row.step, row.difficulty, row.nanoseconds));
        let title = format!("Time of an intersection with a {object}, by the step that decides");
        let x = Axis { label: "condition number of the discriminant", format: power_of_ten };
        let y = Axis { label: "ns a ray", format: short };
        charts.push(lines(&format!("{object}-steps"), &title, [x, y], points));
    }
    // The columns are the scene, the step and its share.
    let shares: Vec<(String, String, f64)> = read(&folder.join("step-shares.csv"))?;
    let shares = shares.iter().map(|(scene, step, share)| (&**scene, &**step, *share));
    let title = "Intersections that each step decides (no mark: none)".to_owned();
    charts.push(by_regime("step-shares".to_owned(), title, "share of intersections", shares));
    Ok(charts)
}

/// Returns a chart with a line for each implementation or step.
fn lines<'a>(name: &str, title: &str, [x, y]: [Axis; 2], points: impl Iterator<Item = (&'a str, f64, f64)>) -> Chart {
    let mut series = Vec::new();
    points.for_each(|(name, x, y)| add(&mut series, name, x, y));
    Chart { name: name.to_owned(), title: title.to_owned(), x, y, series, rows: Vec::new() }
}

/// Returns a chart with a row for each regime or scene, and a dot for each implementation or step that has a positive
/// figure there.
fn by_regime<'a>(
    name: String,
    title: String,
    label: &'static str,
    figures: impl Iterator<Item = (&'a str, &'a str, f64)>,
) -> Chart {
    let (mut rows, mut series) = (Vec::new(), Vec::new());
    for (regime, implementation, figure) in figures {
        if rows.last().is_none_or(|last| last != regime) {
            rows.push(regime.to_owned());
        }
        add(&mut series, implementation, figure, rows.len() as f64);
    }
    let (x, y) = (Axis { label, format: power_of_ten }, Axis { label: "", format: short });
    Chart { name, title, x, y, series, rows }
}

/// Adds a point to the series of an implementation in Rust or of a step, unless one of its coordinates is 0.
fn add(series: &mut Vec<Series>, implementation: &str, x: f64, y: f64) {
    if implementation.starts_with("WGSL") {
        return;
    }
    let at = series.iter().position(|series| series.name == implementation).unwrap_or(series.len());
    if at == series.len() {
        // The first colour is that of guides.
        let color = at + 1;
        series.push(Series { name: implementation.to_owned(), color, is_guide: false, points: Vec::new() });
    }
    if x > 0.0 && y > 0.0 {
        series[at].points.push(Point { x, y, bounds: None });
    }
}

fn read<T: DeserializeOwned>(path: &Path) -> Result<Vec<T>, String> {
    let rows = csv::Reader::from_path(path).and_then(|mut table| table.deserialize().collect());
    rows.map_err(|error| format!("{}: {error}", path.display()))
}

/// Formats a number as one digit and a power of ten, such as `3e-16`.
fn power_of_ten(value: f64) -> String {
    format!("{value:.0e}")
}
