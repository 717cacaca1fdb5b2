//! Sentences about the dependence of time and error on a parameter.

use crate::bench::fit::PowerLaw;
use crate::bench::matrix::PARAMETERS;
use crate::bench::results::{Results, TARGETS, TimeToError};
use crate::format::{Words, hint::Language};
use crate::report::style::{joined, parameter_name, seconds, short, with_error};

pub fn scaling(results: &Results, language: Language) -> Option<String> {
    let best = &results.machines.first()?.instruction_set;
    let of = |law: &PowerLaw| with_error(law.exponent, law.exponent_error);
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

pub fn error(results: &Results, language: Language) -> Option<String> {
    let parts = results.curves.iter().filter_map(|curve| {
        let points: Vec<_> = curve.points.iter().map(|p| (p.samples as f64, p.linear.median)).collect();
        let law = PowerLaw::through(&points)?;
        let (scene, exponent) = (&curve.scene, with_error(law.exponent, law.exponent_error));
        Some(language.say(EXPONENT, &[&exponent, scene, &short(curve.reference_error)]))
    });
    Some(language.say(ERROR, &[&joined(parts, ", ")?]))
}

const EXPONENT: Words =
    ["{} ({}; the converged picture's own error is {})", "{} ({}; el error propio de la imagen convergida es {})"];
const ERROR: Words = [
    "The error falls with the number of samples to the power {}; independent samples give -0.5.",
    "El error cae con el número de muestras elevado a {}; las muestras independientes dan -0.5.",
];

pub fn time_to_error(results: &Results, language: Language) -> Option<String> {
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
            Some(language.say(TIMES, &[&error.to_string(), &seconds(real), &seconds(slow), scene]))
        })
    });
    let [start, next] = [["An error of ", "Un error de "], [", of ", ", de "]].map(|words| language.pick(words));
    Some(format!("{start}{}.", joined(parts, next)?))
}

const TIMES: Words = ["{} takes {} instead of {} ({})", "{} tarda {} en vez de {} ({})"];
