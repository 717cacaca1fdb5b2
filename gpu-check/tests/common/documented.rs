//! Compares verdicts with the documented ones, docs/gpu/probes.csv.

use gpu_check::conformance::csv::Table;
use gpu_check::scenes::repository;

/// Checks that the verdicts in `table` on the driver whose description begins with `driver` are the documented ones.
/// The number of wrong cases is not compared, because it depends on how many invocations a driver runs at once.
pub fn check(table: &Table, driver: &str) {
    let text = std::fs::read_to_string(repository("docs/gpu/probes.csv")).expect("it is committed");
    let documented = Table::parse(&text).expect("conformance wrote it");
    let [found, documented] = [table, &documented].map(|table| table.column(driver).expect("the driver has a column"));
    assert_eq!(found.len(), documented.len(), "the documented table has a line for each probe");
    let is_same = |one: &[&str; 3], other: &[&str; 3]| {
        let both_fail = [one, other].iter().all(|row| row[2].starts_with("failure"));
        one[..2] == other[..2] && (one[2] == other[2] || both_fail)
    };
    let different: Vec<_> = found.iter().zip(&documented).filter(|(one, other)| !is_same(one, other)).collect();
    assert!(different.is_empty(), "{driver}: found and documented verdicts differ: {different:#?}");
    println!("{} probes of {driver} compared", found.len());
}
