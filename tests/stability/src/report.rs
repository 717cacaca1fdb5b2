//! Rows as a table for people and as one for programs.

use std::fmt::Write;

use crate::measure::Row;
use crate::observed::Counts;

/// One regime, all implementations, and the shares of cases left to double-double and to exact arithmetic.
#[derive(Clone, Debug)]
pub struct Section {
    /// A row an implementation.
    pub rows: Vec<Row>,
    /// What the certificate leaves to the next two steps.
    pub fallbacks: [f64; 2],
}

/// What was counted while one picture was rendered.
#[derive(Clone, Debug)]
pub struct Picture {
    /// Which.
    pub name: String,
    /// Spheres and cylinders together.
    pub counts: Counts,
    /// Whether the picture has the textbook's bytes.
    pub same_bytes: bool,
}

/// A share as a percentage with the digits it needs.
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

/// The table of one kind of object in Markdown.
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
            let certified = row.method == crate::methods::CERTIFIED;
            let [double, exact] = fallbacks.map(|share| if certified { percent(share) } else { String::new() });
            let beyond = row.wrong_beyond_noise.map_or(String::from("-"), |count| count.to_string());
            let [median, high, most] = row.lambda_error.map(short);
            let [near, far] = row.surface_error.map(short);
            let (method, wrong, side) = (row.method, row.wrong, row.wrong_side);
            // Writing to a string cannot fail.
            let _ = writeln!(
                text,
                "| {regime} | {method} | {wrong} | {beyond} | {side} | {median} | {high} | {most} | {near} | {far} | {double} | {exact} |"
            );
        }
    }
    text
}

/// All rows for programs; times are left out, since they differ from run to run.
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

/// What a test costs in nanoseconds, in Markdown: in the first regime of each kind of object, and in the dearest.
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

/// Two digits that count, or all before the point.
fn digits(nanoseconds: f64) -> String {
    if nanoseconds < 10.0 { format!("{nanoseconds:.1}") } else { format!("{nanoseconds:.0}") }
}

/// The table of pictures in Markdown.
#[must_use]
pub fn pictures(pictures: &[Picture]) -> String {
    let mut text = String::from(
        "| picture | tests | in doubt | hits | lambdas with the textbook's bits | other decisions | same bytes |\n\
         |---|--:|--:|--:|--:|--:|---|\n",
    );
    for Picture { name, counts, same_bytes } in pictures {
        let doubt = percent(counts.doubtful as f64 / counts.tests.max(1) as f64);
        let kept = match counts.hits {
            0 => String::from("-"),
            hits => format!("{:.3} %", 100.0 * counts.same_bits as f64 / hits as f64),
        };
        let same = if *same_bytes { "yes" } else { "no" };
        let Counts { tests, hits, other_decision, .. } = counts;
        let _ = writeln!(text, "| {name} | {tests} | {doubt} | {hits} | {kept} | {other_decision} | {same} |");
    }
    text
}
