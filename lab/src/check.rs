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
use crate::picture::kind::Kind as Format;
use crate::supervise::Limits;
use crate::{Failure, terminal};
use cases::{Case, Group};
use fault::{Fault, Kind};
use judge::{ARGUMENTS, CONVENTIONS, Comparison, Outcome};

/// How a program is checked.
#[derive(Clone, Copy, Debug, clap::Args)]
pub struct How {
    /// The limits of each run.
    #[command(flatten)]
    pub limits: Limits,
    /// Accept only pictures with the bytes of the specification
    #[arg(long)]
    pub exact: bool,
}

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
    /// The differences of a picture that has other bytes.
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
    pub fn of(program: &Job, cases: &[Case], how: &How, folder: &Path) -> Result<Self, Failure> {
        let bar = terminal::progress(cases.len(), "cases");
        let mut outcomes = Vec::new();
        for case in cases {
            outcomes.push(case.run(program, &folder.join(&case.name), &how.limits)?);
            bar.inc(1);
        }
        bar.finish_and_clear();
        let accepted = |convention: usize| {
            let is_accepted = |outcome: &&Outcome| match outcome {
                Outcome::Compared(compared) => compared[convention].is_accepted(),
                Outcome::Faults(_) => false,
            };
            outcomes.iter().filter(is_accepted).count()
        };
        let convention = usize::from(accepted(1) > accepted(0));
        let judged = cases.iter().zip(outcomes).map(|(case, outcome)| {
            let place = folder.join(&case.name);
            let words = case.command(program, &place);
            let command = terminal::quoted(words.iter().map(AsRef::as_ref));
            let command = if program.place == Path::new(".") {
                command
            } else {
                format!("cd {} && {command}", terminal::quoted([program.place.as_os_str()]))
            };
            let mut checked = Checked {
                case: case.name.clone(),
                group: case.group,
                faults: Vec::new(),
                equal: false,
                difference: None,
                command,
            };
            match outcome {
                Outcome::Faults(faults) => checked.faults = faults,
                Outcome::Compared(compared) => checked.judge(case, &compared, convention, how, &place)?,
            }
            Ok(checked)
        });
        Ok(Self { program: program.name.clone(), convention, cases: judged.collect::<Result<_, Failure>>()? })
    }

    /// Returns the number of passed cases of `group`, and the number of all.
    #[must_use]
    pub fn passed(&self, group: Group) -> [usize; 2] {
        let all = || self.cases.iter().filter(|checked| checked.group == group);
        [all().filter(|checked| checked.faults.is_empty()).count(), all().count()]
    }

    /// Whether the program passed all cases.
    #[must_use]
    pub fn is_passed(&self) -> bool {
        self.cases.iter().all(|checked| checked.faults.is_empty())
    }
}

impl Checked {
    /// Judges a picture by its differences from the expected one. If the picture is wrong, writes the expected picture,
    /// the picture, and their difference into the folder of the case.
    fn judge(
        &mut self,
        case: &Case,
        compared: &[Comparison; 2],
        convention: usize,
        how: &How,
        place: &Path,
    ) -> Result<(), Failure> {
        let computed;
        let difference = match &compared[convention] {
            Comparison::Equal => {
                self.equal = true;
                return Ok(());
            }
            Comparison::Differs(difference) => difference,
            Comparison::Other => {
                let found = Picture::read(&place.join(ARGUMENTS[2]))?;
                computed = Difference::between(&case.expected_picture(CONVENTIONS[convention])?, &found)?;
                &computed
            }
        };
        let bounds = format!("maximum < {MAXIMUM_BOUND}, RMSE < {RMSE_BOUND}");
        let found = format!("maximum {:.1}, RMSE {:.2}", difference.maximum, difference.rmse);
        self.difference = Some(difference.clone());
        if !difference.accepted {
            self.faults.push(Kind::WrongPicture.fault("", bounds, found));
            let found = Picture::read(&place.join(ARGUMENTS[2]))?;
            let expected = case.expected_picture(CONVENTIONS[convention])?;
            let map = heatmap(&expected, &found, Scale::automatic(&expected, &found, false))?;
            let map = map.crop([0, 0, expected.width, expected.height])?;
            for (name, picture) in page::PICTURES.iter().zip([&expected, &found, &map]) {
                Output::open(&place.join(name), Options::default())?.fill(|file| picture.write(Format::Png, file))?;
            }
        } else if how.exact {
            self.faults.push(Kind::OtherBytes.fault("", "", found));
        }
        Ok(())
    }
}
