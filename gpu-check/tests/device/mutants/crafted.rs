//! Pictures of one pixel whose random words are chosen by hand, for decisions that random words practically never
//! reach: a negligible direction, a vector at the centre of the unit ball or on its surface, a word that rounds to
//! 2^64, and as many rejected vectors as the shader allows.

use std::time::Duration;

use cpu::{Config, Scene, Vec3};

use gpu_check::sampled::streams::{Streams, Words};
use gpu_check::sampled::twin::{MAX_TRIES, means};
use gpu_check::sampled::{Convention, Recording};
use gpu_check::{Error, Picture};

/// The word of the number 1/2, which is 0 in an interval around 0.
const MIDDLE: u64 = 1 << 63;
/// A word whose number in `[-1, 1)` is 1e-9. A direction with such components alone is negligible.
const TINY: u64 = MIDDLE + 9_223_372_037;
/// The maximum depth of all pictures.
pub const MAX_DEPTH: u32 = 2;

/// A picture with chosen words.
#[derive(Clone, Debug)]
pub struct Crafted {
    /// What the words try.
    pub name: &'static str,
    /// The picture: a sphere of radius 1 in the middle, seen along +z.
    pub picture: Picture<f64>,
    /// The number of words that each path takes, and the means by the twin in Rust.
    pub recording: Recording,
    /// The streams with the chosen words.
    pub streams: Streams,
}

/// Returns all pictures with chosen words.
///
/// # Errors
/// [`Error::Scene`] if a scene is not valid.
pub fn all() -> Result<Vec<Crafted>, Error> {
    use Convention::{Published, Statement};
    const MATTE: &str = "matte: a .5 .7 .9\n";
    // The z component of a word of all ones all but cancels that of the mirror direction: 2^-52 is left. That is the y
    // component too, whose word is next to the middle.
    const SHINY: &str = "metal: a .5 .7 .9 1\n";
    const METAL: &str = "metal: a .5 .7 .9 .3\n";
    // The camera ray hits the sphere at (0, 0, -1). A word of 0 gives -1, and one of all ones almost 1.
    let rejected = |times: u64| std::iter::repeat_n([0, 0, 0], times as usize).flatten();
    let accepted = [MIDDLE + 5, MIDDLE / 2, MIDDLE + (1 << 61)];
    let cases: [(&str, &str, Convention, Vec<u64>); 6] = [
        ("a negligible direction", MATTE, Statement, vec![MIDDLE, TINY, u64::MAX]),
        ("a word that rounds to 2^64", SHINY, Statement, vec![MIDDLE, MIDDLE + (1 << 11), u64::MAX]),
        ("a metal's own words", METAL, Statement, vec![0, u64::MAX, MIDDLE + 12_345]),
        ("the centre of the ball", MATTE, Published, [[MIDDLE; 3], accepted].concat()),
        ("the surface of the ball", METAL, Published, vec![MIDDLE, 0, MIDDLE]),
        ("the last try", MATTE, Published, rejected(MAX_TRIES - 1).chain(accepted).collect()),
    ];
    cases.into_iter().map(|(name, material, convention, words)| craft(name, material, convention, &words)).collect()
}

fn craft(name: &'static str, material: &str, convention: Convention, words: &[u64]) -> Result<Crafted, Error> {
    let scene = Scene::parse(format!("{material}sphere: 0 0 0 1 a\n").as_bytes())?;
    let config = Config {
        image_width: 1,
        aspect_ratio: [1, 1],
        field_of_view: 20.0,
        max_depth: MAX_DEPTH.into(),
        background_dark_color: Vec3::new(0.25, 0.5, 1.0),
        background_light_color: Vec3::new(1.0, 0.5, 0.75),
        ..Config::default()
    };
    let picture = Picture::new(&config, &scene)?;
    let streams = Streams { jitter: Words::new([MIDDLE; 2], 1), scatter: Words::new(words.iter().copied(), 1) };
    let mut recording = Recording {
        convention,
        samples_per_pixel: 1,
        ray_rng_seed: 1,
        material_rng_seed: 1,
        means: Vec::new(),
        words: vec![words.len() as u32],
        time: Duration::ZERO,
    };
    recording.means = means(&picture, &recording, streams.clone(), |_| ());
    Ok(Crafted { name, picture, recording, streams })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_twin_follows_the_rules_for_the_chosen_words() {
        let [dark, light] = [Vec3::new(0.25, 0.5, 1.0), Vec3::new(1.0, 0.5, 0.75)];
        let reflectance = Vec3::new(0.5, 0.7, 0.9);
        let background = |y: f64| light * (1.0 - (y + 1.0) / 2.0) + dark * ((y + 1.0) / 2.0);
        let means: Vec<_> = all().expect("they are valid").into_iter().map(|case| case.recording.means[0]).collect();
        let is_near = |mean: Vec3, y: f64| (mean - background(y).attenuate(reflectance)).length() < 1e-12;
        assert!(is_near(means[0], 0.0), "the normal is taken, and not (0, 1e-9, 2e-16)");
        assert!(is_near(means[1], 0.5_f64.sqrt()), "(0, 2^-52, -2^-52)");
        assert!(is_near(means[2], 0.3 / (0.3_f64.powi(2) * 2.0 + 1.0).sqrt()), "(-0.3, 0.3, -1)");
        let unit = Vec3::new(0.0, -0.5, 0.25) / (0.25_f64 + 0.0625).sqrt() + Vec3::new(0.0, 0.0, -1.0);
        assert!(is_near(means[3], unit.y / unit.length()) && is_near(means[5], unit.y / unit.length()));
        assert!(is_near(means[4], -0.3 / 1.09_f64.sqrt()), "(0, -0.3, -1)");
    }
}
