//! Renders small pictures of the scenes that were measured, for the page.

use std::io::ErrorKind;
use std::path::Path;

use base64::Engine;
use base64::prelude::BASE64_STANDARD as STANDARD;
use cpu::internals::{InstructionSet, Prepared};
use cpu::{Aos, Config, Error, Scatter, Scene};

use crate::bench::matrix;
use crate::bench::results::Results;
use crate::picture::Picture;

/// A small picture of a scene, for the page.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Thumbnail {
    /// The scene's name.
    pub scene: String,
    /// The picture as a `data:` address, which contains the bytes of a PNG.
    pub address: String,
}

/// Width in pixels, which is twice the width on the page, because some screens have two pixels for each pixel of CSS.
const WIDTH: u64 = 448;
const SAMPLES: u64 = 24;

/// Renders thumbnails of those scenes in `results` that `folder` has, and of the generated scene `board`. Other scenes,
/// such as the course's cases, get none.
///
/// # Errors
/// [`Error::Read`] when a scene is there but cannot be read.
pub fn of(results: &Results, folder: &Path) -> Result<Vec<Thumbnail>, Error> {
    let mut names: Vec<&str> = results.timings.iter().map(|timing| timing.setting.scene.as_str()).collect();
    names.extend(results.curves.iter().map(|curve| curve.scene.as_str()));
    names.sort_unstable();
    names.dedup();
    // The names come from the data. Only letters, digits and `-` are allowed, so that a name cannot be a path to
    // another folder.
    let is_plain = |name: &&str| name.chars().all(|letter| letter.is_ascii_alphanumeric() || letter == '-');
    let thumbnail = |scene: &str| {
        let address = if scene == matrix::BOARD {
            let (config, scene) = matrix::board(matrix::BOARD_OBJECTS, WIDTH);
            drawn(config, &scene).map(Ok)
        } else {
            address(&folder.join(scene)).transpose()
        }?;
        Some(address.map(|address| Thumbnail { scene: scene.to_owned(), address }))
    };
    names.into_iter().filter(is_plain).filter_map(thumbnail).collect()
}

fn address(folder: &Path) -> Result<Option<String>, Error> {
    let read = Config::read(&folder.join("config.txt"))
        .and_then(|config| Ok((config, Scene::read(&folder.join("scene.txt"))?)));
    match read {
        Ok((config, scene)) => Ok(drawn(config, &scene)),
        Err(Error::Read { cause, .. }) if cause.kind() == ErrorKind::NotFound => Ok(None),
        Err(error) => Err(error),
    }
}

fn drawn(config: Config, scene: &Scene) -> Option<String> {
    let config = Config { image_width: WIDTH, samples_per_pixel: SAMPLES, ..config };
    let prepared = Prepared::<Aos>::new(&config, scene, Scatter::Statement).ok()?;
    let picture = Picture::of(&cpu::internals::render_with(&prepared, InstructionSet::chosen()).ok()?).ok()?;
    let mut png = Vec::new();
    picture.write_png(&mut png).ok()?;
    Some(format!("data:image/png;base64,{}", STANDARD.encode(&png)))
}
