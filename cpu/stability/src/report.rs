//! Writes the measured figures as tables in Markdown and as CSV.

use std::fmt::Write;

use crate::measure::Row;
use crate::observed::Counts;

/// A section of a table: the measured figures of one regime.
#[derive(Clone, Debug)]
pub struct Section {
    /// The rows of the table, one for each implementation.
    pub rows: Vec<Row>,
    /// Two shares of the cases, from 0 to 1: those that need double-double, and those that need dyadic arithmetic.
    pub fallbacks: [f64; 2],
}

/// The row of one picture in the table of pictures.
#[derive(Clone, Debug)]
pub struct Picture {
    /// Name of the picture.
    pub name: String,
    /// Counts of the intersections with spheres and with cylinders together.
    pub counts: Counts,
    /// Whether the picture with exact intersections has the bytes of the picture with the plain formulas.
    pub same_bytes: bool,
}

/// Formats a share from 0 to 1 as a percentage with two decimals, or with an exponent if it is small.
fn percent(share: f64) -> String {
    match share {
        0.0 => "0".into(),
        share if share < 1e-4 => format!("{:.1e} %", share * 100.0),
        share => format!("{:.2} %", share * 100.0),
    }
}

fn short(value: f64) -> String {
    if value == 0.0 { "0".into() } else { format!("{value:.1e}") }
}

/// Returns the Markdown table of one kind of object.
#[must_use]
pub fn markdown(sections: &[Section]) -> String {
    let mut text = String::from(
        "| regime | implementation | wrong | beyond 8uS | wrong side | lambda p50 | p99.9 | max | surface p50 | max \
         | double-double | exact |\n|---|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n",
    );
    for Section { rows, fallbacks } in sections {
        for (index, row) in rows.iter().enumerate() {
            let regime = if index == 0 {
                format!("**{}** ({} of {} hit)", row.regime, row.hits, row.cases)
            } else {
                String::new()
            };
            let is_exact = row.method == crate::methods::EXACT;
            let [double, exact] = fallbacks.map(|share| if is_exact { percent(share) } else { String::new() });
            let beyond = row.wrong_beyond_noise.map_or(String::from("-"), |count| count.to_string());
            let [median, high, most] = row.lambda_error.map(short);
            let [near, far] = row.surface_error.map(short);
            let (method, wrong, side) = (row.method, row.wrong, row.wrong_side);
            // Writing to a `String` never fails, so errors are ignored.
            let _ = writeln!(
                text,
                "| {regime} | {method} | {wrong} | {beyond} | {side} | {median} | {high} | {most} | {near} | {far} | {double} | {exact} |"
            );
        }
    }
    text
}

/// Returns the rows of all kinds of objects as CSV. Times are left out, because they differ from run to run.
#[must_use]
pub fn csv(kinds: &[(&str, &[Section])]) -> String {
    let mut text = String::from(
        "object,regime,implementation,cases,hits,wrong,wrong_beyond_8uS,wrong_side,lambda_p50,lambda_p999,lambda_max,\
         surface_p50,surface_max,double_double,exact\n",
    );
    for (kind, sections) in kinds {
        for Section { rows, fallbacks: [double, exact] } in *sections {
            for row in rows {
                let [median, high, most] = row.lambda_error;
                let [near, far] = row.surface_error;
                let beyond = row.wrong_beyond_noise.map_or(String::new(), |count| count.to_string());
                let _ = writeln!(
                    text,
                    "{kind},\"{}\",{},{},{},{},{beyond},{},{median:e},{high:e},{most:e},{near:e},{far:e},{double},{exact}",
                    row.regime, row.method, row.cases, row.hits, row.wrong, row.wrong_side
                );
            }
        }
    }
    text
}

/// Returns the Markdown table of the times of one intersection in nanoseconds. Each kind of object has two columns: its
/// first regime and its slowest regime.
#[must_use]
pub fn costs(kinds: &[(&str, &[Section])]) -> String {
    let (mut head, mut rule) = (String::from("| implementation |"), String::from("|---|"));
    for (kind, sections) in kinds {
        let first = sections.first().and_then(|section| section.rows.first()).map_or("", |row| row.regime);
        head += &format!(" {kind}, {first} | {kind}, dearest regime |");
        rule += "--:|--:|";
    }
    let mut text = format!("{head}\n{rule}\n");
    let rows = kinds.first().and_then(|(_, sections)| sections.first()).map_or(0, |section| section.rows.len());
    for index in 0..rows {
        let mut cells = Vec::new();
        for (_, sections) in kinds {
            let nanoseconds = |section: &Section| section.rows[index].nanoseconds;
            let dearest = sections.iter().map(nanoseconds).fold(0.0, f64::max);
            cells.extend(sections.first().map(nanoseconds).into_iter().chain([dearest]));
        }
        let cells: Vec<_> = cells.into_iter().map(digits).collect();
        let _ = writeln!(text, "| {} | {} |", kinds[0].1[0].rows[index].method, cells.join(" | "));
    }
    text
}

/// Formats nanoseconds with one decimal if they are below 10, and otherwise without decimals.
fn digits(nanoseconds: f64) -> String {
    if nanoseconds < 10.0 { format!("{nanoseconds:.1}") } else { format!("{nanoseconds:.0}") }
}

/// Returns the Markdown table of pictures.
#[must_use]
pub fn pictures(pictures: &[Picture]) -> String {
    let mut text = String::from(
        "| picture | tests | uncertain | hits | lambdas with the plain formulas' bits | other decisions | same bytes |\n\
         |---|--:|--:|--:|--:|--:|---|\n",
    );
    for Picture { name, counts, same_bytes } in pictures {
        let uncertain = percent(counts.uncertain as f64 / counts.tests.max(1) as f64);
        let kept = match counts.hits {
            0 => String::from("-"),
            hits => format!("{:.3} %", 100.0 * counts.same_bits as f64 / hits as f64),
        };
        let same = if *same_bytes { "yes" } else { "no" };
        let Counts { tests, hits, other_decision, .. } = counts;
        let _ = writeln!(text, "| {name} | {tests} | {uncertain} | {hits} | {kept} | {other_decision} | {same} |");
    }
    text
}
