//! Decides whether a driver's results follow one of the allowed readings.

use std::fmt;

use super::outcome::Outcome;
use super::probe::Probe;
use super::reading::Kind;

/// The verdict on a driver for one probe.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// The results are as written.
    AsWritten,
    /// The results follow the rewriting of this name.
    Rewritten(&'static str),
    /// The results are within the error of this name.
    WithinError(&'static str),
    /// The implementation refuses the program, and may do so.
    Refused,
    /// The adapter lacks f64, which the probe needs.
    NotAvailable,
    /// The results follow no allowed reading.
    Failure(Failure),
}

/// The reason of a failure.
#[derive(Clone, Debug, PartialEq)]
pub enum Failure {
    /// These cases do not follow the reading that explains most cases.
    Wrong {
        /// Indices of the cases.
        cases: Vec<usize>,
        /// Number of all cases.
        of: usize,
    },
    /// The number of results is not the number of cases.
    WrongCount(usize),
    /// The implementation refused a program that it must accept.
    Refused(String),
    /// This number of results was not written.
    Unwritten(usize),
    /// The driver ended without results, for this cause.
    Ended(String),
}

impl Verdict {
    /// Returns the verdict on `outcome`. One reading must explain the results of all cases: a driver compiles the
    /// program once, so it cannot rewrite one case and not another.
    #[must_use]
    pub fn of(probe: &Probe, outcome: &Outcome) -> Self {
        let results = match outcome {
            Outcome::Results(results) => results,
            Outcome::Refused(_) if probe.may_be_refused => return Self::Refused,
            Outcome::Refused(message) => return Self::Failure(Failure::Refused(message.clone())),
            Outcome::Unwritten(count) => return Self::Failure(Failure::Unwritten(*count)),
            Outcome::NotAvailable => return Self::NotAvailable,
            Outcome::Ended(cause) => return Self::Failure(Failure::Ended(cause.clone())),
        };
        if results.len() != probe.cases.len() {
            return Self::Failure(Failure::WrongCount(results.len()));
        }
        let mut fewest: Option<Vec<usize>> = None;
        for reading in &probe.readings {
            let is_wrong = |index: &usize| {
                let allowed = reading.allowed(&probe.cases[*index]);
                !allowed.contains(probe.output, results[*index])
            };
            let wrong: Vec<usize> = (0..results.len()).filter(is_wrong).collect();
            if wrong.is_empty() {
                return match reading.kind {
                    Kind::AsWritten => Self::AsWritten,
                    Kind::Rewriting => Self::Rewritten(reading.name),
                    Kind::Error => Self::WithinError(reading.name),
                };
            }
            if fewest.as_ref().is_none_or(|fewest| wrong.len() < fewest.len()) {
                fewest = Some(wrong);
            }
        }
        Self::Failure(Failure::Wrong { cases: fewest.unwrap_or_default(), of: results.len() })
    }

    /// Whether the driver fails the probe.
    #[must_use]
    pub const fn is_failure(&self) -> bool {
        matches!(self, Self::Failure(_))
    }

    /// Returns the class of the verdict.
    #[must_use]
    pub const fn class(&self) -> &'static str {
        match self {
            Self::AsWritten => "as written",
            Self::Rewritten(_) => "rewritten",
            Self::WithinError(_) => "within error",
            Self::Refused => "refused",
            Self::NotAvailable => "not available",
            Self::Failure(_) => "failure",
        }
    }
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::AsWritten | Self::Refused => f.write_str(self.class()),
            Self::Rewritten(name) => write!(f, "rewritten: {name}"),
            Self::WithinError(name) => write!(f, "within error: {name}"),
            Self::NotAvailable => f.write_str("not available (f64)"),
            Self::Failure(failure) => write!(f, "failure: {failure}"),
        }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Wrong { cases, of, .. } => write!(f, "{} of {of} wrong", cases.len()),
            Self::WrongCount(count) => write!(f, "{count} results"),
            Self::Refused(message) => write!(f, "refused: {}", message.lines().next().unwrap_or_default()),
            Self::Unwritten(count) => write!(f, "{count} not written"),
            // The cause is shown elsewhere, because it is too long for a table.
            Self::Ended(_) => f.write_str("the driver ends"),
        }
    }
}
