//! Measures the user time of engines on one picture, in turn, and checks that the pictures are equal.
//!
//! A picture that takes less than [`SHORTEST`](measure::turns::SHORTEST) is rendered several times in a repeat. All
//! engines must write the same bytes, because the time of a wrong picture means nothing.

use cpu::{Config, Scene};
use digest::sha256;
use measure::clock::own_seconds;
use measure::turns::{in_turn, turns_of};

use crate::engine::Engine;
use crate::{Failure, interrupt};

/// Measures the user time of `engines` for one picture. Returns the seconds of one picture in each repeat, for each
/// engine, and the SHA-256 of the picture, which is the same for all engines.
///
/// # Errors
/// An error of the renderer, an engine whose picture differs, or [`Failure::Interrupted`].
pub fn measure(
    engines: &[Engine],
    repeats: usize,
    config: &Config,
    scene: &Scene,
) -> Result<(Vec<Vec<f64>>, String), Failure> {
    let mut digest: Option<String> = None;
    let mut turns = Vec::new();
    for &engine in engines {
        interrupt::check()?;
        // The first picture warms the caches and is compared. From its time follows the number of pictures in one
        // repeat.
        let before = own_seconds();
        let picture = engine.ppm(config, scene)?;
        let seconds = own_seconds() - before;
        let own = sha256(&picture);
        match &digest {
            Some(expected) if *expected != own => {
                return Err(format!("{engine} makes another picture than {}: {own}, not {expected}", engines[0]).into());
            }
            _ => digest = Some(own),
        }
        turns.push(turns_of(seconds));
    }
    let times = in_turn(repeats, &turns, own_seconds, |index| {
        interrupt::check()?;
        std::hint::black_box(engines[index].ppm(config, scene)?);
        Ok::<(), Failure>(())
    })?;
    Ok((times, digest.unwrap_or_default()))
}
