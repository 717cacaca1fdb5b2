//! The table of verdicts as CSV, with a column for each driver. Several machines can fill one table.

use std::fmt;

use super::probe::Probe;
use super::report::Run;

/// Number of columns before those of the drivers: the name of the probe and its program.
const FACTS: usize = 2;

/// A table of verdicts: a line with the names of the columns, and a line for each probe.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Table(Vec<Vec<String>>);

impl Table {
    /// Reads the text of a table, as its `Display` writes it.
    ///
    /// # Errors
    /// A message for the user if a cell is not quoted.
    pub fn parse(text: &str) -> Result<Self, String> {
        let cells = |line: &str| {
            let inner = line.strip_prefix('"')?.strip_suffix('"')?;
            Some(inner.split("\",\"").map(|cell| cell.replace("\"\"", "\"")).collect())
        };
        let rows = (1..)
            .zip(text.lines())
            .map(|(number, line)| cells(line).ok_or_else(|| format!("line {number} is not a row of quoted cells")));
        rows.collect::<Result<_, _>>().map(Self)
    }

    /// Returns the table with a row for each of `probes`. The verdicts of `runs` replace the columns of their drivers
    /// or are new columns. The other columns stay, without the verdicts on programs that have changed.
    #[must_use]
    pub fn with(&self, probes: &[Probe], runs: &[Run]) -> Self {
        let own: Vec<_> = runs.iter().map(|run| (&run.driver, run.verdicts(probes))).collect();
        let mut head = self.0.first().cloned().unwrap_or_else(|| vec!["probe".to_owned(), "program".to_owned()]);
        let new: Vec<_> =
            own.iter().map(|(driver, _)| (*driver).clone()).filter(|driver| !head.contains(driver)).collect();
        head.extend(new);
        let row = |(index, probe): (usize, &Probe)| {
            let facts = [probe.name.clone(), probe.result.to_owned()];
            let old = self.0.iter().find(|row| row.starts_with(&facts));
            let verdict = |(column, driver): (usize, &String)| match own.iter().find(|(name, _)| *name == driver) {
                Some((_, verdicts)) => verdicts[index].to_string(),
                None => old.and_then(|row| row.get(column)).cloned().unwrap_or_default(),
            };
            let verdicts: Vec<_> = head.iter().enumerate().skip(FACTS).map(verdict).collect();
            facts.into_iter().chain(verdicts).collect()
        };
        let rows: Vec<_> = probes.iter().enumerate().map(row).collect();
        Self(std::iter::once(head).chain(rows).collect())
    }

    /// Returns name, program and verdict of each probe on the first driver whose description begins with `driver`, or
    /// `None` if there is no such driver.
    #[must_use]
    pub fn column(&self, driver: &str) -> Option<Vec<[&str; FACTS + 1]>> {
        let (head, rows) = self.0.split_first()?;
        let column = (FACTS..head.len()).find(|column| head[*column].starts_with(driver))?;
        Some(rows.iter().map(|row| [0, 1, column].map(|place| row.get(place).map_or("", String::as_str))).collect())
    }
}

impl fmt::Display for Table {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for row in &self.0 {
            let cells: Vec<_> = row.iter().map(|cell| format!("\"{}\"", cell.replace('"', "\"\""))).collect();
            writeln!(f, "{}", cells.join(","))?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::conformance::outcome::Outcome;
    use crate::conformance::probes;

    #[test]
    fn a_run_replaces_its_own_column_and_keeps_the_others() {
        let probes = probes::all();
        let run = |adapter: &str, outcome: Outcome| Run {
            driver: format!("{adapter}; a \"driver\""),
            outcomes: vec![outcome; probes.len()],
        };
        let unwritten = |count| Outcome::Unwritten(count);
        let table = Table::default().with(&probes[..3], &[run("one", unwritten(1)), run("two", unwritten(2))]);
        assert_eq!(Table::parse(&table.to_string()).as_ref(), Ok(&table));
        let table = table.with(&probes[1..4], &[run("two", unwritten(3)), run("three", Outcome::NotAvailable)]);
        let verdicts = |driver| table.column(driver).expect("it has run").iter().map(|row| row[2]).collect::<Vec<_>>();
        assert_eq!(verdicts("one"), ["failure: 1 not written", "failure: 1 not written", ""]);
        assert_eq!(verdicts("two"), ["failure: 3 not written"; 3]);
        assert_eq!(verdicts("three"), ["not available (f64)"; 3]);
        assert_eq!(table.column("four"), None);
        assert_eq!(table.to_string().lines().count(), 4);
        assert_eq!(Table::parse("\"a\"\nb\n"), Err("line 2 is not a row of quoted cells".to_owned()));
    }
}
