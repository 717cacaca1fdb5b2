//! What the data say, in sentences that are computed from them.

use serde::Serialize;

use super::style::{seconds, short, with_error};
use crate::bench::fit::PowerLaw;
use crate::bench::results::{Results, Timing};

/// A sentence and what it is about.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Finding {
    /// What it is about, in a word or two.
    pub topic: &'static str,
    /// The sentence.
    pub text: String,
}

/// Everything that can be said about the data at hand.
#[must_use]
pub fn of(results: &Results) -> Vec<Finding> {
    let findings = [
        ("Conditions", conditions(results)),
        ("Spread", spread(results)),
        ("Layouts", layouts(results)),
        ("Literal renderer", literal(results)),
        ("Instruction sets", instruction_sets(results)),
        ("Scaling", scaling(results)),
        ("Error", error(results)),
        ("Time to an error", time_to_error(results)),
        ("Energy", energy(results)),
    ];
    findings.into_iter().filter_map(|(topic, text)| Some(Finding { topic, text: text? })).collect()
}

fn conditions(results: &Results) -> Option<String> {
    let machine = results.machines.first()?;
    let size = if results.quick { "The small matrix" } else { "The full matrix" };
    let load = machine
        .load
        .map_or_else(String::new, |load| format!(", with {} processes wanting to run when it began", short(load)));
    let others = match results.machines.len() {
        1 => String::new(),
        count => format!(" and {} other runs", count - 1),
    };
    let (date, processor, processors) = (&machine.date, &machine.processor, machine.processors);
    Some(format!("{size}, measured on {date} on {processor} ({processors} processors{load}){others}."))
}

fn spread(results: &Results) -> Option<String> {
    let mut spreads: Vec<_> = results.timings.iter().map(|timing| timing.median.spread()).collect();
    spreads.sort_by(f64::total_cmp);
    let (middle, worst) = (spreads.get(spreads.len() / 2)?, spreads.last()?);
    let repeats = results.timings.iter().map(|timing| timing.seconds.len()).min()?;
    let confidence = results.timings.iter().map(|timing| timing.median.confidence).fold(1.0, f64::min);
    Some(format!(
        "From run to run, bounds that hold a median with at least {} % confidence ({repeats} repeats or more) are {} % \
         of it wide in the middle, {} % at worst, over {} times.",
        short(100.0 * confidence),
        short(100.0 * middle),
        short(100.0 * worst),
        spreads.len()
    ))
}

/// Pairs of times that differ in the engine alone.
fn pairs<'a>(
    results: &'a Results,
    other: impl Fn(&str) -> Option<String> + 'a,
) -> impl Iterator<Item = (&'a Timing, &'a Timing)> {
    results.timings.iter().filter_map(move |timing| {
        let mut setting = timing.setting.clone();
        setting.engine = other(&setting.engine)?;
        Some((timing, results.timings.iter().find(|timing| timing.setting == setting)?))
    })
}

/// Geometric mean, least and largest.
fn ratios(values: impl Iterator<Item = f64>) -> Option<[f64; 3]> {
    let values: Vec<_> = values.collect();
    let mean = (values.iter().map(|value| value.ln()).sum::<f64>() / values.len() as f64).exp();
    let [low, high] = [values.iter().copied().reduce(f64::min)?, values.iter().copied().reduce(f64::max)?];
    Some([mean, low, high])
}

fn layouts(results: &Results) -> Option<String> {
    let pairs = || pairs(results, |engine| engine.strip_prefix("aos-").map(|set| format!("soa-{set}")));
    let [mean, low, high] = ratios(pairs().map(|(aos, soa)| soa.median.median / aos.median.median))?;
    let apart = pairs().filter(|(a, b)| a.median.low > b.median.high || b.median.low > a.median.high).count();
    Some(format!(
        "Structures of arrays take {} times the time of arrays of structures (geometric mean; {} to {}); in {apart} of {} \
         settings their bounds lie apart.",
        short(mean),
        short(low),
        short(high),
        pairs().count()
    ))
}

fn literal(results: &Results) -> Option<String> {
    let best = results.machines.first()?.instruction_set.clone();
    let faster = pairs(results, move |engine| (engine == format!("aos-{best}")).then(|| "reference".to_owned()));
    let pairs: Vec<_> = faster.collect();
    let ratio = |(real, literal): &(&Timing, &Timing)| literal.median.median / real.median.median;
    let [mean, ..] = ratios(pairs.iter().map(ratio))?;
    let most = pairs.iter().max_by(|a, b| ratio(a).total_cmp(&ratio(b)))?;
    let least = pairs.iter().min_by(|a, b| ratio(a).total_cmp(&ratio(b)))?;
    let place = |(real, _): &(&Timing, &Timing)| {
        format!("{}, {} {}", real.setting.scene, real.setting.value, real.setting.parameter)
    };
    Some(format!(
        "The renderer is {} times as fast as the literal one (geometric mean over {} settings): least {} times ({}), most \
         {} times ({}).",
        short(mean),
        pairs.len(),
        short(ratio(least)),
        place(least),
        short(ratio(most)),
        place(most)
    ))
}

fn instruction_sets(results: &Results) -> Option<String> {
    let sets: Vec<_> = cpu::InstructionSet::ALL.iter().map(|set| set.name()).collect();
    let steps: Vec<_> = sets
        .windows(2)
        .filter_map(|pair| {
            let (slower, faster) = (pair[0], pair[1]);
            let both = pairs(results, move |engine| {
                engine.strip_suffix(faster).filter(|layout| layout.ends_with('-')).map(|l| format!("{l}{slower}"))
            });
            let [mean, low, high] = ratios(both.map(|(fast, slow)| slow.median.median / fast.median.median))?;
            Some(format!("{faster} is {} times as fast as {slower} ({} to {})", short(mean), short(low), short(high)))
        })
        .collect();
    (!steps.is_empty()).then(|| format!("On average {}.", steps.join(", ")))
}

fn scaling(results: &Results) -> Option<String> {
    let best = &results.machines.first()?.instruction_set;
    let of = |law: &PowerLaw| with_error(law.exponent, law.exponent_error);
    let parts: Vec<_> = crate::bench::matrix::PARAMETERS
        .iter()
        .filter_map(|parameter| {
            let find = |engine: &str| {
                results.growth.iter().find(|growth| growth.parameter == *parameter && growth.engine == engine)
            };
            let real = find(&format!("aos-{best}"))?;
            let literal =
                find("reference").map_or_else(String::new, |growth| format!(" (literal: {})", of(&growth.law)));
            Some(format!("{parameter} to the power {}{literal}", of(&real.law)))
        })
        .collect();
    (!parts.is_empty()).then(|| format!("Time grows with {}.", parts.join(", ")))
}

fn error(results: &Results) -> Option<String> {
    let parts: Vec<_> = results
        .curves
        .iter()
        .filter_map(|curve| {
            let points: Vec<_> = curve.points.iter().map(|p| (p.samples as f64, p.linear.median)).collect();
            let law = PowerLaw::through(&points)?;
            let (scene, exponent) = (&curve.scene, with_error(law.exponent, law.exponent_error));
            let own = short(curve.reference_error);
            Some(format!("{exponent} ({scene}; the converged picture's own error is {own})"))
        })
        .collect();
    (!parts.is_empty()).then(|| {
        format!(
            "The error falls with the number of samples to the power {}; independent samples give -0.5.",
            parts.join(", ")
        )
    })
}

fn time_to_error(results: &Results) -> Option<String> {
    let best = format!("aos-{}", results.machines.first()?.instruction_set);
    let find = |scene: &str, engine: &str, error: f64| {
        let is_it =
            |t: &&crate::bench::results::TimeToError| t.scene == scene && t.engine == engine && t.error == error;
        results.times_to_error.iter().find(is_it).and_then(|time| time.seconds)
    };
    // The smallest error for which both were measured, for each scene.
    let parts: Vec<_> = results
        .curves
        .iter()
        .filter_map(|curve| {
            let scene = &curve.scene;
            crate::bench::results::TARGETS.iter().rev().find_map(|&error| {
                let (real, literal) = (find(scene, &best, error)?, find(scene, "reference", error)?);
                Some(format!("{error} takes {} instead of {} ({scene})", seconds(real), seconds(literal)))
            })
        })
        .collect();
    (!parts.is_empty()).then(|| format!("An error of {}.", parts.join(", of ")))
}

fn energy(results: &Results) -> Option<String> {
    let first = results.energy.first()?;
    if let Some(reason) = results.energy.iter().find_map(|energy| energy.reason.as_ref()) {
        return Some(format!("Energy was not measured: {reason}."));
    }
    let parts: Vec<_> = results
        .energy
        .iter()
        .filter_map(|energy| {
            let (joules, watts) = (short(energy.joules?), short(energy.watts?));
            Some(format!("{joules} J a picture at {watts} W ({}, {})", energy.scene, energy.engine))
        })
        .collect();
    let idle =
        first.idle_watts.map_or_else(String::new, |watts| format!(", {} W of the idle machine apart", short(watts)));
    Some(format!("Energy{idle}: {}.", parts.join(", ")))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bench::energy::Energy;
    use crate::bench::machine::Machine;
    use crate::bench::results::Setting;
    use crate::bench::statistics::Median;

    fn timing(engine: &str, value: u64, seconds: f64) -> Timing {
        let [suite, scene, parameter, engine] = ["scale", "board", "objects", engine].map(str::to_owned);
        let setting = Setting { suite, scene, parameter, value, engine };
        let bounds = [0.9 * seconds, seconds, 1.1 * seconds];
        Timing { setting, seconds: bounds.to_vec(), median: Median::of(&bounds), digest: String::new() }
    }

    fn text(results: &Results, topic: &str) -> String {
        of(results).into_iter().find(|finding| finding.topic == topic).expect("it is said").text
    }

    #[test]
    fn sentences_have_the_figures_of_the_data() {
        let machine = Machine { instruction_set: "avx2".to_owned(), ..Machine::here() };
        let mut timings = Vec::new();
        for (value, literal) in [(10, 2.0), (100, 8.0)] {
            timings.extend([timing("reference", value, literal), timing("aos-avx2", value, 1.0)]);
            timings.extend([timing("soa-avx2", value, 2.0), timing("aos-sse2", value, 1.5)]);
        }
        let mut results = Results { machines: vec![machine], timings, ..Results::default() };
        results.complete();
        let layouts = text(&results, "Layouts");
        assert!(layouts.contains("take 2 times the time") && layouts.contains("in 2 of 2 settings"), "{layouts}");
        let literal = text(&results, "Literal renderer");
        assert!(literal.contains("4 times as fast"), "the geometric mean of 2 and 8: {literal}");
        assert!(literal.contains("least 2 times (board, 10 objects), most 8 times (board, 100 objects)"), "{literal}");
        assert!(text(&results, "Instruction sets").contains("avx2 is 1.5 times as fast as sse2"));
        assert!(text(&results, "Scaling").contains("objects to the power 0"), "{}", text(&results, "Scaling"));
    }

    #[test]
    fn energy_that_was_not_measured_has_its_reason() {
        let [scene, engine] = ["grid", "reference"].map(str::to_owned);
        let reason = Some("no RAPL: here".to_owned());
        let energy = Energy { scene, engine, joules: None, watts: None, idle_watts: None, reason };
        let mut results = Results { energy: vec![energy.clone()], ..Results::default() };
        assert_eq!(text(&results, "Energy"), "Energy was not measured: no RAPL: here.");
        results.energy = vec![Energy { joules: Some(1.5), watts: Some(20.0), reason: None, ..energy }];
        assert_eq!(text(&results, "Energy"), "Energy: 1.5 J a picture at 20 W (grid, reference).");
    }

    #[test]
    fn without_data_nothing_is_said() {
        assert!(of(&Results::default()).is_empty());
    }
}
