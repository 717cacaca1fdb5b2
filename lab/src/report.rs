//! Converts measured data into charts and sentences. It writes one HTML page that needs no other file, and the files
//! from which `docs/report` is built.

pub mod axis;
pub mod chart;
pub mod charts;
pub mod findings;
pub mod html;
pub mod style;
pub mod thumbnails;

use std::collections::HashSet;
use std::path::Path;

use output::{Options, Output};

use crate::bench::results::Results;
use crate::{Failure, terminal};
use chart::Chart;

/// Names of the files that [`write()`] writes in addition to the charts.
pub const FILES: [&str; 2] = ["index.html", "findings.json"];

/// Writes `index.html`, `findings.json` and `charts/*.svg` into `folder`.
///
/// # Errors
/// An error if a file cannot be written, or a chart cannot be drawn.
pub fn write(results: &Results, folder: &Path, options: Options) -> Result<(), Failure> {
    // All computations that can fail are done before the first file is written.
    let pictures = thumbnails::of(results, &test_support::project_root().join("scenes"))?;
    let charts = charts::all(results);
    let drawn = charts.iter().map(|chart| Ok((chart, chart.draw()?))).collect::<Result<Vec<_>, String>>()?;
    let figures = folder.join("charts");
    std::fs::create_dir_all(&figures).map_err(|error| format!("{}: {error}", terminal::name(&figures)))?;
    let findings = findings::of(results);
    for (name, (_, svg)) in file_names(&charts).into_iter().zip(&drawn) {
        put(&figures.join(format!("{name}.svg")), svg, options)?;
    }
    let json = serde_json::to_string_pretty(&findings).map_err(|error| error.to_string())?;
    put(&folder.join("findings.json"), &format!("{json}\n"), options)?;
    put(&folder.join("index.html"), &html::page(results, &findings, &drawn, &pictures), options)
}

fn put(path: &Path, text: &str, options: Options) -> Result<(), Failure> {
    Ok(Output::open(path, options)?.fill(|file| file.write_all(text.as_bytes()))?)
}

/// Returns a different file name for each chart, without an ending. A chart's name may contain the name of a scene,
/// which comes from the data. So characters other than letters, digits and `_` become `-`, and no file can lie outside
/// the folder.
fn file_names(charts: &[Chart]) -> Vec<String> {
    const LONGEST: usize = 100;

    let mut taken = HashSet::new();
    let mut names = Vec::new();
    for chart in charts {
        let tame = |c: char| if c.is_ascii_alphanumeric() || c == '_' { c } else { '-' };
        let base: String = chart.name.chars().take(LONGEST).map(tame).collect();
        let numbered = (2..).map(|number| format!("{base}-{number}"));
        names.extend(std::iter::once(base.clone()).chain(numbered).find(|name| taken.insert(name.clone())));
    }
    names
}

#[cfg(test)]
mod tests {
    use super::chart::Axis;
    use super::*;

    #[test]
    fn names_of_scenes_lead_to_no_other_folder_and_stay_different() {
        let axis = Axis { label: "", format: |value| value.to_string() };
        let chart = |name: &str| Chart {
            name: name.to_owned(),
            title: String::new(),
            x: axis,
            y: axis,
            series: Vec::new(),
            rows: Vec::new(),
        };
        let names = ["error-time-grid", "../../x", "..\\..\\x", "a\0\u{1b}\n/ä", &"long".repeat(99)];
        let found = file_names(&names.map(chart));
        assert_eq!(found[..4], ["error-time-grid", "------x", "------x-2", "a-----"].map(str::to_owned));
        assert_eq!(found[4].len(), 100);
    }
}
