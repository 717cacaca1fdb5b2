//! The chart of the results of `bench/nearest`: the time of a nearest hit against the number of objects.

use std::fs;

use lab::report::chart::{Axis, Chart, Point, Series};
use lab::report::style::short;
use serde_json::Value;

/// Returns the chart of the results in the file `path`.
pub fn chart(path: &str) -> Result<Chart, String> {
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
    Ok(Chart {
        name: "nearest".to_owned(),
        title: format!("Nearest hit of a ray from a surface ({set})"),
        x: Axis { label: "objects in the scene", format: short },
        y: Axis { label: "ns a ray", format: short },
        series: series.filter(|series| !series.points.is_empty()).collect(),
        rows: Vec::new(),
    })
}
