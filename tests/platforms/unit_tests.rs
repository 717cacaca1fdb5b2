//! Runs the unit tests of `cpu` on another system.

use libtest_mimic::Failed;

use crate::host::Host;
use crate::table::Platform;

/// Fewest tests that must pass. The package has some more.
const FEWEST: u64 = 200;

/// Builds the tests for the platform and runs them in its emulator.
pub fn pass(platform: &Platform) -> Result<(), Failed> {
    let Host::Emulator { qemu, libraries } = &platform.host else { return Err("there is no emulator".into()) };
    let path = format!("LD_LIBRARY_PATH={libraries}/lib");
    let runner = format!("target.{}.runner={:?}", platform.build.target, [qemu.0, "-L", libraries, "-E", &path]);
    let printed = platform.build.cargo(&["test", "-p", "cpu", "--lib", "--tests", "--config", &runner])?;
    let results = printed.lines().filter_map(|line| line.strip_prefix("test result: ok. ")?.split_once(" passed"));
    let passed: u64 = results.filter_map(|(count, _)| count.parse::<u64>().ok()).sum();
    if passed >= FEWEST { Ok(()) } else { Err(format!("only {passed} tests passed:\n{printed}").into()) }
}
