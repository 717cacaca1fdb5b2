//! Adds the points of all teams, and gives the reason of each 0.

use measure::statistics::Median;

use super::file::{self, File, LEAST_REFERENCE, Weights};
use super::teams::Team;
use super::{Graded, Row};
use crate::bench::commands::Timed;
use crate::check::cases::Group;
use crate::format::Words;
use crate::format::hint::Language;

/// The groups of cases that the points for messages and for pictures depend on.
pub const GROUPS: [&[Group]; 2] =
    [&[Group::Arguments, Group::Messages, Group::Inputs], &[Group::Pictures, Group::Course]];

/// The names of the parts of the points.
pub const PARTS: [Words; 4] =
    [["messages", "mensajes"], ["pictures", "imágenes"], ["time", "tiempo"], ["energy", "energía"]];

const GATE: Words = [
    "{}: 0, because the points for messages or pictures are too few",
    "{}: 0, por pocos puntos de mensajes o imágenes",
];
const TINY: Words = [
    "the scene is too small to be timed: {} s; [[scene]] in grade.toml names another one",
    "la escena es demasiado pequeña para medirla: {} s; [[scene]] en grade.toml indica otra",
];
const SLOW: Words = ["{} s, and {} s have no points", "{} s, y {} s no tienen puntos"];

impl Graded {
    /// Returns the points of 10 for a list of groups, or `None` if there is no case.
    fn share(&self, groups: &[Group]) -> Option<f64> {
        let cases = || self.report.iter().flat_map(|report| &report.cases).filter(|case| groups.contains(&case.group));
        let all: f64 = cases().map(|case| case.weight).sum();
        (all > 0.0).then(|| 10.0 * cases().map(|case| case.weight * case.credit).sum::<f64>() / all)
    }

    /// Returns the number of passed cases of the groups, and the number of all.
    pub fn passed(&self, groups: &[Group]) -> [usize; 2] {
        let counts = self.report.iter().flat_map(|report| groups.iter().map(|group| report.passed(*group)));
        counts.fold([0, 0], |sum, counts| [sum[0] + counts[0], sum[1] + counts[1]])
    }
}

/// Returns a figure of what a program took, if it is known.
type Figure = fn(&Timed) -> Option<f64>;

/// A figure of one scene: its values with 5 points and with none, or why it does not count.
type Scale = Result<[f64; 2], String>;

/// Returns the rows of all teams.
pub fn rows(teams: &[Team], checked: Vec<Vec<Graded>>, scenes: &[String], file: &File, language: Language) -> Vec<Row> {
    let time: Figure = |timed| Some(timed.median.median);
    let energy: Figure = |timed| Some(timed.joules?.median);
    let scales = |figure: Figure, given: fn(&file::Timed) -> [Option<f64>; 2]| {
        let given = move |scene| file.scene.get(scene).map_or([None; 2], given);
        (0..scenes.len()).map(|scene| scale(&checked, scene, figure, given(scene))).collect::<Vec<_>>()
    };
    // If no program has made the right picture, all have no points, whatever the scale is.
    let times = scales(time, |given| [given.reference, given.zero]).into_iter().map(|it| it.unwrap_or([1.0, 4.0]));
    let times: Vec<Scale> = times
        .map(|scale| {
            let is_tiny = scale[0] < LEAST_REFERENCE;
            if is_tiny { Err(language.say(TINY, &[&format!("{:.3}", scale[0])])) } else { Ok(scale) }
        })
        .collect();
    let energies = scales(energy, |given| [given.joules, given.joules_zero]);
    let energies: Vec<Scale> = energies.into_iter().map(|scale| scale.ok_or_else(String::new)).collect();
    let Weights { messages, pictures, time: time_weight, energy: energy_weight } = file.points;
    let weights = [messages, pictures, time_weight, energy_weight];
    let row = |(team, programs): (&Team, Vec<Graded>)| {
        let mut row = Row {
            team: team.name.clone(),
            folder: team.folder.clone(),
            programs,
            points: [None; 4],
            total: None,
            problems: Vec::new(),
        };
        row.problems.extend(team.missing.clone());
        let several = row.programs.len() > 1;
        let label = |graded: &Graded| if several { format!("{}: ", graded.program) } else { String::new() };
        for (part, groups) in GROUPS.iter().enumerate() {
            row.points[part] = mean(row.programs.iter().map(|graded| graded.share(groups)));
            let without = row.programs.iter().filter(|graded| graded.share(groups) == Some(0.0));
            let reason = |graded: &Graded| {
                let main = graded.report.as_ref()?.main_fault(groups, language)?;
                Some(format!("{}{}: {main}", label(graded), language.pick(PARTS[part])))
            };
            row.problems.extend(without.filter_map(reason));
        }
        for (part, scales, figure) in [(2, &times, time), (3, &energies, energy)] {
            let points = row.programs.iter().map(|graded| scored(graded, scales, figure));
            row.points[part] = mean(points);
        }
        for graded in &row.programs {
            let label = label(graded);
            row.problems.extend(graded.not_graded.iter().map(|reason| format!("{label}{reason}")));
            for ((scene, result), scale) in scenes.iter().zip(&graded.times).zip(&times) {
                let reason = match (result, scale) {
                    (Err(reason), _) | (Ok(_), Err(reason)) => Some(reason.clone()),
                    (Ok(timed), Ok([_, zero])) if timed.median.median >= *zero => {
                        Some(language.say(SLOW, &[&format!("{:.3}", timed.median.median), &format!("{zero:.3}")]))
                    }
                    _ => None,
                };
                row.problems.extend(reason.map(|reason| format!("{label}{scene}: {reason}")));
            }
        }
        let gates = [file.gates.messages, file.gates.pictures];
        if row.points.iter().zip(gates).any(|(points, gate)| points.is_some_and(|points| points < gate)) {
            for part in [2, 3] {
                if row.points[part].is_some() {
                    row.points[part] = Some(0.0);
                    row.problems.push(language.say(GATE, &[language.pick(PARTS[part])]));
                }
            }
        }
        let is_graded = !row.programs.is_empty() && row.programs.iter().all(|graded| graded.report.is_some());
        let parts = || row.points.iter().zip(weights).filter_map(|(points, weight)| Some(((*points)?, weight)));
        let all: f64 = parts().map(|(_, weight)| weight).sum();
        let sum: f64 = parts().map(|(points, weight)| points * weight).sum();
        let mut total = if all > 0.0 { sum / all } else { 0.0 };
        for penalty in file.penalty.iter().filter(|penalty| penalty.team == row.team) {
            total -= penalty.points;
            row.problems.push(format!("-{}: {}", penalty.points, crate::terminal::foreign(penalty.reason.as_bytes())));
        }
        row.total = is_graded.then(|| total.clamp(0.0, 10.0));
        row
    };
    teams.iter().zip(checked).map(row).collect()
}

/// Returns the mean of the known values, or `None` if none is known.
fn mean(values: impl Iterator<Item = Option<f64>>) -> Option<f64> {
    let known: Vec<_> = values.flatten().collect();
    (!known.is_empty()).then(|| known.iter().sum::<f64>() / known.len() as f64)
}

/// Returns the values of a figure of a scene with 5 points and with none, those that are given or else those of all
/// programs, or `None` if no program has the figure.
fn scale(
    checked: &[Vec<Graded>],
    scene: usize,
    figure: Figure,
    [reference, zero]: [Option<f64>; 2],
) -> Option<[f64; 2]> {
    let known = checked.iter().flatten().filter_map(|graded| figure(graded.times.get(scene)?.as_ref().ok()?));
    let known: Vec<f64> = known.collect();
    let all = (!known.is_empty()).then(|| Median::of(&known).median)?;
    let reference = reference.unwrap_or(all);
    Some([reference, zero.unwrap_or(4.0 * reference)])
}

/// Returns the mean points of a program for a figure of all scenes that count, or `None` if none of them does.
fn scored(graded: &Graded, scales: &[Scale], figure: Figure) -> Option<f64> {
    let known = graded.times.iter().zip(scales).filter_map(|(timed, scale)| Some((timed, scale.as_ref().ok()?)));
    let points = |(timed, [reference, zero]): (&Result<Timed, String>, &[f64; 2])| {
        Some(timed.as_ref().ok().and_then(figure).map_or(0.0, |value| scaled(value, *reference, *zero)))
    };
    mean(known.map(points))
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
