//! Sentences about the dependence of time and error on a parameter.

use crate::bench::fit::PowerLaw;
use crate::bench::results::Results;
use crate::report::style::{seconds, short, with_error};

pub fn scaling(results: &Results) -> Option<String> {
    let best = &results.machines.first()?.instruction_set;
    let of = |law: &PowerLaw| with_error(law.exponent, law.exponent_error);
    // Time flattens with the depth, so it follows no power of it.
    let parts: Vec<_> = crate::bench::matrix::PARAMETERS
        .iter()
        .filter(|parameter| **parameter != "depth")
        .filter_map(|parameter| {
            let find = |engine: &str| {
                results.growth.iter().find(|growth| growth.parameter == *parameter && growth.engine == engine)
            };
            let real = find(&format!("aos-{best}"))?;
            let slow =
                find("reference").map_or_else(String::new, |growth| format!(" (reference: {})", of(&growth.law)));
            Some(format!("{parameter} to the power {}{slow}", of(&real.law)))
        })
        .collect();
    (!parts.is_empty()).then(|| format!("Time grows with {}.", parts.join(", ")))
}

pub fn error(results: &Results) -> Option<String> {
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

pub fn time_to_error(results: &Results) -> Option<String> {
    let best = format!("aos-{}", results.machines.first()?.instruction_set);
    let find = |scene: &str, engine: &str, error: f64| {
        let is_it =
            |t: &&crate::bench::results::TimeToError| t.scene == scene && t.engine == engine && t.error == error;
        results.times_to_error.iter().find(is_it).and_then(|time| time.seconds)
    };
    // For each scene, the smallest target error that both engines reached.
    let parts: Vec<_> = results
        .curves
        .iter()
        .filter_map(|curve| {
            let scene = &curve.scene;
            crate::bench::results::TARGETS.iter().rev().find_map(|&error| {
                let (real, slow) = (find(scene, &best, error)?, find(scene, "reference", error)?);
                Some(format!("{error} takes {} instead of {} ({scene})", seconds(real), seconds(slow)))
            })
        })
        .collect();
    (!parts.is_empty()).then(|| format!("An error of {}.", parts.join(", of ")))
}
