//! What each optimisation gains: the time with one thing switched off, against the time with nothing switched off.
//!
//! Only what the library can leave out by itself is there. That spans of primary rays, paths through glass and the
//! background's ends are calculated in lanes, and that means become bytes without a power, is woven into the real
//! renderer: what these gain is within the row of the literal renderer, which has no certificate either.

use cpu::internals::InstructionSet;
use serde::{Deserialize, Serialize};

use super::results::{Setting, Timing};

/// How much longer a picture takes with one thing switched off.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Gain {
    /// The scene's name.
    pub scene: String,
    /// What is switched off, or taken instead.
    pub without: String,
    /// Times as long, medians compared.
    pub ratio: f64,
    /// The least that the bounds of both medians allow.
    pub low: f64,
    /// The most that they allow.
    pub high: f64,
}

/// What an engine does without, where `best` is the instruction set of the one with nothing switched off; `None` for
/// that one.
fn without(engine: &str, best: &str) -> Option<String> {
    let rest = engine.strip_prefix("aos-").and_then(|rest| rest.strip_prefix(best));
    match (engine, rest) {
        (_, Some("")) => None,
        (_, Some("-plain-search")) => Some("no search".to_owned()),
        (_, Some("-textbook")) => Some("no certificate".to_owned()),
        ("reference", _) => Some("literal renderer".to_owned()),
        _ if engine == format!("soa-{best}") => Some("soa layout".to_owned()),
        _ => engine.strip_prefix("aos-").map(|set| format!("{set} lanes")),
    }
}

/// The gains that times of the suite `gain` show; `best` is the machine's best instruction set.
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
    // The kinds of things beside each other, lanes from the widest on; each kind in the order of the scenes.
    let sets = InstructionSet::ALL.map(|set| format!("{} lanes", set.name()));
    let others = ["soa layout", "no search", "no certificate", "literal renderer"].map(str::to_owned);
    let order: Vec<_> = sets.into_iter().rev().chain(others).collect();
    gains.sort_by_key(|gain: &Gain| order.iter().position(|name| *name == gain.without));
    gains
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bench::statistics::Median;
    use crate::engine::Engine;

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
            timing("aos-avx2-textbook", [1.0, 1.0, 1.0]),
            timing("aos-sse2", [3.0, 3.0, 3.0]),
        ];
        let gains = of(&timings, "avx2");
        let found: Vec<_> = gains.iter().map(|gain| (gain.without.as_str(), gain.ratio)).collect();
        assert_eq!(found, [("sse2 lanes", 1.5), ("no certificate", 0.5), ("literal renderer", 10.0)]);
        let literal = &gains[2];
        assert!((literal.low - 18.0 / 2.5).abs() < 1e-12 && (literal.high - 22.0 / 1.9).abs() < 1e-12, "{literal:?}");
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
