//! Reads the table of drivers in docs/gpu.md.

use gpu_check::conformance::probe::Probe;
use gpu_check::conformance::verdict::Verdict;
use gpu_check::scenes::repository;

/// Checks that `verdicts` are those in the table's column of this driver, which is counted from 1. Returns the number
/// of failures. The number of wrong cases is not compared, because it depends on how many invocations a driver runs at
/// once.
pub fn check(probes: &[Probe], verdicts: &[Verdict], driver: usize) -> usize {
    let page = std::fs::read_to_string(repository("docs/gpu.md")).expect("it is committed");
    let (_, table) = page.split_once("| Probe | Program | Driver 1 |").expect("the page has the table");
    let row = |name: &str| {
        let line = table.lines().find(|line| line.starts_with(&format!("| `{name}` |")))?;
        line.split(" | ").nth(1 + driver).map(|cell| cell.trim_end_matches(" |").replace("\\|", "|"))
    };
    let (_, others) = table.split_once("As written on every driver that has the type:").expect("the page has the list");
    let others: Vec<&str> = others.trim_start().split("\n\n").next().unwrap_or_default().split_whitespace().collect();
    let mut different = Vec::new();
    for (probe, verdict) in probes.iter().zip(verdicts) {
        let (name, shown) = (&probe.name, verdict.to_string().replace("not available (f64)", "no f64"));
        let documented = match row(name) {
            Some(cell) => cell,
            None if others.contains(&name.as_str()) && *verdict == Verdict::NotAvailable("f64") => shown.clone(),
            None if others.contains(&name.as_str()) => "as written".to_owned(),
            None => "nothing".to_owned(),
        };
        let is_same = documented == shown || (documented.starts_with("failure") && verdict.is_failure());
        if !is_same {
            different.push(format!("{name}: the page has [{documented}], and the driver is [{shown}]"));
        }
    }
    assert_eq!(different, [""; 0], "driver {driver} of docs/gpu.md");
    verdicts.iter().filter(|verdict| verdict.is_failure()).count()
}
