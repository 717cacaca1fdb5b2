//! Shows the grades: as a table, as CSV, and as one HTML page.

use std::io::{self, Write};

use crate::bench::commands::Timed;
use crate::format::Words;
use crate::format::hint::Language;
use crate::report::chart::{Axis, Bounds, Chart, Point, Series};
use crate::report::html;
use crate::report::style::{for_screen, localized, seconds, short};
use crate::template::escape;
use crate::terminal;

use super::points::GROUPS;
use super::{Grades, Row};

const COLUMNS: [Words; 8] = [
    ["team", "equipo"],
    ["points of 10", "puntos sobre 10"],
    ["for messages", "por mensajes"],
    ["for pictures", "por imágenes"],
    ["for time", "por tiempo"],
    ["for energy", "por energía"],
    ["messages", "mensajes"],
    ["pictures", "imágenes"],
];
/// The first of the columns with the numbers of passed cases.
const PASSED: usize = COLUMNS.len() - GROUPS.len();
const UNITS: [&str; 3] = ["s", "MB", "J"];
const TIME: Words = ["user time of a picture", "tiempo de usuario de una imagen"];
const MEMORY: Words = ["memory in MB", "memoria en MB"];
const NOT_GRADED: Words = ["not graded", "sin calificar"];

impl Row {
    /// Returns the number of passed cases of all programs and that of all cases, for messages and pictures.
    fn passed(&self) -> [[usize; 2]; GROUPS.len()] {
        GROUPS.map(|groups| {
            let counts = self.programs.iter().map(|graded| graded.passed(groups));
            counts.fold([0, 0], |sum, counts| [sum[0] + counts[0], sum[1] + counts[1]])
        })
    }
}

impl Grades {
    /// Returns the table of all figures. The first row has the names of the columns.
    pub fn rows(&self, language: Language) -> Vec<Vec<String>> {
        // Most teams have two programs, and so have their figures.
        let most = self.teams.iter().map(|row| row.programs.len()).max().unwrap_or(0);
        let figures = self.scenes.iter().flat_map(|scene| {
            (0..most).flat_map(move |number| {
                let program = if most > 1 { format!(" {}", number + 1) } else { String::new() };
                UNITS.map(|unit| format!("{scene}{program}: {unit}"))
            })
        });
        let columns = COLUMNS.map(|words| language.say(words, &[])).into_iter();
        let head = columns.chain(figures).chain([language.say(["problem", "problema"], &[])]).collect();
        let row = |row: &Row| {
            let missing = if row.total.is_some() { ["no meter", "sin medidor"] } else { NOT_GRADED };
            let rounded = |points: Option<f64>, missing: Words| {
                points.map_or_else(|| language.say(missing, &[]), |points| localized(format!("{points:.2}"), language))
            };
            let points = row.points.map(|points| rounded(points, missing));
            let passed = row.passed().map(|counts| {
                let [passed, all] = counts.map(|count| count.to_string());
                language.say(["{} of {}", "{} de {}"], &[&passed, &all])
            });
            let figures = (0..self.scenes.len()).flat_map(|scene| {
                (0..most).flat_map(move |number| {
                    let timed = row.programs.get(number).and_then(|graded| graded.times.get(scene)?.as_ref().ok());
                    let figures = timed.map(|timed| {
                        let joules = timed.joules.map(|joules| joules.median);
                        [Some(timed.median.median), Some(timed.memory), joules]
                    });
                    figures
                        .unwrap_or_default()
                        .map(|it| it.map_or_else(String::new, |it| localized(short(it), language)))
                })
            });
            let start = [row.team.clone(), rounded(row.total, NOT_GRADED)];
            start.into_iter().chain(points).chain(passed).chain(figures).chain([row.problems.join("; ")]).collect()
        };
        std::iter::once(head).chain(self.teams.iter().map(row)).collect()
    }

    /// Writes the table as the spreadsheet of a language reads it: in Spanish with semicolons, decimal commas, and the
    /// mark by which a spreadsheet knows UTF-8. No cell is a formula.
    ///
    /// # Errors
    /// An error of `out`.
    pub fn write_csv(&self, language: Language, out: &mut dyn Write) -> io::Result<()> {
        let is_spanish = language == Language::Spanish;
        if is_spanish {
            out.write_all("\u{feff}".as_bytes())?;
        }
        let mut writer = csv::WriterBuilder::new().delimiter(if is_spanish { b';' } else { b',' }).from_writer(out);
        for row in self.rows(language) {
            writer.write_record(row.iter().map(|cell| terminal::cell(cell)))?;
        }
        writer.flush()
    }

    /// Returns a page with the table and charts of time and memory. The names in the table lead to the pages of the
    /// teams, or without pages to the reports that follow.
    ///
    /// # Errors
    /// A chart cannot be drawn.
    pub fn page(&self, language: Language, has_pages: bool) -> Result<String, String> {
        let mut rows = self.rows(language);
        for (cells, row) in rows[1..].iter_mut().zip(&self.teams) {
            let verdicts = row.passed().map(|counts| html::verdict(counts, language));
            cells[PASSED..PASSED + verdicts.len()].clone_from_slice(&verdicts);
        }
        // A column without any figure, such as energy without a meter, leaves its room to the others.
        let is_told: Vec<_> = (0..rows[0].len()).map(|at| rows[1..].iter().any(|row| !row[at].is_empty())).collect();
        for row in &mut rows {
            let mut told = is_told.iter();
            row.retain(|_| told.next() == Some(&true));
        }
        let head: Vec<_> = rows[0].iter().map(String::as_str).collect();
        let title = language.pick(["Points and measurements", "Puntos y medidas"]);
        let mut body = html::table(title, &head, rows[1..].iter().cloned());
        for row in &self.teams {
            let name = escape(&row.team);
            let link = if has_pages { format!("{}/page.html", row.folder) } else { format!("#{}", row.folder) };
            // The first cell of a row has one of two forms, by the names of all teams.
            for class in ["", " class=\"t\""] {
                let cell = |text: &str| format!("<tr><td{class}>{text}</td>");
                body = body.replacen(&cell(&name), &cell(&format!("<a href=\"{link}\">{name}</a>")), 1);
            }
        }
        let charts = [
            self.chart(language.pick(TIME), seconds, |timed| {
                [timed.median.median, timed.median.low, timed.median.high]
            }),
            self.chart(language.pick(MEMORY), short, |timed| [timed.memory; 3]),
        ];
        for chart in charts.iter().filter(|chart| !chart.series.is_empty()) {
            body += &format!("<figure>{}</figure>\n", for_screen(&chart.draw()?));
        }
        for row in self.teams.iter().filter(|_| !has_pages) {
            body += &format!("<section id=\"{}\">\n{}</section>\n", row.folder, row.body(language));
        }
        html::document(language, language.pick(["Grades", "Calificaciones"]), &body)
    }

    /// Returns a chart of dots with a row for each program that has the figure, and a series for each scene.
    fn chart(&self, label: &'static str, format: fn(f64) -> String, figure: fn(&Timed) -> [f64; 3]) -> Chart {
        let programs = self.teams.iter().flat_map(|row| row.programs.iter().map(move |graded| (row, graded)));
        let timed: Vec<_> = programs.filter(|(_, graded)| graded.times.iter().any(Result::is_ok)).collect();
        let point = |(row, [x, low, high]): (usize, [f64; 3])| Point {
            x,
            y: row as f64 + 1.0,
            bounds: (low < high).then_some(Bounds::Horizontal(low, high)),
        };
        let series = self.scenes.iter().enumerate().map(|(scene, name)| {
            let rows = timed.iter().enumerate();
            let figures =
                rows.filter_map(|(row, (_, graded))| Some((row, figure(graded.times.get(scene)?.as_ref().ok()?))));
            let is_shown = |(_, [x, ..]): &(usize, [f64; 3])| *x > 0.0;
            Series {
                name: name.clone(),
                color: scene + 1,
                is_guide: false,
                points: figures.filter(is_shown).map(point).collect(),
            }
        });
        let named = |(row, graded): &(&Row, &super::Graded)| {
            if row.team == graded.program { row.team.clone() } else { format!("{} {}", row.team, graded.program) }
        };
        Chart {
            name: String::new(),
            title: label.to_owned(),
            x: Axis { label, format },
            y: Axis { label: "", format: short },
            series: series.filter(|series| !series.points.is_empty()).collect(),
            rows: timed.iter().map(named).collect(),
        }
    }
}
