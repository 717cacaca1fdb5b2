//! Runs probes through wgpu, on an adapter of this machine.

use shaders::Precision;

use super::outcome::Outcome;
use super::probe::Probe;
use crate::pipeline::Content;
use crate::{Error, Gpu, Pipeline};

/// The project's lock file, which has the versions of wgpu and naga.
const LOCK: &str = include_str!("../../../Cargo.lock");

/// Returns the version of a package in the text of a lock file.
fn version<'a>(lock: &'a str, package: &str) -> &'a str {
    let entry = format!("name = \"{package}\"\nversion = \"");
    lock.split_once(&entry).and_then(|(_, rest)| rest.split('"').next()).unwrap_or("unknown")
}

/// Returns the adapter, the driver, the form of the shaders, and the versions of wgpu and naga.
#[must_use]
pub fn driver(gpu: &Gpu) -> String {
    let [wgpu, naga] = ["wgpu", "naga"].map(|package| version(LOCK, package));
    format!("{}; {}, {}; wgpu {wgpu}, naga {naga}", gpu.name(), gpu.driver(), gpu.form(Precision::F32))
}

/// Runs a probe.
#[must_use]
pub fn run(gpu: &Gpu, probe: &Probe) -> Outcome {
    if probe.needs_f64() && !gpu.has_f64() {
        return Outcome::NotAvailable;
    }
    results(gpu, probe).map_or_else(
        |error| match error {
            Error::Shader(error) => Outcome::Refused(error.to_string()),
            Error::Refused { cause } => Outcome::Refused(cause),
            Error::Unwritten { count, .. } => Outcome::Unwritten(count),
            Error::DeviceLost { cause } => Outcome::Ended(format!("the device was lost: {cause}")),
            other => Outcome::Ended(other.to_string()),
        },
        Outcome::Results,
    )
}

/// Returns the results of a probe.
fn results(gpu: &Gpu, probe: &Probe) -> Result<Vec<f64>, Error> {
    let pipeline = Pipeline::new(gpu, &probe.composition(), &[])?;
    let input = probe.input_bytes();
    let contents = [Content::Input(&input), Content::Output(probe.output_size() as u64)];
    let run = pipeline.run(gpu, &contents, probe.cases.len() as u64)?;
    Ok(probe.output.of_bytes(&run.outputs.concat()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn versions_come_from_the_lock_file() {
        assert_eq!(version("name = \"a\"\nversion = \"1.2\"\n\nname = \"b\"\nversion = \"3\"\n", "b"), "3");
        assert_eq!(version("", "b"), "unknown");
        assert!(version(LOCK, "naga").starts_with(|digit: char| digit.is_ascii_digit()));
    }
}
