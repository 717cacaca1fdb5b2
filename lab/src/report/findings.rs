//! Computes sentences about the data from the data.

mod comparisons;

use serde::Serialize;

use super::style::{joined, number, parameter_name, time, with_error};
use crate::bench::fit::PowerLaw;
use crate::bench::matrix::PARAMETERS;
use crate::bench::results::{Results, TARGETS, TimeToError};
use crate::format::{Words, hint::Language};
use comparisons::{instruction_sets, layouts, reference};

pub use comparisons::{LayoutRow, conclusions, layout_rows};

/// A sentence about the data, with its topic.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Finding {
    /// The topic, in one to three words.
    pub topic: &'static str,
    /// The sentence.
    pub text: String,
}

/// All that is found in the data: the contents of `findings.json`, from which the report as PDF takes its numbers too.
#[derive(Clone, Debug, Serialize)]
pub struct Findings {
    /// The sentences.
    pub sentences: Vec<Finding>,
    /// The comparison of the layouts.
    pub layouts: Vec<LayoutRow>,
}

/// Returns a sentence for each topic for which there are data.
pub fn of(results: &Results, language: Language) -> Vec<Finding> {
    let findings: [(Words, Option<String>); 8] = [
        (["Conditions", "Condiciones"], conditions(results, language)),
        (["Spread", "Dispersión"], spread(results, language)),
        (["Layouts", "Disposiciones"], layouts(results, language)),
        (["Reference", "Referencia"], reference(results, language)),
        (["Instruction sets", "Juegos de instrucciones"], instruction_sets(results, language)),
        (["Scaling", "Escalabilidad"], scaling(results, language)),
        (["Error", "Error"], error(results, language)),
        (["Time to an error", "Tiempo hasta un error"], time_to_error(results, language)),
    ];
    let finding = |(topic, text): (Words, Option<String>)| Some(Finding { topic: language.pick(topic), text: text? });
    findings.into_iter().filter_map(finding).collect()
}

fn conditions(results: &Results, language: Language) -> Option<String> {
    let machine = results.machines.first()?;
    let size = if results.quick { ["small", "pequeño"] } else { ["full", "completo"] };
    let load = machine.load.map_or_else(String::new, |load| language.say(LOAD, &[&number(load, language)]));
    let others = match results.machines.len() {
        1 => String::new(),
        count => language.say([" and {} other runs", " y {} medidas más"], &[&(count - 1).to_string()]),
    };
    let (processor, processors) = (&machine.processor, machine.processors.to_string());
    Some(language.say(
        [
            "The {} set of settings, measured on {} on {} ({} processors{}){}.",
            "El conjunto {} de ajustes, medido el {} en {} ({} procesadores{}){}.",
        ],
        &[language.pick(size), &machine.date, processor, &processors, &load, &others],
    ))
}

const LOAD: Words = [
    "; when it began, {} processes on average ran or waited for a processor",
    "; al empezar, {} procesos en promedio se ejecutaban o esperaban un procesador",
];

fn spread(results: &Results, language: Language) -> Option<String> {
    let mut spreads: Vec<_> = results.timings.iter().map(|timing| timing.median.spread()).collect();
    spreads.sort_by(f64::total_cmp);
    let (middle, worst) = (spreads.get(spreads.len() / 2)?, spreads.last()?);
    let repeats = results.timings.iter().map(|timing| timing.seconds.len()).min()?;
    if !results.timings.iter().all(|timing| timing.median.is_bounded()) {
        return Some(language.say(FEW, &[&repeats.to_string()]));
    }
    let confidence = results.timings.iter().map(|timing| timing.median.confidence).fold(1.0, f64::min);
    let [confidence, middle, worst] = [confidence, *middle, *worst].map(|share| number(100.0 * share, language));
    let [repeats, times] = [repeats, spreads.len()].map(|count| count.to_string());
    Some(language.say(SPREAD, &[&repeats, &confidence, &times, &middle, &worst]))
}

const FEW: Words = [
    "The fewest repeats of a time are {}. Bounds of a median that are worth a conclusion need three, and with 95 % \
     confidence six: where there are fewer, no difference is told from chance.",
    "Un tiempo se repitió como mínimo {} veces. Unas cotas de la mediana de las que se pueda concluir algo necesitan \
     tres, y con un 95 % de confianza seis: con menos, ninguna diferencia se distingue del azar.",
];
const SPREAD: Words = [
    "Each time was measured {} times or more. Its median has bounds that hold with at least {} % confidence. In half \
     of the {} times the upper bound is at most {} % of the median above the lower one, and in the worst {} %.",
    "Cada tiempo se midió {} veces o más. Su mediana tiene cotas que se cumplen con al menos un {} % de confianza. En \
     la mitad de los {} tiempos la cota superior supera a la inferior en un {} % de la mediana como mucho; en el peor, \
     en un {} %.",
];

fn scaling(results: &Results, language: Language) -> Option<String> {
    let best = &results.machines.first()?.instruction_set;
    let of = |law: &PowerLaw| with_error(law.exponent, law.exponent_error, language);
    // Time flattens with the depth, so it follows no power of it.
    let parts = PARAMETERS.iter().filter(|parameter| **parameter != "depth").filter_map(|parameter| {
        let find = |engine: &str| {
            results.growth.iter().find(|growth| growth.parameter == *parameter && growth.engine == engine)
        };
        let real = find(&format!("aos-{best}"))?;
        let slow = find("reference").map_or_else(String::new, |growth| {
            language.say([" (reference: {})", " (referencia: {})"], &[&of(&growth.law)])
        });
        let words = ["{} to the power {}{}", "{} a la potencia {}{}"];
        Some(language.say(words, &[parameter_name(parameter, language), &of(&real.law), &slow]))
    });
    Some(language.say(["Time grows with {}.", "El tiempo crece con {}."], &[&joined(parts, ", ")?]))
}

fn error(results: &Results, language: Language) -> Option<String> {
    let parts = results.curves.iter().filter_map(|curve| {
        let points: Vec<_> = curve.points.iter().map(|p| (p.samples as f64, p.linear.median)).collect();
        let law = PowerLaw::through(&points)?;
        let (exponent, rest) =
            (with_error(law.exponent, law.exponent_error, language), number(curve.reference_error, language));
        Some(language.say(EXPONENT, &[&exponent, &curve.scene, &rest]))
    });
    Some(language.say(ERROR, &[&joined(parts, ", ")?]))
}

/// The exponent of the samples, the scene, and the error that the converged picture still has.
const EXPONENT: Words =
    ["{} ({}; the converged picture's own error is {})", "{} ({}; el error propio de la imagen convergida es {})"];
const ERROR: Words = [
    "The error falls with the number of samples to the power {}; independent samples give -0.5.",
    "El error cae con el número de muestras elevado a {}; las muestras independientes dan -0,5.",
];

fn time_to_error(results: &Results, language: Language) -> Option<String> {
    let best = format!("aos-{}", results.machines.first()?.instruction_set);
    let find = |scene: &str, engine: &str, error: f64| {
        let is_it = |t: &&TimeToError| t.scene == scene && t.engine == engine && t.error == error;
        results.times_to_error.iter().find(is_it).and_then(|time| time.seconds)
    };
    // For each scene, the smallest target error that both engines reached.
    let parts = results.curves.iter().filter_map(|curve| {
        let scene = &curve.scene;
        TARGETS.iter().rev().find_map(|&error| {
            let (real, slow) = (find(scene, &best, error)?, find(scene, "reference", error)?);
            Some(language.say(TIMES, &[&number(error, language), &time(real, language), &time(slow, language), scene]))
        })
    });
    let [start, next] = [["An error of ", "Un error de "], [", of ", ", de "]].map(|words| language.pick(words));
    Some(format!("{start}{}.", joined(parts, next)?))
}

const TIMES: Words = ["{} takes {} instead of {} ({})", "{} tarda {} en vez de {} ({})"];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bench::machine::Machine;
    use crate::bench::results::{Setting, Timing, tests};
    use measure::statistics::Median;

    fn timing(engine: &str, value: u64, seconds: f64) -> Timing {
        let bounds = [0.9, 0.95, 1.0, 1.0, 1.05, 1.1].map(|share| share * seconds);
        let timing = tests::timing(engine, value, &bounds);
        let (scene, parameter) = ("board".to_owned(), "objects".to_owned());
        Timing { setting: Setting { scene, parameter, ..timing.setting }, ..timing }
    }

    fn text(results: &Results, topic: &str) -> String {
        of(results, Language::English).into_iter().find(|finding| finding.topic == topic).expect("it is said").text
    }

    #[test]
    fn sentences_have_the_figures_of_the_data() {
        let machine = Machine { instruction_set: "avx2".to_owned(), ..Machine::here() };
        let mut timings = Vec::new();
        for (value, slow) in [(10, 2.0), (100, 8.0)] {
            timings.extend([timing("reference", value, slow), timing("aos-avx2", value, 1.0)]);
            timings.extend([timing("soa-avx2", value, 2.0), timing("aos-portable", value, 1.5)]);
        }
        let mut results = Results { machines: vec![machine], timings, ..Results::default() };
        results.complete();
        let layouts = text(&results, "Layouts");
        assert!(
            layouts.contains("take 2.00 (board) times the time") && layouts.contains("in 2 of 2 settings"),
            "{layouts}"
        );
        let mut once = results.clone();
        once.timings.iter_mut().for_each(|timing| timing.median = Median::of(&timing.seconds[2..3]));
        let unknown = text(&once, "Layouts");
        assert!(unknown.contains("no bounds to tell a difference from chance"), "{unknown}");
        let spread = text(&once, "Spread");
        assert!(spread.contains("no difference is told from chance") && !spread.contains("confidence ("), "{spread}");
        let reference = text(&results, "Reference");
        assert!(reference.contains("is 8 (board, 100 objects) times as fast as the reference"), "{reference}");
        let sets = text(&results, "Instruction sets");
        assert!(sets.ends_with("as a multiple of that with avx2: portable 1.50 (board)."), "{sets}");
        assert!(text(&results, "Scaling").contains("objects to the power 0"), "{}", text(&results, "Scaling"));
        assert_eq!(
            conclusions(&results, Language::English),
            [
                "The renderer is 8 times as fast as the reference where it gains least (board, 100 objects), and 8 \
                 times where it gains most (board, 100 objects).",
                "Arrays of structures are the faster layout. Structures of arrays take 2.00 times the time on average. \
                 In 2 of 2 settings the bounds lie apart: there they are slower in 2 and faster in 0.",
                "Without explicit vector instructions a picture takes 1.50 (board) to 1.50 (board) times the time with \
                 avx2.",
            ]
        );
        let spanish = conclusions(&results, Language::Spanish).concat();
        assert!(
            spanish.contains("tardan en promedio 2,00 veces") && spanish.contains("tarda de 1,50 (board)"),
            "{spanish}"
        );
        // The renderer and structures of arrays change places.
        for timing in &mut results.timings {
            timing.setting.engine = timing.setting.engine.replace("aos", "?").replace("soa", "aos").replace('?', "soa");
        }
        let winner = conclusions(&results, Language::English)[1].clone();
        assert!(winner.starts_with("Structures of arrays are the faster layout. "), "{winner}");
        assert_eq!(conclusions(&once, Language::English).len(), 2, "without bounds no layout is said to be faster");
    }

    #[test]
    fn without_data_nothing_is_said() {
        assert!(of(&Results::default(), Language::Spanish).is_empty());
        assert!(conclusions(&Results::default(), Language::Spanish).is_empty());
    }
}
