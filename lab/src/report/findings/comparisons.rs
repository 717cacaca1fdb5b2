//! Sentences that compare implementations with each other.

use cpu::internals::InstructionSet;

use crate::bench::results::{Results, Timing};
use crate::report::style::{setting, short};

/// Returns pairs of times whose settings differ only in the engine. `other` returns the name of the second engine for
/// the name of the first, or `None` to leave the time out.
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

/// Returns the geometric mean, the smallest and the largest of `values`, or `None` if there are no values.
fn ratios(values: impl Iterator<Item = f64>) -> Option<[f64; 3]> {
    let values: Vec<_> = values.collect();
    let mean = (values.iter().map(|value| value.ln()).sum::<f64>() / values.len() as f64).exp();
    let [low, high] = [values.iter().copied().reduce(f64::min)?, values.iter().copied().reduce(f64::max)?];
    Some([mean, low, high])
}

pub fn layouts(results: &Results) -> Option<String> {
    let pairs = || pairs(results, |engine| engine.strip_prefix("aos-").map(|set| format!("soa-{set}")));
    let [mean, low, high] = ratios(pairs().map(|(aos, soa)| soa.median.median / aos.median.median))?;
    // With fewer than three repeats, bounds are often disjoint by chance, so nothing follows from them.
    let bounded = || pairs().filter(|(a, b)| a.median.is_bounded() && b.median.is_bounded());
    let apart = bounded().filter(|(a, b)| a.median.low > b.median.high || b.median.low > a.median.high).count();
    let conclusion = match bounded().count() {
        0 => "with so few repeats there are no bounds to tell a difference from chance".to_owned(),
        count => format!("in {apart} of {count} settings their bounds lie apart"),
    };
    Some(format!(
        "Structures of arrays take {} times the time of arrays of structures (geometric mean; {} to {}); {conclusion}.",
        short(mean),
        short(low),
        short(high),
    ))
}

/// Says how many times as fast as the reference the renderer is.
pub fn reference(results: &Results) -> Option<String> {
    let best = results.machines.first()?.instruction_set.clone();
    let faster = pairs(results, move |engine| (engine == format!("aos-{best}")).then(|| "reference".to_owned()));
    let pairs: Vec<_> = faster.collect();
    let ratio = |(real, slow): &(&Timing, &Timing)| slow.median.median / real.median.median;
    let [mean, ..] = ratios(pairs.iter().map(ratio))?;
    let most = pairs.iter().max_by(|a, b| ratio(a).total_cmp(&ratio(b)))?;
    let least = pairs.iter().min_by(|a, b| ratio(a).total_cmp(&ratio(b)))?;
    let place = |(real, _): &(&Timing, &Timing)| {
        format!("{}, {}", real.setting.scene, setting(&real.setting.parameter, real.setting.value))
    };
    Some(format!(
        "The renderer is {} times as fast as the reference (geometric mean over {} settings): least {} times ({}), most \
         {} times ({}).",
        short(mean),
        pairs.len(),
        short(ratio(least)),
        place(least),
        short(ratio(most)),
        place(most)
    ))
}

pub fn instruction_sets(results: &Results) -> Option<String> {
    let is_there =
        |set: &&str| results.timings.iter().any(|timing| timing.setting.engine.ends_with(&format!("-{set}")));
    let sets: Vec<_> = InstructionSet::ALL.map(InstructionSet::name).into_iter().filter(is_there).collect();
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
