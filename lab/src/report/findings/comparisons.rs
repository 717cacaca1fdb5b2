//! Sentences that compare implementations with each other.

use cpu::internals::InstructionSet;
use indexmap::{IndexMap, IndexSet};
use serde::Serialize;

use crate::bench::results::{Results, Setting, Timing};
use crate::format::{Words, hint::Language};
use crate::report::style::{joined, localized, number, setting};

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
fn by_scene<'a>(pairs: impl Iterator<Item = (&'a Timing, &'a Timing)>, language: Language) -> Option<String> {
    let parts = means(pairs).into_iter().map(|(scene, mean)| format!("{} ({scene})", hundredths(mean, language)));
    joined(parts, ", ")
}

/// Returns each scene, in the order of the data, with the geometric mean of the ratios of `pairs`.
fn means<'a>(pairs: impl Iterator<Item = (&'a Timing, &'a Timing)>) -> Vec<(&'a str, f64)> {
    let mut scenes: IndexMap<&str, Vec<f64>> = IndexMap::new();
    for (first, second) in pairs {
        scenes.entry(&first.setting.scene).or_default().push(second.median.median / first.median.median);
    }
    scenes.into_iter().filter_map(|(scene, values)| Some((scene, ratios(values.into_iter())?[0]))).collect()
}

/// Formats a ratio near 1.
fn hundredths(ratio: f64, language: Language) -> String {
    localized(format!("{ratio:.2}"), language)
}

/// Returns the pairs of times with the best instruction set that differ in the layout only: arrays of structures first.
fn layout_pairs(results: &Results) -> Option<impl Iterator<Item = (&Timing, &Timing)>> {
    let best = &results.machines.first()?.instruction_set;
    Some(pairs(results, move |engine| (engine == format!("aos-{best}")).then(|| format!("soa-{best}"))))
}

/// Returns how many of the pairs have bounds, and in how many of these the bounds show that the second is slower, and
/// that it is faster. With fewer than three repeats, bounds are often disjoint by chance, so nothing follows from them.
fn apart<'a>(pairs: impl Iterator<Item = (&'a Timing, &'a Timing)>) -> [usize; 3] {
    pairs.filter(|(a, b)| a.median.is_bounded() && b.median.is_bounded()).fold(
        [0; 3],
        |[all, slower, faster], (a, b)| {
            let [is_slower, is_faster] = [b.median.low > a.median.high, a.median.low > b.median.high].map(usize::from);
            [all + 1, slower + is_slower, faster + is_faster]
        },
    )
}

/// How structures of arrays compare with arrays of structures, for one instruction set and one scene: ratios of times
/// that differ in the layout only.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LayoutRow {
    /// Name of the instruction set.
    pub set: String,
    /// Name of the scene.
    pub scene: String,
    /// Number of pairs of times.
    pub pairs: usize,
    /// Geometric mean of the ratios: time of structures of arrays by time of arrays of structures.
    pub mean: f64,
    /// Smallest ratio.
    pub least: f64,
    /// Largest ratio.
    pub most: f64,
    /// Number of pairs whose bounds show that structures of arrays are slower.
    pub slower: usize,
    /// Number of pairs whose bounds show that structures of arrays are faster.
    pub faster: usize,
}

/// Returns a row for each instruction set and each scene for which there are pairs, in the order of the data.
pub fn layout_rows(results: &Results) -> Vec<LayoutRow> {
    let sets: IndexSet<_> =
        results.timings.iter().filter_map(|timing| timing.setting.engine.strip_prefix("aos-")).collect();
    let scenes: IndexSet<_> = results.timings.iter().map(|timing| timing.setting.scene.as_str()).collect();
    let row = |set: &str, scene: &str| {
        let second = |engine: &str| (engine == format!("aos-{set}")).then(|| format!("soa-{set}"));
        let of_scene = || pairs(results, second).filter(|(first, _)| first.setting.scene == scene);
        let [mean, least, most] = ratios(of_scene().map(|(aos, soa)| soa.median.median / aos.median.median))?;
        let [_, slower, faster] = apart(of_scene());
        let [set, scene] = [set, scene].map(str::to_owned);
        Some(LayoutRow { set, scene, pairs: of_scene().count(), mean, least, most, slower, faster })
    };
    sets.iter().flat_map(|set| scenes.iter().filter_map(move |scene| row(set, scene))).collect()
}

/// Compares the layouts with the best instruction set.
pub fn layouts(results: &Results, language: Language) -> Option<String> {
    let best = &results.machines.first()?.instruction_set;
    let [_, low, high] = ratios(layout_pairs(results)?.map(|(aos, soa)| soa.median.median / aos.median.median))?;
    let conclusion = match apart(layout_pairs(results)?) {
        [0, ..] => language.pick(NO_BOUNDS).to_owned(),
        [count, slower, faster] => language.say(APART, &[&(slower + faster).to_string(), &count.to_string()]),
    };
    let [low, high] = [low, high].map(|ratio| hundredths(ratio, language));
    let means = by_scene(layout_pairs(results)?, language)?;
    Some(language.say(LAYOUTS, &[best, &means, &low, &high, &conclusion]))
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

/// Says how many times as fast as the reference the renderer is.
pub fn reference(results: &Results, language: Language) -> Option<String> {
    let parts =
        gains(results, language)?.into_iter().map(|(gain, scene)| format!("{} ({scene})", number(gain, language)));
    Some(language.say(REFERENCE, &[&joined(parts, ", ")?]))
}

/// Returns how many times as fast as the reference the renderer is, with the scene and its samples or objects: the most
/// that both were measured with.
fn gains(results: &Results, language: Language) -> Option<Vec<(f64, String)>> {
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
    let gain = |(real, slow): (&Timing, &Timing)| {
        let at = setting(&real.setting.parameter, real.setting.value, language);
        (slow.median.median / real.median.median, format!("{}, {at}", real.setting.scene))
    };
    Some(largest.into_values().map(gain).collect())
}

const REFERENCE: Words = [
    "In the small pictures of this page the renderer is {} times as fast as the reference. docs/measurements.md has larger \
     pictures.",
    "En las imágenes pequeñas de esta página el renderizador es {} veces más rápido que la referencia. \
     docs/measurements.md tiene imágenes mayores.",
];

/// Compares each other instruction set with the best one.
pub fn instruction_sets(results: &Results, language: Language) -> Option<String> {
    let best = &results.machines.first()?.instruction_set;
    let others = InstructionSet::ALL.map(InstructionSet::name).into_iter().filter(|set| set != best);
    let parts = others.filter_map(|set| Some(format!("{set} {}", by_scene(set_pairs(results, best, set), language)?)));
    Some(language.say(SETS, &[best, &joined(parts, "; ")?]))
}

/// Returns the pairs of times with arrays of structures that differ in the instruction set only: `best` and `set`.
fn set_pairs<'a>(results: &'a Results, best: &'a str, set: &'a str) -> impl Iterator<Item = (&'a Timing, &'a Timing)> {
    pairs(results, move |engine| (engine == format!("aos-{best}")).then(|| format!("aos-{set}")))
}

const SETS: Words = [
    "The time with another instruction set, as a multiple of that with {}: {}.",
    "El tiempo con otro juego de instrucciones, como múltiplo del que se tarda con {}: {}.",
];

/// Returns at most three sentences that a reader should remember, each if there are data for it.
pub fn conclusions(results: &Results, language: Language) -> Vec<String> {
    let sentences =
        [most_gain(results, language), faster_layout(results, language), cost_of_portable(results, language)];
    sentences.into_iter().flatten().collect()
}

/// Says where the renderer gains least and most over the reference.
fn most_gain(results: &Results, language: Language) -> Option<String> {
    let mut gains = gains(results, language)?;
    gains.sort_by(|(a, _), (b, _)| a.total_cmp(b));
    let ((least, simple), (most, hard)) = (gains.first()?, gains.last()?);
    Some(language.say(GAINS, &[&number(*least, language), simple, &number(*most, language), hard]))
}

const GAINS: Words = [
    "The renderer is {} times as fast as the reference where it gains least ({}), and {} times where it gains most \
     ({}).",
    "El renderizador es {} veces más rápido que la referencia donde menos gana ({}) y {} veces donde más gana ({}).",
];

/// Says which layout is faster. It names one if that one is faster more than twice as often as the other, counting only
/// pairs whose bounds lie apart.
fn faster_layout(results: &Results, language: Language) -> Option<String> {
    let [mean, ..] = ratios(layout_pairs(results)?.map(|(aos, soa)| soa.median.median / aos.median.median))?;
    let [count, slower, faster] = apart(layout_pairs(results)?);
    if count == 0 {
        return None;
    }
    let winner = if slower > 2 * faster {
        ["Arrays of structures are the faster layout", "Los arrays de estructuras son la disposición más rápida"]
    } else if faster > 2 * slower {
        ["Structures of arrays are the faster layout", "Las estructuras de arrays son la disposición más rápida"]
    } else {
        ["Neither layout is shown to be faster", "No se ve que ninguna disposición sea más rápida"]
    };
    let [apart, count, slower, faster] = [slower + faster, count, slower, faster].map(|count| count.to_string());
    let mean = hundredths(mean, language);
    Some(language.say(FASTER, &[language.pick(winner), &mean, &apart, &count, &slower, &faster]))
}

const FASTER: Words = [
    "{}. Structures of arrays take {} times the time on average. In {} of {} settings the bounds lie apart: there they \
     are slower in {} and faster in {}.",
    "{}. Las estructuras de arrays tardan en promedio {} veces el tiempo. En {} de {} ajustes las cotas no se solapan: \
     ahí son más lentas en {} y más rápidas en {}.",
];

/// Says what a picture costs without explicit vector instructions.
fn cost_of_portable(results: &Results, language: Language) -> Option<String> {
    let best = &results.machines.first()?.instruction_set;
    let portable = Some(InstructionSet::Portable.name()).filter(|portable| portable != best)?;
    let mut means = means(set_pairs(results, best, portable));
    means.sort_by(|(_, a), (_, b)| a.total_cmp(b));
    let ((simple, least), (hard, most)) = (means.first()?, means.last()?);
    let [least, most] = [least, most].map(|ratio| hundredths(*ratio, language));
    Some(language.say(PORTABLE, &[&least, simple, &most, hard, best]))
}

const PORTABLE: Words = [
    "Without explicit vector instructions a picture takes {} ({}) to {} ({}) times the time with {}.",
    "Sin instrucciones vectoriales explícitas una imagen tarda de {} ({}) a {} ({}) veces lo que tarda con {}.",
];
