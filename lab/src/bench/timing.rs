//! Measures the user time of engines on pictures, in turn, and checks that all engines make the same picture.
//!
//! A picture that takes less than [`SHORTEST`](measure::turns::SHORTEST) is rendered several times in a repeat. All
//! engines must write the same bytes, because the time of a wrong picture means nothing.

use cpu::{Config, Scene};
use format::digest::sha256;
use measure::clock::own_seconds;
use measure::statistics::Median;
use measure::turns::{in_turn, turns_of};

use super::matrix::Plan;
use super::results::{Omitted, Results, Setting, Timing};
use crate::engine::Engine;
use crate::{Failure, interrupt};

impl Plan {
    /// Measures `engines` on `pictures`, which have rising values of a parameter, and adds the times to `results`. The
    /// time of each picture is predicted from the engine's last measured picture. A picture with a predicted time above
    /// [`Plan::patience`] is not measured, and `results` gets the reason.
    pub(super) fn times(
        &self,
        [suite, scene_name, parameter]: [&str; 3],
        engines: &[Engine],
        pictures: impl Iterator<Item = (u64, Config, Scene)>,
        results: &mut Results,
    ) -> Result<(), Failure> {
        let setting = |value, engine: Engine| Setting {
            suite: suite.to_owned(),
            scene: scene_name.to_owned(),
            parameter: parameter.to_owned(),
            value,
            engine: engine.to_string(),
        };
        let mut last: Vec<(Engine, u64, f64)> = Vec::new();
        for (value, config, scene) in pictures {
            let growth = |before: u64| (value as f64 / before as f64).powi(if parameter == "width" { 2 } else { 1 });
            let expected = |engine: Engine| {
                last.iter().rev().find(|(other, ..)| *other == engine).map_or(0.0, |&(_, at, time)| time * growth(at))
            };
            let (wanted, slow): (Vec<_>, Vec<_>) = engines.iter().partition(|&&e| expected(e) <= self.patience());
            for engine in slow {
                let reason = format!("a picture would take about {:.1} s", expected(engine));
                results.omitted.push(Omitted { setting: setting(value, engine), reason });
            }
            let (times, digest) = self.measure(&wanted, &config, &scene)?;
            for (engine, seconds) in wanted.into_iter().zip(times) {
                let median = Median::of(&seconds);
                last.push((engine, value, median.median));
                let (setting, digest) = (setting(value, engine), digest.clone());
                results.timings.push(Timing { setting, seconds, median, digest });
            }
        }
        Ok(())
    }

    /// Measures the user time of `engines` for one picture. Returns the seconds of one picture in each repeat, for each
    /// engine, and the SHA-256 of the picture, which is the same for all engines.
    ///
    /// # Errors
    /// An error of the renderer, an engine whose picture differs, or [`Failure::Interrupted`].
    fn measure(&self, engines: &[Engine], config: &Config, scene: &Scene) -> Result<(Vec<Vec<f64>>, String), Failure> {
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
                    return Err(
                        format!("{engine} makes another picture than {}: {own}, not {expected}", engines[0]).into()
                    );
                }
                _ => digest = Some(own),
            }
            turns.push(turns_of(seconds));
        }
        let times = in_turn(self.repeats, &turns, own_seconds, |index| {
            interrupt::check()?;
            std::hint::black_box(engines[index].ppm(config, scene)?);
            Ok::<(), Failure>(())
        })?;
        Ok((times, digest.unwrap_or_default()))
    }
}

#[cfg(test)]
mod tests {
    use super::super::matrix::board;
    use super::*;

    #[test]
    fn what_would_take_too_long_is_left_out_with_its_reason() {
        let plan = Plan { quick: true, repeats: 1 };
        let (config, scene) = board(300, 48);
        // The second value is a million times the first. So the reference is expected to take too long if its
        // first picture takes more than a millionth of the patience, 0.7 µs.
        let pictures = [1, 1_000_000].map(|value| (value, config.clone(), scene.clone()));
        let mut results = Results::default();
        let engines = [Engine::Reference, Engine::main()[1]];
        let outcome = plan.times(["scale", "s", "samples"], &engines, pictures.into_iter(), &mut results);
        outcome.expect("nothing fails");
        assert!(results.omitted.iter().any(|omitted| omitted.setting.engine == "reference"), "{:?}", results.omitted);
        assert!(results.omitted[0].reason.starts_with("a picture would take about "));
    }
}
