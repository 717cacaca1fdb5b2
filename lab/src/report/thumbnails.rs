//! Small pictures of the scenes that were measured, inside the page.

use std::path::Path;

use base64::Engine;
use base64::prelude::BASE64_STANDARD as STANDARD;
use cpu::{Aos, Config, InstructionSet, Prepared, Scatter, Scene};

use crate::bench::results::Results;
use crate::picture::Picture;

/// A picture as an address that holds all of it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Thumbnail {
    /// The scene's name.
    pub scene: String,
    /// A `data:` address of a PNG.
    pub address: String,
}

/// Pixels in a row, twice what the page shows: some screens have more.
const WIDTH: u64 = 448;
const SAMPLES: u64 = 24;

/// Thumbnails of the scenes in `results` that are in `folder`; others, such as generated ones, have none.
#[must_use]
pub fn of(results: &Results, folder: &Path) -> Vec<Thumbnail> {
    let mut names: Vec<&str> = results.timings.iter().map(|timing| timing.setting.scene.as_str()).collect();
    names.extend(results.curves.iter().map(|curve| curve.scene.as_str()));
    names.sort_unstable();
    names.dedup();
    // A name is one of a folder in the project, and never a path out of it.
    let is_plain = |name: &&str| name.chars().all(|letter| letter.is_ascii_alphanumeric() || letter == '-');
    let thumbnail = |scene: &str| Some(Thumbnail { scene: scene.to_owned(), address: address(&folder.join(scene))? });
    names.into_iter().filter(is_plain).filter_map(thumbnail).collect()
}

fn address(folder: &Path) -> Option<String> {
    let config = Config::read(&folder.join("config.txt")).ok()?;
    let scene = Scene::read(&folder.join("scene.txt")).ok()?;
    let config = Config { image_width: WIDTH, samples_per_pixel: SAMPLES, ..config };
    let prepared = Prepared::<Aos>::new(&config, &scene, Scatter::Statement).ok()?;
    let picture = Picture::of(&cpu::render_with(&prepared, InstructionSet::chosen()).ok()?).ok()?;
    let mut png = Vec::new();
    picture.write_png(&mut png).ok()?;
    Some(format!("data:image/png;base64,{}", STANDARD.encode(&png)))
}
