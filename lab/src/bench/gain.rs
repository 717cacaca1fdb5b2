//! Derives what each optimisation gains: the time with one of them switched off, divided by the time with all of them.
//!
//! Only optimisations that the library can switch off are listed: instruction set, layout and acceleration structure.
//! The others, such as lanes for camera rays and bytes without a power function, are part of the real renderer. Their
//! gain is included in the row of the reference, which has none of them.

use cpu::internals::InstructionSet;

use super::results::{Gain, Setting, Timing};

/// Returns the name of what is switched off in the implementation `engine`, or `None` if nothing is or the name is
/// unknown. `best` is the instruction set of the engine with all optimisations. Results of older versions have engines
/// whose name ends in `-textbook`, which means without the error bounds.
fn without(engine: &str, best: &str) -> Option<String> {
    let rest = engine.strip_prefix("aos-").and_then(|rest| rest.strip_prefix(best));
    match (engine, rest) {
        (_, Some("")) => None,
        (_, Some("-plain-search")) => Some("no search".to_owned()),
        (_, Some("-plain")) => Some("plain formulas".to_owned()),
        ("reference", _) => Some("reference".to_owned()),
        _ if engine == format!("soa-{best}") => Some("soa layout".to_owned()),
        _ => engine.strip_prefix("aos-").map(|set| format!("{set} lanes")),
    }
}

/// Returns the gains, computed from the times of the suite `gain`. `best` is the machine's best instruction set.
#[must_use]
pub fn of(timings: &[Timing], best: &str) -> Vec<Gain> {
    let of_gain = || timings.iter().filter(|timing| timing.setting.suite == "gain");
    let mut gains: Vec<_> = of_gain()
        .filter_map(|timing| {
            let without = without(&timing.setting.engine, best)?;
            let base = Setting { engine: format!("aos-{best}"), ..timing.setting.clone() };
            let is_base = |other: &&Timing| other.setting == base;
            let (slow, fast) = (timing.median, of_gain().find(is_base)?.median);
            let scene = timing.setting.scene.clone();
            let (low, high) = (slow.low / fast.high, slow.high / fast.low);
            Some(Gain { scene, without, ratio: slow.median / fast.median, low, high })
        })
        .collect();
    // Sorted by what is switched off: first the instruction sets, from the widest to the narrowest, then all else. The
    // sort is stable, so the scenes keep their order.
    let sets = InstructionSet::ALL.map(|set| format!("{} lanes", set.name()));
    let others = ["soa layout", "no search", "plain formulas", "reference"].map(str::to_owned);
    let order: Vec<_> = sets.into_iter().rev().chain(others).collect();
    gains.sort_by_key(|gain: &Gain| order.iter().position(|name| *name == gain.without));
    gains
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::Engine;
    use measure::statistics::Median;

    fn timing(engine: &str, seconds: [f64; 3]) -> Timing {
        let [suite, scene, parameter, engine] = ["gain", "grid", "samples", engine].map(str::to_owned);
        let setting = Setting { suite, scene, parameter, value: 4, engine };
        Timing { setting, seconds: seconds.to_vec(), median: Median::of(&seconds), digest: String::new() }
    }

    #[test]
    fn a_gain_is_the_ratio_of_times() {
        let timings = [
            timing("reference", [18.0, 20.0, 22.0]),
            timing("aos-avx2", [1.9, 2.0, 2.5]),
            timing("aos-avx2-plain", [1.0, 1.0, 1.0]),
            timing("aos-sse2", [3.0, 3.0, 3.0]),
        ];
        let gains = of(&timings, "avx2");
        let found: Vec<_> = gains.iter().map(|gain| (gain.without.as_str(), gain.ratio)).collect();
        assert_eq!(found, [("sse2 lanes", 1.5), ("plain formulas", 0.5), ("reference", 10.0)]);
        let slow = &gains[2];
        assert!((slow.low - 18.0 / 2.5).abs() < 1e-12 && (slow.high - 22.0 / 1.9).abs() < 1e-12, "{slow:?}");
    }

    #[test]
    fn every_engine_that_is_timed_has_a_name_for_what_it_does_without() {
        let best = InstructionSet::best().name();
        let names: Vec<_> = Engine::changed().iter().map(|engine| without(&engine.to_string(), best)).collect();
        assert_eq!(names.iter().filter(|name| name.is_none()).count(), 1, "{names:?}");
        let different: std::collections::BTreeSet<_> = names.iter().collect();
        assert_eq!(different.len(), names.len(), "{names:?}");
    }
}
