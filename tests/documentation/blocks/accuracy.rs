//! The block of figures of docs/accuracy/README.md, from the tables of `stress`.

use std::fmt::Write;

use crate::project::Project;

/// The table of errors, as columns of texts.
struct Errors {
    head: Vec<String>,
    rows: Vec<Vec<String>>,
}

impl Errors {
    fn parse(table: &str) -> Self {
        let mut lines = table.lines().map(|line| {
            // Only the name of a regime is quoted, and it may have commas.
            let mut fields = Vec::new();
            for (index, part) in line.split('"').enumerate() {
                match index {
                    1 => fields.push(part.to_owned()),
                    _ => fields.extend(part.trim_matches(',').split(',').map(str::to_owned)),
                }
            }
            fields
        });
        let head = lines.next().expect("a table has a head");
        Self { head, rows: lines.collect() }
    }

    fn text<'a>(&self, row: &'a [String], column: &str) -> &'a str {
        let at = self.head.iter().position(|name| name == column);
        &row[at.unwrap_or_else(|| panic!("errors.csv has no column {column}"))]
    }

    fn number(&self, row: &[String], column: &str) -> f64 {
        let text = self.text(row, column);
        text.parse().unwrap_or_else(|_| panic!("{column}: {text} is no number"))
    }

    /// Returns the row with the largest number of a column, and that number.
    fn largest<'a>(&'a self, rows: &[&'a Vec<String>], column: &str) -> (&'a str, f64) {
        let each = rows.iter().map(|row| (self.text(row, "regime"), self.number(row, column)));
        each.reduce(|best, row| if row.1 > best.1 { row } else { best }).expect("there are regimes")
    }
}

/// Returns the figure, and behind it the regime, if the figure is not 0.
fn with_regime(figure: String, regime: &str, value: f64) -> String {
    if value == 0.0 { figure } else { format!("{figure} ({regime})") }
}

/// Returns the table of each implementation in Rust: its wrong decisions and its largest error of lambda.
///
/// # Panics
/// If an implementation in WGSL has other figures than that in Rust.
fn table(errors: &str, run: &str) -> String {
    let errors = Errors::parse(errors);
    let mut names: Vec<[&str; 2]> = Vec::new();
    for row in &errors.rows {
        let name = ["object", "implementation"].map(|column| errors.text(row, column));
        if !names.contains(&name) {
            names.push(name);
        }
    }
    let of = |name: [&str; 2]| -> Vec<&Vec<String>> {
        let is_it = |row: &&Vec<String>| ["object", "implementation"].map(|column| errors.text(row, column)) == name;
        errors.rows.iter().filter(is_it).collect()
    };
    let cases = errors.text(&errors.rows[0], "cases");
    assert!(errors.rows.iter().all(|row| errors.text(row, "cases") == cases), "every regime has as many rays");
    let mut table = format!(
        "Of {cases} rays of each regime:\n\n| Object | Implementation | Wrong: ordinary | Wrong: most | Hit, part, root | \
         Beyond 8uS | Largest error of lambda |\n|---|---|--:|--:|--:|--:|--:|\n"
    );
    for [object, implementation] in names {
        let rows = of([object, implementation]);
        if let Some(twin) = implementation.strip_prefix("WGSL ") {
            let figures = |rows: &[&Vec<String>]| rows.iter().map(|row| row[3..].to_vec()).collect::<Vec<_>>();
            assert!(
                figures(&of([object, twin])) == figures(&rows),
                "{object}, {implementation}: not the figures of {twin}"
            );
            continue;
        }
        let ordinary = rows.iter().find(|row| errors.text(row, "regime") == "ordinary").expect("it is a regime");
        let (regime, wrong) = errors.largest(&rows, "wrong");
        let sum = |column: &str| rows.iter().map(|row| errors.number(row, column)).sum::<f64>();
        let [hit, part, root] = ["wrong_hit", "wrong_part", "wrong_root"].map(sum);
        let beyond = if object == "sphere" { sum("wrong_beyond_8uS").to_string() } else { String::new() };
        let (place, lambda) = errors.largest(&rows, "lambda_max");
        let _ = writeln!(
            table,
            "| {object} | {implementation} | {} | {} | {hit}, {part}, {root} | {beyond} | {} |",
            errors.text(ordinary, "wrong"),
            with_regime(wrong.to_string(), regime, wrong),
            with_regime(format!("{lambda:.1e}"), place, lambda),
        );
    }
    let said = |name: &str| {
        let line = run.lines().find_map(|line| line.strip_prefix(name)?.strip_prefix(": "));
        line.unwrap_or_else(|| panic!("run.txt has no {name}"))
    };
    let [date, processor, commit] = ["date", "processor", "commit"].map(said);
    table
        + &format!(
            "\nWGSL has the figures of the same formulas in Rust. `stress`, {date}, {processor}, commit {commit}.\n"
        )
}

/// Returns the text of the block.
pub fn block(project: &Project) -> String {
    table(&project.text("docs/accuracy/errors.csv"), &project.text("docs/accuracy/run.txt"))
}

#[test]
fn a_table_of_errors_becomes_a_row_for_each_implementation() {
    let head = "object,regime,implementation,cases,wrong,wrong_hit,wrong_part,wrong_root,wrong_beyond_8uS,lambda_max\n";
    let rows = "sphere,\"ordinary\",plain,100,1,1,0,0,0,2e-12\nsphere,\"ordinary\",WGSL plain,100,1,1,0,0,0,2e-12\n\
                sphere,\"in, on\",plain,100,7,3,0,4,5,1e-12\nsphere,\"in, on\",WGSL plain,100,7,3,0,4,5,1e-12\n";
    let run = "date: today\ncommit: abc\nprocessor: P\n";
    let written = table(&format!("{head}{rows}"), run);
    assert!(
        written.contains("\n| sphere | plain | 1 | 7 (in, on) | 4, 0, 4 | 5 | 2.0e-12 (ordinary) |\n"),
        "{written}"
    );
    assert!(written.ends_with("`stress`, today, P, commit abc.\n"), "{written}");
    let parted = rows.replace("WGSL plain,100,7", "WGSL plain,100,8");
    let failed = std::panic::catch_unwind(|| table(&format!("{head}{parted}"), run));
    assert!(failed.is_err(), "WGSL has other figures");
}
