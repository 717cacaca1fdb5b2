//! Measures the user time of engines on one picture, with interleaved repeats, and checks that the pictures are equal.
//!
//! Each round measures every engine once, and each round starts with a different engine, so that a slow phase of the
//! machine affects all engines. A picture that takes less than [`SHORTEST`] is rendered several times in a repeat. All
//! engines must write the same bytes, because the time of a wrong picture means nothing.

use cpu::{Config, Scene};
use digest::sha256;

use crate::Failure;
use crate::engine::Engine;
use crate::interrupt::Interrupt;
use crate::usage::{Seconds, Usage};

/// The smallest user time of one measurement, in seconds. The system's clock of user time may be coarse.
pub const SHORTEST: Seconds = 0.05;

/// The times of several engines for one picture.
#[derive(Clone, Debug)]
pub struct Times {
    /// Each engine, with the seconds of one picture in each repeat, in the order measured.
    pub of: Vec<(Engine, Vec<Seconds>)>,
    /// SHA-256 of the picture, which is the same for all engines.
    pub digest: String,
}

/// Measures the user time of `engines` for one picture.
///
/// # Errors
/// An error of the renderer, an engine whose picture differs, or [`Failure::Interrupted`].
pub fn measure(
    engines: &[Engine],
    repeats: usize,
    config: &Config,
    scene: &Scene,
    interrupt: &Interrupt,
) -> Result<Times, Failure> {
    let mut digest: Option<String> = None;
    let mut turns = Vec::new();
    for &engine in engines {
        interrupt.check()?;
        // The first picture warms the caches and is compared. From its time follows the number of pictures in one
        // repeat.
        let before = Usage::now().user;
        let picture = engine.ppm(config, scene)?;
        let seconds = Usage::now().user - before;
        let own = sha256(&picture);
        match &digest {
            Some(expected) if *expected != own => {
                return Err(format!("{engine} makes another picture than {}: {own}, not {expected}", engines[0]).into());
            }
            _ => digest = Some(own),
        }
        turns.push(turns_of(seconds));
    }
    let times = interleaved(repeats, &turns, interrupt, |index| {
        std::hint::black_box(engines[index].ppm(config, scene)?);
        Ok(())
    })?;
    Ok(Times { of: engines.iter().copied().zip(times).collect(), digest: digest.unwrap_or_default() })
}

/// Returns how many times to repeat work of `seconds` in one measurement, so that it takes at least [`SHORTEST`]; at
/// most 500.
#[must_use]
pub fn turns_of(seconds: Seconds) -> u32 {
    (SHORTEST / seconds.max(SHORTEST / 500.0)).ceil().max(1.0) as u32
}

/// Returns the user times of `work(index)` in seconds, for each index of `turns`. Each index has `repeats` times. Each
/// time is the mean of `turns[index]` calls.
///
/// # Errors
/// An error of `work`, or [`Failure::Interrupted`].
pub fn interleaved(
    repeats: usize,
    turns: &[u32],
    interrupt: &Interrupt,
    mut work: impl FnMut(usize) -> Result<(), Failure>,
) -> Result<Vec<Vec<Seconds>>, Failure> {
    let mut times: Vec<Vec<Seconds>> = vec![Vec::with_capacity(repeats); turns.len()];
    for repeat in 0..repeats {
        for place in 0..turns.len() {
            interrupt.check()?;
            let index = (place + repeat) % turns.len();
            let before = Usage::now().user;
            for _ in 0..turns[index] {
                work(index)?;
            }
            times[index].push((Usage::now().user - before) / f64::from(turns[index]));
        }
    }
    Ok(times)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_engine_is_measured_as_often_as_asked() {
        let config = Config::parse(&b"image_width: 16\nsamples_per_pixel: 1\n"[..]).expect("it is valid");
        let scene = Scene::parse(&b"matte: m 1 1 1\nsphere: 0 0 0 3 m\n"[..]).expect("it is valid");
        let engines = Engine::main();
        let times = measure(&engines, 2, &config, &scene, &Interrupt::default()).expect("it is small");
        assert_eq!(times.of.len(), 3);
        for (engine, seconds) in &times.of {
            assert!(seconds.len() == 2 && seconds.iter().all(|&seconds| seconds > 0.0), "{engine}: {seconds:?}");
        }
        let expected = Engine::Reference.ppm(&config, &scene).expect("it is small");
        assert_eq!(times.digest, sha256(&expected));
    }
}
