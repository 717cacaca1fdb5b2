//! Holds any program with the statement's command line to the specification.
//!
//! [`cases`] lists the arguments, wrong files and pictures. [`judge`] runs a program on one of them, and finds its
//! [`fault`]s. [`Report`] is the result, and [`page`] shows it.

pub mod cases;
pub mod fault;
pub mod judge;
pub mod page;

use std::path::Path;

use output::{Options, Output};
use serde::Serialize;

use crate::bench::commands::Job;
use crate::difference::{Difference, MAXIMUM_BOUND, RMSE_BOUND};
use crate::heatmap::{Scale, heatmap};
use crate::picture::Picture;
use crate::supervise::Limits;
use crate::{Failure, terminal};
use cases::{Case, Group};
use fault::{Fault, Kind};
use judge::{ARGUMENTS, Comparison};

/// What a program did with one case.
#[derive(Clone, Debug, Serialize)]
pub struct Checked {
    /// The name of the case.
    pub case: String,
    /// Its kind.
    pub group: Group,
    /// What is wrong; nothing if the program passed.
    pub faults: Vec<Fault>,
    /// Whether a picture has the bytes of the specification.
    pub equal: bool,
    /// The differences of a picture from the expected one.
    pub difference: Option<Difference>,
    /// The command that repeats the case.
    pub command: String,
}

/// What a program did with all cases.
#[derive(Clone, Debug, Serialize)]
pub struct Report {
    /// The program's name.
    pub program: String,
    /// The scatter vectors that its pictures have: 0 for those of the statement, 1 for those of the published pictures.
    pub convention: usize,
    /// What it did.
    pub cases: Vec<Checked>,
}

impl Report {
    /// Runs `program` on all `cases`, with their files in `folder`.
    ///
    /// Of the two conventions to scatter light, the program is held to that with more accepted pictures.
    ///
    /// # Errors
    /// A file cannot be written, the program cannot be started, or [`Failure::Interrupted`].
    pub fn of(program: &Job, cases: &[Case], limits: &Limits, folder: &Path) -> Result<Self, Failure> {
        let bar = terminal::progress(cases.len(), "cases");
        let mut outcomes = Vec::new();
        for case in cases {
            let outcome = case.run(program, &folder.join(&case.name), limits);
            outcomes.push(outcome.map_err(|error| error.about(&case.name))?);
            bar.inc(1);
        }
        bar.finish_and_clear();
        let pictures = || outcomes.iter().flatten();
        let accepted = |index: usize| pictures().filter(|compared| compared[index].difference.accepted).count();
        let convention = usize::from(accepted(1) > accepted(0));
        let judged = cases.iter().zip(outcomes).map(|(case, outcome)| {
            let place = folder.join(&case.name);
            let words = case.command(program, &place);
            let mut command = terminal::quoted(words.iter().map(AsRef::as_ref));
            if program.place != Path::new(".") {
                command = format!("cd {} && {command}", terminal::quoted([program.place.as_os_str()]));
            }
            let (equal, difference, faults) = match outcome {
                Err(faults) => (false, None, faults),
                Ok(compared) => {
                    let Comparison { is_equal, difference } = &compared[convention];
                    (*is_equal, Some(difference.clone()), wrong_picture(case, difference, convention, &place)?)
                }
            };
            Ok(Checked { case: case.name.clone(), group: case.group, faults, equal, difference, command })
        });
        Ok(Self { program: program.name.clone(), convention, cases: judged.collect::<Result<_, Failure>>()? })
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

/// Returns the fault of a picture, if it is wrong. Then it writes the expected picture, the picture, and their
/// difference into the folder of the case.
fn wrong_picture(case: &Case, difference: &Difference, convention: usize, place: &Path) -> Result<Vec<Fault>, Failure> {
    if difference.accepted {
        return Ok(Vec::new());
    }
    let found = Picture::read(&place.join(ARGUMENTS[2]))?;
    let expected = &case.expected_pictures()?[convention].picture;
    let map = heatmap(expected, &found, Scale::automatic(expected, &found, false))?;
    let map = map.crop([0, 0, expected.width, expected.height])?;
    for (name, picture) in page::PICTURES.iter().zip([expected, &found, &map]) {
        Output::open(&place.join(name), Options::default())?.fill(|file| picture.write_png(file))?;
    }
    let bounds = format!("maximum < {MAXIMUM_BOUND}, RMSE < {RMSE_BOUND}");
    let figures = format!("maximum {:.1}, RMSE {:.2}", difference.maximum, difference.rmse);
    Ok(vec![Kind::WrongPicture.fault("", bounds, figures)])
}
