//! Renders small pictures of the scenes that were measured, for the page.

use cpu::{Aos, Config, Scatter, Scene};

use crate::bench::results::Results;
use crate::bench::{matrix, scenes};
use crate::picture::Picture;

/// Width in pixels, which is twice the width on the page, because some screens have two pixels for each pixel of CSS.
const WIDTH: u64 = 448;
const SAMPLES: u64 = 24;

/// Renders thumbnails of those scenes in `results` that the program contains, and of the generated scene `board`. Other
/// scenes, such as the course's cases, get none. Each has the scene's name, and the `data:` address of a PNG.
pub fn of(results: &Results) -> Vec<(String, String)> {
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
