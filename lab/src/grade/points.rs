//! The points of programs, from 0 to 10.

use measure::statistics::Median;

use super::file::{File, Weights};
use super::{GROUPS, Graded};
use crate::bench::commands::Timed;

/// Computes the points of all programs.
pub(super) fn add(programs: &mut [Graded], file: &File) {
    let given: Vec<_> = file.scene.iter().map(|scene| [scene.reference, scene.zero]).collect();
    let times = means(programs, &given, |timed| Some(timed.median.median)).unwrap_or(vec![0.0; programs.len()]);
    let energies = means(programs, &[], |timed| Some(timed.joules?.median));
    let Weights { messages, pictures, time, energy } = file.points;
    for (index, graded) in programs.iter_mut().enumerate() {
        let share = |[passed, all]: [usize; 2]| Some(10.0 * passed as f64 / all.max(1) as f64);
        let checks = GROUPS.map(|groups| share(graded.passed(groups)));
        graded.points = [checks[0], checks[1], Some(times[index]), energies.as_ref().map(|energies| energies[index])];
        let weights = [messages, pictures, time, energy];
        let parts = || graded.points.iter().zip(weights).filter_map(|(points, weight)| Some(((*points)?, weight)));
        let total: f64 = parts().map(|(_, weight)| weight).sum();
        graded.total = parts().map(|(points, weight)| points * weight).sum::<f64>() / total;
    }
}

/// Returns the mean points of each program for a figure of its scenes, or `None` if no program has the figure. `given`
/// has the figures of each scene with 5 points and with none, where they are given.
fn means(programs: &[Graded], given: &[[Option<f64>; 2]], figure: fn(&Timed) -> Option<f64>) -> Option<Vec<f64>> {
    let scenes = programs.first()?.times.len();
    let mut means = vec![0.0; programs.len()];
    let mut is_known = false;
    for scene in 0..scenes {
        let figures: Vec<_> = programs.iter().map(|graded| figure(graded.times[scene].as_ref()?)).collect();
        let known: Vec<f64> = figures.iter().copied().flatten().collect();
        if known.is_empty() {
            continue;
        }
        is_known = true;
        let [reference, zero] = given.get(scene).copied().unwrap_or_default();
        let reference = reference.unwrap_or_else(|| Median::of(&known).median);
        let zero = zero.unwrap_or(4.0 * reference);
        for (mean, figure) in means.iter_mut().zip(figures) {
            *mean += figure.map_or(0.0, |figure| scaled(figure, reference, zero)) / scenes as f64;
        }
    }
    is_known.then_some(means)
}

/// Returns the points of a time or an energy: 5 for the reference, 0 for `zero`, and equally many more each time that
/// it is divided by the same factor. At most 10.
fn scaled(value: f64, reference: f64, zero: f64) -> f64 {
    /// The clock of user time may count nothing for a tiny picture.
    const LEAST: f64 = 1e-6;
    match (value.max(LEAST), reference.max(LEAST)) {
        (value, _) if value >= zero => 0.0,
        (_, reference) if reference >= zero => 10.0,
        (value, reference) => (5.0 * (zero / value).ln() / (zero / reference).ln()).min(10.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_reference_has_half_the_points() {
        let points = [0.01, 0.25, 0.5, 1.0, 2.0, 4.0, 9.0].map(|value| scaled(value, 1.0, 4.0));
        assert_eq!(points, [10.0, 10.0, 7.5, 5.0, 2.5, 0.0, 0.0]);
        assert_eq!([scaled(0.0, 0.0, 1.0), scaled(1.0, 3.0, 2.0), scaled(0.0, 0.0, 0.0)], [5.0, 10.0, 0.0]);
    }
}
