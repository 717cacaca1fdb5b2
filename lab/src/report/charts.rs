//! Chooses which charts the report has, and which points each chart has.

use cpu::internals::InstructionSet;

use super::chart::{Axis, Bounds, Chart, Point, Series};
use super::style::{number, seconds, short, time};
use crate::bench::results::{Results, Timing};
use crate::format::{Words, hint::Language};
use measure::statistics::Median;

const TIME: Words = ["user time of a picture", "tiempo de usuario de una imagen"];
const ERROR: Words = ["RMSE in linear light (white is 1)", "RMSE en luz lineal (el blanco es 1)"];
const SAMPLES: Words = ["samples a pixel", "muestras por píxel"];
/// Formats of the numbers at ticks in English and in Spanish, indexed by [`Language`].
type Format = [fn(f64) -> String; 2];
const NUMBER: Format = [short, |value| number(value, Language::Spanish)];
const DURATION: Format = [seconds, |value| time(value, Language::Spanish)];
/// The vertical axis of a chart of dots, whose rows have names instead of numbers.
const ROWS: Axis = Axis { label: "", format: short };

/// Returns every chart for which there are data, in the order of the report.
pub fn all(results: &Results, language: Language) -> Vec<Chart> {
    let scale = crate::bench::matrix::PARAMETERS.iter().filter_map(|parameter| scale(results, language, parameter));
    let curves = results.curves.iter().map(|curve| curve.scene.as_str());
    scale
        .chain(error_by_samples(results, language))
        .chain(curves.filter_map(|scene| error_by_time(results, language, scene)))
        .chain(speed_ups(results, language))
        .collect()
}

/// Returns the chart of times against a parameter, or `None` if there are no data.
fn scale(results: &Results, language: Language, parameter: &str) -> Option<Chart> {
    let (label, title): (Words, Words) = match parameter {
        "width" => (
            ["width of the picture in pixels (height follows)", "anchura de la imagen en píxeles (la altura la sigue)"],
            ["Time against the picture's width", "Tiempo frente a la anchura de la imagen"],
        ),
        "samples" => (SAMPLES, ["Time against samples", "Tiempo frente a las muestras"]),
        "depth" => (
            ["maximum depth", "profundidad máxima"],
            ["Time against the maximum depth", "Tiempo frente a la profundidad máxima"],
        ),
        "density" => (
            ["objects in the same view", "objetos en la misma vista"],
            ["Time against the number of objects in one view", "Tiempo frente al número de objetos en una vista"],
        ),
        _ => (
            ["objects in the scene", "objetos de la escena"],
            ["Time against the number of objects", "Tiempo frente al número de objetos"],
        ),
    };
    let mut series: Vec<Series> = Vec::new();
    for timing in results.timings.iter().filter(|t| t.setting.suite == "scale" && t.setting.parameter == parameter) {
        let (engine, Median { median, low, high, .. }) = (&timing.setting.engine, timing.median);
        // With a single measurement both bounds are equal, so no bar is drawn.
        let bounds = (low < high).then_some(Bounds::Vertical(low, high));
        push(&mut series, engine, color(engine), Point { x: timing.setting.value as f64, y: median, bounds });
    }
    order(&mut series);
    let [x, y] = [(label, NUMBER), (TIME, DURATION)].map(|axis| of(language, axis));
    let name = format!("scale-{parameter}");
    chart(Chart { name, title: language.pick(title).to_owned(), x, y, series, rows: Vec::new() })
}

/// Returns the chart of errors against samples, with a line for each scene and a line of slope -1/2, the law of
/// independent samples. Returns `None` if there are no data.
fn error_by_samples(results: &Results, language: Language) -> Option<Chart> {
    let mut series: Vec<Series> = Vec::new();
    for (index, curve) in results.curves.iter().enumerate() {
        for point in &curve.points {
            let error = point.linear;
            let bounds = Some(Bounds::Vertical(error.low, error.high));
            push(&mut series, &curve.scene, index + 1, Point { x: point.samples as f64, y: error.median, bounds });
        }
    }
    let first = series.first()?.points.clone();
    let (start, end) = (*first.first()?, *first.last()?);
    let guide = [start.x, end.x].map(|x| Point { x, y: 0.6 * start.y * (x / start.x).powf(-0.5), bounds: None });
    let name = language.pick(["slope -1/2", "pendiente -1/2"]).to_owned();
    series.push(Series { name, color: 0, is_guide: true, points: guide.to_vec() });
    let [x, y] = [SAMPLES, ERROR].map(|label| of(language, (label, NUMBER)));
    let title = language.pick(["Error against samples", "Error frente a las muestras"]).to_owned();
    chart(Chart { name: "error-samples".to_owned(), title, x, y, series, rows: Vec::new() })
}

/// Returns the chart of errors against times for a scene, or `None` if there are no data. It shows arrays of structures
/// with every instruction set, but structures of arrays only with the best one.
fn error_by_time(results: &Results, language: Language, scene: &str) -> Option<Chart> {
    let curve = results.curves.iter().find(|curve| curve.scene == scene)?;
    let mut series: Vec<Series> = Vec::new();
    for timing in error_timings(results, scene) {
        let engine = &timing.setting.engine;
        let is_shown = !engine.starts_with("soa") || engine.ends_with(&results.machines.first()?.instruction_set);
        let error = curve.points.iter().find(|point| point.samples == timing.setting.value);
        if let (true, Some(error)) = (is_shown, error) {
            let bounds = Some(Bounds::Vertical(error.linear.low, error.linear.high));
            push(&mut series, engine, color(engine), Point { x: timing.median.median, y: error.linear.median, bounds });
        }
    }
    order(&mut series);
    let title = ["Error against time, scene \u{201c}{}\u{201d}", "Error frente al tiempo, escena «{}»"];
    let (title, name) = (language.say(title, &[scene]), format!("error-time-{scene}"));
    let [x, y] = [(TIME, DURATION), (ERROR, NUMBER)].map(|axis| of(language, axis));
    chart(Chart { name, title, x, y, series, rows: Vec::new() })
}

/// Speed of each engine divided by that of the reference, at the largest number of samples for which the
/// reference was measured.
fn speed_ups(results: &Results, language: Language) -> Option<Chart> {
    // The slowest instruction set comes first. The two layouts of each instruction set have neighbouring rows.
    let sets = InstructionSet::ALL.map(InstructionSet::name);
    let engines = sets.iter().flat_map(|set| ["aos", "soa"].map(|layout| format!("{layout}-{set}")));
    let is_there = |engine: &String| results.timings.iter().any(|timing| timing.setting.engine == *engine);
    let rows: Vec<String> = engines.filter(is_there).collect();
    let mut series: Vec<Series> = Vec::new();
    for (index, curve) in results.curves.iter().enumerate() {
        let timings: Vec<_> = error_timings(results, &curve.scene).collect();
        let Some(slow) = timings.iter().rfind(|timing| timing.setting.engine == "reference") else { continue };
        let same = timings.iter().filter(|timing| timing.setting.value == slow.setting.value);
        for timing in same {
            let Some(row) = rows.iter().position(|row| *row == timing.setting.engine) else { continue };
            let ratio = |seconds: f64| slow.median.median / seconds;
            let bounds = Some(Bounds::Horizontal(ratio(timing.median.high), ratio(timing.median.low)));
            let point = Point { x: ratio(timing.median.median), y: row as f64 + 1.0, bounds };
            push(&mut series, &curve.scene, index + 1, point);
        }
    }
    let x = of(language, (["times as fast as the reference", "veces más rápido que la referencia"], NUMBER));
    let title = ["Implementations against the reference", "Las implementaciones frente a la referencia"];
    let title = language.pick(title).to_owned();
    chart(Chart { name: "speed-up".to_owned(), title, x, y: ROWS, series, rows })
}

/// Returns the times of a scene in the suite `error`, ordered by the number of samples.
fn error_timings<'a>(results: &'a Results, scene: &'a str) -> impl DoubleEndedIterator<Item = &'a Timing> {
    results.timings.iter().filter(move |timing| timing.setting.suite == "error" && timing.setting.scene == scene)
}

/// Returns the axis with this label and format.
fn of(language: Language, (label, format): (Words, Format)) -> Axis {
    Axis { label: language.pick(label), format: format[language as usize] }
}

fn push(series: &mut Vec<Series>, name: &str, color: usize, point: Point) {
    match series.iter_mut().find(|series| series.name == name) {
        Some(series) => series.points.push(point),
        None => series.push(Series { name: name.to_owned(), color, is_guide: false, points: vec![point] }),
    }
}

/// Returns the colour index of an implementation, which is the same in all charts.
fn color(engine: &str) -> usize {
    match engine.split_once('-') {
        None => 0,
        Some(("aos", "portable")) => 4,
        Some(("aos", "avx2")) => 3,
        Some(("aos", _)) => 1,
        Some(_) => 2,
    }
}

/// Sorts the series: the reference first, then by the larger coordinate of the last point, the largest first.
fn order(series: &mut [Series]) {
    let last = |series: &Series| series.points.last().map_or(0.0, |point| point.y.max(point.x));
    series.sort_by(|a, b| a.color.min(1).cmp(&b.color.min(1)).then(last(b).total_cmp(&last(a))));
}

fn chart(chart: Chart) -> Option<Chart> {
    chart.series.iter().any(|series| !series.is_guide && !series.points.is_empty()).then_some(chart)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bench::results::tests::{results, timing};

    #[test]
    fn spanish_axes_have_decimal_commas() {
        let results = results(vec![timing("aos-avx2", 1, &[1.0]), timing("aos-avx2", 4, &[2.0])]);
        let texts = [Language::English, Language::Spanish].map(|language| {
            let charts = all(&results, language);
            (charts[0].x.format)(0.5) + " and " + &(charts[0].y.format)(0.0125)
        });
        assert_eq!(texts, ["0.5 and 12.5 ms", "0,5 and 12,5 ms"]);
    }
}
