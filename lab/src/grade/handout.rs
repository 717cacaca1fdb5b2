//! Writes what a team gets: a page, the results as Gradescope reads them, and as JUnit XML.

use std::path::Path;

use output::{Options, Output};
use serde_json::json;

use super::points::PARTS;
use super::{Graded, Grades, Row};
use crate::check::Checked;
use crate::format::hint::Language;
use crate::report::html;
use crate::template::escape;
use crate::{Failure, sources};

impl Grades {
    /// Writes the table and, into one folder for each team, what it gets.
    ///
    /// # Errors
    /// An error of a file.
    pub fn write(&self, results: &Path, language: Language, options: Options) -> Result<(), Failure> {
        let write = |path: &Path, text: &str| {
            Ok::<_, Failure>(Output::open(path, options)?.fill(|file| file.write_all(text.as_bytes()))?)
        };
        for row in &self.teams {
            let folder = results.join(&row.folder);
            sources::make_folder(&folder)?;
            write(&folder.join("page.html"), &html::document(language, &row.team, &row.body(language))?)?;
            write(&folder.join("results.json"), &row.gradescope(language).to_string())?;
            write(&folder.join("junit.xml"), &row.junit(language))?;
        }
        write(&results.join("index.html"), &self.page(language, true)?)?;
        let mut csv = Vec::new();
        self.write_csv(language, &mut csv)?;
        write(&results.join("grades.csv"), &String::from_utf8_lossy(&csv))
    }
}

impl Row {
    /// Returns the points of the team with their reasons, and the reports of its programs, as a part of a page.
    pub fn body(&self, language: Language) -> String {
        let points = |points: Option<f64>| points.map_or_else(|| "-".to_owned(), |points| format!("{points:.2}"));
        let parts = PARTS.iter().zip(self.points).map(|(words, part)| vec![language.say(*words, &[]), points(part)]);
        let all = vec![language.say(["points of 10", "puntos sobre 10"], &[]), points(self.total)];
        let mut body = html::table(&self.team, &["", ""], std::iter::once(all).chain(parts));
        body.extend(self.problems.iter().map(|problem| html::paragraph(problem)));
        for graded in &self.programs {
            let start = format!("{}: ", graded.program);
            body += &graded.report.as_ref().map_or_else(String::new, |report| report.body(language, &start));
        }
        body
    }

    /// Returns all cases with their programs.
    fn cases(&self) -> impl Iterator<Item = (&Graded, &Checked)> {
        self.programs.iter().flat_map(|graded| {
            graded.report.iter().flat_map(move |report| report.cases.iter().map(move |it| (graded, it)))
        })
    }

    /// Returns the results in the form that Gradescope reads.
    fn gradescope(&self, language: Language) -> serde_json::Value {
        let test = |(graded, checked): (&Graded, &Checked)| {
            json!({
                "name": format!("{}: {}", graded.program, checked.case),
                "score": checked.weight * checked.credit,
                "max_score": checked.weight,
                "output": said(checked, language),
            })
        };
        let tests: Vec<_> = self.cases().map(test).collect();
        json!({ "score": self.total.unwrap_or(0.0), "max_score": 10.0, "output": self.problems.join("\n"), "tests": tests })
    }

    /// Returns the results as JUnit XML.
    fn junit(&self, language: Language) -> String {
        let test = |(graded, checked): (&Graded, &Checked)| {
            let start =
                format!("<testcase classname=\"{}\" name=\"{}\"", escape(&graded.program), escape(&checked.case));
            if checked.faults.is_empty() {
                return start + "/>\n";
            }
            format!("{start}><failure message=\"{}\"/></testcase>\n", escape(&said(checked, language)))
        };
        let error =
            |reason: &String| format!("<testcase name=\"start\"><error message=\"{}\"/></testcase>\n", escape(reason));
        let tests: String = self.cases().map(test).collect();
        let errors: String = self.programs.iter().filter_map(|graded| graded.not_graded.as_ref()).map(error).collect();
        let failures = self.cases().filter(|(_, checked)| !checked.faults.is_empty()).count();
        let head =
            format!("name=\"{}\" tests=\"{}\" failures=\"{failures}\"", escape(&self.team), self.cases().count());
        format!("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite {head}>\n{tests}{errors}</testsuite>\n")
    }
}

/// Returns the faults of a case in words.
fn said(checked: &Checked, language: Language) -> String {
    let fault = |fault: &crate::check::fault::Fault| {
        let name = language.pick(fault.kind.words());
        [name, &fault.expected, &fault.found].into_iter().filter(|text| !text.is_empty()).collect::<Vec<_>>().join(": ")
    };
    checked.faults.iter().map(fault).collect::<Vec<_>>().join("; ")
}
