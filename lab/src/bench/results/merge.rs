//! Joins the results of parts of one matrix.

use super::Results;
use crate::bench::machine::Machine;
use measure::statistics::Median;

impl Results {
    /// Joins the results of parts of one matrix. If two parts have times for one setting, the joined results have the
    /// repeats of both parts.
    ///
    /// # Errors
    /// The error as text, if the parts come from different matrices or commits, or have different pictures for one
    /// setting.
    pub fn merge(parts: Vec<Self>) -> Result<Self, String> {
        let mut all = Self { quick: parts.first().ok_or("there is nothing to join")?.quick, ..Self::default() };
        for part in parts {
            if part.quick != all.quick {
                return Err("quick and full measurements cannot be joined".to_owned());
            }
            for machine in part.machines {
                if all.machines.iter().any(|other| other.commit != machine.commit) {
                    return Err(format!("another part was measured at another commit than {}", machine.commit));
                }
                // Entries of one machine may differ only in the load, which changes from minute to minute.
                let same = |other: &&Machine| Machine { load: machine.load, ..(*other).clone() } == machine;
                if !all.machines.iter().any(|other| same(&other)) {
                    all.machines.push(machine);
                }
            }
            for timing in part.timings {
                match all.timings.iter_mut().find(|other| other.setting == timing.setting) {
                    Some(other) if other.digest != timing.digest => {
                        return Err(format!("different pictures for {:?}", timing.setting));
                    }
                    Some(other) => {
                        other.seconds.extend(timing.seconds);
                        other.median = Median::of(&other.seconds);
                    }
                    None => all.timings.push(timing),
                }
            }
            for curve in part.curves {
                if !all.curves.iter().any(|other| other.scene == curve.scene) {
                    all.curves.push(curve);
                }
            }
            all.omitted.extend(part.omitted);
        }
        all.complete();
        Ok(all)
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{results, timing};
    use super::*;

    #[test]
    fn parts_are_joined_and_what_follows_is_computed() {
        let first = results(vec![timing("a", 4, &[4.0]), timing("a", 1, &[1.0])]);
        let second = results(vec![timing("a", 16, &[16.0]), timing("a", 4, &[6.0])]);
        let joined = Results::merge(vec![first, second]).expect("they fit");
        assert_eq!(joined.machines.len(), 1);
        let medians: Vec<_> =
            joined.timings.iter().map(|timing| (timing.setting.value, timing.median.median)).collect();
        assert_eq!(medians, [(1, 1.0), (4, 5.0), (16, 16.0)], "pooled, and in order");
        assert!((joined.growth[0].law.exponent - 1.0).abs() < 1e-12, "{:?}", joined.growth);
    }

    #[test]
    fn what_does_not_belong_together_is_not_joined() {
        let part = || results(vec![timing("a", 1, &[1.0])]);
        let quick = Results { quick: true, ..part() };
        let mut other_picture = part();
        other_picture.timings[0].digest = "other".to_owned();
        let mut other_commit = part();
        other_commit.machines[0].commit = "other".to_owned();
        for other in [quick, other_picture, other_commit] {
            assert!(Results::merge(vec![part(), other]).is_err());
        }
        assert!(Results::merge(Vec::new()).is_err());
    }
}
