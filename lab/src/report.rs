//! Converts measured data into charts and sentences. It writes one HTML page that needs no other file, and the charts
//! and sentences as files of their own.

pub mod chart;
pub mod charts;
pub mod findings;
pub mod html;
pub mod style;

use std::collections::HashSet;
use std::path::{Path, PathBuf};

use cpu::{Aos, Config, Scatter, Scene};
use output::{Options, Output};

use crate::bench::results::Results;
use crate::bench::{matrix, scenes};
use crate::format::hint::Language;
use crate::picture::Picture;
use crate::{Failure, sources};
use chart::Chart;
use findings::Findings;

/// Writes `index.html`, `findings.json` and `charts/*.svg` into `folder`, with texts in `language`. `data` is the path
/// of the file from which `results` were read. If an output is the file `data`, the function returns an error and
/// writes nothing. `pictures` makes the thumbnails of the scenes, each with its name and its `data:` address, when all
/// outputs have been found writable. If there is the address `pdf` of a report about the results, the page links to it.
///
/// # Errors
/// An output is the file `data`, a file cannot be written, or a chart cannot be drawn.
pub fn write(
    results: &Results,
    data: &Path,
    folder: &Path,
    (language, pdf): (Language, Option<&str>),
    options: Options,
    pictures: impl FnOnce(&Results) -> Vec<(String, String)>,
) -> Result<(), Failure> {
    let charts = charts::all(results, language);
    let names = file_names(&charts).into_iter().map(|name| format!("charts/{name}.svg"));
    let paths: Vec<_> =
        names.chain(["findings.json", "index.html"].map(str::to_owned)).map(|name| folder.join(name)).collect();
    let outputs = open(&paths, data, options)?;
    // Everything else that can fail is computed before the first file is written.
    let drawn = charts.iter().map(|chart| Ok((chart, chart.draw()?))).collect::<Result<Vec<_>, String>>()?;
    let findings = Findings { sentences: findings::of(results, language), layouts: findings::layout_rows(results) };
    let json = serde_json::to_string_pretty(&findings).map_err(|error| error.to_string())? + "\n";
    let page = html::page(results, language, &findings, &drawn, pictures(results), pdf)?;
    let texts = drawn.iter().map(|(_, svg)| svg).chain([&json, &page]);
    for ((path, output), text) in paths.iter().zip(outputs).zip(texts) {
        let output = output.map_or_else(|| Output::open(path, options), Ok)?;
        output.fill(|file| file.write_all(text.as_bytes()))?;
    }
    Ok(())
}

/// Width in pixels, which is twice the width on the page, because some screens have two pixels for each pixel of CSS.
const WIDTH: u64 = 448;
const SAMPLES: u64 = 24;

/// Renders thumbnails of those scenes in `results` that the program contains, and of the generated scene `board`. Other
/// scenes, such as the course's cases, get none. Each has the scene's name, and the `data:` address of a PNG.
pub fn thumbnails(results: &Results) -> Vec<(String, String)> {
    let mut names: Vec<&str> = results.timings.iter().map(|timing| timing.setting.scene.as_str()).collect();
    names.extend(results.curves.iter().map(|curve| curve.scene.as_str()));
    names.sort_unstable();
    names.dedup();
    let thumbnail = |name: &str| {
        let (config, scene) =
            if name == matrix::BOARD { matrix::board(matrix::BOARD_OBJECTS, WIDTH) } else { scenes::named(name)? };
        Some((name.to_owned(), drawn(config, &scene)?))
    };
    names.into_iter().filter_map(thumbnail).collect()
}

fn drawn(config: Config, scene: &Scene) -> Option<String> {
    let config = Config { image_width: WIDTH, samples_per_pixel: SAMPLES, ..config };
    let image = cpu::render::<Aos>(&config, scene, Scatter::Statement).ok()?;
    Picture::of(&image).ok()?.address().ok()
}

/// Largest number of outputs that are open at the same time. Results may have so many scenes that there are more charts
/// than a process may have open files.
const MOST_OPEN: usize = 12;

/// Makes the folders, and opens each file for writing. None of them may be `data`. Files after the first [`MOST_OPEN`]
/// are closed again, and have to be opened once more.
fn open(paths: &[PathBuf], data: &Path, options: Options) -> Result<Vec<Option<Output>>, Failure> {
    for path in paths {
        output::refuse_inputs(path, &[data])?;
    }
    paths.iter().filter_map(|path| path.parent()).try_for_each(sources::make_folder)?;
    let open = |(index, path): (usize, &PathBuf)| {
        let output = Output::open(path, options)?;
        Ok((index < MOST_OPEN).then_some(output))
    };
    paths.iter().enumerate().map(open).collect()
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
    #[test]
    fn a_file_that_cannot_be_written_is_refused_before_thumbnails_are_rendered() {
        use crate::bench::results::tests::{results, timing};
        use std::os::unix::net::UnixListener;
        use test_support::folder::Folder;

        let results = results(vec![timing("aos-avx2", 1, &[1.0]), timing("aos-avx2", 4, &[2.0])]);
        for name in ["index.html", "findings.json", "charts/scale-samples.svg"] {
            let folder = Folder::new();
            std::fs::create_dir(folder.file("charts")).expect("the folder is writable");
            let _socket = UnixListener::bind(folder.file(name)).expect("the folder is writable");
            let (data, language) = (Path::new("data"), (Language::English, None));
            let result = write(&results, data, folder.path(), language, Options::default(), |_| {
                panic!("thumbnails are rendered although {name} cannot be written")
            });
            let message = result.expect_err("a socket is no file").message().expect("an error has a message");
            assert!(message.contains("Cannot write file [") && message.contains(name), "{message}");
            // The folder of charts and the socket.
            assert_eq!(folder.names().len() + folder.names_in("charts").len(), 2);
        }
    }
}
