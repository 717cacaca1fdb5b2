//! The page: words, charts and tables in one file that needs no other.

use std::fmt::Write;

use super::chart::Chart;
use super::findings::Finding;
use super::style::{for_screen, power_of_ten, printable, seconds, short, variables, with_error};
use crate::bench::results::Results;

const STYLE: &str = "\
body{font:16px/1.5 system-ui,sans-serif;margin:0 auto;max-width:52rem;padding:1rem;color:var(--ink);background:var(--paper)}\
h1{font-size:1.6rem;line-height:1.2}h2{font-size:1.2rem;margin-top:2.2rem}figure{margin:1.2rem 0;overflow-x:auto}\
svg{width:100%;min-width:27rem;max-width:46rem;height:auto;display:block}dt{font-weight:600;margin-top:.6rem}dd{margin:0}\
.wide{overflow-x:auto}table{border-collapse:collapse;font-variant-numeric:tabular-nums;font-size:.9rem}\
th,td{padding:.25rem .7rem .25rem 0;text-align:right;border-bottom:1px solid var(--grid);white-space:nowrap}\
th:first-child,td:first-child{text-align:left}footer{margin-top:2rem;font-size:.9rem}";

/// The page about `results`, with its charts as SVG.
#[must_use]
pub fn page(results: &Results, findings: &[Finding], charts: &[(&Chart, String)]) -> String {
    let mut page = format!(
        "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n<title>Measurements</title>\n<style>\n\
         :root{{color-scheme:light dark;--ink:#26262B;--paper:#FFFFFF;{}}}\n\
         @media(prefers-color-scheme:dark){{:root{{--ink:#E6E6EA;--paper:#17171B;{}}}}}\n{STYLE}\n</style>\n\
         <h1>Measurements of the renderer</h1>\n",
        variables(false),
        variables(true)
    );
    page.push_str("<h2>What they say</h2>\n<dl>\n");
    for Finding { topic, text } in findings {
        put(&mut page, format_args!("<dt>{}</dt><dd>{}</dd>\n", escape(topic), escape(text)));
    }
    page.push_str("</dl>\n<h2>Charts</h2>\n");
    for (_, svg) in charts {
        put(&mut page, format_args!("<figure>{}</figure>\n", for_screen(svg)));
    }
    growth(&mut page, results);
    times_to_error(&mut page, results);
    gains(&mut page, results);
    intersections(&mut page, results);
    omitted(&mut page, results);
    machines(&mut page, results);
    page.push_str("</html>\n");
    page
}

fn growth(page: &mut String, results: &Results) {
    let rows = results.growth.iter().map(|growth| {
        let (points, exponent) =
            (growth.law.points.to_string(), with_error(growth.law.exponent, growth.law.exponent_error));
        vec![growth.scene.clone(), growth.parameter.clone(), growth.engine.clone(), points, exponent]
    });
    let head = ["scene", "parameter", "implementation", "points", "exponent"];
    table(page, "Time as a power of a parameter", &head, rows);
}

fn times_to_error(page: &mut String, results: &Results) {
    let rows = results.times_to_error.iter().map(|time| {
        let reached = time.seconds.map_or_else(|| "not reached".to_owned(), seconds);
        vec![time.scene.clone(), time.engine.clone(), short(time.error), reached]
    });
    table(page, "Time to an error (RMSE in linear light)", &["scene", "implementation", "error", "user time"], rows);
}

fn gains(page: &mut String, results: &Results) {
    let rows = results.gains.iter().map(|gain| {
        let bounds = format!("{} to {}", short(gain.low), short(gain.high));
        vec![gain.scene.clone(), gain.without.clone(), short(gain.ratio), bounds]
    });
    table(page, "Time with one thing switched off", &["scene", "with", "times as long", "bounds"], rows);
}

fn intersections(page: &mut String, results: &Results) {
    let rows = results.intersections.iter().map(|found| {
        let [object, rays, name] =
            [&found.trial.object, &found.trial.rays, &found.trial.implementation].map(Clone::clone);
        let wrong = format!("{} of {}", found.wrong, found.cases);
        let [middle, high, most] = found.lambda_error.map(power_of_ten);
        let cost =
            format!("{} ({} to {})", short(found.median.median), short(found.median.low), short(found.median.high));
        vec![object, rays, name, wrong, middle, high, most, cost]
    });
    let head = ["object", "rays", "implementation", "wrong", "error, 50 %", "99.9 %", "most", "ns a test"];
    table(page, "Intersections against exact arithmetic", &head, rows);
}

fn omitted(page: &mut String, results: &Results) {
    let rows = results.omitted.iter().map(|omitted| {
        let setting = &omitted.setting;
        let value = format!("{} {}", setting.value, setting.parameter);
        vec![setting.scene.clone(), value, setting.engine.clone(), omitted.reason.clone()]
    });
    table(page, "Left out", &["scene", "setting", "implementation", "because"], rows);
}

fn machines(page: &mut String, results: &Results) {
    let rows = results.machines.iter().map(|m| {
        let processor = format!("{} ({} processors)", m.processor, m.processors);
        let compiler = format!("{}, {}", m.compiler, m.profile);
        vec![m.date.clone(), processor, m.instruction_set.clone(), m.system.clone(), compiler, m.commit.clone()]
    });
    let head = ["date", "processor", "instruction set", "system", "compiler", "commit"];
    table(page, "Where it was measured", &head, rows);
}

/// A table under a heading, or nothing without rows.
fn table(page: &mut String, heading: &str, head: &[&str], rows: impl Iterator<Item = Vec<String>>) {
    let line = |cells: &mut dyn Iterator<Item = &str>, tag: &str| -> String {
        let cells: String = cells.map(|cell| format!("<{tag}>{}</{tag}>", escape(cell))).collect();
        format!("<tr>{cells}</tr>\n")
    };
    let body: String = rows.map(|row| line(&mut row.iter().map(String::as_str), "td")).collect();
    if !body.is_empty() {
        let head = line(&mut head.iter().copied(), "th");
        put(page, format_args!("<h2>{heading}</h2>\n<div class=\"wide\"><table>\n{head}{body}</table></div>\n"));
    }
}

fn put(page: &mut String, text: std::fmt::Arguments<'_>) {
    // A string takes all text.
    let _ = page.write_fmt(text);
}

fn escape(text: &str) -> String {
    printable(text).replace('&', "&amp;").replace('<', "&lt;")
}
