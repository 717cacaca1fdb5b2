//! What a driver made of a probe, and the line by which a separate process tells it.

use serde::{Deserialize, Serialize};

/// What a driver made of a probe.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub enum Outcome {
    /// It calculated these results, one for each case.
    Results(#[serde(with = "bits")] Vec<f64>),
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
    ///
    /// # Panics
    /// Never: every outcome has a form in JSON.
    #[must_use]
    pub fn to_line(&self) -> String {
        serde_json::to_string(self).expect("its parts are numbers and texts")
    }

    /// Returns the outcome of a line of [`Self::to_line`], or `None` if it is another text.
    #[must_use]
    pub fn of_line(line: &str) -> Option<Self> {
        serde_json::from_str(line).ok()
    }
}

/// Numbers in the form of their bits, because JSON has no NaN.
mod bits {
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    pub fn serialize<S: Serializer>(numbers: &[f64], serializer: S) -> Result<S::Ok, S::Error> {
        numbers.iter().map(|number| number.to_bits()).collect::<Vec<_>>().serialize(serializer)
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<f64>, D::Error> {
        Ok(Vec::deserialize(deserializer)?.into_iter().map(f64::from_bits).collect())
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
        for line in ["", "compiling", "[1]", "{\"Results\":[-1]}", "{\"other\":1}"] {
            assert_eq!(Outcome::of_line(line), None);
        }
    }
}
