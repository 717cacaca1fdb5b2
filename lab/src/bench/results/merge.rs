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
    pub fn merge(parts: impl IntoIterator<Item = Self>) -> Result<Self, String> {
        let mut all = Self::default();
        for (index, part) in parts.into_iter().enumerate() {
            if index == 0 {
                all.quick = part.quick;
            } else if part.quick != all.quick {
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
