//! Measures the time of one intersection, and the error of its lambda.
//!
//! The rays and the oracle come from the crate `stability`. The tables in `docs/accuracy/` show each regime of that
//! crate in its own row. Here all regimes except the ordinary one form one family of hard rays. The time is measured
//! for intersections one after the other, each of one ray with one object. Ray and object are in the form that the
//! renderer uses.

use measure::clock::own_seconds;
use measure::turns::{in_turn, turns_of};
use stability::case::Case;
use stability::measure::Judged;
use stability::methods::{self, Method};
use stability::regimes::{CYLINDERS, Regime, SPHERES};

use super::results::{Intersection, Trial};
use crate::Failure;
use crate::interrupt::Interrupt;
use measure::statistics::Median;

/// Names of the implementations of the intersection, in the order of the chart's legend.
pub const METHODS: [&str; 5] =
    [methods::RESOLVED, methods::EXACT, methods::PLAIN, methods::PLAIN_SINGLE, methods::PROJECTED];

/// Names of the kinds of objects that [`measure()`] accepts.
pub const OBJECTS: [&str; 2] = ["sphere", "cylinder"];

/// Seed of the random rays. It is fixed, so that two measurements of one program differ only in their times.
const SEED: u64 = 1;

/// Measures every implementation for one kind of object, on `count` ordinary rays and on at least `count` hard rays.
///
/// # Errors
/// [`Failure::Interrupted`].
pub fn measure(
    object: &str,
    count: usize,
    repeats: usize,
    interrupt: &Interrupt,
) -> Result<Vec<Intersection>, Failure> {
    let regimes: &[Regime] = if object == OBJECTS[0] { &SPHERES } else { &CYLINDERS };
    let hard = &regimes[1..];
    let each = count.div_ceil(hard.len());
    let families = [
        ("ordinary", regimes[0].cases(SEED, count)),
        ("hard", hard.iter().flat_map(|regime| regime.cases(SEED, each)).collect()),
    ];
    let mut found = Vec::new();
    for (rays, cases) in families {
        let methods: Vec<_> = methods::all().into_iter().chain([methods::resolved()]).collect();
        let times = times(&methods, &cases, repeats, interrupt)?;
        let judged = Judged::new(rays, cases);
        for (method, nanoseconds) in methods.iter().zip(times) {
            interrupt.check()?;
            let row = judged.measure(method.as_ref()).map_err(|error| error.to_string())?;
            let [object, rays, implementation] = [object, rays, method.name()].map(str::to_owned);
            found.push(Intersection {
                trial: Trial { object, rays, implementation, seed: SEED },
                cases: row.cases,
                wrong: row.wrong,
                lambda_error: row.lambda_error,
                median: Median::of(&nanoseconds),
                nanoseconds,
            });
        }
    }
    Ok(found)
}

/// Returns the nanoseconds of one intersection: a list for each implementation, with one entry for each repeat.
fn times(
    methods: &[Box<dyn Method>],
    cases: &[Case],
    repeats: usize,
    interrupt: &Interrupt,
) -> Result<Vec<Vec<f64>>, Failure> {
    let explain = |error: methods::Failure| error.to_string();
    let mut stopwatches = Vec::new();
    let mut turns = Vec::new();
    for method in methods {
        let mut stopwatch = method.stopwatch(cases).map_err(explain)?;
        // The first pass warms the caches. From its time follows the number of passes in one repeat.
        turns.push(turns_of(stopwatch().map_err(explain)?.as_secs_f64()));
        stopwatches.push(stopwatch);
    }
    let seconds = in_turn(repeats, &turns, own_seconds, |index| {
        interrupt.check()?;
        stopwatches[index]().map_err(explain)?;
        Ok::<(), Failure>(())
    })?;
    let a_test = |seconds: f64| seconds * 1e9 / cases.len() as f64;
    Ok(seconds.into_iter().map(|times| times.into_iter().map(a_test).collect()).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_intersections_with_and_without_a_filter_are_right_and_the_others_are_not() {
        for object in OBJECTS {
            let found = measure(object, 900, 2, &Interrupt::default()).expect("nothing fails");
            assert_eq!(found.len(), 2 * METHODS.len());
            let hard = |name: &str| {
                let is_it = |found: &&Intersection| found.trial.rays == "hard" && found.trial.implementation == name;
                found.iter().find(is_it).expect("it was measured")
            };
            for name in METHODS {
                let found = hard(name);
                assert!(found.cases >= 900 && found.nanoseconds.len() == 2 && found.median.median > 0.0, "{found:?}");
                let is_right = [methods::EXACT, methods::RESOLVED].contains(&name);
                assert_eq!(found.wrong == 0, is_right, "{found:?}");
            }
            // The error of the resolved method is at most one unit in the last place. The error of the exact method may
            // be as large as its bound, which is larger.
            assert!(hard(methods::RESOLVED).lambda_error[2] <= f64::EPSILON);
            assert!(hard(methods::EXACT).lambda_error[2] <= 1e-9);
            assert!(hard(methods::PLAIN).lambda_error[2] > 1e-9);
        }
    }
}
