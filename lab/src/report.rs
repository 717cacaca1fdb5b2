//! From measured data to charts and words: one HTML page that needs nothing else, and the files that `docs/report`
//! is built from.
//!
//! [`charts`] chooses what is shown and [`chart`] draws it; [`findings`] puts figures into sentences, so that no
//! sentence can disagree with the data; [`html`] makes the page.

pub mod axis;
pub mod chart;
pub mod charts;
pub mod findings;
pub mod html;
pub mod style;
pub mod thumbnails;

use std::path::Path;

use cpu::output::Output;

use crate::Failure;
use crate::bench::results::Results;

/// Writes `index.html`, `findings.json` and `charts/*.svg` into `folder`.
///
/// # Errors
/// A file cannot be written, or there is nothing to draw.
pub fn write(results: &Results, folder: &Path) -> Result<(), Failure> {
    let charts = charts::all(results);
    let drawn = charts.iter().map(|chart| Ok((chart, chart.draw()?))).collect::<Result<Vec<_>, String>>()?;
    let figures = folder.join("charts");
    std::fs::create_dir_all(&figures).map_err(|error| format!("{}: {error}", figures.display()))?;
    let findings = findings::of(results);
    for (chart, svg) in &drawn {
        put(&figures.join(format!("{}.svg", chart.name)), svg)?;
    }
    let pictures = thumbnails::of(results, &::tests::project_root().join("scenes"));
    let json = serde_json::to_string_pretty(&findings).map_err(|error| error.to_string())?;
    put(&folder.join("findings.json"), &format!("{json}\n"))?;
    put(&folder.join("index.html"), &html::page(results, &findings, &drawn, &pictures))
}

fn put(path: &Path, text: &str) -> Result<(), Failure> {
    Ok(Output::open(path)?.write(|file| file.write_all(text.as_bytes()))?)
}
