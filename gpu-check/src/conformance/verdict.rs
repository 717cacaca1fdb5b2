//! Decides whether a driver's results follow one of the allowed readings.

use std::fmt;

use super::outcome::Outcome;
use super::probe::Probe;
use super::reading::Kind;

/// The verdict on a driver for one probe.
#[derive(Clone, Debug, PartialEq, Eq)]
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
    /// The results follow no allowed reading, for this reason.
    Failure(String),
}

impl Verdict {
    /// Returns the verdict on `outcome`. One reading must explain the results of all cases: a driver compiles the
    /// program once, so it cannot rewrite one case and not another.
    #[must_use]
    pub fn of(probe: &Probe, outcome: &Outcome) -> Self {
        let results = match outcome {
            Outcome::Results(results) => results,
            Outcome::Refused(_) if probe.may_be_refused => return Self::Refused,
            Outcome::Refused(message) => {
                return Self::Failure(format!("refused: {}", message.lines().next().unwrap_or_default()));
            }
            Outcome::Unwritten(count) => return Self::Failure(format!("{count} not written")),
            Outcome::NotAvailable => return Self::NotAvailable,
            // The cause is shown elsewhere, because it is too long for a table.
            Outcome::Ended(_) => return Self::Failure("the driver ends".to_owned()),
        };
        let of = probe.cases.len();
        if results.len() != of {
            return Self::Failure(format!("{} results", results.len()));
        }
        let (reading, wrong) = probe.nearest(results);
        match reading.kind {
            _ if !wrong.is_empty() => Self::Failure(format!("{} of {of} wrong", wrong.len())),
            Kind::AsWritten => Self::AsWritten,
            Kind::Rewriting => Self::Rewritten(reading.name),
            Kind::Error => Self::WithinError(reading.name),
        }
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
        f.write_str(self.class())?;
        match self {
            Self::AsWritten | Self::Refused => Ok(()),
            Self::Rewritten(name) | Self::WithinError(name) => write!(f, ": {name}"),
            Self::NotAvailable => f.write_str(" (f64)"),
            Self::Failure(reason) => write!(f, ": {reason}"),
        }
    }
}
