//! Writes the HTML page: sentences, charts and tables in one file that needs no other file.

use std::collections::BTreeSet;

use minijinja::context;

use super::chart::Chart;
use super::findings::{self, Findings};
use super::style::{self, engine_meaning, for_screen, joined, localized, number, time, variables, with_error};
use crate::bench::machine::Machine;
use crate::bench::results::Results;
use crate::format::{Words, hint::Language};
use crate::template::{escape, filled};

const SCENE: Words = ["scene", "escena"];
const IMPLEMENTATION: Words = ["implementation", "implementación"];
const VERSION: Words = ["on {} with the program of commit {}", "el {} con el programa del commit {}"];
const PDF: Words = [
    "The report that explains these measurements is {}. The command docs/build-report builds it.",
    "El informe que explica estas medidas es {}. Lo construye la orden docs/build-report --language es.",
];
const PROCESSORS: Words = ["{} ({} processors)", "{} ({} procesadores)"];

/// Returns an HTML page that needs no other file. Its colours follow the light or dark setting of the reader.
///
/// # Errors
/// The error of [`filled`].
pub fn document(language: Language, title: &str, body: &str) -> Result<String, String> {
    let values = context! {
        language => language.pick(["en", "es"]),
        title,
        light => variables(false),
        dark => variables(true),
        style => include_str!("../../templates/page.css").replace('\n', ""),
        body,
    };
    Ok(filled(include_str!("../../templates/page.html"), values)? + "\n")
}

/// Returns the HTML page about `results`. Each chart is given with its SVG text, and each scene with its name and the
/// `data:` address of its picture. If there is the address `pdf` of a report about the results, the page begins with a
/// link to it.
///
/// # Errors
/// The error of [`filled`].
pub fn page(
    results: &Results,
    language: Language,
    findings: &Findings,
    charts: &[(&Chart, String)],
    scenes: Vec<(String, String)>,
    pdf: Option<&str>,
) -> Result<String, String> {
    let pdf = pdf.map_or_else(String::new, |address| {
        let name = address.rsplit('/').next().unwrap_or(address);
        let link = format!("<a href=\"{}\">{}</a>", escape(address), escape(name));
        format!("<p>{}</p>\n", language.say(PDF, &[&link]))
    });
    let run = |machine: &Machine| language.say(VERSION, &[&machine.date, &machine.commit]);
    let mut runs: Vec<_> = results.machines.iter().map(run).collect();
    runs.dedup();
    let measured = joined(runs.into_iter(), ", ")
        .map_or_else(String::new, |runs| paragraph(&language.say(["Measured {}.", "Medido {}."], &[&runs])));
    let sentences = findings::conclusions(results, language);
    let conclusions: String = sentences.iter().map(|sentence| paragraph(sentence)).collect();
    let entries =
        findings.sentences.iter().map(|it| format!("<dt>{}</dt><dd>{}</dd>\n", escape(it.topic), escape(&it.text)));
    let figures = charts.iter().map(|(chart, svg)| {
        let caption = escape(caption(chart, language));
        format!("<figure>{}<figcaption>{caption}</figcaption></figure>\n", for_screen(svg))
    });
    let scenes = if scenes.is_empty() {
        String::new()
    } else {
        heading(language.pick(["Scenes", "Escenas"])) + &pictures(language.pick(["The scene ", "La escena "]), scenes)
    };
    let body = [
        if conclusions.is_empty() {
            conclusions
        } else {
            heading(language.pick(["In short", "En resumen"])) + &conclusions
        },
        heading(language.pick(["What the data say", "Qué dicen los datos"])),
        format!("<dl>\n{}</dl>\n", entries.collect::<String>()),
        scenes,
        implementations(results, language),
        heading(language.pick(["Charts", "Gráficas"])),
        figures.collect(),
        layouts(findings, language),
        growth(results, language),
        times_to_error(results, language),
        omitted(results, language),
        machines(results, language),
    ]
    .concat();
    let title = language.pick(["Measurements of the renderer", "Medidas del renderizador"]);
    document(language, title, &(pdf + &measured + &contents(language, &body) + &body))
}

/// Returns a heading of the page. It has an `id` made from its words, so that `contents` can link to it.
pub fn heading(words: &str) -> String {
    let anchor = words.replace(|letter: char| !letter.is_ascii_alphanumeric(), "-").to_ascii_lowercase();
    format!("<h2 id=\"{anchor}\">{}</h2>\n", escape(words))
}

/// Returns a table of contents, which links to the headings of `body`.
fn contents(language: Language, body: &str) -> String {
    let entries = body.split("<h2 id=\"").skip(1).filter_map(|piece| {
        let (id, words) = piece.split_once("</h2>")?.0.split_once("\">")?;
        Some(format!("<li><a href=\"#{id}\">{words}</a></li>\n"))
    });
    let label = language.pick(["Contents", "Contenido"]);
    format!("<nav aria-label=\"{label}\"><ol>\n{}</ol></nav>\n", entries.collect::<String>())
}

/// Returns a row of pictures, each with its caption and its `data:` address. The text for readers who do not see a
/// picture is `what` and the caption.
pub fn pictures(what: &str, pictures: impl IntoIterator<Item = (String, String)>) -> String {
    let figures = pictures.into_iter().map(|(caption, address)| {
        let caption = escape(&caption);
        let image = format!("<img src=\"{address}\" alt=\"{what}{caption}\">");
        format!("<figure>{image}<figcaption>{caption}</figcaption></figure>\n")
    });
    format!("<div class=\"scenes\">\n{}</div>\n", figures.collect::<String>())
}

/// Returns a paragraph.
pub fn paragraph(text: &str) -> String {
    format!("<p>{}</p>\n", escape(text))
}

/// Returns a table that explains the names of the implementations.
fn implementations(results: &Results, language: Language) -> String {
    let engines: BTreeSet<_> = results.timings.iter().map(|timing| timing.setting.engine.as_str()).collect();
    let rows = engines.into_iter().map(|engine| vec![engine.to_owned(), engine_meaning(engine, language)]);
    let head = [["name", "nombre"], ["what it is", "qué es"]].map(|words| language.pick(words));
    table(language.pick(["Implementations", "Implementaciones"]), &head, rows)
}

/// Returns the caption below a chart, which says how to read the chart.
fn caption(chart: &Chart, language: Language) -> &'static str {
    let what: Words = match chart.name.split('-').next().unwrap_or_default() {
        "scale" => [
            "Medians of user time; bars are the bounds of a median. Both axes are logarithmic: a straight line is a power.",
            "Medianas del tiempo de usuario; las barras son las cotas de una mediana. Los dos ejes son logarítmicos: una \
             recta es una potencia.",
        ],
        "error" => [
            "Each point is a number of samples; bars are the bounds of a median. Lower and further left is better.",
            "Cada punto es un número de muestras; las barras son las cotas de una mediana. Más abajo y más a la izquierda \
             es mejor.",
        ],
        "speed" => [
            "Further right is faster; bars are what the bounds of both medians allow.",
            "Más a la derecha es más rápido; las barras son lo que permiten las cotas de las dos medianas.",
        ],
        _ => ["", ""],
    };
    language.pick(what)
}

fn layouts(findings: &Findings, language: Language) -> String {
    let rows = findings.layouts.iter().map(|row| {
        let ratio = |value: f64| localized(format!("{value:.2}"), language);
        let bounds = format!("{} – {}", ratio(row.least), ratio(row.most));
        let counts = [row.pairs, row.slower, row.faster].map(|count| count.to_string());
        let [pairs, slower, faster] = counts;
        vec![row.set.clone(), row.scene.clone(), pairs, ratio(row.mean), bounds, slower, faster]
    });
    let head: [Words; 7] = [
        ["instruction set", "juego de instrucciones"],
        SCENE,
        ["pairs", "pares"],
        ["mean", "media"],
        ["least – most", "mín. – máx."],
        ["SoA slower", "SoA más lenta"],
        ["SoA faster", "SoA más rápida"],
    ];
    let title = ["Time of SoA by time of AoS", "Tiempo de SoA entre tiempo de AoS"];
    table(language.pick(title), &head.map(|words| language.pick(words)), rows)
}

fn growth(results: &Results, language: Language) -> String {
    let rows = results.growth.iter().filter(|growth| growth.parameter != "depth").map(|growth| {
        let (points, exponent) =
            (growth.law.points.to_string(), with_error(growth.law.exponent, growth.law.exponent_error, language));
        let parameter = style::parameter_name(&growth.parameter, language).to_owned();
        vec![growth.scene.clone(), parameter, growth.engine.clone(), points, exponent]
    });
    let head = [SCENE, ["parameter", "parámetro"], IMPLEMENTATION, ["points", "puntos"], ["exponent", "exponente"]];
    let title = language.pick(["Time as a power of a parameter", "El tiempo como potencia de un parámetro"]);
    table(title, &head.map(|words| language.pick(words)), rows)
}

fn times_to_error(results: &Results, language: Language) -> String {
    let rows = results.times_to_error.iter().map(|result| {
        let never = || language.pick(["not reached", "no se alcanza"]).to_owned();
        let reached = result.seconds.map_or_else(never, |seconds| time(seconds, language));
        vec![result.scene.clone(), result.engine.clone(), number(result.error, language), reached]
    });
    let head = [SCENE, IMPLEMENTATION, ["error", "error"], ["user time", "tiempo de usuario"]];
    let title = ["Time to an error (RMSE in linear light)", "Tiempo hasta un error (RMSE en luz lineal)"];
    table(language.pick(title), &head.map(|words| language.pick(words)), rows)
}

const TOO_LONG: Words = ["a picture would take about ", "una imagen tardaría unos "];

fn omitted(results: &Results, language: Language) -> String {
    let rows = results.omitted.iter().map(|omitted| {
        let setting = &omitted.setting;
        let value = style::setting(&setting.parameter, setting.value, language);
        // The data have the reason in English.
        let reason = match (language, omitted.reason.strip_prefix(TOO_LONG[0])) {
            (Language::Spanish, Some(time)) => TOO_LONG[1].to_owned() + &localized(time.to_owned(), language),
            _ => omitted.reason.clone(),
        };
        vec![setting.scene.clone(), value, setting.engine.clone(), reason]
    });
    let head = [SCENE, ["setting", "ajuste"], IMPLEMENTATION, ["because", "motivo"]];
    table(language.pick(["Left out", "Lo que falta"]), &head.map(|words| language.pick(words)), rows)
}

fn machines(results: &Results, language: Language) -> String {
    let rows = results.machines.iter().map(|m| {
        let processor = language.say(PROCESSORS, &[&m.processor, &m.processors.to_string()]);
        let compiler = format!("{}, {}", m.compiler, m.profile);
        vec![m.date.clone(), processor, m.instruction_set.clone(), m.system.clone(), compiler, m.commit.clone()]
    });
    let head: [Words; 6] = [
        ["date", "fecha"],
        ["processor", "procesador"],
        ["instruction set", "juego de instrucciones"],
        ["system", "sistema"],
        ["compiler", "compilador"],
        ["commit", "commit"],
    ];
    let title = language.pick(["Where it was measured", "Dónde se midió"]);
    table(title, &head.map(|words| language.pick(words)), rows)
}

/// The signs with which a cell of a table begins that has another colour, each with the class of the cell.
const SIGNS: [(char, &str); 2] = [('✓', "pass"), ('✗', "fail")];

/// Returns whether all cases are passed, with the number of passed ones and that of all, for a cell of a table.
pub fn verdict([passed, all]: [usize; 2], language: Language) -> String {
    let words: Words = match (passed, all) {
        (_, 0) => ["not checked", "sin comprobar"],
        _ if passed == all => ["✓ passed: {} of {}", "✓ correcto: {} de {}"],
        _ => ["✗ failed: {} of {} passed", "✗ con fallos: {} de {} correctos"],
    };
    language.say(words, &[&passed.to_string(), &all.to_string()])
}

/// Returns a table below a heading, or nothing if there are no rows. A cell may have several lines.
pub fn table(title: &str, head: &[&str], rows: impl Iterator<Item = Vec<String>>) -> String {
    let rows: Vec<_> = rows.collect();
    if rows.is_empty() {
        return String::new();
    }
    let is_number = |cell: &String| cell.starts_with(|first: char| first.is_ascii_digit() || first == '-');
    let line = |cells: &[&str], tag: &str| {
        let cells = cells.iter().enumerate().map(|(place, cell)| {
            // A column without numbers is aligned to the left. All other columns are aligned to the right.
            let has_numbers = rows.iter().any(|row| row.get(place).is_some_and(is_number));
            let sign = SIGNS.iter().find(|(sign, _)| cell.starts_with(*sign)).map(|(_, class)| *class);
            let classes: Vec<_> = sign.into_iter().chain((!has_numbers).then_some("t")).collect();
            let class = if classes.is_empty() { String::new() } else { format!(" class=\"{}\"", classes.join(" ")) };
            let lines: Vec<_> = cell.split('\n').map(escape).collect();
            format!("<{tag}{class}>{}</{tag}>", lines.join("<br>"))
        });
        format!("<tr>{}</tr>\n", cells.collect::<String>())
    };
    let head = if head.concat().is_empty() { String::new() } else { line(head, "th") };
    let body: String = rows.iter().map(|row| line(&row.iter().map(String::as_str).collect::<Vec<_>>(), "td")).collect();
    format!("{}<div class=\"wide\"><table>\n{head}{body}</table></div>\n", heading(title))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bench::results::TimeToError;

    #[test]
    fn a_verdict_is_a_word_and_a_colour() {
        let verdicts = [[3, 3], [2, 3], [0, 0]].map(|counts| verdict(counts, Language::English));
        assert_eq!(verdicts, ["✓ passed: 3 of 3", "✗ failed: 2 of 3 passed", "not checked"]);
        let table = table("t", &["", ""], verdicts.into_iter().map(|cell| vec!["1".to_owned(), cell]));
        for cell in ["<td class=\"pass t\">✓ passed", "<td class=\"fail t\">✗ failed", "<td class=\"t\">not"] {
            assert!(table.contains(cell), "{cell}: {table}");
        }
    }

    #[test]
    fn a_page_has_contents_that_lead_to_its_headings() {
        let [scene, engine] = ["grid", "reference"].map(str::to_owned);
        let times_to_error = vec![TimeToError { scene, engine, error: 0.05, seconds: None }];
        let machine = Machine { date: "2026-01-31".to_owned(), commit: "0123<\u{1b}".to_owned(), ..Machine::here() };
        let results = Results { times_to_error, machines: vec![machine], ..Results::default() };
        let found = Findings { sentences: Vec::new(), layouts: Vec::new() };
        let picture = ["grid", "data:image/png;base64,AAAA"].map(str::to_owned).into();
        let page = page(&results, Language::English, &found, &[], vec![picture], Some("../a&b.pdf"))
            .expect("the template is complete");
        for id in ["what-the-data-say", "scenes", "charts", "time-to-an-error--rmse-in-linear-light-"] {
            let both = [format!("<a href=\"#{id}\">"), format!("<h2 id=\"{id}\">")];
            assert!(both.iter().all(|text| page.contains(text)), "{id}: {page}");
        }
        assert!(page.contains("<img src=\"data:image/png;base64,AAAA\" alt=\"The scene grid\">"), "{page}");
        assert!(page.contains("<p>Measured on 2026-01-31 with the program of commit 0123&lt;\u{fffd}.</p>"), "{page}");
        assert!(
            page.contains("is <a href=\"../a&amp;b.pdf\">a&amp;b.pdf</a>. The command docs/build-report"),
            "{page}"
        );
        assert!(page.contains("<td class=\"t\">grid</td>") && page.contains("<td>0.05</td>"), "{page}");
    }
}
