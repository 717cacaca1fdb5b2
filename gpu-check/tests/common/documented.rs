//! Reads the table of verdicts, docs/gpu/probes.csv.

use gpu_check::conformance::probe::Probe;
use gpu_check::conformance::verdict::Verdict;
use gpu_check::scenes::repository;

/// Checks that the table has a line for each probe with its program, and that `verdicts` are those in the column of
/// this driver, which is counted from 1. Returns the number of failures. The number of wrong cases is not compared,
/// because it depends on how many invocations a driver runs at once.
pub fn check(probes: &[Probe], verdicts: &[Verdict], driver: usize) -> usize {
    let table = std::fs::read_to_string(repository("docs/gpu/probes.csv")).expect("it is committed");
    let lines: Vec<Vec<&str>> = table.lines().skip(1).map(cells).collect();
    assert_eq!(lines.len(), probes.len(), "the table has a line for each probe");
    let mut different = Vec::new();
    for (probe, (verdict, line)) in probes.iter().zip(verdicts.iter().zip(&lines)) {
        let (documented, shown) = (line[1 + driver], verdict.to_string());
        let is_same = documented == shown || (documented.starts_with("failure") && verdict.is_failure());
        if (line[0], line[1]) != (probe.name.as_str(), probe.result) || !is_same {
            different.push(format!("{} is [{shown}], and the table has {line:?}", probe.name));
        }
    }
    assert_eq!(different, [""; 0], "driver {driver} of docs/gpu/probes.csv");
    verdicts.iter().filter(|verdict| verdict.is_failure()).count()
}

/// Returns the cells of a line. All of them are quoted, and none contains a quotation mark.
fn cells(line: &str) -> Vec<&str> {
    let inner = line.strip_prefix('"').and_then(|rest| rest.strip_suffix('"')).expect("the cells are quoted");
    inner.split("\",\"").collect()
}
