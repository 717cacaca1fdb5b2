//! The sentence about the times and errors of intersections.

use crate::bench::intersections::{METHODS, OBJECTS};
use crate::bench::results::{Intersection, Results};
use crate::report::style::{power_of_ten, short};

/// Returns a sentence with the time, the error and the number of wrong decisions of every implementation, on ordinary
/// and on hard rays. Returns `None` if there are no data.
pub fn intersections(results: &Results) -> Option<String> {
    let find = |object: &str, rays: &str, name: &str| {
        let is_it = |found: &&Intersection| {
            (found.trial.object.as_str(), found.trial.rays.as_str(), found.trial.implementation.as_str())
                == (object, rays, name)
        };
        results.intersections.iter().find(is_it)
    };
    let said = |object: &str| {
        let parts: Vec<_> = METHODS
            .iter()
            .filter_map(|name| Some(phrase(name, find(object, "ordinary", name)?, find(object, "hard", name)?)))
            .collect();
        (!parts.is_empty()).then(|| format!("With a {object}: {}", parts.join("; ")))
    };
    let objects: Vec<_> = OBJECTS.iter().filter_map(|object| said(object)).collect();
    (!objects.is_empty()).then(|| {
        format!(
            "What a test of one ray costs, the error that 99.9 % of lambdas keep within, and wrong decisions, each on \
             ordinary and on hard rays. {}.",
            objects.join(". ")
        )
    })
}

fn phrase(name: &str, ordinary: &Intersection, hard: &Intersection) -> String {
    let share = |found: &Intersection| short(100.0 * found.wrong as f64 / found.cases as f64);
    let wrong = match ordinary.wrong + hard.wrong {
        0 => "none wrong".to_owned(),
        _ => format!("{} % and {} % wrong", share(ordinary), share(hard)),
    };
    let error = |found: &Intersection| power_of_ten(found.lambda_error[1]);
    format!(
        "{name} {} and {} ns, errors of {} and {}, {wrong}",
        short(ordinary.median.median),
        short(hard.median.median),
        error(ordinary),
        error(hard)
    )
}
