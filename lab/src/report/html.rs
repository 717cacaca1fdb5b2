//! Writes the HTML page: sentences, charts and tables in one file that needs no other file.

use std::fmt::Write;

use super::chart::Chart;
use super::findings::Finding;
use super::style::{self, engine_meaning, for_screen, printable, seconds, short, variables, with_error};
use super::thumbnails::Thumbnail;
use crate::bench::results::Results;
use crate::format::{Words, hint::Language};

const STYLE: &str = "\
body{font:16px/1.5 system-ui,sans-serif;margin:0 auto;max-width:52rem;padding:1rem;color:var(--ink);background:var(--paper)}\
h1{font-size:1.6rem;line-height:1.2}h2{font-size:1.2rem;margin-top:2.2rem}figure{margin:1.2rem 0;overflow-x:auto}\
svg{width:100%;min-width:27rem;max-width:46rem;height:auto;display:block}dt{font-weight:600;margin-top:.6rem}dd{margin:0}\
.wide{overflow-x:auto}table{border-collapse:collapse;font-variant-numeric:tabular-nums;font-size:.9rem}\
th,td{padding:.25rem .7rem .25rem 0;text-align:right;vertical-align:top;border-bottom:1px solid var(--grid);white-space:nowrap}\
th.t,td.t{text-align:left}td.t:last-child{white-space:normal}nav ol{columns:2;padding-left:1.4rem}a{color:inherit}\
figcaption{font-size:.9rem;max-width:46rem}.scenes{display:flex;flex-wrap:wrap;gap:1rem;margin-bottom:1rem}.scenes figure{margin:0}\
.scenes img{display:block;width:14rem;max-width:100%;height:auto}footer{margin-top:2rem;font-size:.9rem}";

const SCENE: Words = ["scene", "escena"];
const IMPLEMENTATION: Words = ["implementation", "implementación"];
const VERSION: Words = ["on {} with the program of commit {}", "el {} con el programa del commit {}"];
const PROCESSORS: Words = ["{} ({} processors)", "{} ({} procesadores)"];

/// Returns an HTML page that needs no other file. Its colours follow the light or dark setting of the reader.
pub fn document(language: Language, title: &str, body: &str) -> String {
    let (light, dark, title) = (variables(false), variables(true), escape(title));
    let lang = ["en", "es"][language as usize];
    format!(
        "<!doctype html>\n<html lang=\"{lang}\">\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n<title>{title}</title>\n<style>\n\
         :root{{color-scheme:light dark;--ink:#26262B;--paper:#FFFFFF;{light}}}\n\
         @media(prefers-color-scheme:dark){{:root{{--ink:#E6E6EA;--paper:#17171B;{dark}}}}}\n{STYLE}\n</style>\n\
         <h1>{title}</h1>\n{body}</html>\n"
    )
}

/// Returns the HTML page about `results`. Each chart is given with its SVG text.
pub fn page(
    results: &Results,
    language: Language,
    findings: &[Finding],
    charts: &[(&Chart, String)],
    pictures: &[Thumbnail],
) -> String {
    let mut page = String::new();
    versions(&mut page, results, language);
    let mut body = String::new();
    heading(&mut body, language.pick(["What they say", "Qué dicen"]));
    body.push_str("<dl>\n");
    for Finding { topic, text } in findings {
        put(&mut body, format_args!("<dt>{}</dt><dd>{}</dd>\n", escape(topic), escape(text)));
    }
    body.push_str("</dl>\n");
    scenes(&mut body, language, pictures);
    implementations(&mut body, results, language);
    heading(&mut body, language.pick(["Charts", "Gráficas"]));
    for (chart, svg) in charts {
        let caption = escape(&caption(chart, language));
        put(&mut body, format_args!("<figure>{}<figcaption>{caption}</figcaption></figure>\n", for_screen(svg)));
    }
    growth(&mut body, results, language);
    times_to_error(&mut body, results, language);
    omitted(&mut body, results, language);
    machines(&mut body, results, language);
    contents(&mut page, language, &body);
    page.push_str(&body);
    document(language, language.pick(["Measurements of the renderer", "Medidas del renderizador"]), &page)
}

/// Appends a heading with an anchor, to which the table of contents links.
pub fn heading(page: &mut String, words: &str) {
    put(page, format_args!("<h2 id=\"{}\">{}</h2>\n", anchor(words), escape(words)));
}

fn anchor(words: &str) -> String {
    let letters =
        words.chars().map(|letter| if letter.is_ascii_alphanumeric() { letter.to_ascii_lowercase() } else { '-' });
    letters.collect()
}

/// Appends a table of contents, which links to the headings of `body`.
fn contents(page: &mut String, language: Language, body: &str) {
    put(page, format_args!("<nav aria-label=\"{}\"><ol>\n", language.pick(["Contents", "Contenido"])));
    for piece in body.split("<h2 id=\"").skip(1) {
        let entry = piece.split_once("</h2>").and_then(|(heading, _)| heading.split_once("\">"));
        if let Some((id, words)) = entry {
            put(page, format_args!("<li><a href=\"#{id}\">{words}</a></li>\n"));
        }
    }
    page.push_str("</ol></nav>\n");
}

/// Adds the dates of the data and the versions of the program that was measured.
fn versions(page: &mut String, results: &Results, language: Language) {
    let mut runs: Vec<_> =
        results.machines.iter().map(|machine| language.say(VERSION, &[&machine.date, &machine.commit])).collect();
    runs.dedup();
    if !runs.is_empty() {
        paragraph(page, &language.say(["Measured {}.", "Medido {}."], &[&runs.join(", ")]));
    }
}

/// Appends small pictures of the scenes that were measured.
fn scenes(page: &mut String, language: Language, thumbnails: &[Thumbnail]) {
    if !thumbnails.is_empty() {
        heading(page, language.pick(["Scenes", "Escenas"]));
        let named = thumbnails.iter().map(|Thumbnail { scene, address }| (scene.clone(), address.clone()));
        pictures(page, language.pick(["The scene ", "La escena "]), named);
    }
}

/// Appends a row of pictures, each with its caption and its `data:` address. The text for readers who do not see a
/// picture is `what` and the caption.
pub fn pictures(page: &mut String, what: &str, pictures: impl Iterator<Item = (String, String)>) {
    page.push_str("<div class=\"scenes\">\n");
    for (caption, address) in pictures {
        let caption = escape(&caption);
        let image = format!("<img src=\"{address}\" alt=\"{what}{caption}\">");
        put(page, format_args!("<figure>{image}<figcaption>{caption}</figcaption></figure>\n"));
    }
    page.push_str("</div>\n");
}

/// Appends a paragraph.
pub fn paragraph(page: &mut String, text: &str) {
    put(page, format_args!("<p>{}</p>\n", escape(text)));
}

/// Appends a table that explains the names of the implementations.
fn implementations(page: &mut String, results: &Results, language: Language) {
    let timed = results.timings.iter().map(|timing| timing.setting.engine.as_str());
    let engines: std::collections::BTreeSet<_> = timed.collect();
    let rows = engines.into_iter().map(|engine| vec![engine.to_owned(), engine_meaning(engine, language)]);
    let head = [["name", "nombre"], ["what it is", "qué es"]].map(|words| language.pick(words));
    table(page, language.pick(["Implementations", "Implementaciones"]), &head, rows);
}

/// Returns the text of the caption below a chart.
fn caption(chart: &Chart, language: Language) -> String {
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
    format!("{}. {}", chart.title, language.pick(what))
}

fn growth(page: &mut String, results: &Results, language: Language) {
    let rows = results.growth.iter().filter(|growth| growth.parameter != "depth").map(|growth| {
        let (points, exponent) =
            (growth.law.points.to_string(), with_error(growth.law.exponent, growth.law.exponent_error));
        let parameter = style::parameter_name(&growth.parameter, language).to_owned();
        vec![growth.scene.clone(), parameter, growth.engine.clone(), points, exponent]
    });
    let head = [SCENE, ["parameter", "parámetro"], IMPLEMENTATION, ["points", "puntos"], ["exponent", "exponente"]];
    let title = language.pick(["Time as a power of a parameter", "El tiempo como potencia de un parámetro"]);
    table(page, title, &head.map(|words| language.pick(words)), rows);
}

fn times_to_error(page: &mut String, results: &Results, language: Language) {
    let rows = results.times_to_error.iter().map(|time| {
        let reached = time.seconds.map_or_else(|| language.pick(["not reached", "no se alcanza"]).to_owned(), seconds);
        vec![time.scene.clone(), time.engine.clone(), short(time.error), reached]
    });
    let head = [SCENE, IMPLEMENTATION, ["error", "error"], ["user time", "tiempo de usuario"]];
    let title = ["Time to an error (RMSE in linear light)", "Tiempo hasta un error (RMSE en luz lineal)"];
    table(page, language.pick(title), &head.map(|words| language.pick(words)), rows);
}

fn omitted(page: &mut String, results: &Results, language: Language) {
    let rows = results.omitted.iter().map(|omitted| {
        let setting = &omitted.setting;
        let value = style::setting(&setting.parameter, setting.value, language);
        vec![setting.scene.clone(), value, setting.engine.clone(), omitted.reason.clone()]
    });
    let head = [SCENE, ["setting", "ajuste"], IMPLEMENTATION, ["because", "motivo"]];
    table(page, language.pick(["Left out", "Lo que falta"]), &head.map(|words| language.pick(words)), rows);
}

fn machines(page: &mut String, results: &Results, language: Language) {
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
    table(page, title, &head.map(|words| language.pick(words)), rows);
}

/// Appends a table below a heading. A cell may have several lines. Appends nothing if there are no rows.
pub fn table(page: &mut String, title: &str, head: &[&str], rows: impl Iterator<Item = Vec<String>>) {
    let rows: Vec<_> = rows.collect();
    let is_number = |cell: &String| cell.starts_with(|first: char| first.is_ascii_digit() || first == '-');
    let is_words = |place: usize| !rows.iter().any(|row| row.get(place).is_some_and(is_number));
    let line = |cells: &mut dyn Iterator<Item = &str>, tag: &str| -> String {
        // A column without numbers is aligned to the left. All other columns are aligned to the right.
        let class = |place: usize| if is_words(place) { " class=\"t\"" } else { "" };
        let lines = |cell: &str| cell.split('\n').map(escape).collect::<Vec<_>>().join("<br>");
        let cells = cells.enumerate().map(|(place, cell)| format!("<{tag}{}>{}</{tag}>", class(place), lines(cell)));
        format!("<tr>{}</tr>\n", cells.collect::<String>())
    };
    let body: String = rows.iter().map(|row| line(&mut row.iter().map(String::as_str), "td")).collect();
    if !body.is_empty() {
        let head = if head.concat().is_empty() { String::new() } else { line(&mut head.iter().copied(), "th") };
        heading(page, title);
        put(page, format_args!("<div class=\"wide\"><table>\n{head}{body}</table></div>\n"));
    }
}

fn put(page: &mut String, text: std::fmt::Arguments<'_>) {
    // Writing to a `String` never fails.
    let _ = page.write_fmt(text);
}

/// Returns `text` for an HTML page, without control characters and with the characters of markup escaped.
pub fn escape(text: &str) -> String {
    printable(text).replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bench::machine::Machine;
    use crate::bench::results::TimeToError;

    #[test]
    fn a_page_has_contents_that_lead_to_its_headings() {
        let [scene, engine] = ["grid", "reference"].map(str::to_owned);
        let times_to_error = vec![TimeToError { scene, engine, error: 0.05, seconds: None }];
        let machine = Machine { date: "2026-01-31".to_owned(), commit: "0123<\u{1b}".to_owned(), ..Machine::here() };
        let results = Results { times_to_error, machines: vec![machine], ..Results::default() };
        let picture = Thumbnail { scene: "grid".to_owned(), address: "data:image/png;base64,AAAA".to_owned() };
        let page = page(&results, Language::English, &[], &[], &[picture]);
        for id in ["what-they-say", "scenes", "charts", "time-to-an-error--rmse-in-linear-light-"] {
            let both = [format!("<a href=\"#{id}\">"), format!("<h2 id=\"{id}\">")];
            assert!(both.iter().all(|text| page.contains(text)), "{id}: {page}");
        }
        assert!(page.contains("<img src=\"data:image/png;base64,AAAA\" alt=\"The scene grid\">"), "{page}");
        assert!(page.contains("<p>Measured on 2026-01-31 with the program of commit 0123&lt;\u{fffd}.</p>"), "{page}");
        assert!(page.contains("<td class=\"t\">grid</td>") && page.contains("<td>0.05</td>"), "{page}");
    }
}
