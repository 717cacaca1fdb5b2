//! Shows the grades: as a table, as CSV, and as one HTML page.

use std::path::Path;

use crate::bench::commands::Timed;
use crate::format::Words;
use crate::format::hint::Language;
use crate::report::chart::{Axis, Bounds, Chart, Point, Series};
use crate::report::html;
use crate::report::style::{for_screen, seconds, short};

use super::{GROUPS, Graded, Grades};

const COLUMNS: [Words; 8] = [
    ["program", "programa"],
    ["points of 10", "puntos sobre 10"],
    ["for messages", "por mensajes"],
    ["for pictures", "por imágenes"],
    ["for time", "por tiempo"],
    ["for energy", "por energía"],
    ["messages", "mensajes"],
    ["pictures", "imágenes"],
];
const UNITS: [&str; 3] = ["s", "MB", "J"];
const TIME: Words = ["user time of a picture", "tiempo de usuario de una imagen"];
const MEMORY: Words = ["memory in MB", "memoria en MB"];

impl Grades {
    /// Returns the table of all figures. The first row has the names of the columns.
    pub fn rows(&self, language: Language) -> Vec<Vec<String>> {
        let figures = self.scenes.iter().flat_map(|scene| UNITS.map(|unit| format!("{scene}: {unit}")));
        let columns = COLUMNS.map(|words| language.say(words, &[])).into_iter();
        let head = columns.chain(figures).chain([language.say(["problem", "problema"], &[])]).collect();
        let measured =
            |figure: Option<f64>| figure.map_or_else(|| language.say(["no meter", "sin medidor"], &[]), short);
        let row = |graded: &Graded| {
            let points = graded.points.map(|points| measured(points.map(|points| (100.0 * points).round() / 100.0)));
            let passed = GROUPS.map(|groups| graded.passed(groups)).map(|[passed, all]| format!("{passed}/{all}"));
            let figures = graded.times.iter().flat_map(|timed| match timed {
                None => Default::default(),
                Some(timed) => {
                    let joules = timed.joules.map(|joules| joules.median);
                    [Some(timed.median.median), Some(timed.memory), joules].map(measured)
                }
            });
            let start = [graded.program.clone(), format!("{:.2}", graded.total)];
            start.into_iter().chain(points).chain(passed).chain(figures).chain([graded.problems.join("; ")]).collect()
        };
        std::iter::once(head).chain(self.programs.iter().map(row)).collect()
    }

    /// Returns a page with the table, charts of time and memory, and the failures of every program. `kept` has the
    /// files of the cases.
    ///
    /// # Errors
    /// A chart cannot be drawn.
    pub fn page(&self, language: Language, kept: &Path) -> Result<String, String> {
        let rows = self.rows(language);
        let head: Vec<_> = rows[0].iter().map(String::as_str).collect();
        let title = language.pick(["Points and measurements", "Puntos y medidas"]);
        let mut body = html::table(title, &head, rows[1..].iter().cloned());
        let charts = [
            self.chart(language.pick(TIME), seconds, |timed| {
                [timed.median.median, timed.median.low, timed.median.high]
            }),
            self.chart(language.pick(MEMORY), short, |timed| [timed.memory; 3]),
        ];
        for chart in charts.iter().filter(|chart| !chart.series.is_empty()) {
            body += &format!("<figure>{}</figure>\n", for_screen(&chart.draw()?));
        }
        for graded in &self.programs {
            if let Some(report) = &graded.report {
                body += &report.body(language, &format!("{}: ", graded.program), &kept.join(&graded.program));
            }
        }
        html::document(language, language.pick(["Grades", "Calificaciones"]), &body)
    }

    /// Returns a chart of dots with a row for each program that has the figure, and a series for each scene.
    fn chart(&self, label: &'static str, format: fn(f64) -> String, figure: fn(&Timed) -> [f64; 3]) -> Chart {
        let timed: Vec<_> = self.programs.iter().filter(|graded| graded.times.iter().any(Option::is_some)).collect();
        let point = |(row, [x, low, high]): (usize, [f64; 3])| Point {
            x,
            y: row as f64 + 1.0,
            bounds: (low < high).then_some(Bounds::Horizontal(low, high)),
        };
        let series = self.scenes.iter().enumerate().map(|(scene, name)| {
            let rows = timed.iter().enumerate();
            let figures = rows.filter_map(|(row, graded)| Some((row, figure(graded.times[scene].as_ref()?))));
            let is_shown = |(_, [x, ..]): &(usize, [f64; 3])| *x > 0.0;
            Series {
                name: name.clone(),
                color: scene + 1,
                is_guide: false,
                points: figures.filter(is_shown).map(point).collect(),
            }
        });
        Chart {
            name: String::new(),
            title: label.to_owned(),
            x: Axis { label, format },
            y: Axis { label: "", format: short },
            series: series.filter(|series| !series.points.is_empty()).collect(),
            rows: timed.iter().map(|graded| graded.program.clone()).collect(),
        }
    }
}
