//! Holds any program with the statement's command line to the statement.
//!
//! [`cases`] lists the arguments, wrong files, pairs of files and pictures. [`judge`] runs a program on one of them,
//! and finds its [`fault`]s. [`Report`] is the result, and [`page`] shows it.

pub mod cases;
pub mod fault;
pub mod judge;
pub mod page;

use std::fs::File;
use std::path::{Path, PathBuf};

use indicatif::ProgressBar;
use serde::{Deserialize, Serialize};

use crate::bench::commands::Job;
use crate::difference::Difference;
use crate::heatmap::{Scale, heatmap};
use crate::picture::Picture;
use crate::supervise::Limits;
use crate::{Failure, terminal};
use cases::{Case, Expected, Group};
use fault::{Fault, Kind};
use judge::{Comparison, Judged};

/// How near a picture is to the expected one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// Every byte is equal.
    SameBytes,
    /// It differs, and less than the bounds of the case.
    Accepted,
    /// It differs more.
    AnotherPicture,
}

/// What a program did with one case.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Checked {
    /// The name of the case.
    pub case: String,
    /// Its kind.
    pub group: Group,
    /// The line of an input file that the case is about, or nothing.
    pub line: String,
    /// What is wrong; nothing if the program passed.
    pub faults: Vec<Fault>,
    /// What costs no points.
    pub remarks: Vec<Fault>,
    /// How much the case counts, and the share of it that the program has.
    pub weight: f64,
    /// From 0 to 1.
    pub credit: f64,
    /// How near a picture is to the expected one.
    pub verdict: Option<Verdict>,
    /// The differences of a picture from the expected one.
    pub difference: Option<Difference>,
    /// The command that repeats the case.
    pub command: String,
    /// The folder with the files of the case.
    pub folder: PathBuf,
}

/// What a program did with all cases.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Report {
    /// The program's name.
    pub program: String,
    /// The scatter vectors that its pictures have: 0 for those of the statement, 1 for those of the published pictures.
    pub convention: usize,
    /// What it did.
    pub cases: Vec<Checked>,
}

/// Number of runs over the limit of time after which a program is given up.
const MOST_TIME_OUTS: usize = 3;

impl Report {
    /// Runs `program` on all `cases`, with their files in `folder`. The folders of the cases have numbers as names, so
    /// that a program does not learn from its arguments what is checked.
    ///
    /// Of the two conventions to scatter light, the program is held to that which is nearer to its pictures.
    ///
    /// # Errors
    /// A file cannot be written, or the errors of [`crate::supervise::run`].
    pub fn of(
        program: &Job,
        cases: &[Case],
        limits: &Limits,
        folder: &Path,
        bar: &ProgressBar,
    ) -> Result<Self, Failure> {
        let (mut threads, mut time_outs, mut judged) = (0, 0, Vec::new());
        for (number, case) in cases.iter().enumerate() {
            let place = folder.join((number + 1).to_string());
            bar.inc(1);
            if time_outs == MOST_TIME_OUTS {
                let faults = vec![Kind::LeftOut.fault(case.section, "", "")];
                judged.push((place, Judged { faults, ..Judged::default() }));
                continue;
            }
            let (run, outcome) = case.run(program, &place, limits, threads)?;
            threads = run.threads.max(threads);
            time_outs += usize::from(outcome.faults.iter().any(|fault| fault.kind == Kind::TimeOut));
            judged.push((place, outcome));
        }
        let compared = || judged.iter().filter_map(|(_, judged)| judged.compared.as_ref());
        let distance = |index: usize| compared().map(|(_, both)| both[index].difference.rmse).sum::<f64>();
        let convention = usize::from(distance(1) < distance(0));
        let checked = cases.iter().zip(judged).map(|(case, (place, judged))| {
            let words = case.command(program, &place);
            let mut command = terminal::quoted(words.iter().map(AsRef::as_ref));
            if program.place != Path::new(".") {
                command = format!("cd {} && {command}", terminal::quoted([program.place.as_os_str()]));
            }
            let Judged { mut faults, remarks, mut credit, compared } = judged;
            let (mut verdict, mut difference) = (None, None);
            if let Some((picture, both)) = compared {
                let judgement = case.verdict(&both[convention]);
                if judgement == Verdict::AnotherPicture {
                    credit = 0.0;
                    faults.push(case.wrong_picture(&both[convention], convention));
                    show(case, convention, &picture, &place)?;
                }
                verdict = Some(judgement);
                difference = Some(both[convention].difference.clone());
            }
            let (name, line) = (case.name.clone(), terminal::foreign(case.line.as_bytes()));
            let (group, weight, folder) = (case.group, case.weight, place);
            Ok(Checked {
                case: name,
                group,
                line,
                faults,
                remarks,
                weight,
                credit,
                verdict,
                difference,
                command,
                folder,
            })
        });
        let cases = checked.collect::<Result<_, Failure>>()?;
        Ok(Self { program: program.name.clone(), convention, cases })
    }

    /// Returns the number of passed cases of `group`, and the number of all.
    pub fn passed(&self, group: Group) -> [usize; 2] {
        let all = || self.cases.iter().filter(|checked| checked.group == group);
        [all().filter(|checked| checked.faults.is_empty()).count(), all().count()]
    }

    /// Whether the program passed all cases.
    pub fn is_passed(&self) -> bool {
        self.cases.iter().all(|checked| checked.faults.is_empty())
    }
}

impl Case {
    /// Returns how near a picture is to the expected one.
    pub fn verdict(&self, Comparison { is_equal, difference }: &Comparison) -> Verdict {
        let [maximum, rmse] = self.bounds();
        match (*is_equal, difference.maximum < maximum && difference.rmse < rmse) {
            (true, _) => Verdict::SameBytes,
            (_, true) => Verdict::Accepted,
            _ => Verdict::AnotherPicture,
        }
    }

    /// Returns the fault of a picture that is not near the expected one.
    pub fn wrong_picture(&self, Comparison { difference, .. }: &Comparison, convention: usize) -> Fault {
        let [maximum, rmse] = self.bounds();
        let expected =
            format!("maximum < {maximum:.0}, RMSE < {rmse:.1}{}", if convention == 0 { "" } else { " (11.2)" });
        Kind::WrongPicture.fault(
            self.section,
            expected,
            format!("maximum {:.1}, RMSE {:.2}", difference.maximum, difference.rmse),
        )
    }

    fn bounds(&self) -> [f64; 2] {
        if let Expected::Picture(bounds) = self.expected { bounds } else { [f64::INFINITY; 2] }
    }
}

/// Writes the expected picture, the found one, and their difference into the folder of the case.
fn show(case: &Case, convention: usize, found: &Picture, place: &Path) -> Result<(), Failure> {
    let drawn = case.expected(convention)?;
    let higher = if drawn.picture.height == found.height {
        None
    } else {
        Some(case.drawn_with(convention, Some(found.height))?)
    };
    let expected = &higher.as_ref().unwrap_or(drawn).picture;
    let map = heatmap(expected, found, Scale::automatic(expected, found, false))?;
    let map = map.crop([0, 0, expected.width, expected.height])?;
    for (name, picture) in page::PICTURES.iter().zip([expected, found, &map]) {
        // The program may have left anything with this name.
        judge::remove(&place.join(name));
        picture.write_png(File::create_new(place.join(name))?)?;
    }
    Ok(())
}
