//! What a driver made of a probe, and the line by which a separate process tells it.

use serde_json::{Value, json};

/// What a driver made of a probe.
#[derive(Clone, Debug, PartialEq)]
pub enum Outcome {
    /// It calculated these results, one for each case.
    Results(Vec<f64>),
    /// It refused the program, with this message.
    Refused(String),
    /// It left this number of results unwritten.
    Unwritten(usize),
    /// The adapter lacks f64, which the probe needs.
    NotAvailable,
    /// It ended without results, for this cause: the device was lost, the process ended, or the time was over.
    Ended(String),
}

impl Outcome {
    /// Returns the outcome as one line of JSON, without a line end.
    #[must_use]
    pub fn to_line(&self) -> String {
        let value = match self {
            // JSON has no NaN, so the results are written as bits.
            Self::Results(results) => {
                json!({"results": results.iter().map(|result| result.to_bits()).collect::<Vec<_>>()})
            }
            Self::Refused(message) => json!({"refused": message}),
            Self::Unwritten(count) => json!({"unwritten": count}),
            Self::NotAvailable => json!({"not available": "f64"}),
            Self::Ended(cause) => json!({"ended": cause}),
        };
        value.to_string()
    }

    /// Returns the outcome of a line of [`Self::to_line`], or `None` if it is another text.
    #[must_use]
    pub fn of_line(line: &str) -> Option<Self> {
        let value: Value = serde_json::from_str(line).ok()?;
        let (kind, value) = value.as_object()?.iter().next()?;
        let text = || value.as_str().map(str::to_owned);
        match kind.as_str() {
            "results" => {
                let bits = value.as_array()?.iter().map(Value::as_u64);
                bits.map(|bits| bits.map(f64::from_bits)).collect::<Option<_>>().map(Self::Results)
            }
            "refused" => text().map(Self::Refused),
            "unwritten" => Some(Self::Unwritten(usize::try_from(value.as_u64()?).ok()?)),
            "not available" => Some(Self::NotAvailable),
            "ended" => text().map(Self::Ended),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_has_the_whole_outcome() {
        for outcome in [
            Outcome::Results(vec![0.0, -0.0, 0.1, f64::INFINITY]),
            Outcome::Refused("line 1\nline \"2\"".to_owned()),
            Outcome::Unwritten(3),
            Outcome::NotAvailable,
            Outcome::Ended("lost".to_owned()),
        ] {
            let line = outcome.to_line();
            assert!(!line.contains('\n'), "{line}");
            assert_eq!(Outcome::of_line(&line), Some(outcome));
        }
        for line in ["", "compiling", "[1]", "{\"results\":[-1]}", "{\"other\":1}"] {
            assert_eq!(Outcome::of_line(line), None);
        }
    }
}
