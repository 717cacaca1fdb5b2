//! Sentences that compare implementations with each other.

use cpu::internals::InstructionSet;
use indexmap::IndexMap;

use crate::bench::results::{Results, Setting, Timing};
use crate::format::{Words, hint::Language};
use crate::report::style::{joined, setting, short};

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

/// Returns for each scene, in the order of the data, the geometric mean of the ratios of `pairs`: second time by first.
fn by_scene<'a>(pairs: impl Iterator<Item = (&'a Timing, &'a Timing)>) -> Option<String> {
    let mut scenes: IndexMap<&str, Vec<f64>> = IndexMap::new();
    for (first, second) in pairs {
        scenes.entry(&first.setting.scene).or_default().push(second.median.median / first.median.median);
    }
    let parts = scenes.into_iter().filter_map(|(scene, values)| {
        let [mean, ..] = ratios(values.into_iter())?;
        Some(format!("{mean:.2} ({scene})"))
    });
    joined(parts, ", ")
}

/// Compares the layouts with the best instruction set.
pub fn layouts(results: &Results, language: Language) -> Option<String> {
    let best = &results.machines.first()?.instruction_set;
    let pairs = || pairs(results, move |engine| (engine == format!("aos-{best}")).then(|| format!("soa-{best}")));
    let [_, low, high] = ratios(pairs().map(|(aos, soa)| soa.median.median / aos.median.median))?;
    // With fewer than three repeats, bounds are often disjoint by chance, so nothing follows from them.
    let bounded = || pairs().filter(|(a, b)| a.median.is_bounded() && b.median.is_bounded());
    let apart = bounded().filter(|(a, b)| a.median.low > b.median.high || b.median.low > a.median.high).count();
    let conclusion = match bounded().count() {
        0 => language.pick(NO_BOUNDS).to_owned(),
        count => language.say(APART, &[&apart.to_string(), &count.to_string()]),
    };
    let [low, high] = [low, high].map(|ratio| format!("{ratio:.2}"));
    Some(language.say(LAYOUTS, &[best, &by_scene(pairs())?, &low, &high, &conclusion]))
}

const NO_BOUNDS: Words = [
    "with so few repeats there are no bounds to tell a difference from chance",
    "con tan pocas repeticiones no hay cotas que distingan una diferencia del azar",
];
const APART: Words = ["in {} of {} settings their bounds lie apart", "en {} de {} ajustes sus cotas no se solapan"];
const LAYOUTS: Words = [
    "With {}, structures of arrays take {} times the time of arrays of structures (geometric means; {} to {}); {}.",
    "Con {}, las estructuras de arrays tardan {} veces lo que los arrays de estructuras (medias geométricas; de {} a \
     {}); {}.",
];

/// Says how many times as fast as the reference the renderer is, at the most samples or objects that both were measured
/// with.
pub fn reference(results: &Results, language: Language) -> Option<String> {
    let best = results.machines.first()?.instruction_set.clone();
    let faster = pairs(results, move |engine| (engine == format!("aos-{best}")).then(|| "reference".to_owned()));
    let mut largest: IndexMap<(&str, &str), (&Timing, &Timing)> = IndexMap::new();
    for pair in faster.filter(|(_, slow)| ["samples", "objects"].contains(&&*slow.setting.parameter)) {
        let Setting { scene, parameter, value, .. } = &pair.0.setting;
        let old = largest.entry((scene, parameter)).or_insert(pair);
        if old.0.setting.value < *value {
            *old = pair;
        }
    }
    let parts = largest.into_values().map(|(real, slow)| {
        let at = setting(&real.setting.parameter, real.setting.value, language);
        format!("{} ({}, {at})", short(slow.median.median / real.median.median), real.setting.scene)
    });
    Some(language.say(REFERENCE, &[&joined(parts, ", ")?]))
}

const REFERENCE: Words = [
    "In the small pictures of this page the renderer is {} times as fast as the reference. docs/measurements.md has whole \
     pictures.",
    "En las imágenes pequeñas de esta página el renderizador es {} veces más rápido que la referencia. \
     docs/measurements.md tiene imágenes completas.",
];

/// Compares each other instruction set with the best one.
pub fn instruction_sets(results: &Results, language: Language) -> Option<String> {
    let best = &results.machines.first()?.instruction_set;
    let others = InstructionSet::ALL.map(InstructionSet::name).into_iter().filter(|set| set != best);
    let parts = others.filter_map(|set| {
        let both = pairs(results, move |engine| (engine == format!("aos-{best}")).then(|| format!("aos-{set}")));
        Some(format!("{set} {}", by_scene(both)?))
    });
    Some(language.say(SETS, &[best, &joined(parts, "; ")?]))
}

const SETS: Words = [
    "The time with another instruction set, as a multiple of that with {}: {}.",
    "El tiempo con otro juego de instrucciones, como múltiplo del que se tarda con {}: {}.",
];
